/* Functions that the examples of split work share: boundary, areas, volume and the area's gradient of a file's balls,
 * by an executor and by one thread, which must find the same bits. */
#ifndef SPLIT_WORK_H
#define SPLIT_WORK_H

#include <hardsphere_workspace.h>
#include <stdio.h>

#include "read_balls.h"

struct results {
  hsp_boundary_counts counts;
  hsp_totals totals;
  hsp_energy energy;
  double *numbers; /* [5 n]: areas, terms of the volume, the area's gradient by the centres */
};

static inline int32_t compute(const struct balls *balls, const hsp_executor *executor, struct results *r) {
  const uint32_t n = balls->count;
  r->numbers = malloc((5 * (size_t)n + 1) * sizeof *r->numbers);
  if (r->numbers == NULL) return HSP_E_MEMORY;
  double *const area = r->numbers, *const volume = area + n, *const centre = volume + n;
  hsp_boundary_request computing = {.struct_size = sizeof computing, .executor = executor};
  hsp_measure_request measuring = {.struct_size = sizeof measuring, .executor = executor};
  hsp_measure_outputs measures = {sizeof measures, .capacity = n, .totals = &r->totals, .area = area,
                                  .volume_term = volume};
  hsp_gradient_request deriving = {.struct_size = sizeof deriving, .tension = 1, .executor = executor};
  hsp_gradient_outputs gradient = {sizeof gradient, .capacity = n, .energy = &r->energy, .d_centre = centre};
  hsp_workspace work = {0};
  int32_t status = hsp_workspace_set(&work, n, balls->xyz, balls->radius, NULL, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary_with(&work, &computing);
  if (status == HSP_OK) status = hsp_boundary_get_measures(work.boundary, &measuring, &measures);
  if (status == HSP_OK) status = hsp_boundary_get_gradient(work.boundary, &deriving, &gradient);
  if (status == HSP_OK) status = hsp_boundary_get_counts(work.boundary, &r->counts);
  hsp_workspace_free(&work);
  return status;
}

/* Whether both have the same, which is printed; the status of a program. */
static inline int compare_with_one(const char *path, const hsp_executor *executor) {
  struct balls balls = {0, NULL, NULL};
  struct results r, one;
  memset(&r, 0, sizeof r);
  memset(&one, 0, sizeof one);
  int same = 0;
  if (read_balls(path, &balls)) {
    int32_t status = compute(&balls, executor, &r);
    if (status == HSP_OK) status = compute(&balls, NULL, &one);
    if (status == HSP_OK) {
      same = memcmp(&r.counts, &one.counts, sizeof r.counts) == 0 &&
             memcmp(&r.totals, &one.totals, sizeof r.totals) == 0 &&
             memcmp(&r.energy, &one.energy, sizeof r.energy) == 0 &&
             memcmp(r.numbers, one.numbers, 5 * (size_t)balls.count * sizeof *r.numbers) == 0;
      printf("%u balls, %u vertices, area %.6f, volume %.6f: %s as by one thread\n", (unsigned)balls.count,
             (unsigned)r.counts.vertices, r.totals.area, r.totals.volume, same ? "the same bits" : "NOT the same bits");
    } else {
      fprintf(stderr, "%s: %s\n", path, hsp_status_text(status));
    }
  }
  free(r.numbers);
  free(one.numbers);
  free_balls(&balls);
  return same ? 0 : 1;
}

#endif
