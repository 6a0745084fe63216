/* Invariants of any computed topology: what the header promises of it. Each function returns NULL, or a sentence about
 * the first one that does not hold. Later ones rely on what the earlier ones have found sound. */
#pragma once

#include "decided_count.h"
#include "topology_result.h"

#ifdef __cplusplus
extern "C" {
#endif

/* All invariants of one topology that are declared below, one after the other. */
const char *broken_topology(const topology_result *t);

/* The quad-edge algebra, and that flat arrays and functions agree. */
const char *broken_topology_quad_edges(const topology_result *t);

/* Records of vertices, edges and simple faces, and how they cut the boundary's arcs, circles and faces. */
const char *broken_topology_cuts(const topology_result *t);

/* Shells, components and regions, scans, and the library's own check. Time is quadratic in the number of shells. */
const char *broken_topology_shells(const topology_result *t);

/* Positions, axes and angles within rounding errors. Time is edges times balls. */
const char *broken_topology_positions(const topology_result *t);

/* The areas that the loops of simple faces enclose. The count is of maximal faces. */
const char *broken_topology_face_areas(const topology_result *t);
extern decided_count face_areas_decided;

/* Scans of outer shells start where the highest point is. The count is of components whose
 * loop is elsewhere. */
const char *broken_topology_start_faces(const topology_result *t);
extern decided_count start_faces_decided;

/* The order of the balls has no effect but on ids. `other` has the balls of t in another order: positions and angles
 * agree bit for bit, areas and volumes up to rounding. */
const char *topology_difference_after_permutation(const topology_result *t, const topology_result *other);

#ifdef __cplusplus
}
#endif
