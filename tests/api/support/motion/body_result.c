#include "body_result.h"

#include <stdlib.h>
#include <string.h>

const hsp_pose body_poses[BODY_POSES] = {
    {{1, 0, 0, 0}, {0, 0, 0}}, {{9, 1, 2, 0}, {0.5, -0.25, 0.125}}, {{0, 3, 4, 0}, {2, 0, 0}}};
const hsp_rational_pose body_rational_poses[BODY_POSES] = {
    {{1, 0, 0, 0}, {0, 0, 0}}, {{9, 1, 2, 0}, {0.5, -0.25, 0.125}}, {{0, 3, 4, 0}, {2, 0, 0}}};

static int32_t bytes_of_limits(const void *limits, size_t *bytes) {
  return hsp_body_bytes(((const body_limits *)limits)->balls, bytes);
}

static int32_t init_handle(void *memory, size_t bytes, const void *limits, void **handle) {
  hsp_body *made = *handle;
  const int32_t status = hsp_body_init(memory, bytes, ((const body_limits *)limits)->balls, &made);
  *handle = made;
  return status;
}

/* Bodies do not say how many balls they need room for: the model does. */
static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const body_result *b = source;
  const int32_t status = hsp_body_set(handle, b->base->model);
  if (limits != NULL) ((body_limits *)limits)->balls = b->base->n;
  return status;
}

const handle_kind body_handle = {
    (uint32_t)sizeof(body_limits), 1, {"", "balls"}, NULL, bytes_of_limits, init_handle, compute_handle, 0};

int32_t body_result_make(const computed *base, body_result *b) {
  void *body = NULL;
  uint32_t enlargements = 0;
  int32_t status;
  memset(b, 0, sizeof *b);
  b->base = base;
  status = grow_until_computed(&body_handle, b, base->n, &b->memory, &body, &b->needed, &enlargements);
  b->body = body;
  if (status == HSP_OK) status = hsp_body_gaps(b->body, b->body, BODY_POSES, body_poses, b->gap, NULL);
  return status == HSP_OK ? hsp_body_overlaps(b->body, b->body, BODY_POSES, body_poses, b->overlap, NULL) : status;
}

void body_result_release(body_result *b) {
  free(b->memory);
  memset(b, 0, sizeof *b);
}
