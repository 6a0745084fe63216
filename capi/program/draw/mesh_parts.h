/* The connected parts of a mesh in a view: which of them are voids, and which parts a cut leaves. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "write/mesh_file.h"

struct mesh_parts {
  double *seen;   /* [vertices][3], along the axes of the view */
  uint32_t *root; /* [vertices], the root of the connected part to which it belongs */
  double *volume; /* [vertices], for a root the volume of its part; negative: a void */
  bool *dropped;  /* [vertices], whether it belongs to a crumb behind a cut */
  double low[3], high[3];
  double cut; /* the depth of the plane; infinite: none */
};

/* Find the parts. Free them on true and on false. False: memory is short. axis: see mesh_view. */
bool mesh_parts_find(const struct triangle_mesh *mesh, const double axis[3][3], struct mesh_parts *parts);
void mesh_parts_free(struct mesh_parts *parts);

/* The root of a vertex: one vertex that stands for all that are connected. root: for each vertex another one connected
 * with it, at first itself. */
uint32_t mesh_parts_root(uint32_t *root, uint32_t v);

bool mesh_parts_is_of_void(const struct mesh_parts *parts, uint32_t vertex);

/* Set the plane of the cut: at a depth, or if that is NULL through the middle of the largest void, or, without voids,
 * of everything. Drop crumbs: parts behind the plane with less than a hundredth of the triangles, of which only the
 * first `of_outside` count. False: memory is short. */
bool mesh_parts_cut(const struct triangle_mesh *mesh, uint32_t of_outside, const double *depth,
                    struct mesh_parts *parts);
