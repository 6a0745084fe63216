/* The solvent-excluded surface over a computed boundary, in memory of its own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct surface_result {
  const computed *base; /* what it was computed from; must outlive it */
  void *memory;
  hsp_surface *surface;
  hsp_surface_limits needed; /* exactly */
  uint32_t enlargements;     /* how often limits had to be raised, starting from as many vertices as balls */
  hsp_surface_counts counts;
  hsp_surface_totals totals;
  hsp_surface_totals *balls; /* n */
} surface_result;

/* Computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * surface_result_release in either case. */
int32_t surface_result_make(const computed *base, surface_result *result);

void surface_result_release(surface_result *result);

/* How such handles are made; they are computed from a `surface_result` of which only the base is used. */
extern const handle_kind surface_handle;

#ifdef __cplusplus
}
#endif
