#include "map_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(map)
LIMITS_OF_BALLS(map)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const map_result *m = source;
  return hsp_map_compute(handle, m->base->model, &m->options, limits);
}

const handle_kind map_handle = {(uint32_t)sizeof(hsp_map_limits),
                                3,
                                {"", "balls", "neighbours", "edges", ""},
                                init_limits,
                                bytes_of_limits,
                                init_handle,
                                compute_handle,
                                9};

static int32_t read_map(map_result *m) {
  uint32_t needed = 0;
  int32_t status = hsp_map_get_info(m->map, &m->info);
  if (status != HSP_OK) return status;
  m->vertices = test_zeros(m->info.vertices, sizeof *m->vertices);
  m->edges = test_zeros(m->info.edges, sizeof *m->edges);
  m->faces = test_zeros(m->info.faces, sizeof *m->faces);
  m->area = test_zeros(m->base->n, sizeof *m->area);
  status = hsp_map_get_vertices(m->map, 0, m->info.vertices, m->vertices);
  if (status == HSP_OK) status = hsp_map_get_edges(m->map, 0, m->info.edges, m->edges);
  if (status == HSP_OK) status = hsp_map_get_faces(m->map, 0, m->info.faces, m->faces);
  if (status == HSP_OK) status = hsp_map_get_areas(m->map, m->area, m->base->n, &needed);
  return status;
}

int32_t map_result_make(const computed *base, const hsp_view_options *options, map_result *m) {
  void *map = NULL;
  int32_t status;
  memset(m, 0, sizeof *m);
  m->base = base;
  m->options = *options;
  status = grow_until_computed(&map_handle, m, base->n, &m->memory, &map, &m->needed, &m->enlargements);
  m->map = map;
  return status == HSP_OK ? read_map(m) : status;
}

void map_result_release(map_result *m) {
  free(m->memory);
  free(m->vertices);
  free(m->edges);
  free(m->faces);
  free(m->area);
  memset(m, 0, sizeof *m);
}
