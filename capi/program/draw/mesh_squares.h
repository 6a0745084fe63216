/* Squares of the page, each with the triangles that its box meets. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/seen_triangle.h"

/* The squares from one to another. */
struct square_range {
  uint32_t from[2], to[2];
};

struct mesh_squares {
  int32_t low[2], high[2]; /* the page */
  int64_t side;
  uint32_t across[2];
  uint32_t *first; /* [squares + 1], row by row */
  uint32_t *met;
  struct square_range *range; /* [triangles] */
};

#define MESH_SQUARES_NONE \
  { {0, 0}, {0, 0}, 1, {0, 0}, NULL, NULL, NULL }

/* Make squares about as wide as the mean of `count` > 0 triangles. Free them on true and on false. False: memory is
 * short. */
bool mesh_squares_make(const struct seen_triangle *triangle, uint32_t count, struct mesh_squares *squares);
void mesh_squares_free(struct mesh_squares *squares);

/* The squares that a box within the page meets. */
struct square_range mesh_squares_range(const struct mesh_squares *squares, const int32_t low[2], const int32_t high[2]);
