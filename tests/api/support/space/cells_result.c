#include "cells_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(cells)
LIMITS_OF_BALLS(cells)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const cells_result *c = source;
  return hsp_cells_compute(handle, c->base->model, limits);
}

/* By the header at most six enlargements. */
const handle_kind cells_handle = {(uint32_t)sizeof(hsp_cells_limits),
                                  9,
                                  {"", "cubes", "entries", "cells", "adjacencies", "landmarks", "facets", "corners",
                                   "balls of a cube", "corners of a cube"},
                                  init_limits,
                                  bytes_of_limits,
                                  init_handle,
                                  compute_handle,
                                  3};

int32_t cells_result_make(const computed *base, cells_result *c) {
  void *cells = NULL;
  int32_t status;
  memset(c, 0, sizeof *c);
  c->base = base;
  status = grow_until_computed(&cells_handle, c, 0, &c->memory, &cells, &c->needed, &c->enlargements);
  c->cells = cells;
  if (status == HSP_OK) status = hsp_cells_get_counts(c->cells, &c->counts);
  if (status != HSP_OK) return status;
  c->list = test_zeros(c->counts.cells, sizeof *c->list);
  c->pairs = test_zeros(c->counts.adjacencies, sizeof *c->pairs);
  status = hsp_cells_get_cells(c->cells, 0, c->counts.cells, c->list);
  return status == HSP_OK ? hsp_cells_get_pairs(c->cells, 0, c->counts.adjacencies, c->pairs) : status;
}

void cells_result_release(cells_result *c) {
  free(c->memory);
  free(c->list);
  free(c->pairs);
  memset(c, 0, sizeof *c);
}
