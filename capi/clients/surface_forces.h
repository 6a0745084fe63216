/* Energy tension * sum of areas of a code's own atoms, and the forces on them: what a code with ghosts calls in each
 * step (capi/guide/ghosts.md). C99 and C++. Ghosts have to reach 2 * (largest radius + probe) from the own atoms. */
#ifndef SURFACE_FORCES_H
#define SURFACE_FORCES_H

#include <hardsphere_workspace.h>

/** All zeros at first but for the first three, which are the same on all ranks. */
typedef struct surface_forces {
  double probe, tension, largest_radius; /**< the largest radius without the probe */
  hsp_workspace work;
  uint32_t room;
  double *area, *gradient; /**< [all], [all][3] of the last call; 0 for ghosts */
  uint8_t *selected;
} surface_forces;

/** x [all][3] and radius [all], the own atoms first; *energy becomes that of the own ones. */
static inline int32_t surface_forces_compute(surface_forces *s, uint32_t own, uint32_t all, const double *x,
                                             const double *radius, double *energy) {
  hsp_model_options options;
  hsp_boundary_request of_own;
  hsp_gradient_request asked;
  hsp_gradient_outputs outputs;
  hsp_energy found;
  int32_t status;
  *energy = 0;
  if (own == 0) return HSP_OK;
  if (all > s->room) {
    const size_t n = (size_t)all + all / 4 + 64;
    free(s->area);
    free(s->selected);
    s->room = 0;
    s->area = (double *)malloc(4 * n * sizeof(double));
    s->selected = (uint8_t *)malloc(n);
    if (s->area == NULL || s->selected == NULL) return HSP_E_MEMORY;
    s->gradient = s->area + n;
    s->room = (uint32_t)n;
  }
  memset(s->selected, 1, own);
  memset(s->selected + own, 0, all - own);
  memset(&of_own, 0, sizeof of_own);
  memset(&outputs, 0, sizeof outputs);
  memset(&found, 0, sizeof found);
  of_own.struct_size = sizeof of_own;
  of_own.selected = s->selected;
  outputs.struct_size = sizeof outputs;
  outputs.capacity = all;
  outputs.energy = &found;
  outputs.area = s->area;
  outputs.d_centre = s->gradient;
  status = hsp_model_options_init(&options, sizeof options);
  if (status == HSP_OK) status = hsp_gradient_request_init(&asked, sizeof asked);
  if (status != HSP_OK) return status;
  options.probe = s->probe;
  options.largest_radius = s->largest_radius;
  asked.tension = s->tension;
  status = hsp_workspace_set(&s->work, all, x, radius, &options, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary_with(&s->work, &of_own);
  if (status == HSP_OK) status = hsp_boundary_get_gradient(s->work.boundary, &asked, &outputs);
  *energy = found.value;
  return status;
}

static inline void surface_forces_free(surface_forces *s) {
  hsp_workspace_free(&s->work);
  free(s->area);
  free(s->selected);
  s->area = s->gradient = NULL;
  s->selected = NULL;
  s->room = 0;
}

#endif
