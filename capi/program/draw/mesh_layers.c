#include "draw/mesh_layers.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

static double middle_of(const struct seen_triangle *triangle) {
  return (triangle->depth[0] + triangle->depth[1] + triangle->depth[2]) / 3.0;
}

static int compare(const void *left, const void *right) {
  const struct seen_triangle *a = left;
  const struct seen_triangle *b = right;
  const double depth[2] = {middle_of(a), middle_of(b)};
  if (depth[0] != depth[1]) return depth[0] < depth[1] ? -1 : 1;
  return (a->number > b->number) - (a->number < b->number);
}

/* Twice the area, below 0 if it is clockwise. */
static double area_of(const struct seen_triangle *a) {
  return (double)(a->at[1][0] - a->at[0][0]) * (a->at[2][1] - a->at[0][1]) -
         (double)(a->at[1][1] - a->at[0][1]) * (a->at[2][0] - a->at[0][0]);
}

/* Whether an edge of a has all of b on its outer side; turn: +1 if a is counter-clockwise, else -1. */
static bool separates(const struct seen_triangle *a, const struct seen_triangle *b, double slack) {
  const double turn = area_of(a) < 0.0 ? -1.0 : 1.0;
  for (int k = 0; k < 3; ++k) {
    const int32_t *from = a->at[k];
    const int32_t *to = a->at[(k + 1) % 3];
    const double dx = to[0] - from[0], dy = to[1] - from[1];
    const double most = slack * sqrt(dx * dx + dy * dy);
    bool outside = true;
    for (int i = 0; i < 3 && outside; ++i) {
      outside = turn * (dx * (b->at[i][1] - from[1]) - dy * (b->at[i][0] - from[0])) <= most;
    }
    if (outside) return true;
  }
  return false;
}

static bool overlap(const struct seen_triangle *a, const struct seen_triangle *b, double slack) {
  return !separates(a, b, slack) && !separates(b, a, slack);
}

enum { MOST_POINTS = 9 };

/* How far on its inner side of the k-th edge of a triangle a point lies, times the edge's length. */
static double side_of(const struct seen_triangle *triangle, int k, const double at[2]) {
  const int32_t *from = triangle->at[k];
  const int32_t *to = triangle->at[(k + 1) % 3];
  const double side = ((double)to[0] - from[0]) * (at[1] - from[1]) - ((double)to[1] - from[1]) * (at[0] - from[0]);
  return area_of(triangle) < 0.0 ? -side : side;
}

/* The middle of the corners of what two triangles share; false if that is nothing. */
static bool find_common_point(const struct seen_triangle *a, const struct seen_triangle *b, double middle[2]) {
  double point[MOST_POINTS][2], left[MOST_POINTS][2];
  int count = 3;
  for (int i = 0; i < 6; ++i) point[i / 2][i % 2] = a->at[i / 2][i % 2];
  for (int k = 0; k < 3; ++k) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
      const double *from = point[i], *to = point[(i + 1) % count];
      const double side[2] = {side_of(b, k, from), side_of(b, k, to)};
      if (side[0] >= 0.0 && kept < MOST_POINTS) {
        for (int axis = 0; axis < 2; ++axis) left[kept][axis] = from[axis];
        ++kept;
      }
      if ((side[0] < 0.0) == (side[1] < 0.0) || kept == MOST_POINTS) continue;
      const double share = side[0] / (side[0] - side[1]);
      for (int axis = 0; axis < 2; ++axis) left[kept][axis] = from[axis] + share * (to[axis] - from[axis]);
      ++kept;
    }
    count = kept;
    for (int i = 0; i < 2 * kept; ++i) point[i / 2][i % 2] = left[i / 2][i % 2];
  }
  middle[0] = middle[1] = 0.0;
  for (int i = 0; i < 2 * count; ++i) middle[i % 2] += point[i / 2][i % 2] / count;
  return count > 0;
}

static double depth_at(const struct seen_triangle *triangle, const double at[2]) {
  double sum = 0.0, sides = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double side = side_of(triangle, k, at);
    sum += side * triangle->depth[(k + 2) % 3];
    sides += side;
  }
  return sides > 0.0 ? sum / sides : middle_of(triangle);
}

/* Whether the later one of the order, b, is nearer than a where both are. */
static bool lies_over(const struct seen_triangle *b, const struct seen_triangle *a) {
  double at[2];
  return !find_common_point(a, b, at) || depth_at(b, at) >= depth_at(a, at);
}

/* ---- squares of the page, each with the triangles that its box meets ---- */

enum { MOST_SIDES = 1024 };

struct squares {
  int32_t low[2];
  int64_t side;
  uint32_t across[2];
  uint32_t *first; /* [squares + 1] */
  uint32_t *met;
  struct range *range; /* [triangles] */
};

/* From a square to a square. */
struct range {
  uint32_t from[2], to[2];
};

static void find_box(const struct seen_triangle *triangle, int32_t low[2], int32_t high[2]) {
  for (int axis = 0; axis < 2; ++axis) {
    low[axis] = high[axis] = triangle->at[0][axis];
    for (int k = 1; k < 3; ++k) {
      const int32_t at = triangle->at[k][axis];
      if (at < low[axis]) low[axis] = at;
      if (at > high[axis]) high[axis] = at;
    }
  }
}

/* The box of all triangles, left as it is without any; returns the sum of the sides of their own. */
static int64_t find_page(const struct seen_triangle *triangle, uint32_t count, int32_t low[2], int32_t high[2]) {
  int64_t sides = 0;
  for (uint32_t i = 0; i < count; ++i) {
    int32_t own[2][2];
    find_box(&triangle[i], own[0], own[1]);
    for (int axis = 0; axis < 2; ++axis) {
      if (i == 0 || own[0][axis] < low[axis]) low[axis] = own[0][axis];
      if (i == 0 || own[1][axis] > high[axis]) high[axis] = own[1][axis];
      sides += own[1][axis] - (int64_t)own[0][axis];
    }
  }
  return sides;
}

static struct range find_range(const struct squares *squares, const struct seen_triangle *triangle) {
  int32_t low[2], high[2];
  struct range range;
  find_box(triangle, low, high);
  for (int axis = 0; axis < 2; ++axis) {
    range.from[axis] = (uint32_t)((low[axis] - (int64_t)squares->low[axis]) / squares->side);
    range.to[axis] = (uint32_t)((high[axis] - (int64_t)squares->low[axis]) / squares->side);
  }
  return range;
}

/* Squares about as wide as a triangle is in the mean. */
static void choose_squares(const struct seen_triangle *triangle, uint32_t count, struct squares *squares) {
  int32_t high[2] = {0, 0};
  squares->side = find_page(triangle, count, squares->low, high) / (2 * (int64_t)count) + 1;
  for (int axis = 0; axis < 2; ++axis) {
    const int64_t wide = high[axis] - (int64_t)squares->low[axis];
    if (wide / squares->side >= MOST_SIDES) squares->side = wide / MOST_SIDES + 1;
  }
  for (int axis = 0; axis < 2; ++axis) {
    squares->across[axis] = (uint32_t)((high[axis] - (int64_t)squares->low[axis]) / squares->side) + 1;
  }
}

static bool fill_squares(const struct seen_triangle *triangle, uint32_t count, struct squares *squares) {
  const size_t all = (size_t)squares->across[0] * squares->across[1];
  size_t needed = 0;
  squares->first = calloc(all + 2, sizeof *squares->first);
  squares->range = calloc((size_t)count + 1, sizeof *squares->range);
  if (squares->first == NULL || squares->range == NULL) return false;
  for (int pass = 0; pass < 2; ++pass) {
    for (uint32_t i = 0; i < count; ++i) {
      if (pass == 0) squares->range[i] = find_range(squares, &triangle[i]);
      const struct range *const range = &squares->range[i];
      for (uint32_t y = range->from[1]; y <= range->to[1]; ++y) {
        for (uint32_t x = range->from[0]; x <= range->to[0]; ++x) {
          const size_t square = (size_t)y * squares->across[0] + x;
          if (pass == 0) {
            ++squares->first[square + 2];
            ++needed;
          } else {
            squares->met[squares->first[square + 1]++] = i;
          }
        }
      }
    }
    if (pass == 1) break;
    for (size_t k = 2; k < all + 2; ++k) squares->first[k] += squares->first[k - 1];
    squares->met = needed < UINT32_MAX ? calloc(needed + 1, sizeof *squares->met) : NULL;
    if (squares->met == NULL) return false;
  }
  return true;
}

/* ---- which of two lies over the other ---- */

struct pairs {
  uint32_t (*pair)[2]; /* [count], the lower one first */
  size_t count, room;
};

static bool add_pair(struct pairs *pairs, uint32_t lower, uint32_t upper) {
  if (pairs->count == pairs->room) {
    const size_t room = 2 * pairs->room + 1024;
    uint32_t(*const grown)[2] = realloc(pairs->pair, room * sizeof *grown);
    if (grown == NULL) return false;
    pairs->pair = grown;
    pairs->room = room;
  }
  pairs->pair[pairs->count][0] = lower;
  pairs->pair[pairs->count++][1] = upper;
  return true;
}

/* Boxes that meet have one square in which their common part begins. */
static bool begins_here(const struct range *a, const struct range *b, uint32_t x, uint32_t y) {
  return x == (a->from[0] > b->from[0] ? a->from[0] : b->from[0]) &&
         y == (a->from[1] > b->from[1] ? a->from[1] : b->from[1]);
}

static bool find_pairs(const struct seen_triangle *triangle, uint32_t count, const struct squares *squares,
                       double slack, struct pairs *pairs) {
  for (uint32_t i = 0; i < count; ++i) {
    const struct range *const range = &squares->range[i];
    for (uint32_t y = range->from[1]; y <= range->to[1]; ++y) {
      for (uint32_t x = range->from[0]; x <= range->to[0]; ++x) {
        const size_t square = (size_t)y * squares->across[0] + x;
        for (uint32_t k = squares->first[square]; k < squares->first[square + 1] && squares->met[k] < i; ++k) {
          const uint32_t other = squares->met[k];
          if (!begins_here(range, &squares->range[other], x, y)) continue;
          if (!overlap(&triangle[other], &triangle[i], slack)) continue;
          const bool over = lies_over(&triangle[i], &triangle[other]);
          if (!add_pair(pairs, over ? other : i, over ? i : other)) return false;
        }
      }
    }
  }
  return true;
}

/* ---- layers ---- */

struct order {
  uint32_t *first;   /* [count + 1], of the upper ones of each */
  uint32_t *upper;   /* [pairs] */
  uint32_t *waiting; /* [count], for so many lower ones */
  uint32_t *ready;   /* [count] */
  bool *done;        /* [count] */
};

static bool make_order(const struct pairs *pairs, uint32_t count, struct order *order) {
  const size_t n = (size_t)count + 2;
  *order = (struct order){calloc(n, sizeof(uint32_t)), calloc(pairs->count + 1, sizeof(uint32_t)),
                          calloc(n, sizeof(uint32_t)), calloc(n, sizeof(uint32_t)), calloc(n, sizeof(bool))};
  if (order->first == NULL || order->upper == NULL || order->waiting == NULL || order->ready == NULL ||
      order->done == NULL || pairs->count >= UINT32_MAX) {
    return false;
  }
  for (size_t k = 0; k < pairs->count; ++k) {
    ++order->first[pairs->pair[k][0] + 2];
    ++order->waiting[pairs->pair[k][1]];
  }
  for (size_t i = 2; i < n; ++i) order->first[i] += order->first[i - 1];
  for (size_t k = 0; k < pairs->count; ++k) order->upper[order->first[pairs->pair[k][0] + 1]++] = pairs->pair[k][1];
  return true;
}

static void set_layers(struct seen_triangle *triangle, uint32_t count, const struct order *order) {
  uint32_t taken = 0, ready = 0, farthest = 0;
  for (uint32_t i = 0; i < count; ++i) {
    triangle[i].layer = 0;
    order->done[i] = order->waiting[i] == 0;
    if (order->done[i]) order->ready[ready++] = i;
  }
  while (taken < count) {
    if (taken == ready) { /* a ring */
      while (order->done[farthest]) ++farthest;
      order->done[farthest] = true;
      order->ready[ready++] = farthest;
    }
    const uint32_t lower = order->ready[taken++];
    for (uint32_t k = order->first[lower]; k < order->first[lower + 1]; ++k) {
      const uint32_t upper = order->upper[k];
      if (order->done[upper]) continue;
      if (triangle[upper].layer <= triangle[lower].layer) triangle[upper].layer = triangle[lower].layer + 1;
      if (--order->waiting[upper] > 0) continue;
      order->done[upper] = true;
      order->ready[ready++] = upper;
    }
  }
}

bool mesh_layers_find(struct seen_triangle *triangle, uint32_t count, double slack) {
  struct squares squares = {{0, 0}, 1, {0, 0}, NULL, NULL, NULL};
  struct pairs pairs = {NULL, 0, 0};
  struct order order = {NULL, NULL, NULL, NULL, NULL};
  if (count == 0) return true;
  qsort(triangle, count, sizeof *triangle, compare);
  choose_squares(triangle, count, &squares);
  const bool enough = fill_squares(triangle, count, &squares) && find_pairs(triangle, count, &squares, slack, &pairs) &&
                      make_order(&pairs, count, &order);
  if (enough) set_layers(triangle, count, &order);
  free(squares.first);
  free(squares.met);
  free(squares.range);
  free(pairs.pair);
  free(order.first);
  free(order.upper);
  free(order.waiting);
  free(order.ready);
  free(order.done);
  return enough;
}

/* ---- hidden triangles ---- */

/* Points of the page, numbered row by row, and which of them are covered. */
struct points {
  int32_t low[2], apart;
  size_t across[2];
  uint8_t *covered;
};

static void spread_points(const struct seen_triangle *triangle, uint32_t count, struct points *points) {
  int32_t high[2] = {0, 0};
  (void)find_page(triangle, count, points->low, high);
  for (int axis = 0; axis < 2; ++axis) {
    points->across[axis] = (size_t)((high[axis] - points->low[axis]) / points->apart) + 1;
  }
}

/* How many points of a triangle, border included, are not covered; covers them. */
static uint32_t cover(const struct seen_triangle *triangle, struct points *points) {
  const int64_t turn = area_of(triangle) < 0.0 ? -1 : 1;
  int32_t low[2], high[2];
  uint32_t seen = 0;
  find_box(triangle, low, high);
  const int32_t apart = points->apart;
  const int32_t first[2] = {(low[0] - points->low[0] + apart - 1) / apart,
                            (low[1] - points->low[1] + apart - 1) / apart};
  for (int32_t row = first[1]; points->low[1] + row * apart <= high[1]; ++row) {
    for (int32_t column = first[0]; points->low[0] + column * apart <= high[0]; ++column) {
      const int64_t x = points->low[0] + column * apart, y = points->low[1] + row * apart;
      bool inside = true;
      for (int k = 0; k < 3 && inside; ++k) {
        const int32_t *from = triangle->at[k], *to = triangle->at[(k + 1) % 3];
        inside = turn * ((to[0] - (int64_t)from[0]) * (y - from[1]) - (to[1] - (int64_t)from[1]) * (x - from[0])) >= 0;
      }
      uint8_t *const covered = &points->covered[(size_t)row * points->across[0] + (size_t)column];
      if (!inside || *covered) continue;
      ++seen;
      if (triangle->whole) *covered = 1;
    }
  }
  return seen;
}

bool mesh_layers_find_seen(struct seen_triangle *triangle, uint32_t count, int32_t apart) {
  struct points points = {.apart = apart};
  uint32_t layers = 0;
  if (count == 0) return true;
  spread_points(triangle, count, &points);
  for (uint32_t i = 0; i < count; ++i) layers = triangle[i].layer >= layers ? triangle[i].layer + 1 : layers;
  uint32_t *first = calloc((size_t)layers + 2, sizeof *first), *order = calloc(count, sizeof *order);
  points.covered = calloc(points.across[0] * points.across[1], sizeof *points.covered);
  const bool enough = first != NULL && order != NULL && points.covered != NULL;
  if (enough) {
    for (uint32_t i = 0; i < count; ++i) ++first[triangle[i].layer + 2];
    for (size_t k = 2; k < (size_t)layers + 2; ++k) first[k] += first[k - 1];
    for (uint32_t i = 0; i < count; ++i) order[first[triangle[i].layer + 1]++] = i;
    for (uint32_t i = count; i-- > 0;) triangle[order[i]].points = cover(&triangle[order[i]], &points);
  }
  free(first);
  free(order);
  free(points.covered);
  return enough;
}
