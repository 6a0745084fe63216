/* The invariants of gradients and of rows of the Jacobian for every set of the catalogue, for either tangency, in any
 * order of the balls, in other units and with a probe. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "gradient_invariants.h"
#include "gradients.h"

/* Weights that depend on where a ball lies, so that copies of a ball have the same and the order does not matter. */
static void weigh(const ball_set *set, double *sigma) {
  uint32_t i;
  for (i = 0; i < set->n; ++i) {
    const double *c = set->xyz + 3 * i;
    sigma[i] = sin(3 * c[0] + 5 * c[1] + 7 * c[2]) + 0.25 * set->radius[i];
  }
}

static void check_nothing_broken(const char *broken) {
  check_true(broken == NULL, broken == NULL ? "gradients" : broken, __FILE__, __LINE__);
}

static uint32_t flagged(const computed *c) {
  static gradients g;
  uint32_t i, count = 0;
  CHECK_EQUAL(gradients_make(c, NULL, 1, 1, HSP_TANGENT_OVERLAP, &g), HSP_OK);
  for (i = 0; i < c->n; ++i) count += g.flags[i];
  return count;
}

/* hsp_boundary_get_gradient, property 3. */
static void check_order(const ball_set *set, const computed *c, const double *sigma, uint32_t tangency) {
  static ball_set permuted;
  uint32_t order[BALL_SET_MOST], i;
  double other_sigma[BALL_SET_MOST];
  int round;
  for (round = 0; round < 3; ++round) {
    computed d;
    for (i = 0; i < set->n; ++i) order[i] = set->n - 1 - i;
    if (round > 0) ball_set_shuffle(set->n, (uint64_t)round, order);
    ball_set_permute(set, order, &permuted);
    weigh(&permuted, other_sigma);
    CHECK_EQUAL(computed_make(permuted.n, permuted.xyz, permuted.radius, NULL, &d), HSP_OK);
    check_nothing_broken(gradient_difference_after_permutation(c, sigma, &d, other_sigma, tangency));
    computed_release(&d);
  }
}

/* The same integers in another unit: derivatives of areas grow with it, those of the volume with its square. */
static void check_unit(const ball_set *set, double unit, double step) {
  static ball_set scaled;
  static gradients area, volume, other;
  hsp_model_options options;
  computed c, d;
  uint32_t i;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  scaled = *set;
  for (i = 0; i < 3 * set->n; ++i) scaled.xyz[i] *= unit;
  for (i = 0; i < set->n; ++i) scaled.radius[i] *= unit;
  options.step = 1e-6;
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK);
  options.step = step;
  CHECK_EQUAL(computed_make(set->n, scaled.xyz, scaled.radius, &options, &d), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 0, HSP_TANGENT_OVERLAP, &area), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 0, 1, HSP_TANGENT_OVERLAP, &volume), HSP_OK);
  CHECK_EQUAL(gradients_make(&d, NULL, 2, 3, HSP_TANGENT_OVERLAP, &other), HSP_OK);
  CHECK_BYTES(other.flags, area.flags, set->n * sizeof(uint32_t));
  for (i = 0; i < 3 * set->n; ++i) {
    const double expected = 2 * unit * area.centre[i] + 3 * unit * unit * volume.centre[i];
    CHECK_NEAR(other.centre[i], expected, 1e-14 * (unit * fabs(area.centre[i]) + unit * unit * fabs(volume.centre[i])));
  }
  for (i = 0; i < set->n; ++i) {
    const double expected = 2 * unit * area.radius[i] + 3 * unit * unit * volume.radius[i];
    CHECK_NEAR(other.radius[i], expected, 1e-14 * (unit * fabs(area.radius[i]) + unit * unit * fabs(volume.radius[i])));
  }
  computed_release(&c);
  computed_release(&d);
}

/* The same integers times a power of two: no bit changes but in exponents. */
static void check_power_of_two(const ball_set *set, int exponent) {
  static ball_set whole, scaled;
  static gradients here, there;
  hsp_model_options options;
  computed c, d;
  uint32_t i;
  int of_volume;
  whole = *set;
  for (i = 0; i < 3 * set->n; ++i) whole.xyz[i] = floor(set->xyz[i] / set->step + 0.5);
  for (i = 0; i < set->n; ++i) whole.radius[i] = floor(set->radius[i] / set->step + 0.5);
  scaled = whole;
  for (i = 0; i < 3 * set->n; ++i) scaled.xyz[i] = ldexp(whole.xyz[i], exponent);
  for (i = 0; i < set->n; ++i) scaled.radius[i] = ldexp(whole.radius[i], exponent);
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = 1;
  CHECK_EQUAL(computed_make(set->n, whole.xyz, whole.radius, &options, &c), HSP_OK);
  options.step = ldexp(1, exponent);
  CHECK_EQUAL(computed_make(set->n, scaled.xyz, scaled.radius, &options, &d), HSP_OK);
  for (of_volume = 0; of_volume < 2; ++of_volume) {
    const int times = (1 + of_volume) * exponent;
    CHECK_EQUAL(gradients_make(&c, NULL, 1 - of_volume, of_volume, HSP_TANGENT_OVERLAP, &here), HSP_OK);
    CHECK_EQUAL(gradients_make(&d, NULL, 1 - of_volume, of_volume, HSP_TANGENT_OVERLAP, &there), HSP_OK);
    for (i = 0; i < 3 * set->n; ++i) CHECK(ldexp(here.centre[i], times) == there.centre[i]);
    for (i = 0; i < set->n; ++i) CHECK(ldexp(here.radius[i], times) == there.radius[i]);
  }
  computed_release(&c);
  computed_release(&d);
}

/* hsp_model_options.probe is the same as larger radii: half of the smallest radius as a probe. */
static void check_probe(const ball_set *set) {
  static ball_set smaller;
  static gradients with_probe, with_radii;
  hsp_model_options options;
  computed c, d;
  double steps = HUGE_VAL;
  uint32_t i;
  for (i = 0; i < set->n; ++i) steps = fmin(steps, floor(set->radius[i] / set->step / 2));
  if (!(steps >= 1 && steps < HUGE_VAL)) return;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = set->step;
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &d), HSP_OK);
  smaller = *set;
  for (i = 0; i < set->n; ++i) smaller.radius[i] = (floor(set->radius[i] / set->step + 0.5) - steps) * set->step;
  options.probe = steps * set->step;
  CHECK_EQUAL(computed_make(set->n, smaller.xyz, smaller.radius, &options, &c), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 1, HSP_TANGENT_DISJOINT, &with_probe), HSP_OK);
  CHECK_EQUAL(gradients_make(&d, NULL, 1, 1, HSP_TANGENT_DISJOINT, &with_radii), HSP_OK);
  CHECK_BYTES(&with_probe, &with_radii, sizeof with_probe);
  computed_release(&c);
  computed_release(&d);
}

/* Flags tell of touches at free points alone: copies of a ball that is buried bare nothing by moving a little. */
static void check_buried_copies(void) {
  static ball_set set;
  static gradients g;
  computed c;
  uint32_t i;
  ball_set_start(&set, "buried copies", 1e-8);
  ball_set_add(&set, 0, 0, 0, 3);
  for (i = 0; i < 3; ++i) ball_set_add(&set, 0.5, 0, 0, 1);
  check_scene("%s", set.name);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 0, HSP_TANGENT_OVERLAP, &g), HSP_OK);
  for (i = 0; i < 4; ++i) CHECK_EQUAL(g.flags[i], 0);
  computed_release(&c);
}

int main(void) {
  static ball_set set;
  double sigma[BALL_SET_MOST];
  uint32_t which, tangency;
  for (which = 0; which < ball_set_count(); ++which) {
    computed c;
    ball_set_make(which, &set);
    weigh(&set, sigma);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      check_nothing_broken(broken_gradient_flags(&c, sigma));
      if (strcmp(set.name, "cubic grid of touching balls") == 0) CHECK_EQUAL(flagged(&c), 27);
      if (strcmp(set.name, "a chain of 60 atoms") == 0) CHECK_EQUAL(flagged(&c), 0);
      for (tangency = HSP_TANGENT_OVERLAP; tangency <= HSP_TANGENT_DISJOINT; ++tangency) {
        check_scene("%s, tangency %u", set.name, (unsigned)tangency);
        check_nothing_broken(broken_gradients(&c, NULL, -0.75, 2.5, tangency));
        check_nothing_broken(broken_gradients(&c, sigma, -0.75, 2.5, tangency));
        check_nothing_broken(broken_area_rows(&c, sigma, tangency));
        check_order(&set, &c, sigma, tangency);
      }
    }
    computed_release(&c);
    check_scene("%s in other units", set.name);
    check_unit(&set, 1e6, 1);
    check_unit(&set, 10, 1e-5);
    check_power_of_two(&set, -60);
    check_power_of_two(&set, 37);
    check_scene("%s with a probe", set.name);
    check_probe(&set);
  }
  check_buried_copies();
  return check_report();
}
