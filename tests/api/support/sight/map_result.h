/* A visibility map of a computed set and everything the interface tells about it, in memory of its own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct map_result {
  const computed *base; /* what it was computed from; must outlive it */
  hsp_view_options options;
  void *memory;
  hsp_map *map;
  hsp_map_limits needed; /* exactly */
  uint32_t enlargements; /* how often limits had to be raised, starting from none of anything but balls */
  hsp_map_info info;
  hsp_map_vertex *vertices;
  hsp_map_edge *edges;
  hsp_map_face *faces;
  double *area; /* [n] */
} map_result;

/* Computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by map_result_release
 * in either case. */
int32_t map_result_make(const computed *base, const hsp_view_options *options, map_result *result);

void map_result_release(map_result *result);

/* How such handles are made; they are computed from a `map_result` of which only base and options are used. */
extern const handle_kind map_handle;

#ifdef __cplusplus
}
#endif
