#include "draw/mesh_lines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/contour_pieces.h"
#include "draw/hidden_lines.h"
#include "draw/mesh_creases.h"
#include "draw/mesh_sides.h"
#include "hardsphere.h"
#include "read/vectors.h"

/* Widths of lines: shares of the mean radius on the page, and bounds in tenths of a px. */
static const double hairline_share = 0.0033, thinnest_hairline = 2.0, widest_hairline = 5.0;
static const double contour_share = 0.0048, thinnest_contour = 6.0, widest_contour = 14.0;

/* A contour doubles another one if behind it there is only a strip, at most `narrowest_strip` widths of a contour wide,
 * and the gap behind the strip's own contour is more than `larger_gap` times as large. */
static const double narrowest_strip = 3.0, larger_gap = 4.0;

/* In mean radii: larger gaps count as this one. */
static const double largest_gap = 3.0;

/* A contour that ends alone is a speck if it has no more ink than a line of full width with this length, in widths. */
static const double shortest_contour = 12.0;

/* Lengths in widths of a contour: from an end alone to full width; the longest thinner part that is raised; the longest
 * gap that is closed, by the thinnest line. */
static const double taper = 6.0, longest_dip = 3.0, longest_gap = 6.0;
enum { THINNEST_LEVEL = 2 };

/* Contours of no higher level may be dropped as specks. */
static const double least_level = 1.0;

/* Such an end is left out if it has no more ink than a line of full width with this length, in widths. */
static const double shortest_end = 3.0;

/* Bounds of a normal's component towards the viewer: hairlines on steeper surfaces double contours and are left out; on
 * flatter ones they have their full width. */
static const double steepest = 0.25, flattest = 0.6;

/* The distance outside a contour, in units of the page, at which its own surface cannot be any more. */
static const double own_surface = 2.0;

static double hairline_width(const struct mesh_picture *picture) {
  const double width = hairline_share * picture->mean_radius * picture->frame.scale;
  return width < widest_hairline ? width : widest_hairline;
}

static double contour_width(const struct mesh_picture *picture) {
  const double width = thinnest_contour + contour_share * picture->mean_radius * picture->frame.scale;
  return width < widest_contour ? width : widest_contour;
}

double mesh_line_width(const struct mesh_picture *picture, uint32_t paint) {
  if (paint >= FIRST_OUTLINE) return contour_width(picture) * (paint - FIRST_OUTLINE) / CONTOUR_LEVELS;
  if (paint >= FIRST_CONTOUR) return contour_width(picture) * (paint - FIRST_CONTOUR) / CONTOUR_LEVELS;
  if (paint >= FIRST_RIM) return contour_width(picture);
  return hairline_width(picture) * (paint - FIRST_BORDER) / BORDER_LEVELS;
}

static uint32_t level_of(double share, uint32_t levels) {
  return share < 1.0 ? (uint32_t)(share * levels + 0.5) : levels;
}

/* Lines while they are found. */
struct line_search {
  struct hidden_lines hidden;
  struct contour_pieces contours;
  struct creases creases;
  uint32_t *root;   /* [vertices] the same for vertices between which contours have no length on the page */
  uint32_t *nearer; /* [vertices], the patch of a contour that is seen there, or NO_PATCH */
};

/* The ends of an edge, in the direction of the first side. */
static struct seen_line line_of(const struct mesh_picture *picture, const struct mesh_side *side) {
  struct seen_line line = {.beside = {side[0].triangle, side[1].triangle}};
  for (int k = 0; k < 2; ++k) {
    const uint32_t vertex = (k == 0) != side->back ? side->low : side->high;
    const double *const at = picture->parts.seen + 3 * (size_t)vertex;
    memcpy(line.at[k], picture->page[vertex], sizeof line.at[k]);
    line.depth[k] = at[2];
    line.vertex[k] = vertex;
  }
  return line;
}

/* The share of a line at which it goes through the plane of the cut. */
static double share_at(const struct seen_line *line, double plane) {
  return (plane - line->depth[0]) / (line->depth[1] - line->depth[0]);
}

/* The gap in depth from a point of a line to the nearest surface at the distance `outside` from the line. The line's
 * own surface is on its left. */
static double gap_outside(const struct hidden_lines *hidden, const struct seen_line *line, double share,
                          double outside) {
  const double along[2] = {(double)line->at[1][0] - line->at[0][0], (double)line->at[1][1] - line->at[0][1]};
  const double part = outside / sqrt(along[0] * along[0] + along[1] * along[1]);
  const double at[2] = {line->at[0][0] + share * along[0] - part * along[1],
                        line->at[0][1] + share * along[1] + part * along[0]};
  const double gap = line->depth[0] + share * (line->depth[1] - line->depth[0]) - hidden_lines_front(hidden, at);
  return fmax(gap, 0.0);
}

/* Whether the surface behind a point of a line ends near by. A sudden increase of the gap shows its end; a surface that
 * falls off recedes step by step. */
static bool has_strip(const struct mesh_picture *picture, const struct hidden_lines *hidden,
                      const struct seen_line *line, double share) {
  const double step = contour_width(picture) / 2.0;
  double before = gap_outside(hidden, line, share, step);
  for (int k = 2; k <= 2.0 * narrowest_strip; ++k) {
    const double gap = fmin(gap_outside(hidden, line, share, k * step), largest_gap * picture->mean_radius);
    if (gap > larger_gap * before) return true;
    before = gap;
  }
  return false;
}

/* Set the level of a part of a contour by the least gap just outside its line, as the library does for contours of
 * balls; 0 if the part doubles another contour. */
static void set_level(const struct mesh_picture *picture, const struct hidden_lines *hidden,
                      const struct seen_line *line, struct span span, struct contour_piece *piece) {
  double gap = INFINITY, width = 0.0;
  bool doubles = true;
  for (int half = 0; half <= 2; ++half) {
    const double share = span.from + (span.to - span.from) * half / 2.0;
    gap = fmin(gap, gap_outside(hidden, line, share, contour_width(picture) / 2.0));
    doubles = doubles && has_strip(picture, hidden, line, share);
  }
  hsp_picture_ink_width(1.0, fmin(gap / picture->mean_radius, largest_gap), &width);
  piece->level = doubles ? 0.0 : level_of(width, CONTOUR_LEVELS);
  piece->outline = isinf(gap);
}

/* Seen from the side a line on a surface is foreshortened. */
static uint32_t border_level(const struct mesh_picture *picture, const struct mesh_side *side) {
  double towards = 0.0;
  if (hairline_width(picture) < thinnest_hairline) return 0;
  for (int k = 0; k < 2; ++k) {
    const double *const normal = picture->mesh->normals + 3 * (size_t)(k == 0 ? side->low : side->high);
    towards += fabs(dot(picture->view->axis[2], normal)) / 2.0;
  }
  const double *const from = picture->parts.seen + 3 * (size_t)side->low;
  const double *const to = picture->parts.seen + 3 * (size_t)side->high;
  const double along[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  const double on_page = along[0] * along[0] + along[1] * along[1];
  const double seen = sqrt(on_page / (on_page + along[2] * along[2]));
  const double share = (fmin(towards / seen, 1.0) - steepest) / (flattest - steepest);
  return share > 0.0 ? level_of(share, BORDER_LEVELS) : 0;
}

static void add_edge_between(struct painted_edges *edges, const double points[2][2], struct span span, uint32_t paint) {
  struct painted_edge edge = {.layer = 0, .paint = paint};
  for (int axis = 0; axis < 2; ++axis) {
    const double at = points[0][axis], along = points[1][axis] - at;
    edge.from[axis] = mesh_rounded(at + span.from * along);
    edge.to[axis] = mesh_rounded(at + span.to * along);
  }
  painted_edges_add(edges, &edge);
}

/* A contour moved outwards by `aside` from its surface. */
static struct seen_line outside_of(const struct seen_line *line, double aside) {
  const double along[2] = {(double)line->at[1][0] - line->at[0][0], (double)line->at[1][1] - line->at[0][1]};
  const double part = aside / sqrt(along[0] * along[0] + along[1] * along[1]);
  struct seen_line outside = *line;
  for (int end = 0; end < 2; ++end) {
    outside.at[end][0] -= mesh_rounded(part * along[1]);
    outside.at[end][1] += mesh_rounded(part * along[0]);
  }
  return outside;
}

static bool is_concave(const struct mesh_picture *picture, uint32_t triangle) {
  return picture->mesh->kinds[triangle] == HSP_PATCH_CONCAVE;
}

/* The paint of the area that ends with a contour, for the visible side, if the area is of a sphere; else 0. A ball has
 * a contour if it is seen from outside; a concave patch, if it is seen from inside; and the edge between two concave
 * patches, if it is seen from outside. */
static uint32_t contour_paint(const struct mesh_picture *picture, const struct seen_line *line) {
  const struct triangle_mesh *const mesh = picture->mesh;
  const bool one = mesh->patches[line->beside[0]] == mesh->patches[line->beside[1]];
  const bool concave[2] = {is_concave(picture, line->beside[0]), is_concave(picture, line->beside[1])};
  if (!one && !(concave[0] && concave[1])) return 0;
  const bool outside = !one || !concave[0];
  const uint32_t triangle = line->beside[picture->faces[line->beside[0]] == outside ? 0 : 1];
  return mesh_is_of_sphere(picture, triangle) ? mesh_sphere_paint(picture, triangle, mesh_side_of(picture, triangle))
                                              : 0;
}

/* The share at which an edge crosses a line, from the shares at which it crosses the line moved aside, and moved twice
 * as far, if it crosses both. */
static double crossing(double aside, double twice) {
  const bool crosses = aside > 0.0 && aside < 1.0 && twice > 0.0 && twice < 1.0;
  return crosses ? fmin(fmax(2.0 * aside - twice, 0.0), 1.0) : aside;
}

/* Find the spans of a contour that no other surface than its own hides. Its own surface is edge-on there and made of
 * flat triangles, and so lies before it in places. Therefore the spans are found on a line beside the contour. If this
 * is crossed at a small angle, the crossing is far from that of the contour: a second line corrects it. */
enum { MOST_SPANS = 4 }; /* an edge is short; with more spans their ends are not corrected */
static bool find_seen_of_contour(struct hidden_lines *hidden, const struct seen_line *line) {
  struct span aside[MOST_SPANS];
  const struct seen_line near = outside_of(line, own_surface), far = outside_of(line, 2.0 * own_surface);
  bool crossed = false;
  if (!hidden_lines_find_seen(hidden, &near)) return false;
  const size_t spans = hidden->spans;
  if (spans > MOST_SPANS) return true;
  for (size_t i = 0; i < spans; ++i) {
    aside[i] = hidden->span[i];
    crossed = crossed || aside[i].from > 0.0 || aside[i].to < 1.0;
  }
  if (!crossed) return true;
  if (!hidden_lines_find_seen(hidden, &far)) return false;
  const bool same = hidden->spans == spans;
  hidden->spans = 0;
  for (size_t i = 0; i < spans; ++i) {
    const struct span twice = same ? hidden->span[i] : aside[i];
    const struct span span = {crossing(aside[i].from, twice.from), crossing(aside[i].to, twice.to)};
    if (span.from < span.to) hidden->span[hidden->spans++] = span;
  }
  return true;
}

/* Note the ends of a contour that are not ends of its visible spans: there it goes on hidden. */
static void add_hidden_ends(struct line_search *search, const struct seen_line *line) {
  const struct span *const span = search->hidden.span;
  const size_t spans = search->hidden.spans;
  const bool seen[2] = {spans > 0 && span[0].from == 0.0, spans > 0 && span[spans - 1].to == 1.0};
  for (int end = 0; end < 2; ++end) {
    const struct contour_piece piece = {.vertex = {line->vertex[end], NO_CONTOUR_VERTEX}, .goes_on = true};
    if (!seen[end]) contour_pieces_add(&search->contours, &piece);
  }
}

/* Set the patch of a contour at its ends, if most of it is visible; a contour that is hidden near an end may count,
 * too. */
static void set_nearer(const struct mesh_picture *picture, const struct line_search *search,
                       const struct seen_line *line) {
  double seen = 0.0;
  for (size_t i = 0; i < search->hidden.spans; ++i) seen += search->hidden.span[i].to - search->hidden.span[i].from;
  for (int end = 0; end < 2 && seen > 0.5; ++end) {
    search->nearer[line->vertex[end]] = picture->mesh->patches[line->beside[0]];
  }
}

/* The part of a line behind the plane. False if there is none. */
static bool find_behind(const struct seen_line *line, double plane, double range[2]) {
  const bool behind[2] = {line->depth[0] <= plane, line->depth[1] <= plane};
  if (!behind[0] && !behind[1]) return false;
  range[0] = behind[0] ? 0.0 : share_at(line, plane);
  range[1] = behind[1] ? 1.0 : share_at(line, plane);
  return true;
}

/* The part of a span within a range; empty unless `from` is less than `to`. */
static struct span clipped(struct span span, const double range[2]) {
  return (struct span){fmax(span.from, range[0]), fmin(span.to, range[1])};
}

/* The seen part of a line behind the plane. paint: or 0 of a contour, whose paint depends on where. */
static bool add_line(struct mesh_picture *picture, struct line_search *search, const struct seen_line *line,
                     double plane, uint32_t paint) {
  const struct hidden_lines *const hidden = &search->hidden;
  const double ends[2][2] = {{line->at[0][0], line->at[0][1]}, {line->at[1][0], line->at[1][1]}};
  double range[2];
  if (!find_behind(line, plane, range)) return true;
  const bool enough =
      paint == 0 ? find_seen_of_contour(&search->hidden, line) : hidden_lines_find_seen(&search->hidden, line);
  if (!enough) return false;
  if (paint == 0) add_hidden_ends(search, line);
  if (paint == 0) set_nearer(picture, search, line);
  for (size_t i = 0; i < hidden->spans; ++i) {
    const struct span span = clipped(hidden->span[i], range);
    if (span.from >= span.to) continue;
    if (paint > 0) {
      add_edge_between(&picture->lines, ends, span, paint);
      continue;
    }
    struct contour_piece piece = {.vertex = {span.from > 0.0 ? NO_CONTOUR_VERTEX : line->vertex[0],
                                             span.to < 1.0 ? NO_CONTOUR_VERTEX : line->vertex[1]}};
    set_level(picture, hidden, line, span, &piece);
    piece.paint = contour_paint(picture, line);
    for (int k = 0; k < 4; ++k) {
      const int axis = k % 2;
      piece.at[k / 2][axis] = ends[0][axis] + (k < 2 ? span.from : span.to) * (ends[1][axis] - ends[0][axis]);
    }
    contour_pieces_add(&search->contours, &piece);
  }
  return true;
}

/* Give the area of a contour a line, as beside creases, if the contour has no line or hardly one: otherwise areas of
 * farther triangles extend over its edge in places. At an end where the contour's own line begins, the edge of this
 * line is that of the area. drawn [vertices]: whether a contour with a line ends there. */
static void add_area_line(struct mesh_picture *picture, const struct contour_piece *piece, const bool *drawn) {
  const double along[2] = {piece->at[1][0] - piece->at[0][0], piece->at[1][1] - piece->at[0][1]};
  const double length = contour_piece_length(piece);
  double line[2][2];
  for (int end = 0; end < 2; ++end) {
    const bool meets = piece->vertex[end] != NO_CONTOUR_VERTEX && drawn[piece->vertex[end]];
    const double by = meets && length > 0.0 ? (CREASE_LINE - AREA_LINE) / 2.0 / length : 0.0;
    line[end][0] = piece->at[end][0] + by * along[1];
    line[end][1] = piece->at[end][1] - by * along[0];
  }
  add_edge_between(&picture->creases, (const double(*)[2])line, (struct span){0.0, 1.0}, piece->paint);
}

/* Add contours in parts, each of one level. */
static bool add_contours(struct mesh_picture *picture, const struct contour_pieces *contours, double slope) {
  bool *const drawn = calloc((size_t)picture->mesh->vertices + 1, sizeof *drawn);
  if (drawn == NULL) return false;
  for (size_t i = 0; i < 2 * contours->count; ++i) {
    const struct contour_piece *const piece = &contours->piece[i / 2];
    const uint32_t vertex = piece->vertex[i % 2];
    if (piece->level > least_level && vertex != NO_CONTOUR_VERTEX) drawn[vertex] = true;
  }
  for (size_t i = 0; i < contours->count; ++i) {
    const struct contour_piece *const piece = &contours->piece[i];
    if (piece->level <= least_level && piece->paint > 0) add_area_line(picture, piece, drawn);
    const double steps = ceil(slope * contour_piece_length(piece));
    const double *const most = piece->most;
    const uint32_t parts = piece->level > fmin(most[0], most[1]) && steps > 1.0 ? (uint32_t)steps : 1;
    for (uint32_t part = 0; part < parts && piece->level > 0.0; ++part) {
      const struct span span = {(double)part / parts, (part + 1.0) / parts};
      const uint32_t level = (uint32_t)(contour_piece_level(piece, slope, span.from / 2.0 + span.to / 2.0) + 0.5);
      add_edge_between(&picture->lines, (const double(*)[2])piece->at, span,
                       (piece->outline && picture->view->dark ? FIRST_OUTLINE : FIRST_CONTOUR) +
                           (level > THINNEST_LEVEL ? level : THINNEST_LEVEL));
    }
  }
  free(drawn);
  return true;
}

/* The paint of a line between two triangles that show the same side; 0: there is no line. */
static uint32_t border_paint(const struct mesh_picture *picture, const struct mesh_side *side) {
  int pocket[2], seen_as[2];
  for (int k = 0; k < 2; ++k) {
    const uint32_t triangle = side[k].triangle;
    seen_as[k] = mesh_side_of(picture, triangle);
    pocket[k] = mesh_pocket_of(seen_as[k]);
  }
  if (pocket[0] != pocket[1] && pocket[0] > 0 && pocket[1] > 0) return FIRST_CONTOUR + CONTOUR_LEVELS;
  if (pocket[0] != pocket[1]) {
    const bool first = pocket[1] == 0 || (pocket[0] != 0 && pocket[0] < pocket[1]);
    return FIRST_RIM + (uint32_t)pocket[first ? 0 : 1];
  }
  if (picture->mesh->patches[side[0].triangle] == picture->mesh->patches[side[1].triangle]) return 0;
  const bool concave = is_concave(picture, side[0].triangle) && is_concave(picture, side[1].triangle);
  if (concave && mesh_is_of_sphere(picture, side[0].triangle)) return 0;
  const uint32_t level = border_level(picture, side);
  return level > 0 ? FIRST_BORDER + level : 0;
}

static uint32_t colour_at(struct mesh_picture *picture, uint32_t triangle) {
  const bool convex = picture->mesh->kinds[triangle] == HSP_PATCH_CONVEX;
  return mesh_colour_of(picture, convex ? picture->mesh->balls[triangle] : BETWEEN_ATOMS,
                        mesh_side_of(picture, triangle));
}

/* Whether an edge is a crease: two patches of spheres meet there, or two colours one of which is a sphere's. There it
 * is visible which one extends over the other. */
static bool is_crease(struct mesh_picture *picture, const struct mesh_side *side) {
  const uint32_t triangle[2] = {side[0].triangle, side[1].triangle};
  if (picture->mesh->patches[triangle[0]] == picture->mesh->patches[triangle[1]]) return false;
  const int spheres = mesh_is_of_sphere(picture, triangle[0]) + mesh_is_of_sphere(picture, triangle[1]);
  return spheres == 2 || (spheres == 1 && colour_at(picture, triangle[0]) != colour_at(picture, triangle[1]));
}

/* An edge of a crease, with the patch with the lower number on the side that struct crease has it on: on the other one
 * of inner sides, which are seen the other way round. */
static struct seen_line crease_line(const struct mesh_picture *picture, const struct mesh_side *side) {
  const struct seen_line line = line_of(picture, side);
  const bool first = picture->mesh->patches[side[0].triangle] < picture->mesh->patches[side[1].triangle];
  if (first == picture->faces[side->triangle]) return line;
  struct seen_line turned = line;
  for (int end = 0; end < 2; ++end) {
    memcpy(turned.at[end], line.at[1 - end], sizeof turned.at[end]);
    turned.depth[end] = line.depth[1 - end];
    turned.vertex[end] = line.vertex[1 - end];
  }
  return turned;
}

/* Whether one triangle beside an edge of a crease is. */
static bool is_painted_later(const struct mesh_picture *picture, const struct mesh_side *side, int k) {
  const uint32_t own = side[k].triangle, other = side[1 - k].triangle;
  const uint32_t layer[2] = {picture->layer[own] + 1, picture->layer[other] + 1}; /* 0: not painted */
  if (layer[0] != layer[1]) return layer[0] > layer[1];
  if (!mesh_is_of_sphere(picture, own) || !mesh_is_of_sphere(picture, other)) return mesh_is_of_sphere(picture, own);
  return mesh_sphere_paint(picture, own, mesh_side_of(picture, own)) >
         mesh_sphere_paint(picture, other, mesh_side_of(picture, other));
}

/* The patch of a crease that extends over the other one is chosen when all contours are known. */
static void add_crease(const struct mesh_picture *picture, const struct mesh_side *side, size_t edge,
                       struct creases *creases) {
  const struct seen_line line = crease_line(picture, side);
  const uint32_t patch[2] = {picture->mesh->patches[side[0].triangle], picture->mesh->patches[side[1].triangle]};
  const int first = patch[0] < patch[1] ? 0 : 1;
  const bool spheres[2] = {mesh_is_of_sphere(picture, side[first].triangle),
                           mesh_is_of_sphere(picture, side[1 - first].triangle)};
  const struct crease crease = {.vertex = {line.vertex[0], line.vertex[1]},
                                .patch = {patch[first], patch[1 - first]},
                                .at = {{line.at[0][0], line.at[0][1]}, {line.at[1][0], line.at[1][1]}},
                                .painted = is_painted_later(picture, side, first) ? 0 : 1,
                                .edge = edge,
                                .known = spheres[0] != spheres[1],
                                .over = spheres[0] ? 0 : 1};
  creases_add(creases, &crease);
}

static bool add_creases(struct mesh_picture *picture, struct line_search *search, const struct mesh_side *sides) {
  const struct hidden_lines *const hidden = &search->hidden;
  const double width[2] = {CREASE_LINE, AREA_LINE};
  if (!creases_choose(&search->creases, search->nearer, picture->patch_points, width)) return false;
  for (size_t i = 0; i < search->creases.count; ++i) {
    const struct crease *const crease = &search->creases.crease[i];
    const struct mesh_side *const side = &sides[crease->edge];
    const struct seen_line line = crease_line(picture, side);
    const bool of_void = mesh_parts_is_of_void(&picture->parts, side->low);
    double range[2];
    if (crease->known && crease->painted == crease->over && border_level(picture, side) == BORDER_LEVELS) continue;
    if (!find_behind(&line, of_void ? INFINITY : picture->parts.cut, range)) continue;
    if (!hidden_lines_find_seen(&search->hidden, &line)) return false;
    const bool first = picture->mesh->patches[side[0].triangle] == crease->patch[crease->over];
    const uint32_t triangle = side[first ? 0 : 1].triangle;
    const uint32_t paint = mesh_sphere_paint(picture, triangle, mesh_side_of(picture, triangle));
    for (size_t n = 0; n < hidden->spans; ++n) {
      const struct span span = clipped(hidden->span[n], range);
      if (span.from < span.to) add_edge_between(&picture->creases, crease->line, span, paint);
    }
  }
  return true;
}

static bool is_of_contour(const struct mesh_picture *picture, const struct mesh_side *side) {
  return mesh_faces_viewer(picture, side[0].triangle) != mesh_faces_viewer(picture, side[1].triangle);
}

/* Add the lines at an edge with these two sides. */
static bool add_edge(struct mesh_picture *picture, struct line_search *search, const struct mesh_side *sides,
                     size_t edge) {
  const struct mesh_side *const side = &sides[edge];
  const bool shown[2] = {picture->shown[side[0].triangle], picture->shown[side[1].triangle]};
  const bool of_void = mesh_parts_is_of_void(&picture->parts, side->low);
  const double plane = of_void ? INFINITY : picture->parts.cut;
  if (is_of_contour(picture, side)) {
    const bool front = mesh_faces_viewer(picture, side->triangle);
    struct mesh_side turned[2] = {side[front ? 0 : 1], side[front ? 1 : 0]};
    if (of_void) turned[0].back = !turned[0].back;
    struct seen_line line = line_of(picture, turned);
    const bool any = line.at[0][0] != line.at[1][0] || line.at[0][1] != line.at[1][1];
    if (!any) search->root[mesh_parts_root(search->root, side->low)] = mesh_parts_root(search->root, side->high);
    return !any || !(shown[0] || shown[1]) || add_line(picture, search, &line, plane, 0);
  }
  if (!shown[0] || !shown[1]) return true;
  if (is_crease(picture, side)) add_crease(picture, side, edge, &search->creases);
  const uint32_t paint = border_paint(picture, side);
  if (paint == 0) return true;
  const struct seen_line line = line_of(picture, side);
  return add_line(picture, search, &line, plane, paint);
}

/* Count for each patch the points at which it is seen. */
static bool count_points(struct mesh_picture *picture, const struct seen_triangle *seen, uint32_t count) {
  const struct triangle_mesh *const mesh = picture->mesh;
  uint32_t last = 0;
  for (uint32_t t = 0; t < mesh->triangles; ++t) last = mesh->patches[t] > last ? mesh->patches[t] : last;
  picture->patch_points = calloc((size_t)last + 1, sizeof *picture->patch_points);
  for (uint32_t i = 0; i < count && picture->patch_points != NULL; ++i) {
    picture->patch_points[mesh->patches[seen[i].number]] += seen[i].points;
  }
  return picture->patch_points != NULL;
}

bool mesh_lines_find(struct mesh_picture *picture, const struct seen_triangle *seen, uint32_t count) {
  const struct triangle_mesh *mesh = picture->mesh;
  struct mesh_side *sides = mesh_sides_find(mesh);
  const double width = contour_width(picture);
  const struct contour_limits limits = {longest_dip * width, THINNEST_LEVEL, longest_gap * width,
                                        CONTOUR_LEVELS / (taper * width), shortest_end * width * CONTOUR_LEVELS};
  struct line_search search = {.contours = CONTOUR_PIECES_NONE,
                               .creases = CREASES_NONE,
                               .root = calloc((size_t)mesh->vertices + 1, sizeof *search.root),
                               .nearer = calloc((size_t)mesh->vertices + 1, sizeof *search.nearer)};
  const size_t found = 3 * (size_t)mesh->triangles;
  bool enough = hidden_lines_begin(seen, count, picture->parts.cut, &search.hidden) && sides != NULL &&
                search.root != NULL && search.nearer != NULL;
  for (uint32_t v = 0; v < mesh->vertices && enough; ++v) search.root[v] = v;
  for (uint32_t v = 0; v < mesh->vertices && enough; ++v) search.nearer[v] = NO_PATCH;
  enough = enough && count_points(picture, seen, count);
  for (size_t i = 0; enough && i + 1 < found; ++i) {
    if (mesh_sides_share_edge(&sides[i])) enough = add_edge(picture, &search, sides, i);
  }
  enough = enough && add_creases(picture, &search, sides);
  for (size_t i = 0; enough && i < 2 * search.contours.count; ++i) {
    uint32_t *const vertex = &search.contours.piece[i / 2].vertex[i % 2];
    if (*vertex != NO_CONTOUR_VERTEX) *vertex = mesh_parts_root(search.root, *vertex);
  }
  enough = enough && contour_pieces_level(&search.contours, mesh->vertices, &limits);
  enough = enough && add_contours(picture, &search.contours, limits.slope);
  hidden_lines_free(&search.hidden);
  contour_pieces_free(&search.contours);
  creases_free(&search.creases);
  free(search.root);
  free(search.nearer);
  free(sides);
  painted_edges_cancel(&picture->lines);
  painted_edges_cancel(&picture->creases);
  return enough && !picture->lines.out_of_memory && !picture->creases.out_of_memory &&
         painted_edges_drop_specks(&picture->lines, FIRST_CONTOUR, shortest_contour * width * CONTOUR_LEVELS, width) &&
         painted_edges_find_joints(&picture->lines, 0, UINT32_MAX);
}
