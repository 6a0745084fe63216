#include "moving_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(moving)
LIMITS_OF_BALLS(moving)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const moving_result *m = source;
  return hsp_moving_set(handle, m->base->model, NULL, 1, -0.5, HSP_TANGENT_OVERLAP, limits, NULL);
}

const handle_kind moving_handle = {(uint32_t)sizeof(hsp_moving_limits),
                                   2,
                                   {"", "balls", "neighbours"},
                                   init_limits,
                                   bytes_of_limits,
                                   init_handle,
                                   compute_handle,
                                   0};

int32_t moving_result_make(const computed *base, moving_result *m) {
  void *moving = NULL;
  int32_t status;
  memset(m, 0, sizeof *m);
  m->base = base;
  status = grow_until_computed(&moving_handle, m, base->n, &m->memory, &moving, &m->needed, &m->enlargements);
  m->moving = moving;
  if (status == HSP_OK) status = hsp_moving_get_info(m->moving, &m->info);
  if (status == HSP_OK) status = hsp_moving_measure(m->moving, &m->totals, NULL, NULL, 0, NULL);
  if (status == HSP_OK) status = hsp_moving_gradient(m->moving, &m->energy, NULL, NULL, NULL, 0, NULL);
  return status;
}

void moving_result_release(moving_result *m) {
  free(m->memory);
  memset(m, 0, sizeof *m);
}
