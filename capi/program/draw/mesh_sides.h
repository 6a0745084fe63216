/* The sides of a mesh's triangles, edge by edge. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "write/mesh_file.h"

/* A side of a triangle, in the direction in which the triangle is counter-clockwise on the page, or, with `back`, in
 * the other one. */
struct mesh_side {
  uint32_t low, high, triangle;
  bool back;
};

/* All sides, sorted by their ends: those of one edge are neighbours, the triangle with the lower number first. Free
 * them. NULL: memory is short. */
struct mesh_side *mesh_sides_find(const struct triangle_mesh *mesh);

/* Whether a side and the next one belong to the same edge. */
bool mesh_sides_share_edge(const struct mesh_side side[2]);
