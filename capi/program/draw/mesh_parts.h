/* The connected parts of a mesh as it is looked at: which are voids, where a cut opens them, and what is left. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "write/mesh_file.h"

struct mesh_parts {
  double *seen;   /* [vertices][3], along the axes of the view */
  uint32_t *root; /* [vertices], of the connected part that it belongs to */
  double *volume; /* [vertices], of the part of which it is the root; negative: a void */
  bool *dropped;  /* [vertices], of crumbs behind a cut */
  double low[3], high[3];
  double cut; /* the depth of the plane; infinite: none */
};

/* To be freed on true and on false, which is for want of memory. axis: see mesh_view. */
bool mesh_parts_find(const struct triangle_mesh *mesh, const double axis[3][3], struct mesh_parts *parts);
void mesh_parts_free(struct mesh_parts *parts);

/* Of connected vertices the one that stands for all; root: of each another one of them, at first itself. */
uint32_t mesh_parts_root(uint32_t *root, uint32_t v);

bool mesh_parts_is_of_void(const struct mesh_parts *parts, uint32_t vertex);

/* Set the plane at a depth, or if that is NULL through the middle of the largest void, or else of everything, and drop
 * crumbs: what it cuts off behind it with less than a hundredth of the triangles, of which only the first so many
 * count. False for want of memory. */
bool mesh_parts_cut(const struct triangle_mesh *mesh, uint32_t of_outside, const double *depth,
                    struct mesh_parts *parts);
