#include "topology_result.h"

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
static int32_t compute_topology(topology_result *t) {
  hsp_topology_limits limits;
  memset(&limits, 0, sizeof limits);
  limits.struct_size = (uint32_t)sizeof limits;
  limits.balls = t->base->n;
  for (t->enlargements = 0;; ++t->enlargements) {
    size_t bytes = 0;
    int32_t status = hsp_topology_bytes(&limits, &bytes);
    if (status != HSP_OK) return status;
    free(t->memory);
    t->memory = take(bytes, 1);
    status = hsp_topology_init(t->memory, bytes, &limits, &t->topology);
    if (status != HSP_OK) return status;
    status = hsp_topology_compute(t->topology, t->base->boundary);
    if (status == HSP_OK) return hsp_topology_get_needed(t->topology, &t->needed);
    if (status != HSP_E_CAPACITY || t->enlargements == 3) return status;
    status = hsp_topology_get_needed(t->topology, &t->needed);
    if (status != HSP_OK) return status;
    raise_to(&limits.balls, t->needed.balls);
    raise_to(&limits.neighbours, t->needed.neighbours);
    raise_to(&limits.edges, t->needed.edges);
    raise_to(&limits.extra_arcs, t->needed.extra_arcs);
  }
}

static int32_t read_topology(topology_result *t) {
  uint32_t needed = 0;
  const hsp_topology_counts *k = &t->counts;
  int32_t status = hsp_topology_get_counts(t->topology, &t->counts);
  if (status != HSP_OK) return status;
  t->onext = take(k->edges, 4 * sizeof *t->onext);
  t->origin = take(k->edges, 4 * sizeof *t->origin);
  t->vertices = take(k->vertices, sizeof *t->vertices);
  t->edges = take(k->edges, sizeof *t->edges);
  t->faces = take(k->simple_faces, sizeof *t->faces);
  t->shells = take(k->shells, sizeof *t->shells);
  t->components = take(k->components, sizeof *t->components);
  t->cells = take(k->cells, sizeof *t->cells);
  status = hsp_topology_get_quad_edges(t->topology, t->onext, t->origin, k->edges, &needed);
  if (status == HSP_OK) status = hsp_topology_get_vertices(t->topology, t->vertices, k->vertices, &needed);
  if (status == HSP_OK) status = hsp_topology_get_edges(t->topology, t->edges, k->edges, &needed);
  if (status == HSP_OK) status = hsp_topology_get_faces(t->topology, t->faces, k->simple_faces, &needed);
  if (status == HSP_OK) status = hsp_topology_get_shells(t->topology, t->shells, k->shells, &needed);
  if (status == HSP_OK) status = hsp_topology_get_components(t->topology, t->components, k->components, &needed);
  if (status == HSP_OK) status = hsp_topology_get_cells(t->topology, t->cells, k->cells, &needed);
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
  free(t->cells);
  memset(t, 0, sizeof *t);
}

const char *broken_topology(const topology_result *t) {
  const char *broken = broken_quad_edges(t);
  if (broken == NULL) broken = broken_cuts(t);
  if (broken == NULL) broken = broken_shell_records(t);
  if (broken == NULL) broken = broken_topology_places(t);
  if (broken == NULL) broken = broken_face_areas(t);
  if (broken == NULL) broken = broken_start_faces(t);
  return broken;
}
