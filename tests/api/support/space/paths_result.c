#include "paths_result.h"

#include <stdlib.h>
#include <string.h>

/* ---- where to go ---- */

/* The box around all balls, and as much again as the largest radius. */
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

static int is_outside(const computed *base, const double *point) {
  uint32_t i;
  for (i = 0; i < base->n; ++i) {
    const double *c = base->xyz + 3 * (size_t)i;
    const double x = point[0] - c[0], y = point[1] - c[1], z = point[2] - c[2];
    const double reach = base->radius[i] * 1.0001;
    if (x * x + y * y + z * z <= reach * reach) return 0;
  }
  return 1;
}

/* The mean of all centres, or about that of three of them, if it is outside all balls, else a corner of the box. */
static void point_among(const computed *base, double *point) {
  double high[3];
  uint32_t i, j, l;
  int k;
  for (k = 0; k < 3; ++k) {
    point[k] = 0;
    for (i = 0; i < base->n; ++i) point[k] += base->xyz[3 * (size_t)i + (size_t)k] / base->n;
  }
  if (base->n > 0 && is_outside(base, point)) return;
  for (i = 0; i < base->n; ++i) {
    for (j = i + 1; j < base->n; ++j) {
      for (l = j + 1; l < base->n; ++l) {
        for (k = 0; k < 3; ++k) {
          const double *xyz = base->xyz + k;
          point[k] = 0.3 * xyz[3 * (size_t)i] + 0.36 * xyz[3 * (size_t)j] + 0.34 * xyz[3 * (size_t)l];
        }
        if (is_outside(base, point)) return;
      }
    }
  }
  box_around(base, point, high);
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

/* ---- a gate ---- */

static int32_t gate_limits_init(void *limits, uint32_t struct_size, uint32_t balls) {
  return hsp_gate_limits_init(limits, struct_size, balls);
}

static int32_t gate_bytes(const void *limits, size_t *bytes) {
  return hsp_gate_bytes(limits, bytes);
}

static int32_t gate_init(void *memory, size_t bytes, const void *limits, void **handle) {
  hsp_gate *made = handle != NULL ? *handle : NULL;
  const int32_t status = hsp_gate_init(memory, bytes, limits, handle != NULL ? &made : NULL);
  if (handle != NULL) *handle = made;
  return status;
}

static int32_t gate_compute(void *handle, const void *source, void *limits) {
  const gate_result *g = source;
  return hsp_gate_compute(handle, g->base->model, g->from, NULL, limits);
}

/* By the header at most forty enlargements. */
const handle_kind gate_handle = {(uint32_t)sizeof(hsp_gate_limits),
                                 10,
                                 {"", "balls", "cubes", "entries", "cells", "adjacencies", "landmarks", "facets",
                                  "corners", "balls of a cube", "corners of a cube"},
                                 gate_limits_init,
                                 gate_bytes,
                                 gate_init,
                                 gate_compute,
                                 37};

int32_t gate_result_make(const computed *base, gate_result *g) {
  void *gate = NULL;
  double high[3];
  int32_t status;
  memset(g, 0, sizeof *g);
  g->base = base;
  point_among(base, g->from);
  status = grow_until_computed(&gate_handle, g, base->n, &g->memory, &gate, &g->needed, &g->enlargements);
  if (status == HSP_E_RANGE) { /* there is so much room that balls would grow beyond the lattice */
    box_around(base, g->from, high);
    status = grow_until_computed(&gate_handle, g, base->n, &g->memory, &gate, &g->needed, &g->enlargements);
  }
  g->gate = gate;
  return status == HSP_OK ? hsp_gate_get_widest(g->gate, &g->widest) : status;
}

void gate_result_release(gate_result *g) {
  free(g->memory);
  memset(g, 0, sizeof *g);
}
