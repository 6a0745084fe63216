/* A path around a computed set, in memory of its own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A path between two corners of the box around the balls. */
typedef struct paths_result {
  const computed *base; /* what it was computed from; must outlive it */
  double from[3], to[3];
  void *memory;
  hsp_paths *paths;
  hsp_paths_limits needed; /* exactly */
  uint32_t enlargements;   /* how often limits had to be raised, starting from none of anything */
  hsp_path path;
} paths_result;

/* Computes everything. The first status that is not HSP_OK, or HSP_OK. To be followed by the release in either case. */
int32_t paths_result_make(const computed *base, paths_result *result);

void paths_result_release(paths_result *result);

/* How such handles are made; they are computed from a `paths_result` of which base and points are used. Finding the
 * path is part of the computation. */
extern const handle_kind paths_handle;

#ifdef __cplusplus
}
#endif
