#include "read/geometry.h"

#include <stdlib.h>

bool failure_in_library(struct failure *failure, int32_t status) {
  /* The workspace takes as much memory as it needs. */
  if (status == HSP_E_MEMORY) return failure_of_memory(failure);
  return failure_in_input(failure, 0, "%s", hsp_status_text(status));
}

const char *geometry_reason(int32_t status) {
  return status == HSP_E_RANGE ? "a value lies beyond the lattice or the largest size" : hsp_status_text(status);
}

bool geometry_set_model(struct geometry *geometry, const struct molecule *molecule, double probe, double step,
                        struct failure *failure) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, (uint32_t)sizeof options);
  if (status != HSP_OK) return failure_in_library(failure, status);
  options.probe = probe;
  options.step = step;
  progress_show(&geometry->progress, "building the model");
  uint32_t first_bad = HSP_NONE;
  status = hsp_workspace_set(&geometry->work, molecule->atoms, molecule->xyz, molecule->radius, &options, &first_bad);
  if (status != HSP_OK && first_bad < molecule->atoms) {
    const uint64_t line = molecule->line[first_bad];
    if (probe == 0.0) {
      return failure_in_input(failure, line, "ball %lu: %s", (unsigned long)first_bad, geometry_reason(status));
    }
    return failure_in_input(failure, line, "ball %lu, probe %g added: %s", (unsigned long)first_bad, probe,
                            geometry_reason(status));
  }
  if (status == HSP_E_RANGE && probe > 0.0) {
    return failure_in_input(failure, 0, "probe %g: %s", probe, geometry_reason(status));
  }
  if (status != HSP_OK) return failure_in_library(failure, status);
  return true;
}

bool geometry_compute_boundary(struct geometry *geometry, struct failure *failure) {
  progress_show(&geometry->progress, "computing the boundary");
  const int32_t status = hsp_workspace_boundary(&geometry->work);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_compute_topology(struct geometry *geometry, struct failure *failure) {
  if (!geometry_compute_boundary(geometry, failure)) return false;
  progress_show(&geometry->progress, "computing the topology");
  const int32_t status = hsp_workspace_topology(&geometry->work);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_compute_contacts(struct geometry *geometry, struct failure *failure) {
  if (!geometry_compute_boundary(geometry, failure)) return false;
  progress_show(&geometry->progress, "finding contacts");
  const int32_t status = hsp_workspace_contacts(&geometry->work);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* Memory for the limits; what was in it before is lost. */
static int32_t make_periodic(struct geometry *geometry) {
  size_t bytes = 0;
  int32_t status = hsp_periodic_bytes(&geometry->periodic_limits, &bytes);
  geometry->periodic = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&geometry->periodic_memory, bytes);
  if (status == HSP_OK) {
    status = hsp_periodic_init(geometry->periodic_memory, bytes, &geometry->periodic_limits, &geometry->periodic);
  }
  return status;
}

bool geometry_compute_periodic(struct geometry *geometry, const struct molecule *molecule, double probe,
                               const double *box, struct failure *failure) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, (uint32_t)sizeof options);
  options.probe = probe;
  progress_show(&geometry->progress, "computing the box");
  if (status == HSP_OK && geometry->periodic == NULL) {
    status = hsp_periodic_limits_init(&geometry->periodic_limits, (uint32_t)sizeof geometry->periodic_limits,
                                      molecule->atoms);
    if (status == HSP_OK) status = make_periodic(geometry);
  }
  while (status == HSP_OK) {
    hsp_periodic_limits limits = geometry->periodic_limits;
    status = hsp_periodic_compute(geometry->periodic, molecule->atoms, molecule->xyz, molecule->radius, &options, box,
                                  &limits, NULL);
    if (status != HSP_E_CAPACITY) break;
    geometry->periodic_limits = limits;
    status = make_periodic(geometry);
  }
  if (status == HSP_E_ARGUMENT) {
    return failure_in_input(failure, 0, "the box: its vectors must be AX,0,0, BX,BY,0 and CX,CY,CZ");
  }
  if (status == HSP_E_RANGE) {
    return failure_in_input(failure, 0, "the box is too thin for the balls, too large, or a ball is too far from it");
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_compute_cells(struct geometry *geometry, struct failure *failure) {
  progress_show(&geometry->progress, "cutting free space");
  const int32_t status = hsp_workspace_cells(&geometry->work);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_find_path(struct geometry *geometry, const double from[3], const double to[3], hsp_path *path,
                        struct failure *failure) {
  progress_show(&geometry->progress, "looking for a path");
  const int32_t status = hsp_workspace_path(&geometry->work, from, to, path);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--from or --to: %s", geometry_reason(status));
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_find_gate(struct geometry *geometry, const struct molecule *molecule, const double from[3],
                        const double *to, struct failure *failure) {
  enum { COARSER = 6 };
  hsp_model_info info;
  progress_show(&geometry->progress, "looking for the widest probe");
  int32_t status = hsp_workspace_gate(&geometry->work, from, to);
  for (int time = 0; time < COARSER && status == HSP_E_RANGE; ++time) {
    status = hsp_model_get_info(geometry->work.model, &info);
    if (status != HSP_OK) return failure_in_library(failure, status);
    if (!geometry_set_model(geometry, molecule, 0.0, 10.0 * info.step, failure)) return false;
    status = hsp_workspace_gate(&geometry->work, from, to);
  }
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--from or --to: %s", geometry_reason(status));
  return status == HSP_OK || failure_in_library(failure, status);
}

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

bool geometry_compute_view(struct geometry *geometry, const hsp_view_options *options, struct failure *failure) {
  progress_show(&geometry->progress, "cutting and sorting");
  const int32_t status = hsp_workspace_view(&geometry->work, geometry->work.boundary != NULL, options);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_compute_map(struct geometry *geometry, const struct viewing *viewing, const struct molecule *molecule,
                          struct failure *failure) {
  hsp_view_options options;
  progress_show(&geometry->progress, "finding what is seen");
  int32_t status = viewing_options(viewing, molecule, &options);
  if (status == HSP_OK) status = hsp_workspace_map(&geometry->work, &options);
  if (status == HSP_E_CHECK) {
    return failure_in_input(failure, 0, "too many balls stand exactly behind each other: look from elsewhere");
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_list_shells(const struct geometry *geometry, hsp_shell **shells, uint32_t *count,
                          struct failure *failure) {
  *count = 0;
  int32_t status = hsp_topology_get_shells(geometry->work.topology, NULL, 0, count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  *shells = calloc((size_t)*count + 1, sizeof **shells);
  if (*shells == NULL) return failure_of_memory(failure);
  status = hsp_topology_get_shells(geometry->work.topology, *shells, *count, count);
  if (status == HSP_OK) return true;
  free(*shells);
  return failure_in_library(failure, status);
}

void geometry_free(struct geometry *geometry) {
  progress_end(&geometry->progress);
  free(geometry->sticks_memory);
  free(geometry->periodic_memory);
  hsp_workspace_free(&geometry->work);
}
