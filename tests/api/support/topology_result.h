/* The topology of a computed boundary and everything the interface tells about it, in memory of its own. */
#ifndef HSP_TESTS_TOPOLOGY_RESULT_H
#define HSP_TESTS_TOPOLOGY_RESULT_H

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct topology_result {
  const computed *base; /* what it was computed from; must outlive it */
  void *memory;
  hsp_topology *topology;
  hsp_topology_limits needed; /* exactly */
  uint32_t enlargements;      /* how often limits had to be raised, starting from none of anything but balls */
  hsp_topology_counts counts;
  uint32_t *onext;  /* [edges][4] */
  uint32_t *origin; /* [edges][4] */
  hsp_topology_vertex *vertices;
  hsp_topology_edge *edges;
  hsp_simple_face *faces;
  hsp_shell *shells;
  hsp_component *components;
  hsp_cell *cells;
} topology_result;

/* Computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * topology_result_release in either case. */
int32_t topology_result_make(const computed *base, topology_result *result);

void topology_result_release(topology_result *result);

/* How such handles are made; they are computed from a `topology_result`, which needs but its base. */
extern const handle_kind topology_handle;

/* NULL, or a sentence about the first promise of the header that the result breaks. Each of the following, one
 * after the other: */
const char *broken_topology(const topology_result *result);

/* the quad-edge algebra, and that flat arrays and accessors agree; */
const char *broken_quad_edges(const topology_result *result);

/* records of vertices, edges and simple faces, and how they cut the boundary's arcs, circles and faces; */
const char *broken_cuts(const topology_result *result);

/* shells, components and cells, scans, and the library's own check; time is quadratic in the number of shells; */
const char *broken_shell_records(const topology_result *result);

/* positions, axes and angles within rounding errors; time is edges times balls; */
const char *broken_topology_places(const topology_result *result);

/* the areas that the loops of simple faces enclose; */
const char *broken_face_areas(const topology_result *result);

/* and that scans of outer shells start where the highest point is. */
const char *broken_start_faces(const topology_result *result);

/* NULL, or a sentence about where two results differ although the balls of `other` are those of `result` in another
 * order. Everything but ids must agree: positions and angles bit for bit, sums up to rounding. */
const char *topology_difference_after_permutation(const topology_result *result, const topology_result *other);

#ifdef __cplusplus
}
#endif

#endif
