/* The places of the vertices of a mesh, checked against all balls. */
#pragma once

#include "mesh_result.h"

#ifdef __cplusplus
extern "C" {
#endif

/* For the mesh of a boundary: a vertex is inside no ball and on the sphere of the ball that it names. Its normal has
 * length 1 and, inside of a patch, points away from this ball. NULL, or a sentence about the first promise that does
 * not hold. */
const char *broken_mesh_vertices(const mesh_result *m);

/* For each vertex 1 more than the patch that it is in, or HSP_NONE if it is in several. To be freed. */
uint32_t *patches_of_vertices(const mesh_result *m);

#ifdef __cplusplus
}
#endif
