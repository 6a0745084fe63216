#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/mesh_lines.h"
#include "draw/mesh_page.h"
#include "draw/pen.h"
#include "draw/surface_light.h"
#include "draw/text_width.h"
#include "hardsphere.h"

static const double section_line = 22.0;

#define LEGEND_CIRCLE 0.4 /* of the light, on which the colours of legends are */

enum { HYDROGEN = 1, CARBON = 6, ELEMENTS = 119 };

static bool is_of_sphere(uint32_t paint) {
  return paint >= FIRST_SPHERE;
}

static int compare_paints(const void *left, const void *right) {
  const uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
  return (a > b) - (a < b);
}

static uint32_t sphere_colour(struct mesh_picture *picture, uint32_t paint) {
  const uint32_t sphere = paint / picture->sides;
  return mesh_colour_of(picture, sphere < picture->mesh->atoms ? sphere : BETWEEN_ATOMS, (int)(paint % picture->sides));
}

/* Normals point away from the centre of a ball, and towards the centre of a probe; on the inside the other way
 * round. */
static void add_sphere(struct mesh_picture *picture, struct text_buffer *out, uint32_t paint) {
  const struct triangle_mesh *mesh = picture->mesh;
  const uint32_t sphere = paint / picture->sides;
  const bool of_ball = sphere < mesh->atoms;
  const bool turned = of_ball == (mesh_plain_side((int)(paint % picture->sides)) != OUTSIDE);
  const bool smooth = picture->view->patches != NULL;
  double centre[3];
  double radius = mesh->probe;
  if (of_ball) {
    memcpy(centre, picture->ball + 3 * (size_t)sphere, sizeof centre);
    radius = picture->molecule->radius[sphere] + (smooth ? 0.0 : mesh->probe);
  } else {
    mesh_turn(picture->view->axis, picture->view->patches[sphere - mesh->atoms].probe, centre);
  }
  int32_t at[2];
  mesh_place(&picture->frame, centre, at);
  for (int axis = 0; axis < 2; ++axis) at[axis] *= 2; /* see add_picture */
  const double size = 2.0 * radius * picture->frame.scale * (turned ? -1.0 : 1.0);
  text_buffer_add(out,
                  "<radialGradient id=\"s%" PRIu32 "\" gradientUnits=\"userSpaceOnUse\" cx=\"%" PRId32
                  "\" cy=\"%" PRId32 "\" r=\"%" PRId32 "\" fx=\"%" PRId32 "\" fy=\"%" PRId32 "\">",
                  paint, at[0], at[1], mesh_rounded(fabs(size)), mesh_rounded(at[0] + surface_light_focus[0] * size),
                  mesh_rounded(at[1] - surface_light_focus[1] * size));
  const uint32_t colour = picture->colour[sphere_colour(picture, paint)];
  for (int stop = 0; stop < SURFACE_STOPS; ++stop) {
    text_buffer_add(out, "<stop offset=\"%.2g\" stop-color=\"#%06" PRIx32 "\"/>", surface_light_offset(stop),
                    surface_light_stop(colour, stop));
  }
  text_buffer_add_text(out, "</radialGradient>\n");
}

/* If spheres meet at an angle their tones differ, and one extends over the other by half the width of its line. By the
 * layers of triangles this would change along a crease; so creases have lines of their own, all of one sphere. */
static bool add_creases(const struct mesh_picture *picture, struct text_buffer *out, uint32_t *paints,
                        size_t *spheres) {
  const struct painted_edges *creases = &picture->creases;
  bool enough = true;
  for (size_t i = 0, end = 0; enough && i < creases->count; i = end) {
    const uint32_t sphere = creases->edge[i].paint - FIRST_SPHERE;
    end = painted_edges_end(creases, i);
    text_buffer_add(
        out, "<path fill=\"none\" stroke=\"url(#s%" PRIu32 ")\" stroke-width=\"%.0f\" stroke-linecap=\"butt\" d=\"",
        sphere, 2.0 * CREASE_LINE);
    enough = painted_edges_write(creases, i, end, false, true, out);
    text_buffer_add(out, "\"/>\n");
    paints[(*spheres)++] = sphere;
  }
  return enough;
}

/* Add areas with lines in their own colour, which cover the gaps that anti-aliasing leaves between neighbours. An empty
 * area is not written: some readers would paint the next one wrongly. Lists the visible spheres, each once. */
static bool add_areas(const struct mesh_picture *picture, struct text_buffer *out, uint32_t *paints, size_t *spheres) {
  const struct painted_edges *areas = &picture->areas;
  bool enough = true;
  for (size_t i = 0, end = 0; enough && i < areas->count; i = end) {
    const uint32_t paint = areas->edge[i].paint;
    const bool sphere = is_of_sphere(paint);
    const size_t before = out->length;
    end = painted_edges_end(areas, i);
    if (sphere) {
      text_buffer_add(out, "<path fill=\"url(#s%" PRIu32 ")\" stroke=\"url(#s%" PRIu32 ")\" d=\"", paint - FIRST_SPHERE,
                      paint - FIRST_SPHERE);
    } else {
      const uint32_t band = paint % BANDS, colour = paint / BANDS;
      const uint32_t tone =
          surface_light_on(picture->colour[colour], picture->border[band] / 2.0 + picture->border[band + 1] / 2.0);
      text_buffer_add(out, "<path fill=\"#%06" PRIx32 "\" stroke=\"#%06" PRIx32 "\" d=\"", tone, tone);
    }
    const size_t begun = out->length;
    enough = painted_edges_write(areas, i, end, true, sphere, out) && !out->out_of_memory;
    if (out->length == begun) {
      out->length = before;
      continue;
    }
    text_buffer_add(out, "\"/>\n");
    if (sphere) paints[(*spheres)++] = paint - FIRST_SPHERE;
  }
  enough = enough && add_creases(picture, out, paints, spheres);
  qsort(paints, *spheres, sizeof *paints, compare_paints);
  size_t kept = 0;
  for (size_t i = 0; i < *spheres; ++i) {
    if (i == 0 || paints[i] != paints[i - 1]) paints[kept++] = paints[i];
  }
  *spheres = kept;
  return enough;
}

/* Add lines. Borders of patches are faint, as colours meet there; rims of pockets have the darkest tone of the pocket;
 * contours have the colour of lines. */
static bool add_lines(const struct mesh_picture *picture, struct text_buffer *out) {
  const struct painted_edges *lines = &picture->lines;
  bool enough = true;
  for (size_t i = 0, end = 0; enough && i < lines->count; i = end) {
    const uint32_t paint = lines->edge[i].paint;
    const bool rim = paint >= FIRST_RIM && paint < FIRST_CONTOUR;
    const char *const faint = paint < FIRST_RIM ? " stroke-opacity=\".4\" stroke-linecap=\"butt\"" : "";
    const uint32_t colour = rim ? surface_light_on(mesh_pocket_colour((int)(paint - FIRST_RIM)), 1.0)
                            : paint >= FIRST_OUTLINE ? mesh_text_colour(picture)
                                                     : LINE_COLOUR;
    end = painted_edges_end(lines, i);
    text_buffer_add(out, "<path fill=\"none\" stroke=\"#%06" PRIx32 "\"%s stroke-width=\"%.2f\" d=\"", colour, faint,
                    2.0 * mesh_line_width(picture, paint));
    enough = painted_edges_write(lines, i, end, false, true, out);
    text_buffer_add(out, "\"/>\n");
  }
  return enough;
}

/* Within the section the inside is seen everywhere: in its darkest tone below all areas, so that no page shows where
 * one of them is too thin to be painted; over them its line. */
static bool add_section_area(const struct mesh_picture *picture, struct text_buffer *out) {
  if (picture->section.count == 0) return true;
  text_buffer_add(out, "<defs><path id=\"section\" d=\"");
  const bool enough = painted_edges_write(&picture->section, 0, picture->section.count, false, true, out);
  text_buffer_add(out, "\"/></defs>\n<use xlink:href=\"#section\" fill=\"#%06" PRIx32 "\" fill-rule=\"evenodd\"/>\n",
                  surface_light_on(mesh_plain_colour(INSIDE), 1.0));
  return enough;
}

static void add_section_line(const struct mesh_picture *picture, struct text_buffer *out) {
  if (picture->section.count == 0) return;
  text_buffer_add(out, "<use xlink:href=\"#section\" fill=\"none\" stroke=\"#%06" PRIx32 "\" stroke-width=\"%.0f\"/>\n",
                  mesh_text_colour(picture), 2.0 * section_line);
}

static void add_entry(const struct mesh_picture *picture, const struct pen *pen, double *x, double y, uint32_t colour,
                      const char *text) {
  const double corner[2] = {*x, y - PAGE_LETTER * 0.45};
  pen_swatch(pen, corner, PAGE_LETTER, colour, mesh_text_colour(picture));
  const struct pen_text written = {text, *x + 1.3 * PAGE_LETTER,    y + 0.36 * PAGE_LETTER,   PAGE_LETTER,
                                   0.0,  mesh_text_colour(picture), mesh_page_colour(picture)};
  pen_write(pen, &written);
  *x += 1.9 * PAGE_LETTER + text_width(text, PAGE_LETTER);
}

/* Legends name colours that are seen at this many points or more, a patch of some 10 px. */
enum { LEAST_POINTS = 1000 };

static void add_pockets(struct mesh_picture *picture, const struct pen *pen, double *x, double y) {
  uint64_t seen[OTHER_POCKETS + 1] = {0};
  bool any = false;
  for (uint32_t t = 0; t < picture->mesh->triangles; ++t) {
    const int side = mesh_side_of(picture, t);
    if (side == INSIDE || (picture->view->pockets == NULL && side == OF_VOID)) continue;
    seen[mesh_pocket_of(side)] += picture->points[t];
  }
  for (int pocket = 1; pocket <= MESH_POCKETS; ++pocket) {
    char name[sizeof "pocket 4294967295"];
    if (seen[pocket] < LEAST_POINTS) continue;
    snprintf(name, sizeof name, "%s%" PRIu32, any ? "" : "pocket ", picture->view->pockets->number[pocket - 1]);
    any = true;
    add_entry(picture, pen, x, y, surface_light_on(mesh_pocket_colour(pocket), LEGEND_CIRCLE), name);
  }
  if (seen[OTHER_POCKETS] >= LEAST_POINTS) {
    add_entry(picture, pen, x, y, surface_light_on(mesh_pocket_colour(OTHER_POCKETS), LEGEND_CIRCLE),
              any ? "other pockets" : "pockets");
  }
  if (seen[0] < LEAST_POINTS) return;
  add_entry(picture, pen, x, y, surface_light_on(mesh_plain_colour(SIDES), LEGEND_CIRCLE),
            any ? "rest of the surface" : "outside");
}

/* Elements whose outside is seen, C and H first, then by their numbers. */
static void add_elements(struct mesh_picture *picture, const struct pen *pen, double *x, double y) {
  uint64_t seen[ELEMENTS] = {0}, between = 0;
  for (uint32_t t = 0; t < picture->mesh->triangles; ++t) {
    if (picture->points[t] == 0 || mesh_side_of(picture, t) != OUTSIDE) continue;
    const uint32_t ball = picture->mesh->balls[t], number = mesh_element_of(picture, ball);
    if (picture->mesh->kinds[t] != HSP_PATCH_CONVEX) {
      between += picture->points[t];
      continue;
    }
    if (number >= ELEMENTS || picture->molecule->label[ball].element.text[0] == '\0') continue;
    seen[number] += picture->points[t];
  }
  for (uint32_t k = 0; k < ELEMENTS + 2; ++k) {
    const uint32_t number = k == 0 ? CARBON : k == 1 ? HYDROGEN : k - 2;
    if (seen[number] < LEAST_POINTS) continue;
    seen[number] = 0;
    struct element_symbol symbol;
    if (!element_symbol_of_number(number, &symbol)) continue;
    add_entry(picture, pen, x, y, surface_light_on(mesh_element_colour(number), LEGEND_CIRCLE), symbol.text);
  }
  if (between < LEAST_POINTS) return;
  add_entry(picture, pen, x, y, surface_light_on(BETWEEN_COLOUR, LEGEND_CIRCLE), "between atoms");
}

static void add_legend(struct mesh_picture *picture, struct text_buffer *out) {
  const struct pen pen = {out, HSP_FORMAT_SVG, (double)picture->frame.height};
  const double y = picture->frame.height + picture->frame.strip / 2.0 - 0.3 * PAGE_LETTER;
  const bool pockets = picture->view->pockets != NULL;
  double x = PAGE_MARGIN * 10.0 * PICTURE_WIDTH;
  uint64_t of_voids = 0;
  for (uint32_t t = picture->view->of_outside; t < picture->mesh->triangles; ++t) of_voids += picture->points[t];
  pen_begin(&pen);
  (pockets || picture->view->cut ? add_pockets : add_elements)(picture, &pen, &x, y);
  if (picture->view->cut) {
    add_entry(picture, &pen, &x, y, surface_light_on(mesh_plain_colour(INSIDE), LEGEND_CIRCLE), "inside, cut open");
  }
  if (of_voids >= LEAST_POINTS && !pockets) {
    add_entry(picture, &pen, &x, y, surface_light_on(mesh_plain_colour(OF_VOID), LEGEND_CIRCLE), "voids");
  }
  pen_end(&pen);
}

bool mesh_add_svg(struct mesh_picture *picture, const char *title, struct text_buffer *out) {
  const struct frame *const frame = &picture->frame;
  const int32_t height = frame->height + frame->strip;
  struct text_buffer areas = TEXT_BUFFER_EMPTY;
  uint32_t *paints = calloc(picture->areas.count + picture->creases.count + 1, sizeof *paints); /* spheres */
  size_t spheres = 0;
  bool enough = paints != NULL && add_areas(picture, &areas, paints, &spheres);
  text_buffer_add(out,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                  "width=\"%" PRId32 ".%" PRId32 "px\" height=\"%" PRId32 ".%" PRId32 "px\" viewBox=\"0 0 %" PRId32
                  " %" PRId32 "\" role=\"img\">\n<title>",
                  frame->width / 10, frame->width % 10, height / 10, height % 10, frame->width, height);
  text_buffer_add_xml(out, title);
  text_buffer_add(out,
                  "</title>\n<rect width=\"%" PRId32 "\" height=\"%" PRId32 "\" fill=\"#%06" PRIx32 "\"/>\n<defs>\n",
                  frame->width, height, mesh_page_colour(picture));
  for (size_t i = 0; i < spheres; ++i) add_sphere(picture, out, paints[i]);
  /* Outlines are in halves of units. */
  text_buffer_add(
      out,
      "</defs>\n<g transform=\"scale(.5)\" stroke-width=\"%.0f\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
      2.0 * AREA_LINE);
  enough = enough && add_section_area(picture, out);
  text_buffer_append(out, areas.text, areas.length);
  enough = enough && add_lines(picture, out);
  add_section_line(picture, out);
  text_buffer_add(out, "</g>\n");
  if (picture->mesh->triangles > 0) add_legend(picture, out);
  text_buffer_add(out, "</svg>\n");
  text_buffer_free(&areas);
  free(paints);
  return enough;
}
