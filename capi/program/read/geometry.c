#include "read/geometry.h"

#include <stdlib.h>

#include "read/stopping.h"
#include "read/threads.h"

/* The number of balls that is worth the start of a thread: a millisecond or two of work. */
enum { BALLS_OF_THREAD = 1500 };

static int32_t run_tasks(void *context, uint32_t tasks, hsp_task *task, void *data) {
  const hsp_executor *const executor = context;
  threads_run(executor->workers, tasks, task, data);
  return 0;
}

void geometry_share_work(struct geometry *geometry, uint32_t threads, uint32_t balls) {
  const uint32_t most = balls / BALLS_OF_THREAD;
  hsp_executor *const executor = &geometry->executor;
  executor->struct_size = (uint32_t)sizeof *executor;
  executor->workers = threads < most ? threads : most;
  executor->context = executor;
  executor->run = run_tasks;
  executor->proceed = stopping_proceed;
}

const hsp_executor *geometry_executor(const struct geometry *geometry) {
  return geometry->executor.workers > 1 ? &geometry->executor : stopping_executor();
}

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
  options.largest_radius = geometry->largest_radius;
  progress_show(&geometry->progress, "building the model");
  uint32_t first_bad = HSP_NONE;
  geometry->work.executor = stopping_executor();
  status = hsp_workspace_set(&geometry->work, molecule->atoms, molecule->xyz, molecule->radius, &options, &first_bad);
  if (status != HSP_OK && first_bad < molecule->atoms) {
    const uint64_t line = molecule->line[first_bad];
    if (probe == 0.0) {
      return failure_in_input(failure, line, "ball %lu: %s", (unsigned long)first_bad, geometry_reason(status));
    }
    return failure_in_input(failure, line, "ball %lu, probe %g added: %s", (unsigned long)first_bad, probe,
                            geometry_reason(status));
  }
  if (status == HSP_E_RANGE && probe < 1.0) {
    return failure_in_input(failure, 0, "all lengths are below 1.05e-16: give them in a smaller unit");
  }
  if (status == HSP_E_RANGE) {
    return failure_in_input(failure, 0, "probe %g: %s", probe, geometry_reason(status));
  }
  hsp_model_info info;
  if (status == HSP_OK) status = hsp_model_get_info(geometry->work.model, &info);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (info.largest_rounding > geometry->largest_rounding) geometry->largest_rounding = info.largest_rounding;
  return true;
}

bool geometry_compute_boundary(struct geometry *geometry, struct failure *failure) {
  return geometry_compute_boundary_of(geometry, NULL, failure);
}

bool geometry_compute_boundary_of(struct geometry *geometry, const uint8_t *selected, struct failure *failure) {
  progress_show(&geometry->progress, "computing the boundary");
  const hsp_boundary_request request = {
      .struct_size = sizeof request, .reserved = 0, .executor = geometry_executor(geometry), .selected = selected};
  int32_t status = hsp_workspace_boundary_with(&geometry->work, &request);
  if (status == HSP_E_MEMORY && request.executor->workers > 1) { /* each thread needs some of its own */
    geometry->executor.workers = 1;
    geometry->work.boundary_limits.workers = 0;
    status = hsp_workspace_boundary_with(
        &geometry->work,
        &(hsp_boundary_request){.struct_size = sizeof request, .executor = stopping_executor(), .selected = selected});
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_measure(const struct geometry *geometry, uint32_t balls, const uint8_t *selected, hsp_totals *totals,
                      double *area, struct failure *failure) {
  const hsp_measure_request request = {
      .struct_size = (uint32_t)sizeof request, .selected = selected, .executor = geometry_executor(geometry)};
  hsp_measure_outputs outputs = {
      .struct_size = (uint32_t)sizeof outputs, .capacity = area == NULL ? 0 : balls, .totals = totals, .area = area};
  const int32_t status = hsp_boundary_get_measures(geometry->work.boundary, &request, &outputs);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_compute_topology(struct geometry *geometry, struct failure *failure) {
  return geometry_compute_boundary(geometry, failure) && geometry_topology_of_boundary(geometry, failure);
}

bool geometry_topology_of_boundary(struct geometry *geometry, struct failure *failure) {
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

bool geometry_compute_periodic(struct geometry *geometry, const struct molecule *molecule, double probe, double step,
                               const double *box, struct failure *failure) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, (uint32_t)sizeof options);
  options.probe = probe;
  options.step = step;
  progress_show(&geometry->progress, "computing the box");
  if (status == HSP_OK && geometry->periodic == NULL) {
    status = hsp_periodic_limits_init(&geometry->periodic_limits, (uint32_t)sizeof geometry->periodic_limits,
                                      molecule->atoms);
    if (status == HSP_OK) status = make_periodic(geometry);
  }
  while (status == HSP_OK) {
    hsp_periodic_limits limits = geometry->periodic_limits;
    const hsp_periodic_request request = {
        .struct_size = (uint32_t)sizeof request, .options = &options, .executor = stopping_executor()};
    status = hsp_periodic_compute_with(geometry->periodic, molecule->atoms, molecule->xyz, molecule->radius, box,
                                       &request, &limits, NULL);
    if (status != HSP_E_CAPACITY) break;
    geometry->periodic_limits = limits;
    status = make_periodic(geometry);
  }
  if (status == HSP_E_RANGE) {
    return failure_in_input(failure, 0,
                            "the box is flat, too thin for the balls, too large, or a ball is too far from it");
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
  free(geometry->bond);
  free(geometry->sticks_memory);
  free(geometry->ink_of_sticks_memory);
  free(geometry->periodic_memory);
  hsp_workspace_free(&geometry->work);
}
