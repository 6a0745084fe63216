#include "paths_result.h"

#include <stdlib.h>
#include <string.h>

/* ---- where to go ---- */

/* The box around all balls, larger on all sides by the largest radius. */
static void box_around(const computed *base, double *low, double *high) {
  double largest = 1;
  uint32_t i;
  int k;
  for (i = 0; i < base->n; ++i) {
    if (base->radius[i] > largest) largest = base->radius[i];
  }
  for (k = 0; k < 3; ++k) {
    low[k] = high[k] = base->n > 0 ? base->xyz[k] : 0;
    for (i = 1; i < base->n; ++i) {
      const double at = base->xyz[3 * (size_t)i + (size_t)k];
      if (at < low[k]) low[k] = at;
      if (at > high[k]) high[k] = at;
    }
    low[k] -= 2 * largest;
    high[k] += 2 * largest;
  }
}

/* ---- paths ---- */

static int32_t paths_limits_init(void *limits, uint32_t struct_size, uint32_t balls) {
  return hsp_paths_limits_init(limits, struct_size, balls);
}

static int32_t paths_bytes(const void *limits, size_t *bytes) {
  return hsp_paths_bytes(limits, bytes);
}

static int32_t paths_init(void *memory, size_t bytes, const void *limits, void **handle) {
  hsp_paths *made = handle != NULL ? *handle : NULL;
  const int32_t status = hsp_paths_init(memory, bytes, limits, handle != NULL ? &made : NULL);
  if (handle != NULL) *handle = made;
  return status;
}

static int32_t paths_compute(void *handle, const void *source, void *limits) {
  const paths_result *p = source;
  hsp_path path;
  const int32_t status = hsp_paths_compute(handle, p->base->model, limits);
  return status != HSP_OK ? status : hsp_paths_find(handle, p->from, p->to, &path, limits);
}

/* By the header at most six enlargements for the cells, and one for the points. */
const handle_kind paths_handle = {(uint32_t)sizeof(hsp_paths_limits),
                                  10,
                                  {"", "cubes", "entries", "cells", "adjacencies", "landmarks", "facets", "corners",
                                   "balls of a cube", "corners of a cube", "points"},
                                  paths_limits_init,
                                  paths_bytes,
                                  paths_init,
                                  paths_compute,
                                  4};

int32_t paths_result_make(const computed *base, paths_result *p) {
  void *paths = NULL;
  int32_t status;
  memset(p, 0, sizeof *p);
  p->base = base;
  box_around(base, p->from, p->to);
  status = grow_until_computed(&paths_handle, p, 0, &p->memory, &paths, &p->needed, &p->enlargements);
  p->paths = paths;
  return status == HSP_OK ? hsp_paths_find(p->paths, p->from, p->to, &p->path, NULL) : status;
}

void paths_result_release(paths_result *p) {
  free(p->memory);
  memset(p, 0, sizeof *p);
}
