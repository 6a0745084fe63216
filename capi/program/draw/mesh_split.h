/* Splitting of triangles along a border. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "write/mesh_file.h"

/* An edge that the border crosses, from the vertex with the lower number to the other one; at which share of it, from 0
 * to 1; and how far off the edge the new vertex is. */
struct split_edge {
  uint32_t low, high;
  double share;
  double bulge[3];
};

/* Sort the edges, and keep each once, with the least of its shares. */
size_t mesh_split_sort(struct split_edge *edges, size_t count);

/* Split all triangles that have such edges; these are sorted. The first corner of each part is an old vertex, on whose
 * side of the border the part is; the middle of a triangle with three such edges has none. *marks: a mark for each
 * triangle, which its parts inherit, so that the array grows; or marks is NULL. */
bool mesh_split(struct triangle_mesh *mesh, const struct split_edge *edges, size_t count, uint8_t **marks,
                struct failure *failure);
