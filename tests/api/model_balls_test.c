/* Balls as rounded to the lattice: what hsp_model_get_balls promises, on all sets of the interface tests. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "topology_sets.h"
#include "untouched.h"

static uint32_t exact_sets;

/* The number of the lattice nearest to a length, in steps. */
static double nearest(double length, double step) {
  return round(length / step);
}

/* Property 1. */
static void check_rounding(const ball_set *set, const computed *c, const double *xyz, const double *radius) {
  const double step = c->info.step, half = 0.5 * step * (1 + 1e-6);
  uint32_t i;
  int all_same = 1;
  for (i = 0; i < c->n; ++i) {
    int axis;
    for (axis = 0; axis < 3; ++axis) {
      const double given = set->xyz[3 * i + (uint32_t)axis], found = xyz[3 * i + (uint32_t)axis];
      CHECK_NEAR(found, given, half + 1e-15 * fabs(given));
      all_same = all_same && found == given;
    }
    CHECK_NEAR(radius[i], set->radius[i] + c->info.probe, half);
    CHECK_NEAR(nearest(radius[i], step), nearest(set->radius[i], step) + nearest(c->info.probe, step), 0);
  }
  exact_sets += all_same ? 1 : 0;
}

/* Property 2. */
static void check_again(const computed *c, const double *xyz, const double *radius) {
  hsp_model_options options;
  computed again;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = c->info.step;
  if (!CHECK_EQUAL(computed_make(c->n, xyz, radius, &options, &again), HSP_OK)) return;
  CHECK_BYTES(&again.counts, &c->counts, sizeof again.counts);
  CHECK_BYTES(again.vertices, c->vertices, c->counts.vertices * sizeof *again.vertices);
  CHECK_BYTES(again.area, c->area, c->n * sizeof *again.area);
  CHECK_BYTES(again.balls, c->balls, c->n * sizeof *again.balls);
  computed_release(&again);
}

static void check_set(const ball_set *set, double probe) {
  const hsp_model_options options = options_with_probe(probe);
  double *const xyz = test_zeros(set->n, 3 * sizeof *xyz), *const alone = test_zeros(set->n, 3 * sizeof *alone);
  double *const radius = test_zeros(set->n, sizeof *radius);
  uint32_t needed;
  computed c;
  check_scene("%s, probe %g", set->name, probe);
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK)) {
    FILL(needed);
    CHECK_EQUAL(hsp_model_get_balls(c.model, xyz, radius, c.n, &needed), HSP_OK);
    CHECK_EQUAL(needed, c.n);
    CHECK_EQUAL(hsp_model_get_balls(c.model, alone, NULL, c.n, NULL), HSP_OK);
    CHECK_BYTES(alone, xyz, 3 * c.n * sizeof *xyz);
    CHECK_EQUAL(hsp_model_get_balls(c.model, NULL, NULL, 0, &needed), HSP_OK);
    check_rounding(set, &c, xyz, radius);
    check_again(&c, xyz, radius);
    computed_release(&c);
  }
  free(xyz);
  free(alone);
  free(radius);
}

int main(void) {
  static const double probes[] = {0.0, 1.4};
  sets_with_probes(probes, (uint32_t)(sizeof probes / sizeof probes[0]), check_set);
  CHECK(exact_sets > 0);
  return check_report();
}
