#include "draw/mesh_squares.h"

#include <stddef.h>
#include <stdlib.h>

enum { MOST_SIDES = 1024 };

struct square_range mesh_squares_range(const struct mesh_squares *squares, const int32_t low[2],
                                       const int32_t high[2]) {
  struct square_range range;
  for (int axis = 0; axis < 2; ++axis) {
    range.from[axis] = (uint32_t)((low[axis] - (int64_t)squares->low[axis]) / squares->side);
    range.to[axis] = (uint32_t)((high[axis] - (int64_t)squares->low[axis]) / squares->side);
  }
  return range;
}

static void choose_squares(const struct seen_triangle *triangle, uint32_t count, struct mesh_squares *squares) {
  squares->side = seen_triangles_page(triangle, count, squares->low, squares->high) / (2 * (int64_t)count) + 1;
  for (int axis = 0; axis < 2; ++axis) {
    const int64_t wide = squares->high[axis] - (int64_t)squares->low[axis];
    if (wide / squares->side >= MOST_SIDES) squares->side = wide / MOST_SIDES + 1;
  }
  for (int axis = 0; axis < 2; ++axis) {
    squares->across[axis] = (uint32_t)((squares->high[axis] - (int64_t)squares->low[axis]) / squares->side) + 1;
  }
}

static bool fill_squares(const struct seen_triangle *triangle, uint32_t count, struct mesh_squares *squares) {
  const size_t all = (size_t)squares->across[0] * squares->across[1];
  size_t needed = 0;
  squares->first = calloc(all + 2, sizeof *squares->first);
  squares->range = calloc((size_t)count + 1, sizeof *squares->range);
  if (squares->first == NULL || squares->range == NULL) return false;
  for (int pass = 0; pass < 2; ++pass) {
    for (uint32_t i = 0; i < count; ++i) {
      if (pass == 0) {
        int32_t low[2], high[2];
        seen_triangle_box(&triangle[i], low, high);
        squares->range[i] = mesh_squares_range(squares, low, high);
      }
      const struct square_range *const range = &squares->range[i];
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

bool mesh_squares_make(const struct seen_triangle *triangle, uint32_t count, struct mesh_squares *squares) {
  choose_squares(triangle, count, squares);
  return fill_squares(triangle, count, squares);
}

void mesh_squares_free(struct mesh_squares *squares) {
  free(squares->first);
  free(squares->met);
  free(squares->range);
}
