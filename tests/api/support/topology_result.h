/* The topology of a computed boundary and everything the interface tells about it, in memory of its own. */
#pragma once

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
  hsp_region *regions;
} topology_result;

/* Computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * topology_result_release in either case. */
int32_t topology_result_make(const computed *base, topology_result *result);

void topology_result_release(topology_result *result);

/* How such handles are made; they are computed from a `topology_result`, which needs but its base. */
extern const handle_kind topology_handle;

#ifdef __cplusplus
}
#endif
