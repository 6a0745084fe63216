/* Energy tension * sum of areas of a code's own atoms, the forces on them and the virial: what a code calls in each
 * step that has ghosts (capi/guide/ghosts.md), or a periodic box. C99 and C++. Ghosts have to reach 2 * (largest radius
 * + probe) from the own atoms. */
#ifndef SURFACE_FORCES_H
#define SURFACE_FORCES_H

#include <hardsphere_workspace.h>

/** All zeros at first but for the first four, which are the same on all ranks. */
typedef struct surface_forces {
  double probe, tension, largest_radius; /**< the largest radius without the probe */
  int32_t with_strain;                   /**< 1: also the virial */
  double strain[9]; /**< of the last call: [3 p + q] is dE/deps_pq, E of the own atoms, as all x become x + eps x. The
                         virial sum F_p x_q is -strain; the sum over all ranks is that of the whole */
  hsp_workspace work;
  uint32_t room;
  double *area, *gradient; /**< [all], [all][3] of the last call; 0 for ghosts */
  uint8_t *selected;
  uint32_t entries; /**< that the next three have room for, [entries], [entries][3] */
  uint32_t *first, *ball;
  double *row;
} surface_forces;

static inline int32_t surface_forces_make_room(surface_forces *s, uint32_t all) {
  const size_t n = (size_t)all + all / 4 + 64;
  if (all <= s->room) return HSP_OK;
  free(s->area);
  free(s->selected);
  free(s->first);
  s->room = 0;
  s->area = (double *)malloc(4 * n * sizeof(double));
  s->selected = (uint8_t *)malloc(n);
  s->first = (uint32_t *)malloc((n + 1) * sizeof(uint32_t));
  if (s->area == NULL || s->selected == NULL || s->first == NULL) return HSP_E_MEMORY;
  s->gradient = s->area + n;
  s->room = (uint32_t)n;
  return HSP_OK;
}

/* How the own areas depend on the atoms around, times the ways there. */
static inline int32_t surface_forces_add_strain(surface_forces *s, uint32_t all, const double *x) {
  uint32_t needed = 0;
  int32_t status =
      hsp_boundary_get_area_rows(s->work.boundary, NULL, s->first, s->ball, s->row, NULL, s->entries, &needed);
  if (status == HSP_E_CAPACITY) {
    free(s->ball);
    free(s->row);
    s->entries = needed + needed / 4;
    s->ball = (uint32_t *)malloc(s->entries * sizeof(uint32_t));
    s->row = (double *)malloc(3 * (size_t)s->entries * sizeof(double));
    if (s->ball == NULL || s->row == NULL) s->entries = 0;
    if (s->entries == 0) return HSP_E_MEMORY;
    status = hsp_boundary_get_area_rows(s->work.boundary, NULL, s->first, s->ball, s->row, NULL, s->entries, &needed);
  }
  for (uint32_t i = 0; i < all && status == HSP_OK; ++i) {
    for (uint32_t k = s->first[i]; k < s->first[i + 1]; ++k) {
      const double *other = x + 3 * (size_t)s->ball[k], *own = x + 3 * (size_t)i;
      for (int t = 0; t < 9; ++t) {
        s->strain[t] += s->tension * s->row[3 * (size_t)k + (size_t)(t / 3)] * (other[t % 3] - own[t % 3]);
      }
    }
  }
  return status;
}

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
  memset(s->strain, 0, sizeof s->strain);
  if (own == 0) return HSP_OK;
  status = surface_forces_make_room(s, all);
  if (status != HSP_OK) return status;
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
  if (status == HSP_OK && s->with_strain != 0) status = surface_forces_add_strain(s, all, x);
  *energy = found.value;
  return status;
}

#if HSP_HAS_BOXES
/** The same of all n atoms of one process in a periodic box: its vectors box [9] are any three, one after the other. */
static inline int32_t surface_forces_compute_in_box(surface_forces *s, uint32_t n, const double *x,
                                                    const double *radius, const double *box, double *energy) {
  hsp_model_options options;
  hsp_periodic_request in_box;
  hsp_gradient_request asked;
  hsp_periodic_gradient_outputs outputs;
  hsp_energy found;
  int32_t status = surface_forces_make_room(s, n);
  *energy = 0;
  memset(&in_box, 0, sizeof in_box);
  memset(&outputs, 0, sizeof outputs);
  memset(&found, 0, sizeof found);
  if (status == HSP_OK) status = hsp_model_options_init(&options, sizeof options);
  if (status == HSP_OK) status = hsp_gradient_request_init(&asked, sizeof asked);
  if (status != HSP_OK) return status;
  options.probe = s->probe;
  options.largest_radius = s->largest_radius;
  in_box.struct_size = sizeof in_box;
  in_box.areas_alone = 1;
  in_box.options = &options;
  asked.tension = s->tension;
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &found;
  outputs.area = s->area;
  outputs.d_centre = s->gradient;
  outputs.d_strain = s->strain;
  status = hsp_workspace_periodic_with(&s->work, n, x, radius, box, &in_box, NULL);
  if (status == HSP_OK) status = hsp_periodic_get_gradient(s->work.periodic, &asked, &outputs);
  *energy = found.value;
  return status;
}
#endif

static inline void surface_forces_free(surface_forces *s) {
  hsp_workspace_free(&s->work);
  free(s->area);
  free(s->selected);
  free(s->first);
  free(s->ball);
  free(s->row);
  s->area = s->gradient = s->row = NULL;
  s->selected = NULL;
  s->first = s->ball = NULL;
  s->room = s->entries = 0;
}

#endif
