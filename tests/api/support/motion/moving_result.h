/* Balls that move, set to those of a computed set, and what the interface tells about them, in memory of their own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct moving_result {
  const computed *base; /* whose balls they are */
  void *memory;
  hsp_moving *moving;
  hsp_moving_limits needed; /* exactly */
  uint32_t enlargements;    /* how often limits had to be raised, starting from none of anything but balls */
  hsp_moving_info info;
  hsp_totals totals;
  hsp_energy energy;
} moving_result;

/* Sets the balls and reads what is known of all. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * moving_result_release in either case. */
int32_t moving_result_make(const computed *base, moving_result *result);

void moving_result_release(moving_result *result);

/* How such handles are made; they are set from a `moving_result` of which only the base is used. */
extern const handle_kind moving_handle;

#ifdef __cplusplus
}
#endif
