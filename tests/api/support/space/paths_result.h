/* A path around a computed set, and the widest probe from a point among its balls to the outside, in memory of their
 * own. */
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

typedef struct gate_result {
  const computed *base;
  double from[3]; /* a point outside all balls, between the outermost centres along all axes if one is found */
  void *memory;
  hsp_gate *gate;
  hsp_gate_limits needed;
  uint32_t enlargements;
  hsp_widest_probe widest;
} gate_result;

/* Compute everything. The first status that is not HSP_OK, or HSP_OK. To be followed by the release in either case. */
int32_t paths_result_make(const computed *base, paths_result *result);
int32_t gate_result_make(const computed *base, gate_result *result);

void paths_result_release(paths_result *result);
void gate_result_release(gate_result *result);

/* How such handles are made; they are computed from a `paths_result` or `gate_result`, which needs its base and points.
 * Of paths the path is part of it. */
extern const handle_kind paths_handle;
extern const handle_kind gate_handle;

#ifdef __cplusplus
}
#endif
