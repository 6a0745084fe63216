/* The results of the library's component smooth for a molecule: the solvent-excluded surface and meshes. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/geometry.h"
#include "write/mesh_file.h"

/* Compute the solvent-excluded surface over the boundary, which is computed. */
bool geometry_compute_surface(struct geometry *geometry, struct failure *failure);

/* The same for the outer region alone, as if voids were filled. */
bool geometry_compute_outer_surface(struct geometry *geometry, struct failure *failure);

/* List the probe and the balls of each patch of a computed surface; convex patches have none. Free *patches on true. */
bool geometry_list_patches(const struct geometry *geometry, struct mesh_patch **patches, struct failure *failure);

/* Make triangles of the boundary, or of the solvent-excluded surface; it must be computed. */
bool geometry_compute_mesh(struct geometry *geometry, bool of_surface, double edge, struct failure *failure);
