#include "commands/surface_geometry.h"

#include <stdlib.h>
#include <string.h>

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
  status = hsp_topology_get_region_shells(geometry->work.topology, 0, shells, counts.shells, &needed);
  progress_show(&geometry->progress, "computing the surface");
  if (status == HSP_OK) status = hsp_workspace_surface_of(&geometry->work, shells, needed);
  free(shells);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The parts of a boundary. */
struct parts {
  hsp_vertex *vertex;
  hsp_arc *arc;
  hsp_circle *circle;
};

static int32_t get_parts(const hsp_boundary *boundary, struct parts *parts) {
  hsp_boundary_counts counts;
  uint32_t needed = 0;
  int32_t status = hsp_boundary_get_counts(boundary, &counts);
  if (status != HSP_OK) return status;
  parts->vertex = calloc((size_t)counts.vertices + 1, sizeof *parts->vertex);
  parts->arc = calloc((size_t)counts.arcs + 1, sizeof *parts->arc);
  parts->circle = calloc((size_t)counts.circles + 1, sizeof *parts->circle);
  if (parts->vertex == NULL || parts->arc == NULL || parts->circle == NULL) return HSP_E_MEMORY;
  status = hsp_boundary_get_vertices(boundary, parts->vertex, counts.vertices, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_arcs(boundary, parts->arc, counts.arcs, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_circles(boundary, parts->circle, counts.circles, &needed);
  return status;
}

static void set_patch(const hsp_surface_patch *from, const struct parts *parts, struct mesh_patch *patch) {
  patch->ball[0] = patch->ball[1] = patch->ball[2] = UINT32_MAX;
  if (from->kind == HSP_PATCH_CONCAVE) {
    memcpy(patch->probe, parts->vertex[from->source].xyz, sizeof patch->probe);
    memcpy(patch->ball, parts->vertex[from->source].ball, sizeof patch->ball);
  } else if (from->kind != HSP_PATCH_CONVEX) {
    const bool of_arc = from->kind == HSP_PATCH_SADDLE;
    const uint32_t *ball = of_arc ? parts->arc[from->source].ball : parts->circle[from->source].ball;
    memcpy(patch->ball, ball, 2 * sizeof *ball);
  }
}

bool geometry_list_patches(const struct geometry *geometry, struct mesh_patch **patches, struct failure *failure) {
  hsp_surface_part_counts counts;
  struct parts parts = {NULL, NULL, NULL};
  int32_t status = hsp_surface_get_part_counts(geometry->work.surface, &counts);
  if (status != HSP_OK) return failure_in_library(failure, status);
  hsp_surface_patch *from = calloc((size_t)counts.patches + 1, sizeof *from);
  *patches = calloc((size_t)counts.patches + 1, sizeof **patches);
  status = from == NULL || *patches == NULL ? HSP_E_MEMORY : get_parts(geometry->work.boundary, &parts);
  if (status == HSP_OK) status = hsp_surface_get_patches(geometry->work.surface, 0, counts.patches, from);
  for (uint32_t k = 0; status == HSP_OK && k < counts.patches; ++k) set_patch(&from[k], &parts, &(*patches)[k]);
  free(from);
  free(parts.vertex);
  free(parts.arc);
  free(parts.circle);
  if (status == HSP_OK) return true;
  free(*patches);
  return failure_in_library(failure, status);
}

bool geometry_compute_mesh(struct geometry *geometry, bool of_surface, double edge, struct failure *failure) {
  progress_show(&geometry->progress, "making triangles");
  const int32_t status = hsp_workspace_mesh(&geometry->work, of_surface, edge);
  if (status == HSP_E_DEGENERATE) {
    return failure_in_input(failure, 0, "borders of the surface come together: no triangles tell them apart");
  }
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--edge %g yields too many triangles", edge);
  return status == HSP_OK || failure_in_library(failure, status);
}
