/* The body of a computed set, and what the interface tells about it: its meeting with itself in a few poses. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The poses: in the same place; turned a little; beside itself, turned over. */
enum { BODY_POSES = 3 };
extern const hsp_pose body_poses[BODY_POSES];
extern const hsp_rational_pose body_rational_poses[BODY_POSES];

/* A body's only limit is a number of balls; here in the form of the limits of a handle_kind. */
typedef struct body_limits {
  uint32_t struct_size;
  uint32_t balls;
} body_limits;

typedef struct body_result {
  const computed *base; /* the set, whose model it is set from */
  void *memory;
  hsp_body *body;
  body_limits needed;
  hsp_body_gap gap[BODY_POSES];
  hsp_body_overlap overlap[BODY_POSES];
} body_result;

/* Sets the body and asks about it. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * body_result_release in either case. */
int32_t body_result_make(const computed *base, body_result *result);

void body_result_release(body_result *result);

/* How bodies are made; they are set from a `body_result` of which only the base is used. */
extern const handle_kind body_handle;

#ifdef __cplusplus
}
#endif
