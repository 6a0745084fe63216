#include "draw/mesh_picture.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "draw/colour_mixed.h"
#include "hardsphere.h"
#include "read/text_buffer.h"
#include "write/output_file.h"

static const double picture_width = 1000.0; /* px */
static const double margin = 0.03;          /* of the larger side */

static const uint32_t inside_colour = 0xC9B79C;
static const uint32_t void_colour = 0xC2452F;
static const double element_share = 0.7; /* the rest is grey */
static const uint32_t grey = 0xD2CDC3;

/* Towards the light, as in pictures of style soft: left, above and before. */
static const double light[3] = {-0.421, 0.521, 0.742};
enum { LIGHT_STEPS = 40, CARBON = 6 };
static const double fog = 0.25; /* of the farthest triangle */

/* A part of the picture: what is left of a triangle, or a piece of the rim of a cut. */
struct part {
  double depth; /* of its middle */
  double point[4][2];
  int points; /* 2: of a rim */
  uint32_t colour;
};

struct mesh_picture {
  const struct triangle_mesh *mesh;
  const struct molecule *molecule;
  double *seen;      /* [vertices][3], along the axes of the view */
  uint32_t *root;    /* [vertices], of the connected part that it belongs to */
  double *volume;    /* [vertices], of the part of which it is the root; negative: a void */
  struct part *part; /* [2 triangles] */
  size_t parts;
  double low[3], high[3];
  double cut; /* the depth of the plane; infinite: none */
};

/* ---- connected parts ---- */

static uint32_t root_of(uint32_t *root, uint32_t v) {
  while (root[v] != v) {
    root[v] = root[root[v]];
    v = root[v];
  }
  return v;
}

static double determinant(const double *a, const double *b, const double *c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Triangles are counter-clockwise seen from outside the balls: around a void the volume is negative. */
static void find_connected_parts(struct mesh_picture *picture) {
  const struct triangle_mesh *mesh = picture->mesh;
  for (uint32_t v = 0; v < mesh->vertices; ++v) picture->root[v] = v;
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    for (int k = 1; k < 3; ++k) picture->root[root_of(picture->root, c[k])] = root_of(picture->root, c[0]);
  }
  for (uint32_t v = 0; v < mesh->vertices; ++v) picture->root[v] = root_of(picture->root, v);
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    const uint32_t root = picture->root[c[0]];
    double side[3][3];
    for (int k = 0; k < 9; ++k) {
      side[k / 3][k % 3] =
          picture->seen[3 * (size_t)c[k / 3] + (size_t)(k % 3)] - picture->seen[3 * (size_t)root + (size_t)(k % 3)];
    }
    picture->volume[root] += determinant(side[0], side[1], side[2]) / 6.0;
  }
}

static bool is_of_void(const struct mesh_picture *picture, uint32_t vertex) {
  return picture->volume[picture->root[vertex]] < 0.0;
}

/* ---- what is seen ---- */

static void look(struct mesh_picture *picture, const double axis[3][3]) {
  const struct triangle_mesh *mesh = picture->mesh;
  for (size_t v = 0; v < mesh->vertices; ++v) {
    const double *at = mesh->xyz + 3 * v;
    for (int k = 0; k < 3; ++k) {
      const double x = axis[k][0] * at[0] + axis[k][1] * at[1] + axis[k][2] * at[2];
      picture->seen[3 * v + (size_t)k] = x;
      if (v == 0 || x < picture->low[k]) picture->low[k] = x;
      if (v == 0 || x > picture->high[k]) picture->high[k] = x;
    }
  }
}

/* The plane through the middle of the largest void, or else of everything. */
static double find_cut(const struct mesh_picture *picture) {
  const struct triangle_mesh *mesh = picture->mesh;
  uint32_t largest = UINT32_MAX;
  for (uint32_t v = 0; v < mesh->vertices; ++v) {
    const double volume = picture->volume[v];
    if (volume < 0.0 && (largest == UINT32_MAX || volume < picture->volume[largest])) largest = v;
  }
  double low = picture->low[2];
  double high = picture->high[2];
  bool any = false;
  for (uint32_t v = 0; v < mesh->vertices && largest != UINT32_MAX; ++v) {
    if (picture->root[v] != largest) continue;
    const double depth = picture->seen[3 * (size_t)v + 2];
    if (!any || depth < low) low = depth;
    if (!any || depth > high) high = depth;
    any = true;
  }
  return low / 2.0 + high / 2.0;
}

static uint32_t own_colour(const struct mesh_picture *picture, size_t triangle, bool inside, bool of_void) {
  if (of_void) return void_colour;
  if (inside) return inside_colour;
  /* Borders between atoms on smooth patches follow triangles: the mean over the corners softens the steps. */
  uint32_t colour = 0;
  for (int k = 0; k < 3; ++k) {
    const uint32_t vertex = picture->mesh->corners[3 * triangle + (size_t)k];
    const struct atom_label *label = &picture->molecule->label[picture->mesh->vertex_balls[vertex]];
    const uint32_t number = label->element.text[0] == '\0' ? CARBON : element_atomic_number(label->element);
    colour = colour_mixed(colour, hsp_palette_colour(HSP_PALETTE_SOFT, number, 0), 1.0 / (k + 1));
  }
  return colour_mixed(grey, colour, element_share);
}

/* With the mean of the corners' normals, turned to the viewer, in steps: so many colours differ by more than an eye can
 * tell. */
static uint32_t lit_colour(const struct mesh_picture *picture, const struct mesh_view *view, size_t triangle,
                           bool inside, double depth, uint32_t colour) {
  double normal[3] = {0.0, 0.0, 0.0};
  for (int k = 0; k < 3; ++k) {
    const double *n = picture->mesh->normals + 3 * (size_t)picture->mesh->corners[3 * triangle + (size_t)k];
    for (int axis = 0; axis < 3; ++axis) {
      const double *a = view->axis[axis];
      normal[axis] += (inside ? -1.0 : 1.0) * (a[0] * n[0] + a[1] * n[1] + a[2] * n[2]);
    }
  }
  const double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  const double cosine =
      length > 0.0 ? (normal[0] * light[0] + normal[1] * light[1] + normal[2] * light[2]) / length : 1.0;
  const double part = floor((1.0 + cosine) / 2.0 * LIGHT_STEPS + 0.5) / LIGHT_STEPS;
  const double bright = 0.42 + 0.66 * part * sqrt(part);
  const uint32_t lit =
      bright <= 1.0 ? colour_mixed(0x0A0A18, colour, bright) : colour_mixed(colour, 0xFFFFFF, 4.0 * (bright - 1.0));
  const double range = picture->high[2] - picture->low[2];
  const double behind = range > 0.0 ? (picture->high[2] - depth) / range : 0.0;
  return colour_mixed(lit, 0xFFFFFF, fog * floor(behind * 16.0 + 0.5) / 16.0);
}

/* What is left of a triangle behind the cut, and the piece of the rim where the cut goes through. */
static void add_parts(struct mesh_picture *picture, const double *corner[3], double depth, bool whole,
                      uint32_t colour) {
  struct part *part = &picture->part[picture->parts++];
  struct part rim = {.depth = picture->cut, .points = 0, .colour = 0};
  *part = (struct part){.depth = whole || depth < picture->cut ? depth : picture->cut, .points = 0, .colour = colour};
  for (int k = 0; k < 3; ++k) {
    const double *from = corner[k];
    const double *to = corner[(k + 1) % 3];
    const bool behind[2] = {whole || from[2] <= picture->cut, whole || to[2] <= picture->cut};
    if (behind[0]) {
      for (int axis = 0; axis < 2; ++axis) part->point[part->points][axis] = from[axis];
      ++part->points;
    }
    if (behind[0] == behind[1]) continue;
    const double share = (picture->cut - from[2]) / (to[2] - from[2]);
    for (int axis = 0; axis < 2; ++axis) {
      const double x = from[axis] + share * (to[axis] - from[axis]);
      part->point[part->points][axis] = x;
      rim.point[rim.points][axis] = x;
    }
    ++part->points;
    ++rim.points;
  }
  if (part->points < 3) --picture->parts;
  if (rim.points == 2) picture->part[picture->parts++] = rim;
}

/* Nobody looks through a closed surface. Of a void, as a body, what faces the viewer is what turns away from him as a
 * surface of the balls. */
static bool is_shown(bool cut, bool of_void, double turn) {
  if (of_void) return cut && turn < 0.0;
  return turn > 0.0 || (cut && turn < 0.0);
}

static void find_parts(struct mesh_picture *picture, const struct mesh_view *view) {
  const struct triangle_mesh *mesh = picture->mesh;
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    const double *corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = picture->seen + 3 * (size_t)c[k];
    const double turn = (corner[1][0] - corner[0][0]) * (corner[2][1] - corner[0][1]) -
                        (corner[1][1] - corner[0][1]) * (corner[2][0] - corner[0][0]);
    const bool inside = turn < 0.0;
    const bool of_void = is_of_void(picture, c[0]);
    if (!is_shown(view->cut, of_void, turn)) continue;
    const double depth = (corner[0][2] + corner[1][2] + corner[2][2]) / 3.0;
    const uint32_t own = own_colour(picture, t, inside, of_void);
    add_parts(picture, corner, depth, of_void, lit_colour(picture, view, t, inside, depth, own));
  }
}

static int compare_parts(const void *a, const void *b) {
  const struct part *p = a;
  const struct part *q = b;
  if (p->depth != q->depth) return p->depth < q->depth ? -1 : 1;
  for (int k = 0; k < 2; ++k) {
    if (p->point[0][k] != q->point[0][k]) return p->point[0][k] < q->point[0][k] ? -1 : 1;
  }
  return p->points - q->points;
}

/* ---- the file ---- */

/* Tenths of a px. */
struct frame {
  double scale, left, top;
  int64_t width, height;
};

static int64_t rounded(double value) {
  return (int64_t)floor(value + 0.5);
}

static struct frame find_frame(const struct mesh_picture *picture) {
  const double wide = picture->high[0] - picture->low[0];
  const double high = picture->high[1] - picture->low[1];
  const double around = margin * (wide > high ? wide : high);
  const double across = wide + 2.0 * around;
  struct frame frame = {1.0, 0.0, 0.0, rounded(10.0 * picture_width), rounded(10.0 * picture_width)};
  if (!(across > 0.0)) return frame; /* nothing is seen */
  frame.scale = 10.0 * picture_width / across;
  frame.left = picture->low[0] - around;
  frame.top = picture->high[1] + around;
  frame.height = rounded(frame.scale * (high + 2.0 * around));
  return frame;
}

/* Lines in a triangle's own colour cover what anti-aliasing leaves open between neighbours. currentColor gives line and
 * area one colour; classes would be shared by all pictures of a page. */
static void add_part(struct text_buffer *out, const struct part *part, const struct frame *frame) {
  int64_t before[2] = {0, 0};
  text_buffer_add(out, "<path color=\"#%06" PRIx32 "\" d=\"", part->points == 2 ? UINT32_C(0x23202B) : part->colour);
  for (int k = 0; k < part->points; ++k) {
    const int64_t at[2] = {rounded((part->point[k][0] - frame->left) * frame->scale),
                           rounded((frame->top - part->point[k][1]) * frame->scale)};
    const int64_t y = at[1] - before[1];
    text_buffer_add(out, "%s%" PRId64 "%s%" PRId64,
                    k == 0              ? "M"
                    : k == 1            ? "l"
                    : at[0] < before[0] ? ""
                                        : " ",
                    at[0] - before[0], y < 0 ? "" : " ", y);
    before[0] = at[0];
    before[1] = at[1];
  }
  text_buffer_add(out, "%s\"/>\n", part->points == 2 ? "" : "z");
}

static void add_picture(struct text_buffer *out, const struct mesh_picture *picture, const char *title) {
  const struct frame frame = find_frame(picture);
  text_buffer_add(out,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%" PRId64 ".%" PRId64 "px\" height=\"%" PRId64
                  ".%" PRId64 "px\" viewBox=\"0 0 %" PRId64 " %" PRId64 "\" role=\"img\">\n<title>",
                  frame.width / 10, frame.width % 10, frame.height / 10, frame.height % 10, frame.width, frame.height);
  text_buffer_add_xml(out, title);
  text_buffer_add(out,
                  "</title>\n<rect width=\"%" PRId64 "\" height=\"%" PRId64
                  "\" fill=\"#ffffff\"/>\n<g fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\"6\" "
                  "stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
                  frame.width, frame.height);
  for (size_t i = 0; i < picture->parts; ++i) add_part(out, &picture->part[i], &frame);
  text_buffer_add(out, "</g>\n</svg>\n");
}

static bool write_text(const struct text_buffer *text, const char *path, struct failure *failure) {
  struct output_file file;
  if (text->out_of_memory) return failure_of_memory(failure);
  if (!output_file_open(&file, path, failure)) return false;
  output_file_write(&file, text->text, text->length);
  return output_file_finish(&file, failure);
}

bool mesh_picture_write(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                        const char *title, const char *path, uint64_t *bytes, struct failure *failure) {
  const size_t v = (size_t)mesh->vertices + 1;
  struct mesh_picture picture = {.mesh = mesh,
                                 .molecule = molecule,
                                 .seen = calloc(v, 3 * sizeof *picture.seen),
                                 .root = calloc(v, sizeof *picture.root),
                                 .volume = calloc(v, sizeof *picture.volume),
                                 .part = calloc((size_t)mesh->triangles + 1, 2 * sizeof *picture.part),
                                 .cut = INFINITY};
  struct text_buffer text = TEXT_BUFFER_EMPTY;
  bool done = false;
  if (picture.seen == NULL || picture.root == NULL || picture.volume == NULL || picture.part == NULL) {
    failure_of_memory(failure);
  } else {
    look(&picture, view->axis);
    find_connected_parts(&picture);
    if (view->cut) picture.cut = find_cut(&picture);
    find_parts(&picture, view);
    qsort(picture.part, picture.parts, sizeof *picture.part, compare_parts);
    add_picture(&text, &picture, title);
    done = write_text(&text, path, failure);
    *bytes = text.length;
  }
  text_buffer_free(&text);
  free(picture.seen);
  free(picture.root);
  free(picture.volume);
  free(picture.part);
  return done;
}
