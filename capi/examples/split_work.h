/* What the examples of split work have in common: a molecule's boundary with room for so many workers, computed twice,
 * by one and by several, who have to find the same bits. */
#ifndef SPLIT_WORK_H
#define SPLIT_WORK_H

#include <hardsphere.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read_balls.h"

struct molecule {
  struct balls balls;
  hsp_model *model;
  hsp_boundary *boundary;
  hsp_boundary_limits limits;
  void *model_memory, *boundary_memory;
  double *area, *volume;           /* [count] */
  double *area_centre, *of_energy; /* [count][3]: the area's gradient by the centres, and shares of it */
};

static inline int32_t make_boundary(struct molecule *m) {
  size_t bytes = 0;
  int32_t status = hsp_boundary_bytes(&m->limits, &bytes);
  if (status != HSP_OK) return status;
  free(m->boundary_memory);
  m->boundary_memory = malloc(bytes);
  if (m->boundary_memory == NULL) return HSP_E_MEMORY;
  return hsp_boundary_init(m->boundary_memory, bytes, &m->limits, &m->boundary);
}

static inline int32_t make_molecule(struct molecule *m, uint32_t workers) {
  const uint32_t n = m->balls.count;
  size_t bytes = 0;
  int32_t status = hsp_model_bytes(n, &bytes);
  if (status != HSP_OK) return status;
  m->model_memory = malloc(bytes);
  m->area = malloc((n + (size_t)1) * sizeof *m->area);
  m->volume = malloc((n + (size_t)1) * sizeof *m->volume);
  m->area_centre = malloc((3 * (size_t)n + 1) * sizeof *m->area_centre);
  m->of_energy = malloc((3 * (size_t)n + 1) * sizeof *m->of_energy);
  if (m->model_memory == NULL || m->area == NULL || m->volume == NULL) return HSP_E_MEMORY;
  if (m->area_centre == NULL || m->of_energy == NULL) return HSP_E_MEMORY;
  status = hsp_model_init(m->model_memory, bytes, n, &m->model);
  if (status == HSP_OK) status = hsp_model_set(m->model, n, m->balls.xyz, m->balls.radius, NULL, NULL);
  if (status == HSP_OK) status = hsp_boundary_limits_init(&m->limits, sizeof m->limits, n);
  m->limits.workers = workers;
  return status == HSP_OK ? make_boundary(m) : status;
}

static inline void free_molecule(struct molecule *m) {
  free_balls(&m->balls);
  free(m->model_memory);
  free(m->boundary_memory);
  free(m->area);
  free(m->volume);
  free(m->area_centre);
  free(m->of_energy);
}

static inline uint32_t first_of_part(uint32_t balls, uint32_t part, uint32_t parts) {
  return (uint32_t)((uint64_t)balls * part / parts);
}

/* Areas, volumes and the area's gradient of the balls of part `part` of `parts`. */
static inline void measure_part(const struct molecule *m, uint32_t part, uint32_t parts) {
  const uint32_t first = first_of_part(m->balls.count, part, parts);
  const uint32_t count = first_of_part(m->balls.count, part + 1, parts) - first;
  hsp_boundary_measure_range(m->boundary, NULL, first, count, m->area, m->volume);
  hsp_boundary_gradient_range(m->boundary, NULL, 1.0, 0.0, HSP_TANGENT_OVERLAP, first, count, m->area_centre, NULL,
                              NULL, m->of_energy, NULL);
}

/* What there is for all balls at once, after all parts. */
static inline int32_t end_measuring(const struct molecule *m, hsp_totals *totals, hsp_energy *energy) {
  const int32_t status = hsp_boundary_measure_end(m->boundary, totals, m->area, m->volume);
  return status == HSP_OK ? hsp_boundary_gradient_end(m->boundary, 1.0, 0.0, energy, NULL, m->of_energy) : status;
}

/* Whether one worker finds the same as several, whose results are there. */
static inline int32_t compare_with_one(const struct molecule *m, const hsp_totals *totals, const hsp_energy *energy) {
  const uint32_t n = m->balls.count;
  double *area = malloc((n + (size_t)1) * sizeof *area);
  double *volume = malloc((n + (size_t)1) * sizeof *volume);
  double *centre = malloc((3 * (size_t)n + 1) * sizeof *centre);
  hsp_boundary_counts counts, counts_of_one;
  hsp_totals totals_of_one;
  hsp_energy energy_of_one;
  int32_t status = area != NULL && volume != NULL && centre != NULL ? HSP_OK : HSP_E_MEMORY;
  if (status == HSP_OK) status = hsp_boundary_get_counts(m->boundary, &counts);
  if (status == HSP_OK) status = hsp_boundary_compute(m->boundary, m->model, NULL);
  if (status == HSP_OK) status = hsp_boundary_get_counts(m->boundary, &counts_of_one);
  if (status == HSP_OK) status = hsp_boundary_measure(m->boundary, NULL, &totals_of_one, area, volume, n, NULL);
  if (status == HSP_OK) {
    status = hsp_boundary_gradient(m->boundary, NULL, 1.0, 0.0, HSP_TANGENT_OVERLAP, &energy_of_one, centre, NULL, NULL,
                                   n, NULL, NULL);
  }
  if (status == HSP_OK) {
    const int same =
        memcmp(&counts, &counts_of_one, sizeof counts) == 0 && memcmp(totals, &totals_of_one, sizeof *totals) == 0 &&
        memcmp(energy, &energy_of_one, sizeof *energy) == 0 && memcmp(area, m->area, n * sizeof *area) == 0 &&
        memcmp(volume, m->volume, n * sizeof *volume) == 0 &&
        memcmp(centre, m->area_centre, 3 * (size_t)n * sizeof *centre) == 0;
    printf("%u balls, %u vertices, area %.6f, volume %.6f: %s as by one thread\n", (unsigned)n,
           (unsigned)counts.vertices, totals->area, totals->volume, same ? "the same bits" : "NOT the same bits");
    if (!same) status = HSP_E_CHECK;
  }
  free(area);
  free(volume);
  free(centre);
  return status;
}

#endif
