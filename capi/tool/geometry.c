#include "geometry.h"

#include <stdlib.h>

bool failure_in_library(struct failure *failure, int32_t status) {
  return failure_in_input(failure, 0, "%s", hsp_status_text(status));
}

static void *allocate(size_t bytes, struct failure *failure) {
  void *memory = malloc(bytes == 0 ? 1 : bytes);
  if (memory == NULL) failure_in_input(failure, 0, "out of memory: %zu bytes are needed at once", bytes);
  return memory;
}

bool geometry_set_model(struct geometry *geometry, const struct molecule *molecule, double probe,
                        struct failure *failure) {
  size_t bytes = 0;
  int32_t status = hsp_model_bytes(molecule->atoms, &bytes);
  if (status != HSP_OK) return failure_in_library(failure, status);
  geometry->model_memory = allocate(bytes, failure);
  if (geometry->model_memory == NULL) return false;
  status = hsp_model_init(geometry->model_memory, bytes, molecule->atoms, &geometry->model);
  if (status != HSP_OK) return failure_in_library(failure, status);

  hsp_model_options options;
  status = hsp_model_options_init(&options, (uint32_t)sizeof options);
  if (status != HSP_OK) return failure_in_library(failure, status);
  options.probe = probe;
  uint32_t first_bad = HSP_NONE;
  status = hsp_model_set(geometry->model, molecule->atoms, molecule->xyz, molecule->radius, &options, &first_bad);
  if (status != HSP_OK && first_bad < molecule->atoms) {
    const uint64_t line = molecule->line[first_bad];
    if (probe == 0.0) {
      return failure_in_input(failure, line, "ball %lu: %s", (unsigned long)first_bad, hsp_status_text(status));
    }
    return failure_in_input(failure, line, "ball %lu, probe %g added: %s", (unsigned long)first_bad, probe,
                            hsp_status_text(status));
  }
  if (status == HSP_E_RANGE && probe > 0.0) {
    return failure_in_input(failure, 0, "probe %g: %s", probe, hsp_status_text(status));
  }
  if (status != HSP_OK) return failure_in_library(failure, status);
  return true;
}

/* Raise *limit to what is needed; whether that changed it. */
static bool raise(uint32_t *limit, uint32_t needed) {
  if (needed <= *limit) return false;
  *limit = needed;
  return true;
}

bool geometry_compute_boundary(struct geometry *geometry, const struct molecule *molecule, struct failure *failure) {
  hsp_boundary_limits limits;
  int32_t status = hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, molecule->atoms);
  if (status != HSP_OK) return failure_in_library(failure, status);
  for (;;) {
    size_t bytes = 0;
    status = hsp_boundary_bytes(&limits, &bytes);
    if (status != HSP_OK) return failure_in_library(failure, status);
    free(geometry->boundary_memory);
    geometry->boundary = NULL;
    geometry->boundary_memory = allocate(bytes, failure);
    if (geometry->boundary_memory == NULL) return false;
    status = hsp_boundary_init(geometry->boundary_memory, bytes, &limits, &geometry->boundary);
    if (status != HSP_OK) return failure_in_library(failure, status);

    status = hsp_boundary_compute(geometry->boundary, geometry->model);
    if (status == HSP_OK) return true;
    hsp_boundary_limits needed;
    if (status != HSP_E_CAPACITY || hsp_boundary_get_needed(geometry->boundary, &needed) != HSP_OK) {
      return failure_in_library(failure, status);
    }
    /* Each round raises a limit, or the library contradicts its header and the loop must end. */
    const bool more_neighbours = raise(&limits.neighbours, needed.neighbours);
    const bool more_vertices = raise(&limits.vertices, needed.vertices);
    const bool more_circles = raise(&limits.circles, needed.circles);
    if (!more_neighbours && !more_vertices && !more_circles) return failure_in_library(failure, status);
  }
}

bool geometry_compute_topology(struct geometry *geometry, const struct molecule *molecule, struct failure *failure) {
  if (!geometry_compute_boundary(geometry, molecule, failure)) return false;
  hsp_topology_limits limits;
  int32_t status = hsp_topology_limits_for(&limits, (uint32_t)sizeof limits, geometry->boundary);
  if (status != HSP_OK) return failure_in_library(failure, status);
  for (;;) {
    size_t bytes = 0;
    status = hsp_topology_bytes(&limits, &bytes);
    if (status != HSP_OK) return failure_in_library(failure, status);
    free(geometry->topology_memory);
    geometry->topology = NULL;
    geometry->topology_memory = allocate(bytes, failure);
    if (geometry->topology_memory == NULL) return false;
    status = hsp_topology_init(geometry->topology_memory, bytes, &limits, &geometry->topology);
    if (status != HSP_OK) return failure_in_library(failure, status);

    status = hsp_topology_compute(geometry->topology, geometry->boundary);
    if (status == HSP_OK) return true;
    hsp_topology_limits needed;
    if (status != HSP_E_CAPACITY || hsp_topology_get_needed(geometry->topology, &needed) != HSP_OK) {
      return failure_in_library(failure, status);
    }
    const bool more_neighbours = raise(&limits.neighbours, needed.neighbours);
    const bool more_edges = raise(&limits.edges, needed.edges);
    const bool more_cut_arcs = raise(&limits.cut_arcs, needed.cut_arcs);
    if (!more_neighbours && !more_edges && !more_cut_arcs) return failure_in_library(failure, status);
  }
}

bool geometry_compute_view(struct geometry *geometry, const struct molecule *molecule, const hsp_view_options *options,
                           struct failure *failure) {
  hsp_view_limits limits;
  int32_t status = hsp_view_limits_init(&limits, (uint32_t)sizeof limits, molecule->atoms);
  if (status != HSP_OK) return failure_in_library(failure, status);
  for (;;) {
    size_t bytes = 0;
    status = hsp_view_bytes(&limits, &bytes);
    if (status != HSP_OK) return failure_in_library(failure, status);
    free(geometry->view_memory);
    geometry->view = NULL;
    geometry->view_memory = allocate(bytes, failure);
    if (geometry->view_memory == NULL) return false;
    status = hsp_view_init(geometry->view_memory, bytes, &limits, &geometry->view);
    if (status != HSP_OK) return failure_in_library(failure, status);

    status = hsp_view_compute(geometry->view, geometry->model, geometry->boundary, options);
    if (status == HSP_OK) return true;
    hsp_view_limits needed;
    if (status != HSP_E_CAPACITY || hsp_view_get_needed(geometry->view, &needed) != HSP_OK) {
      return failure_in_library(failure, status);
    }
    const bool more_neighbours = raise(&limits.neighbours, needed.neighbours);
    const bool more_arcs = raise(&limits.arcs, needed.arcs);
    if (!more_neighbours && !more_arcs) return failure_in_library(failure, status);
  }
}

bool geometry_list_shells(const struct geometry *geometry, hsp_shell **shells, uint32_t *count,
                          struct failure *failure) {
  *count = 0;
  int32_t status = hsp_topology_get_shells(geometry->topology, NULL, 0, count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  *shells = calloc((size_t)*count + 1, sizeof **shells);
  if (*shells == NULL) return failure_of_memory(failure);
  status = hsp_topology_get_shells(geometry->topology, *shells, *count, count);
  if (status == HSP_OK) return true;
  free(*shells);
  return failure_in_library(failure, status);
}

void geometry_free(struct geometry *geometry) {
  free(geometry->model_memory);
  free(geometry->boundary_memory);
  free(geometry->topology_memory);
  free(geometry->view_memory);
  *geometry = (struct geometry)GEOMETRY_NONE;
}
