#include "periodic_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(periodic)

/* Computes on the lattice of the set's model, and without a probe, as the radii include it. */
static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const periodic_result *p = source;
  hsp_model_options options;
  const int32_t status = hsp_model_options_init(&options, (uint32_t)sizeof options);
  if (status != HSP_OK) return status;
  options.step = p->base->info.step;
  return hsp_periodic_compute(handle, p->base->n, p->base->xyz, p->base->radius, p->box, &options, limits, NULL);
}

const handle_kind periodic_handle = {(uint32_t)sizeof(hsp_periodic_limits),
                                     6,
                                     {"", "balls", "images", "neighbours", "vertices", "circles", "contacts"},
                                     NULL,
                                     bytes_of_limits,
                                     init_handle,
                                     compute_handle,
                                     2};

static void choose_box(periodic_result *p) {
  const computed *c = p->base;
  double largest = 0.0;
  uint32_t i;
  int axis;
  for (i = 0; i < c->n; ++i) {
    if (c->radius[i] > largest) largest = c->radius[i];
  }
  for (axis = 0; axis < 3; ++axis) {
    double low = 0.0, high = 0.0;
    for (i = 0; i < c->n; ++i) {
      const double x = c->xyz[3 * (size_t)i + (size_t)axis];
      if (i == 0 || x < low) low = x;
      if (i == 0 || x > high) high = x;
    }
    p->box[4 * axis] = high - low + 1.25 * largest;
    if (!(p->box[4 * axis] > 0.0)) p->box[4 * axis] = 1.0;
  }
  p->box[3] = 0.25 * p->box[0];
  p->box[6] = -0.125 * p->box[0];
  p->box[7] = 0.375 * p->box[4];
}

/* Turns the vectors of the box by a rotation matrix whose entries are multiples of 1/7. */
static void turn_box(periodic_result *p) {
  static const double sevenths[9] = {2, 3, 6, 3, -6, 2, 6, 2, -3};
  double turned[9];
  int k, l;
  for (k = 0; k < 9; ++k) {
    turned[k] = 0;
    for (l = 0; l < 3; ++l) turned[k] += sevenths[3 * (k % 3) + l] * p->box[3 * (k / 3) + l] / 7;
  }
  memcpy(p->box, turned, sizeof turned);
}

static int32_t make_in_box(periodic_result *p) {
  const computed *const base = p->base;
  void *periodic = NULL;
  uint32_t needed = 0;
  int32_t status;
  status = grow_until_computed(&periodic_handle, p, base->n, &p->memory, &periodic, &p->needed, &p->enlargements);
  p->periodic = periodic;
  if (status == HSP_OK) status = hsp_periodic_get_counts(p->periodic, &p->counts);
  if (status != HSP_OK) return status;
  p->area = test_zeros(base->n, sizeof *p->area);
  p->share_volume = test_zeros(base->n, sizeof *p->share_volume);
  p->contacts = test_zeros(p->counts.contacts, sizeof *p->contacts);
  p->windings = test_zeros(p->counts.components, sizeof *p->windings);
  p->vertices = test_zeros(p->counts.vertices, sizeof *p->vertices);
  p->arcs = test_zeros(p->counts.arcs, sizeof *p->arcs);
  p->circles = test_zeros(p->counts.circles, sizeof *p->circles);
  status = hsp_periodic_measure(p->periodic, &p->totals, p->area, p->share_volume, base->n, NULL);
  if (status == HSP_OK) status = hsp_periodic_get_contacts(p->periodic, p->contacts, p->counts.contacts, &needed);
  if (status == HSP_OK) status = hsp_periodic_get_vertices(p->periodic, p->vertices, p->counts.vertices, &needed);
  if (status == HSP_OK) status = hsp_periodic_get_arcs(p->periodic, p->arcs, p->counts.arcs, &needed);
  if (status == HSP_OK) status = hsp_periodic_get_circles(p->periodic, p->circles, p->counts.circles, &needed);
  if (status != HSP_OK) return status;
  return hsp_periodic_get_windings(p->periodic, p->windings, p->counts.components, &needed);
}

int32_t periodic_result_make(const computed *base, periodic_result *p) {
  memset(p, 0, sizeof *p);
  p->base = base;
  choose_box(p);
  return make_in_box(p);
}

int32_t periodic_result_make_turned(const computed *base, periodic_result *p) {
  memset(p, 0, sizeof *p);
  p->base = base;
  choose_box(p);
  turn_box(p);
  return make_in_box(p);
}

void periodic_result_release(periodic_result *p) {
  free(p->memory);
  free(p->area);
  free(p->share_volume);
  free(p->contacts);
  free(p->windings);
  free(p->vertices);
  free(p->arcs);
  free(p->circles);
  memset(p, 0, sizeof *p);
}
