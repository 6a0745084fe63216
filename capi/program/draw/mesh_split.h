/* Triangles that a border goes through, split there. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "write/mesh_file.h"

/* An edge that the border crosses, from the vertex with the lower number to the other one, where, from 0 to 1, and
 * how far off the edge. */
struct split_edge {
  uint32_t low, high;
  double share;
  double bulge[3];
};

/* Sort the edges, and leave each there once: of several shares the least. */
size_t mesh_split_sort(struct split_edge *edges, size_t count);

/* Split all triangles with such edges, which are sorted. Each part has an old vertex as its first corner, on whose side
 * of the border it is, but for the middle of a triangle with three such edges. *marks: one for each triangle, which its
 * parts have, too, and which grow with these; or marks is NULL. */
bool mesh_split(struct triangle_mesh *mesh, const struct split_edge *edges, size_t count, uint8_t **marks,
                struct failure *failure);
