#include "topology_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(topology)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const topology_result *t = source;
  return hsp_topology_compute(handle, t->base->boundary, limits);
}

const handle_kind topology_handle = {(uint32_t)sizeof(hsp_topology_limits),
                                     4,
                                     {"", "balls", "neighbours", "edges", "cut arcs", "shells"},
                                     NULL,
                                     bytes_of_limits,
                                     init_handle,
                                     compute_handle,
                                     0};

static int32_t compute_topology(topology_result *t) {
  void *topology = NULL;
  const int32_t status =
      grow_until_computed(&topology_handle, t, t->base->n, &t->memory, &topology, &t->needed, &t->enlargements);
  t->topology = topology;
  return status;
}

static int32_t read_topology(topology_result *t) {
  uint32_t needed = 0;
  const hsp_topology_counts *k = &t->counts;
  int32_t status = hsp_topology_get_counts(t->topology, &t->counts);
  if (status != HSP_OK) return status;
  t->onext = test_zeros(k->edges, 4 * sizeof *t->onext);
  t->origin = test_zeros(k->edges, 4 * sizeof *t->origin);
  t->vertices = test_zeros(k->vertices, sizeof *t->vertices);
  t->edges = test_zeros(k->edges, sizeof *t->edges);
  t->faces = test_zeros(k->simple_faces, sizeof *t->faces);
  t->shells = test_zeros(k->shells, sizeof *t->shells);
  t->components = test_zeros(k->components, sizeof *t->components);
  t->regions = test_zeros(k->regions, sizeof *t->regions);
  status = hsp_topology_get_quad_edges(t->topology, 0, k->edges, t->onext, t->origin);
  if (status == HSP_OK) status = hsp_topology_get_vertices(t->topology, 0, k->vertices, t->vertices);
  if (status == HSP_OK) status = hsp_topology_get_edges(t->topology, 0, k->edges, t->edges);
  if (status == HSP_OK) status = hsp_topology_get_simple_faces(t->topology, 0, k->simple_faces, t->faces);
  if (status == HSP_OK) status = hsp_topology_get_shells(t->topology, t->shells, k->shells, &needed);
  if (status == HSP_OK) status = hsp_topology_get_components(t->topology, t->components, k->components, &needed);
  if (status == HSP_OK) status = hsp_topology_get_regions(t->topology, t->regions, k->regions, &needed);
  return status;
}

int32_t topology_result_make(const computed *base, topology_result *t) {
  int32_t status;
  memset(t, 0, sizeof *t);
  t->base = base;
  status = compute_topology(t);
  if (status == HSP_OK) status = read_topology(t);
  return status;
}

void topology_result_release(topology_result *t) {
  free(t->memory);
  free(t->onext);
  free(t->origin);
  free(t->vertices);
  free(t->edges);
  free(t->faces);
  free(t->shells);
  free(t->components);
  free(t->regions);
  memset(t, 0, sizeof *t);
}
