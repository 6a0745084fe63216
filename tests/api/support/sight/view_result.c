#include "view_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(view)
LIMITS_OF_BALLS(view)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const view_result *v = source;
  const hsp_boundary *boundary = v->with_boundary ? v->base->boundary : NULL;
  return hsp_view_compute(handle, v->base->model, boundary, &v->options, limits);
}

const handle_kind view_handle = {(uint32_t)sizeof(hsp_view_limits),
                                 3,
                                 {"", "balls", "neighbours", "arcs", ""},
                                 init_limits,
                                 bytes_of_limits,
                                 init_handle,
                                 compute_handle,
                                 0};

static int32_t compute_view(view_result *v) {
  void *view = NULL;
  const int32_t status =
      grow_until_computed(&view_handle, v, v->base->n, &v->memory, &view, &v->needed, &v->enlargements);
  v->view = view;
  return status;
}

static int32_t read_view(view_result *v) {
  uint32_t needed = 0;
  int32_t status = hsp_view_get_info(v->view, &v->info);
  if (status != HSP_OK) return status;
  v->pieces = test_zeros(v->info.pieces, sizeof *v->pieces);
  v->loops = test_zeros(v->info.loops, sizeof *v->loops);
  v->arcs = test_zeros(v->info.arcs, sizeof *v->arcs);
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
