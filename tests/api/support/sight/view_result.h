/* A view of a computed set and everything the interface tells about it, in memory of its own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct view_result {
  const computed *base; /* what it was computed from; must outlive it */
  hsp_view_options options;
  int with_boundary; /* whether the boundary was handed in */
  void *memory;
  hsp_view *view;
  hsp_view_limits needed; /* exactly */
  uint32_t enlargements;  /* how often limits had to be raised, starting from none of anything but balls */
  hsp_view_info info;
  hsp_view_piece *pieces;
  hsp_view_loop *loops;
  hsp_view_arc *arcs;
} view_result;

/* Computes and reads everything; H-pieces need the boundary. The first status that is not HSP_OK, or HSP_OK. To be
 * followed by view_result_release in either case. */
int32_t view_result_make(const computed *base, const hsp_view_options *options, int with_boundary, view_result *result);

void view_result_release(view_result *result);

/* How such handles are made; they are computed from a `view_result` of which only base and options are used. */
extern const handle_kind view_handle;

#ifdef __cplusplus
}
#endif
