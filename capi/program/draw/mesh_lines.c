#include "draw/mesh_lines.h"

#include <math.h>
#include <stdlib.h>

#include "draw/hidden_lines.h"

/* Units. */
static const double hairline_per_unit = 0.0055, thinnest_hairline = 1.2, widest_hairline = 5.0;
static const double contour_per_unit = 0.008, thinnest_contour = 6.0, widest_contour = 14.0;

double mesh_line_width(const struct mesh_picture *picture, uint32_t paint) {
  const double scale = picture->frame.scale;
  if (paint == BORDERS)
    return hairline_per_unit * scale < widest_hairline ? hairline_per_unit * scale : widest_hairline;
  const double width = thinnest_contour + contour_per_unit * scale;
  return width < widest_contour ? width : widest_contour;
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

/* What is seen of a line behind the plane. */
static bool add_line(struct mesh_picture *picture, struct hidden_lines *hidden, const struct seen_line *line,
                     double plane, uint32_t paint) {
  const bool behind[2] = {line->depth[0] <= plane, line->depth[1] <= plane};
  if (!behind[0] && !behind[1]) return true;
  const double first = behind[0] ? 0.0 : share_at(line, plane), last = behind[1] ? 1.0 : share_at(line, plane);
  if (!hidden_lines_find_seen(hidden, line)) return false;
  for (size_t i = 0; i < hidden->spans; ++i) {
    struct painted_edge edge = {.layer = 0, .paint = paint};
    const double from = hidden->span[i].from > first ? hidden->span[i].from : first;
    const double to = hidden->span[i].to < last ? hidden->span[i].to : last;
    if (from >= to) continue;
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
    /* The front is left of it. */
    const struct side turned[2] = {side[front[0] ? 0 : 1], side[front[0] ? 1 : 0]};
    const struct seen_line line = line_of(picture, turned);
    return !(shown[0] || shown[1]) || add_line(picture, hidden, &line, plane, CONTOURS);
  }
  if (!shown[0] || !shown[1] || picture->mesh->patches[t[0]] == picture->mesh->patches[t[1]]) return true;
  if (mesh_line_width(picture, BORDERS) < thinnest_hairline) return true;
  const struct seen_line line = line_of(picture, side);
  return add_line(picture, hidden, &line, plane, BORDERS);
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
  return enough && !picture->lines.out_of_memory && painted_edges_find_joints(&picture->lines, BORDERS, CONTOURS + 1);
}
