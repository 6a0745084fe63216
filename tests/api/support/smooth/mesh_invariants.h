/* Where the vertices of a mesh lie. */
#pragma once

#include "mesh_result.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Of a boundary's mesh, by all balls: a vertex is inside none and on the one that it names, and its normal has length 1
 * and inside of a patch points away from that. NULL, or a sentence about the first one that does not hold. */
const char *broken_mesh_vertices(const mesh_result *m);

/* For each vertex 1 more than the patch that it is in, or HSP_NONE if it is in several. To be freed. */
uint32_t *patches_of_vertices(const mesh_result *m);

#ifdef __cplusplus
}
#endif
