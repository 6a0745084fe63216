#include "commands/surface_geometry.h"

#include <stdlib.h>

bool geometry_compute_surface(struct geometry *geometry, struct failure *failure) {
  progress_show(&geometry->progress, "computing the surface");
  const int32_t status = hsp_workspace_surface(&geometry->work);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_compute_outer_surface(struct geometry *geometry, struct failure *failure) {
  progress_show(&geometry->progress, "computing the topology");
  hsp_topology_counts counts;
  uint32_t needed = 0;
  int32_t status = hsp_workspace_topology(&geometry->work);
  if (status == HSP_OK) status = hsp_topology_get_counts(geometry->work.topology, &counts);
  if (status != HSP_OK) return failure_in_library(failure, status);
  uint32_t *shells = calloc((size_t)counts.shells + 1, sizeof *shells);
  if (shells == NULL) return failure_of_memory(failure);
  status = hsp_topology_get_cell_shells(geometry->work.topology, 0, shells, counts.shells, &needed);
  progress_show(&geometry->progress, "computing the surface");
  if (status == HSP_OK) status = hsp_workspace_surface_of(&geometry->work, shells, needed);
  free(shells);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_compute_mesh(struct geometry *geometry, bool of_surface, double edge, struct failure *failure) {
  progress_show(&geometry->progress, "making triangles");
  const int32_t status = hsp_workspace_mesh(&geometry->work, of_surface, edge);
  if (status == HSP_E_OPEN_SURFACE) {
    return failure_in_input(failure, 0, "patches of the surface meet in one point: it has no triangles there");
  }
  if (status == HSP_E_CHECK) {
    return failure_in_input(failure, 0, "borders of the surface come together: no triangles tell them apart");
  }
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--edge %g yields too many triangles", edge);
  return status == HSP_OK || failure_in_library(failure, status);
}
