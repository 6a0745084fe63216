#include "view_result.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *take(size_t count, size_t size) {
  void *memory = calloc(count == 0 ? 1 : count, size);
  if (memory == NULL) {
    fprintf(stderr, "out of memory in a test\n");
    exit(2);
  }
  return memory;
}

static void raise_to(uint32_t *limit, uint32_t needed) {
  if (needed > *limit) *limit = needed;
}

/* From no room for anything but the balls: the header promises that the third enlargement suffices. */
static int32_t compute_view(view_result *v) {
  const hsp_boundary *boundary = v->with_boundary ? v->base->boundary : NULL;
  hsp_view_limits limits;
  memset(&limits, 0, sizeof limits);
  limits.struct_size = (uint32_t)sizeof limits;
  limits.balls = v->base->n;
  for (v->enlargements = 0;; ++v->enlargements) {
    size_t bytes = 0;
    int32_t status = hsp_view_bytes(&limits, &bytes);
    if (status != HSP_OK) return status;
    free(v->memory);
    v->memory = take(bytes, 1);
    status = hsp_view_init(v->memory, bytes, &limits, &v->view);
    if (status != HSP_OK) return status;
    status = hsp_view_compute(v->view, v->base->model, boundary, &v->options);
    if (status == HSP_OK) return hsp_view_get_needed(v->view, &v->needed);
    if (status != HSP_E_CAPACITY || v->enlargements == 3) return status;
    status = hsp_view_get_needed(v->view, &v->needed);
    if (status != HSP_OK) return status;
    raise_to(&limits.balls, v->needed.balls);
    raise_to(&limits.neighbours, v->needed.neighbours);
    raise_to(&limits.arcs, v->needed.arcs);
  }
}

static int32_t read_view(view_result *v) {
  uint32_t needed = 0;
  int32_t status = hsp_view_get_info(v->view, &v->info);
  if (status != HSP_OK) return status;
  v->pieces = take(v->info.pieces, sizeof *v->pieces);
  v->loops = take(v->info.loops, sizeof *v->loops);
  v->arcs = take(v->info.arcs, sizeof *v->arcs);
  status = hsp_view_get_pieces(v->view, v->pieces, v->info.pieces, &needed);
  if (status == HSP_OK) status = hsp_view_get_loops(v->view, v->loops, v->info.loops, &needed);
  if (status == HSP_OK) status = hsp_view_get_arcs(v->view, v->arcs, v->info.arcs, &needed);
  return status;
}

int32_t view_result_make(const computed *base, const hsp_view_options *options, int with_boundary, view_result *v) {
  int32_t status;
  memset(v, 0, sizeof *v);
  v->base = base;
  v->options = *options;
  v->with_boundary = with_boundary;
  status = compute_view(v);
  if (status == HSP_OK) status = read_view(v);
  return status;
}

void view_result_release(view_result *v) {
  free(v->memory);
  free(v->pieces);
  free(v->loops);
  free(v->arcs);
  memset(v, 0, sizeof *v);
}
