#include "draw/mesh_lines.h"

#include <math.h>
#include <stdlib.h>

#include "draw/hidden_lines.h"

/* Shares of the mean radius on the page, and tenths of a px. */
static const double hairline_share = 0.0033, thinnest_hairline = 2.0, widest_hairline = 5.0;
static const double contour_share = 0.0048, thinnest_contour = 6.0, widest_contour = 14.0;

/* Before a gap of so many mean radii contours have their full width. */
static const double full_gap = 3.0;

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

/* Of the part of a contour, with its surface on the left, by the least gap just outside its line: as in contours of
 * balls (ink.hpp) widths grow with the power 5/8 of the gap in mean radii. */
static uint32_t contour_level(const struct mesh_picture *picture, const struct hidden_lines *hidden,
                              const struct seen_line *line, double from, double to) {
  const double along[2] = {(double)line->at[1][0] - line->at[0][0], (double)line->at[1][1] - line->at[0][1]};
  const double length = sqrt(along[0] * along[0] + along[1] * along[1]);
  const double outside = contour_width(picture) / 2.0 / length;
  const double full = full_gap * picture->mean_radius;
  double gap = full;
  for (int half = 0; half <= 2; ++half) {
    const double share = from + (to - from) * half / 2.0;
    const double at[2] = {line->at[0][0] + share * along[0] - outside * along[1],
                          line->at[0][1] + share * along[1] + outside * along[0]};
    gap = fmin(gap, line->depth[0] + share * (line->depth[1] - line->depth[0]) - hidden_lines_front(hidden, at));
  }
  const double root = sqrt(fmax(gap, 0.0) / full);
  return level_of(root * sqrt(sqrt(root)), CONTOUR_LEVELS);
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

/* The seen part of a line behind the plane. border: its level, or 0 of a contour. */
static bool add_line(struct mesh_picture *picture, struct hidden_lines *hidden, const struct seen_line *line,
                     double plane, uint32_t border) {
  const bool behind[2] = {line->depth[0] <= plane, line->depth[1] <= plane};
  if (!behind[0] && !behind[1]) return true;
  const double first = behind[0] ? 0.0 : share_at(line, plane), last = behind[1] ? 1.0 : share_at(line, plane);
  if (!hidden_lines_find_seen(hidden, line)) return false;
  for (size_t i = 0; i < hidden->spans; ++i) {
    const double from = hidden->span[i].from > first ? hidden->span[i].from : first;
    const double to = hidden->span[i].to < last ? hidden->span[i].to : last;
    if (from >= to) continue;
    const uint32_t contour = border > 0 ? 0 : contour_level(picture, hidden, line, from, to);
    if (border == 0 && contour == 0) continue;
    struct painted_edge edge = {.layer = 0, .paint = border > 0 ? FIRST_BORDER + border : FIRST_CONTOUR + contour};
    for (int axis = 0; axis < 2; ++axis) {
      const double at = line->at[0][axis], along = (double)line->at[1][axis] - at;
      edge.from[axis] = mesh_rounded(at + from * along);
      edge.to[axis] = mesh_rounded(at + to * along);
    }
    painted_edges_add(&picture->lines, &edge);
  }
  return true;
}

/* Of two sides of one edge. */
static bool add_edge(struct mesh_picture *picture, struct hidden_lines *hidden, const struct side *side) {
  const uint32_t t[2] = {side[0].triangle, side[1].triangle};
  const bool shown[2] = {picture->shown[t[0]], picture->shown[t[1]]};
  const bool front[2] = {mesh_faces_viewer(picture, t[0]), mesh_faces_viewer(picture, t[1])};
  const bool of_void = mesh_parts_is_of_void(&picture->parts, side->low);
  const double plane = of_void ? INFINITY : picture->parts.cut;
  if (front[0] != front[1]) {
    struct side turned[2] = {side[front[0] ? 0 : 1], side[front[0] ? 1 : 0]};
    if (of_void) turned[0].back = !turned[0].back;
    const struct seen_line line = line_of(picture, turned);
    const bool any = line.at[0][0] != line.at[1][0] || line.at[0][1] != line.at[1][1];
    return !any || !(shown[0] || shown[1]) || add_line(picture, hidden, &line, plane, 0);
  }
  if (!shown[0] || !shown[1] || picture->mesh->patches[t[0]] == picture->mesh->patches[t[1]]) return true;
  const uint32_t level = border_level(picture, side);
  if (level == 0 || hairline_width(picture) < thinnest_hairline) return true;
  const struct seen_line line = line_of(picture, side);
  return add_line(picture, hidden, &line, plane, level);
}

bool mesh_lines_find(struct mesh_picture *picture, const struct seen_triangle *seen, uint32_t count) {
  const struct triangle_mesh *mesh = picture->mesh;
  struct side *sides = calloc((size_t)mesh->triangles + 1, 3 * sizeof *sides);
  struct hidden_lines hidden;
  size_t found = 0;
  bool enough = hidden_lines_begin(seen, count, picture->parts.cut, &hidden) && sides != NULL;
  for (uint32_t t = 0; enough && t < mesh->triangles; ++t) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t from = mesh->corners[3 * (size_t)t + k], to = mesh->corners[3 * (size_t)t + (k + 1) % 3];
      sides[found++] = (struct side){from < to ? from : to, from < to ? to : from, t, from > to};
    }
  }
  if (enough) qsort(sides, found, sizeof *sides, compare_sides);
  for (size_t i = 0; enough && i + 1 < found; ++i) {
    if (sides[i].low != sides[i + 1].low || sides[i].high != sides[i + 1].high) continue;
    enough = add_edge(picture, &hidden, &sides[i]);
  }
  hidden_lines_free(&hidden);
  free(sides);
  painted_edges_cancel(&picture->lines);
  return enough && !picture->lines.out_of_memory && painted_edges_find_joints(&picture->lines, 0, UINT32_MAX);
}
