#include "draw/hidden_lines.h"

#include <math.h>
#include <stdlib.h>

#include "read/growing_array.h"

bool hidden_lines_begin(const struct seen_triangle *triangle, uint32_t count, double plane,
                        struct hidden_lines *lines) {
  *lines = (struct hidden_lines){.triangle = triangle, .plane = plane, .squares = MESH_SQUARES_NONE};
  return count == 0 || mesh_squares_make(triangle, count, &lines->squares);
}

void hidden_lines_free(struct hidden_lines *lines) {
  mesh_squares_free(&lines->squares);
  free(lines->span);
}

static void point_of(const struct seen_line *line, double share, double at[2]) {
  for (int axis = 0; axis < 2; ++axis) {
    at[axis] = line->at[0][axis] + share * ((double)line->at[1][axis] - line->at[0][axis]);
  }
}

/* Leaves the part where a linear function is above 0 that has these values at the ends of the whole. */
static bool keep_above(struct span *span, double at_from, double at_to) {
  if (at_from <= 0.0 && at_to <= 0.0) return false;
  if (at_from > 0.0 && at_to > 0.0) return true;
  const double share = at_from / (at_from - at_to);
  if (at_from > 0.0 && share < span->to) span->to = share;
  if (at_to > 0.0 && share > span->from) span->from = share;
  return span->from < span->to;
}

/* The part of a line that lies under a triangle; false if there is none. */
static bool find_hidden(const struct hidden_lines *lines, const struct seen_triangle *triangle,
                        const struct seen_line *line, struct span *span) {
  double end[2][2], middle[2];
  *span = (struct span){0.0, 1.0};
  for (int i = 0; i < 2; ++i) point_of(line, i, end[i]);
  for (int k = 0; k < 3; ++k) {
    const double side[2] = {seen_triangle_side(triangle, k, end[0]), seen_triangle_side(triangle, k, end[1])};
    if (!keep_above(span, side[0], side[1])) return false;
  }
  if (!triangle->whole && !keep_above(span, lines->plane - seen_triangle_depth(triangle, end[0]),
                                      lines->plane - seen_triangle_depth(triangle, end[1]))) {
    return false;
  }
  const double share = (span->from + span->to) / 2.0;
  point_of(line, share, middle);
  return seen_triangle_depth(triangle, middle) > line->depth[0] + share * (line->depth[1] - line->depth[0]);
}

static int compare(const void *left, const void *right) {
  const struct span *a = left;
  const struct span *b = right;
  if (a->from != b->from) return a->from < b->from ? -1 : 1;
  return (a->to > b->to) - (a->to < b->to);
}

/* One more than is asked for, as between n hidden parts there are n + 1 others. */
static bool make_room(struct hidden_lines *lines) {
  return array_make_room(&lines->span, lines->spans + 1, &lines->room, sizeof *lines->span);
}

/* In place: the gap before a hidden part is written where an earlier one was read, as there is one more at the end. */
static void invert(struct hidden_lines *lines) {
  double reached = 0.0;
  size_t kept = 0;
  for (size_t i = 0; i < lines->spans; ++i) {
    const struct span hidden = lines->span[i];
    if (hidden.from > reached) lines->span[kept++] = (struct span){reached, hidden.from};
    if (hidden.to > reached) reached = hidden.to;
  }
  if (reached < 1.0) lines->span[kept++] = (struct span){reached, 1.0};
  lines->spans = kept;
}

bool hidden_lines_find_seen(struct hidden_lines *lines, const struct seen_line *line) {
  const struct mesh_squares *const squares = &lines->squares;
  int32_t low[2], high[2];
  bool off = squares->met == NULL;
  lines->spans = 0;
  if (!make_room(lines)) return false;
  for (int axis = 0; axis < 2; ++axis) {
    const int32_t a = line->at[0][axis], b = line->at[1][axis];
    low[axis] = a < b ? a : b;
    high[axis] = a < b ? b : a;
    if (high[axis] < squares->low[axis] || low[axis] > squares->high[axis]) off = true;
    if (low[axis] < squares->low[axis]) low[axis] = squares->low[axis];
    if (high[axis] > squares->high[axis]) high[axis] = squares->high[axis];
  }
  struct square_range range = {{0, 0}, {0, 0}};
  if (!off) range = mesh_squares_range(squares, low, high);
  for (uint32_t y = range.from[1]; !off && y <= range.to[1]; ++y) {
    for (uint32_t x = range.from[0]; x <= range.to[0]; ++x) {
      const size_t square = (size_t)y * squares->across[0] + x;
      for (uint32_t k = squares->first[square]; k < squares->first[square + 1]; ++k) {
        const struct seen_triangle *const triangle = &lines->triangle[squares->met[k]];
        if (triangle->number == line->beside[0] || triangle->number == line->beside[1]) continue;
        struct span hidden;
        if (!find_hidden(lines, triangle, line, &hidden)) continue;
        if (!make_room(lines)) return false;
        lines->span[lines->spans++] = hidden;
      }
    }
  }
  qsort(lines->span, lines->spans, sizeof *lines->span, compare);
  invert(lines);
  return true;
}

static bool covers(const struct seen_triangle *triangle, const double at[2]) {
  for (int k = 0; k < 3; ++k) {
    if (seen_triangle_side(triangle, k, at) < 0.0) return false;
  }
  return true;
}

double hidden_lines_front(const struct hidden_lines *lines, const double at[2]) {
  const struct mesh_squares *const squares = &lines->squares;
  double front = -INFINITY;
  int32_t in[2];
  for (int axis = 0; axis < 2; ++axis) {
    in[axis] = (int32_t)floor(at[axis]);
    if (in[axis] < squares->low[axis] || in[axis] > squares->high[axis]) return front;
  }
  const struct square_range range = mesh_squares_range(squares, in, in);
  const size_t square = (size_t)range.from[1] * squares->across[0] + range.from[0];
  for (uint32_t k = squares->first[square]; k < squares->first[square + 1]; ++k) {
    const struct seen_triangle *const triangle = &lines->triangle[squares->met[k]];
    if (!covers(triangle, at)) continue;
    const double depth = seen_triangle_depth(triangle, at);
    if (depth > front && (triangle->whole || depth <= lines->plane)) front = depth;
  }
  return front;
}
