#include "draw/mesh_layers.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

static int compare(const void *left, const void *right) {
  const struct seen_triangle *a = left;
  const struct seen_triangle *b = right;
  if (a->depth != b->depth) return a->depth < b->depth ? -1 : 1;
  return (a->number > b->number) - (a->number < b->number);
}

/* Whether an edge of a has all of b on its outer side; turn: +1 if a is counter-clockwise, else -1. */
static bool separates(const struct seen_triangle *a, const struct seen_triangle *b, double slack) {
  const double area = (double)(a->at[1][0] - a->at[0][0]) * (a->at[2][1] - a->at[0][1]) -
                      (double)(a->at[1][1] - a->at[0][1]) * (a->at[2][0] - a->at[0][0]);
  const double turn = area < 0.0 ? -1.0 : 1.0;
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

/* ---- squares of the page, each with the triangles that its box meets ---- */

enum { MOST_SIDES = 1024 };

struct squares {
  int32_t low[2];
  int64_t side;
  uint32_t across[2];
  uint32_t *first; /* [squares + 1] */
  uint32_t *met;
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

static void find_range(const struct squares *squares, const struct seen_triangle *triangle, uint32_t from[2],
                       uint32_t to[2]) {
  int32_t low[2], high[2];
  find_box(triangle, low, high);
  for (int axis = 0; axis < 2; ++axis) {
    from[axis] = (uint32_t)((low[axis] - (int64_t)squares->low[axis]) / squares->side);
    to[axis] = (uint32_t)((high[axis] - (int64_t)squares->low[axis]) / squares->side);
  }
}

/* Squares about as wide as a triangle is in the mean. */
static void choose_squares(const struct seen_triangle *triangle, uint32_t count, struct squares *squares) {
  int32_t high[2] = {0, 0};
  int64_t sides = 0;
  for (uint32_t i = 0; i < count; ++i) {
    int32_t own[2][2];
    find_box(&triangle[i], own[0], own[1]);
    for (int axis = 0; axis < 2; ++axis) {
      if (i == 0 || own[0][axis] < squares->low[axis]) squares->low[axis] = own[0][axis];
      if (i == 0 || own[1][axis] > high[axis]) high[axis] = own[1][axis];
      sides += own[1][axis] - (int64_t)own[0][axis];
    }
  }
  squares->side = sides / (2 * (int64_t)count) + 1;
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
  uint32_t from[2], to[2];
  squares->first = calloc(all + 2, sizeof *squares->first);
  if (squares->first == NULL) return false;
  for (int pass = 0; pass < 2; ++pass) {
    for (uint32_t i = 0; i < count; ++i) {
      find_range(squares, &triangle[i], from, to);
      for (uint32_t y = from[1]; y <= to[1]; ++y) {
        for (uint32_t x = from[0]; x <= to[0]; ++x) {
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

/* Of all that lies before it in the order. */
static uint32_t layer_over(const struct seen_triangle *triangle, uint32_t at, const struct squares *squares,
                           double slack) {
  uint32_t layer = 0;
  uint32_t from[2], to[2];
  find_range(squares, &triangle[at], from, to);
  for (uint32_t y = from[1]; y <= to[1]; ++y) {
    for (uint32_t x = from[0]; x <= to[0]; ++x) {
      const size_t square = (size_t)y * squares->across[0] + x;
      for (uint32_t k = squares->first[square]; k < squares->first[square + 1] && squares->met[k] < at; ++k) {
        const struct seen_triangle *other = &triangle[squares->met[k]];
        if (other->layer >= layer && overlap(other, &triangle[at], slack)) layer = other->layer + 1;
      }
    }
  }
  return layer;
}

bool mesh_layers_find(struct seen_triangle *triangle, uint32_t count, double slack) {
  struct squares squares = {{0, 0}, 1, {0, 0}, NULL, NULL};
  if (count == 0) return true;
  qsort(triangle, count, sizeof *triangle, compare);
  choose_squares(triangle, count, &squares);
  const bool enough = fill_squares(triangle, count, &squares);
  for (uint32_t i = 0; enough && i < count; ++i) triangle[i].layer = layer_over(triangle, i, &squares, slack);
  free(squares.first);
  free(squares.met);
  return enough;
}
