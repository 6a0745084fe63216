#include "surface_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(surface)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const surface_result *s = source;
  return hsp_surface_compute(handle, s->base->boundary, limits);
}

const handle_kind surface_handle = {(uint32_t)sizeof(hsp_surface_limits),
                                    6,
                                    {"", "vertices", "faces", "neighbours", "pieces", "arcs", "cusped circles"},
                                    NULL,
                                    bytes_of_limits,
                                    init_handle,
                                    compute_handle,
                                    3};

int32_t surface_result_make(const computed *base, surface_result *s) {
  void *surface = NULL;
  uint32_t needed = 0;
  int32_t status;
  memset(s, 0, sizeof *s);
  s->base = base;
  status = grow_until_computed(&surface_handle, s, base->n, &s->memory, &surface, &s->needed, &s->enlargements);
  s->surface = surface;
  s->balls = test_zeros(base->n, sizeof *s->balls);
  if (status == HSP_OK) status = hsp_surface_get_counts(s->surface, &s->counts);
  if (status != HSP_OK) return status;
  return hsp_surface_measure(s->surface, &s->totals, s->balls, base->n, &needed);
}

void surface_result_release(surface_result *s) {
  free(s->memory);
  free(s->balls);
  memset(s, 0, sizeof *s);
}
