#include "draw/mesh_layers.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "draw/mesh_squares.h"
#include "read/growing_array.h"

static int compare(const void *left, const void *right) {
  const struct seen_triangle *a = left;
  const struct seen_triangle *b = right;
  const double depth[2] = {seen_triangle_middle(a), seen_triangle_middle(b)};
  if (depth[0] != depth[1]) return depth[0] < depth[1] ? -1 : 1;
  return (a->number > b->number) - (a->number < b->number);
}

/* Whether an edge of a has all of b on its outer side; turn: +1 if a is counter-clockwise, else -1. */
static bool separates(const struct seen_triangle *a, const struct seen_triangle *b, double slack) {
  const double turn = seen_triangle_area(a) < 0.0 ? -1.0 : 1.0;
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

/* Find the mean of the corners of the common part of two triangles. False: they have none. */
static bool find_common_point(const struct seen_triangle *a, const struct seen_triangle *b, double middle[2]) {
  double point[MOST_POINTS][2], left[MOST_POINTS][2];
  int count = 3;
  for (int i = 0; i < 6; ++i) point[i / 2][i % 2] = a->at[i / 2][i % 2];
  for (int k = 0; k < 3; ++k) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
      const double *from = point[i], *to = point[(i + 1) % count];
      const double side[2] = {seen_triangle_side(b, k, from), seen_triangle_side(b, k, to)};
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

/* Whether the later one of the order, b, is nearer than a where both are. */
static bool lies_over(const struct seen_triangle *b, const struct seen_triangle *a) {
  double at[2];
  return !find_common_point(a, b, at) || seen_triangle_depth(b, at) >= seen_triangle_depth(a, at);
}

/* ---- which of two lies over the other ---- */

struct pairs {
  uint32_t (*pair)[2]; /* [count], the lower one first */
  size_t count, room;
};

static bool add_pair(struct pairs *pairs, uint32_t lower, uint32_t upper) {
  const uint32_t pair[2] = {lower, upper};
  return array_append(&pairs->pair, &pairs->count, &pairs->room, pair, sizeof pair);
}

/* Boxes that meet have one square in which their common part begins. */
static bool begins_here(const struct square_range *a, const struct square_range *b, uint32_t x, uint32_t y) {
  return x == (a->from[0] > b->from[0] ? a->from[0] : b->from[0]) &&
         y == (a->from[1] > b->from[1] ? a->from[1] : b->from[1]);
}

static bool find_pairs(const struct seen_triangle *triangle, uint32_t count, const struct mesh_squares *squares,
                       double slack, struct pairs *pairs) {
  for (uint32_t i = 0; i < count; ++i) {
    const struct square_range *const range = &squares->range[i];
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
  uint32_t *waiting; /* [count], how many lower ones have no layer yet */
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
  struct mesh_squares squares = MESH_SQUARES_NONE;
  struct pairs pairs = {NULL, 0, 0};
  struct order order = {NULL, NULL, NULL, NULL, NULL};
  if (count == 0) return true;
  qsort(triangle, count, sizeof *triangle, compare);
  const bool enough = mesh_squares_make(triangle, count, &squares) &&
                      find_pairs(triangle, count, &squares, slack, &pairs) && make_order(&pairs, count, &order);
  if (enough) set_layers(triangle, count, &order);
  mesh_squares_free(&squares);
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
  (void)seen_triangles_page(triangle, count, points->low, high);
  for (int axis = 0; axis < 2; ++axis) {
    points->across[axis] = (size_t)((high[axis] - points->low[axis]) / points->apart) + 1;
  }
}

static int64_t floor_of(int64_t dividend, int64_t divisor) { /* divisor > 0 */
  return dividend / divisor - (dividend % divisor < 0);
}

/* The columns of a row that lie in a triangle, border included; those given are the ones in its box. */
static void columns_inside(const struct seen_triangle *triangle, const struct points *points, int64_t y, int64_t *first,
                           int64_t *last) {
  const int64_t turn = seen_triangle_area(triangle) < 0.0 ? -1 : 1;
  for (int k = 0; k < 3; ++k) {
    const int32_t *from = triangle->at[k], *to = triangle->at[(k + 1) % 3];
    const int64_t dx = turn * ((int64_t)to[0] - from[0]), dy = turn * ((int64_t)to[1] - from[1]);
    /* A column lies on the inner side if side >= its number * step. */
    const int64_t side = dx * (y - from[1]) - dy * ((int64_t)points->low[0] - from[0]), step = dy * points->apart;
    if (step > 0) {
      const int64_t most = floor_of(side, step);
      if (most < *last) *last = most;
    } else if (step < 0) {
      const int64_t least = -floor_of(side, -step);
      if (least > *first) *first = least;
    } else if (side < 0) {
      *last = *first - 1;
    }
  }
}

/* How many points of a triangle, border included, are not covered; covers them. */
static uint32_t cover(const struct seen_triangle *triangle, struct points *points) {
  int32_t low[2], high[2];
  uint32_t seen = 0;
  seen_triangle_box(triangle, low, high);
  const int32_t apart = points->apart;
  for (int32_t row = (low[1] - points->low[1] + apart - 1) / apart; points->low[1] + row * apart <= high[1]; ++row) {
    int64_t first = (low[0] - points->low[0] + apart - 1) / apart, last = (high[0] - points->low[0]) / apart;
    columns_inside(triangle, points, points->low[1] + row * apart, &first, &last);
    for (int64_t column = first; column <= last; ++column) {
      uint8_t *const covered = &points->covered[(size_t)row * points->across[0] + (size_t)column];
      seen += *covered == 0;
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
