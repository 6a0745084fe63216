/* Balls and sticks of a computed set as a map, and everything the interface tells about them, in memory of its own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { STICKS_OF_RESULT = 12 };

typedef struct sticks_result {
  const computed *base;
  hsp_view_options options;
  hsp_stick
      stick[STICKS_OF_RESULT]; /* those that conflict with nothing, of a few between balls that follow each other */
  uint32_t count;
  double radius; /* of the sticks: a quarter of the least positive radius of a ball */
  void *memory;
  hsp_sticks *sticks;
  hsp_sticks_limits needed; /* exactly */
  uint32_t enlargements;    /* from no room for anything but the balls */
  hsp_sticks_info info;
  hsp_map_info map;
  hsp_map_vertex *vertices;
  hsp_map_edge *edges;
  hsp_map_face *faces;
  double *area; /* of balls, then of halves of sticks */
} sticks_result;

/* Chooses sticks, computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * sticks_result_release in any case. */
int32_t sticks_result_make(const computed *base, const hsp_view_options *options, sticks_result *result);
/* The same with the sticks of `like`, whose ball i is ball place[i] of `base`. */
int32_t sticks_result_make_like(const computed *base, const sticks_result *like, const uint32_t *place,
                                sticks_result *result);
void sticks_result_release(sticks_result *result);

/* How such handles are made; they are computed from a `sticks_result` of which base, options and sticks are used. */
extern const handle_kind sticks_handle;

#ifdef __cplusplus
}
#endif
