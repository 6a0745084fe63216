/* The sides of a mesh's triangles, edge by edge. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "write/mesh_file.h"

/* Of a triangle, in the direction in which it is counter-clockwise on the page, or `back`. */
struct mesh_side {
  uint32_t low, high, triangle;
  bool back;
};

/* All sides by their ends, those of one edge side by side, the triangle with the lower number first. To be freed; NULL
 * for want of memory. */
struct mesh_side *mesh_sides_find(const struct triangle_mesh *mesh);

/* Whether a side and the next one are of one edge. */
bool mesh_sides_share_edge(const struct mesh_side side[2]);
