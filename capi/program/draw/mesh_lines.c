#include "draw/mesh_lines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/hidden_lines.h"

/* Shares of the mean radius on the page, and tenths of a px. */
static const double hairline_share = 0.0033, thinnest_hairline = 2.0, widest_hairline = 5.0;
static const double contour_share = 0.0048, thinnest_contour = 6.0, widest_contour = 14.0;

/* Before a gap of so many mean radii contours have their full width. */
static const double full_gap = 3.0;

/* A contour beside which a strip is seen that is no wider than that, before a gap so many times as large, doubles the
 * contour of the strip. In widths. */
static const double narrowest_strip = 3.0, larger_gap = 4.0;

/* Contours that end alone are specks if they are no more than a line of full width as long as so many widths. */
static const double shortest_contour = 12.0;

/* So much of a hairline's full width has one on what is seen from straight above. */
static const double steepness = 2.0;

static double hairline_width(const struct mesh_picture *picture) {
  const double width = hairline_share * picture->mean_radius * picture->frame.scale;
  return width < widest_hairline ? width : widest_hairline;
}

static double contour_width(const struct mesh_picture *picture) {
  const double width = thinnest_contour + contour_share * picture->mean_radius * picture->frame.scale;
  return width < widest_contour ? width : widest_contour;
}

double mesh_line_width(const struct mesh_picture *picture, uint32_t paint) {
  if (paint >= FIRST_CONTOUR) return contour_width(picture) * (paint - FIRST_CONTOUR) / CONTOUR_LEVELS;
  if (paint >= FIRST_RIM) return contour_width(picture);
  return hairline_width(picture) * (paint - FIRST_BORDER) / BORDER_LEVELS;
}

static uint32_t level_of(double share, uint32_t levels) {
  return share < 1.0 ? (uint32_t)(share * levels + 0.5) : levels;
}

/* Of a triangle, in the direction in which it is counter-clockwise on the page, or `back`. */
struct side {
  uint32_t low, high, triangle;
  bool back;
};

/* Of a vertex the edges of contours that meet there, and where the other ends of the first two are. */
struct contour_corner {
  uint32_t edges;
  double at[2][2];
};

static int compare_sides(const void *left, const void *right) {
  const struct side *a = left;
  const struct side *b = right;
  if (a->low != b->low) return a->low < b->low ? -1 : 1;
  if (a->high != b->high) return a->high < b->high ? -1 : 1;
  return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* The ends of an edge, in the direction of the first side. */
static struct seen_line line_of(const struct mesh_picture *picture, const struct side *side) {
  struct seen_line line = {.beside = {side[0].triangle, side[1].triangle}};
  for (int k = 0; k < 2; ++k) {
    const uint32_t vertex = (k == 0) != side->back ? side->low : side->high;
    const double *const at = picture->parts.seen + 3 * (size_t)vertex;
    mesh_place(&picture->frame, at, line.at[k]);
    line.depth[k] = at[2];
  }
  return line;
}

/* The share of a line at which it goes through the plane of the cut. */
static double share_at(const struct seen_line *line, double plane) {
  return (plane - line->depth[0]) / (line->depth[1] - line->depth[0]);
}

/* From a point of a line, with the surface on the left, to what is seen so far outside. */
static double gap_outside(const struct mesh_picture *picture, const struct hidden_lines *hidden,
                          const struct seen_line *line, double share, double outside) {
  const double along[2] = {(double)line->at[1][0] - line->at[0][0], (double)line->at[1][1] - line->at[0][1]};
  const double part = outside / sqrt(along[0] * along[0] + along[1] * along[1]);
  const double at[2] = {line->at[0][0] + share * along[0] - part * along[1],
                        line->at[0][1] + share * along[1] + part * along[0]};
  const double gap = line->depth[0] + share * (line->depth[1] - line->depth[0]) - hidden_lines_front(hidden, at);
  return fmin(fmax(gap, 0.0), full_gap * picture->mean_radius);
}

/* Whether beside a point of a line what is behind it ends. A surface that falls off does so step by step. */
static bool has_strip(const struct mesh_picture *picture, const struct hidden_lines *hidden,
                      const struct seen_line *line, double share) {
  const double step = contour_width(picture) / 2.0;
  double before = gap_outside(picture, hidden, line, share, step);
  for (int k = 2; k <= 2.0 * narrowest_strip; ++k) {
    const double gap = gap_outside(picture, hidden, line, share, k * step);
    if (gap > larger_gap * before) return true;
    before = gap;
  }
  return false;
}

/* Of the part of a contour, by the least gap just outside its line: as in contours of balls (ink.hpp) widths grow with
 * the power 5/8 of the gap in mean radii. 0 where it doubles another one. */
static uint32_t contour_level(const struct mesh_picture *picture, const struct hidden_lines *hidden,
                              const struct seen_line *line, double from, double to) {
  const double full = full_gap * picture->mean_radius;
  double gap = full;
  bool doubles = true;
  for (int half = 0; half <= 2; ++half) {
    const double share = from + (to - from) * half / 2.0;
    gap = fmin(gap, gap_outside(picture, hidden, line, share, contour_width(picture) / 2.0));
    doubles = doubles && has_strip(picture, hidden, line, share);
  }
  const double root = sqrt(gap / full);
  return doubles ? 0 : level_of(root * sqrt(sqrt(root)), CONTOUR_LEVELS);
}

/* Seen from the side a line on a surface is foreshortened. */
static uint32_t border_level(const struct mesh_picture *picture, const struct side *side) {
  double towards = 0.0;
  for (int k = 0; k < 2; ++k) {
    const double *const normal = picture->mesh->normals + 3 * (size_t)(k == 0 ? side->low : side->high);
    towards += fabs(mesh_dot(picture->view->axis[2], normal)) / 2.0;
  }
  return level_of(steepness * towards, BORDER_LEVELS);
}

/* The seen part of a line behind the plane, painted between two points of the page. paint: or 0 of a contour, whose
 * paint depends on where. */
static bool add_line(struct mesh_picture *picture, struct hidden_lines *hidden, const struct seen_line *line,
                     double points[2][2], double plane, uint32_t paint) {
  const bool behind[2] = {line->depth[0] <= plane, line->depth[1] <= plane};
  if (!behind[0] && !behind[1]) return true;
  const double first = behind[0] ? 0.0 : share_at(line, plane), last = behind[1] ? 1.0 : share_at(line, plane);
  if (!hidden_lines_find_seen(hidden, line)) return false;
  for (size_t i = 0; i < hidden->spans; ++i) {
    const double from = hidden->span[i].from > first ? hidden->span[i].from : first;
    const double to = hidden->span[i].to < last ? hidden->span[i].to : last;
    if (from >= to) continue;
    const uint32_t contour = paint > 0 ? 0 : contour_level(picture, hidden, line, from, to);
    if (paint == 0 && contour == 0) continue;
    struct painted_edge edge = {.layer = 0, .paint = paint > 0 ? paint : FIRST_CONTOUR + contour};
    for (int axis = 0; axis < 2; ++axis) {
      const double at = points[0][axis], along = points[1][axis] - at;
      edge.from[axis] = mesh_rounded(at + from * along);
      edge.to[axis] = mesh_rounded(at + to * along);
    }
    painted_edges_add(&picture->lines, &edge);
  }
  return true;
}

/* The paint of a line between two triangles of which the same side is seen; 0: there is none. */
static uint32_t border_paint(const struct mesh_picture *picture, const struct side *side) {
  int pocket[2];
  for (int k = 0; k < 2; ++k) {
    const uint32_t triangle = side[k].triangle;
    pocket[k] = mesh_pocket_of(mesh_side_of(picture, triangle, mesh_seen_area(picture, triangle)));
  }
  if (pocket[0] != pocket[1]) {
    const bool first = pocket[1] == 0 || (pocket[0] != 0 && pocket[0] < pocket[1]);
    return FIRST_RIM + (uint32_t)pocket[first ? 0 : 1];
  }
  if (picture->mesh->patches[side[0].triangle] == picture->mesh->patches[side[1].triangle]) return 0;
  const uint32_t level = hairline_width(picture) < thinnest_hairline ? 0 : border_level(picture, side);
  return level > 0 ? FIRST_BORDER + level : 0;
}

static bool is_edge(const struct side *side) {
  return side[0].low == side[1].low && side[0].high == side[1].high;
}

static bool is_of_contour(const struct mesh_picture *picture, const struct side *side) {
  return mesh_faces_viewer(picture, side[0].triangle) != mesh_faces_viewer(picture, side[1].triangle);
}

/* Of two sides of one edge. smooth: where its ends are on contours. */
static bool add_edge(struct mesh_picture *picture, struct hidden_lines *hidden, const struct side *side,
                     const double (*smooth)[2]) {
  const bool shown[2] = {picture->shown[side[0].triangle], picture->shown[side[1].triangle]};
  const bool of_void = mesh_parts_is_of_void(&picture->parts, side->low);
  const double plane = of_void ? INFINITY : picture->parts.cut;
  double points[2][2];
  if (is_of_contour(picture, side)) {
    const bool front = mesh_faces_viewer(picture, side->triangle);
    struct side turned[2] = {side[front ? 0 : 1], side[front ? 1 : 0]};
    if (of_void) turned[0].back = !turned[0].back;
    const struct seen_line line = line_of(picture, turned);
    const bool any = line.at[0][0] != line.at[1][0] || line.at[0][1] != line.at[1][1];
    for (int k = 0; k < 2; ++k) {
      memcpy(points[k], smooth[(k == 0) != turned[0].back ? side->low : side->high], sizeof points[k]);
    }
    return !any || !(shown[0] || shown[1]) || add_line(picture, hidden, &line, points, plane, 0);
  }
  const uint32_t paint = shown[0] && shown[1] ? border_paint(picture, side) : 0;
  if (paint == 0) return true;
  const struct seen_line line = line_of(picture, side);
  for (int k = 0; k < 4; ++k) points[k / 2][k % 2] = line.at[k / 2][k % 2];
  return add_line(picture, hidden, &line, points, plane, paint);
}

/* Contours follow edges of triangles to and fro: the mean of each vertex and its two neighbours along a contour takes
 * that away, and a step back from another mean what the first one has taken from curves. Corners of more than 90
 * degrees stay, which are cusps, where contours end. smooth, corner: [vertices]. */
static void smooth_contours(const struct mesh_picture *picture, const struct side *sides, size_t count,
                            double (*smooth)[2], struct contour_corner *corner) {
  const uint32_t vertices = picture->mesh->vertices;
  for (uint32_t v = 0; v < vertices; ++v) {
    int32_t at[2];
    mesh_place(&picture->frame, picture->parts.seen + 3 * (size_t)v, at);
    for (int axis = 0; axis < 2; ++axis) smooth[v][axis] = at[axis];
  }
  for (int pass = 0; pass < 2; ++pass) {
    memset(corner, 0, vertices * sizeof *corner);
    for (size_t i = 0; i + 1 < count; ++i) {
      if (!is_edge(&sides[i]) || !is_of_contour(picture, &sides[i])) continue;
      for (int k = 0; k < 2; ++k) {
        struct contour_corner *const own = &corner[k == 0 ? sides[i].low : sides[i].high];
        if (own->edges < 2) memcpy(own->at[own->edges], smooth[k == 0 ? sides[i].high : sides[i].low], sizeof *smooth);
        ++own->edges;
      }
    }
    for (uint32_t v = 0; v < vertices; ++v) {
      const double(*ends)[2] = (const double(*)[2])corner[v].at;
      double *const at = smooth[v];
      if (corner[v].edges != 2) continue;
      if ((at[0] - ends[0][0]) * (ends[1][0] - at[0]) + (at[1] - ends[0][1]) * (ends[1][1] - at[1]) <= 0.0) continue;
      for (int axis = 0; axis < 2; ++axis) {
        const double away = ends[0][axis] / 2.0 + ends[1][axis] / 2.0 - at[axis];
        at[axis] += (pass == 0 ? 0.5 : -0.5) * away;
      }
    }
  }
}

bool mesh_lines_find(struct mesh_picture *picture, const struct seen_triangle *seen, uint32_t count) {
  const struct triangle_mesh *mesh = picture->mesh;
  struct side *sides = calloc((size_t)mesh->triangles + 1, 3 * sizeof *sides);
  double(*smooth)[2] = calloc((size_t)mesh->vertices + 1, sizeof *smooth);
  struct contour_corner *corner = calloc((size_t)mesh->vertices + 1, sizeof *corner);
  const double width = contour_width(picture);
  struct hidden_lines hidden;
  size_t found = 0;
  bool enough =
      hidden_lines_begin(seen, count, picture->parts.cut, &hidden) && sides != NULL && smooth != NULL && corner != NULL;
  for (uint32_t t = 0; enough && t < mesh->triangles; ++t) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t from = mesh->corners[3 * (size_t)t + k], to = mesh->corners[3 * (size_t)t + (k + 1) % 3];
      sides[found++] = (struct side){from < to ? from : to, from < to ? to : from, t, from > to};
    }
  }
  if (enough) qsort(sides, found, sizeof *sides, compare_sides);
  if (enough) smooth_contours(picture, sides, found, smooth, corner);
  for (size_t i = 0; enough && i + 1 < found; ++i) {
    if (is_edge(&sides[i])) enough = add_edge(picture, &hidden, &sides[i], (const double(*)[2])smooth);
  }
  hidden_lines_free(&hidden);
  free(sides);
  free(smooth);
  free(corner);
  painted_edges_cancel(&picture->lines);
  return enough && !picture->lines.out_of_memory &&
         painted_edges_drop_specks(&picture->lines, FIRST_CONTOUR, shortest_contour * width * CONTOUR_LEVELS, width) &&
         painted_edges_find_joints(&picture->lines, 0, UINT32_MAX);
}
