/* HSP_SURFACE_DEGENERATE: where a derivative of the smooth surface jumps, as difference quotients on both sides say,
 * the balls concerned are flagged; sets in general position are not. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "random_numbers.h"
#include "surface_result.h"

enum { most_balls = 12, by_probe = -1 };

typedef struct jump_case {
  const char *name;
  double probe;
  uint32_t n;
  double ball[4][4]; /* x, y, z, radius */
  double sigma[4];
  double tension, pressure;
  int number; /* 4 i + 0, 1, 2, 3: x, y, z, radius of ball i */
  double right, left;
  uint32_t flagged; /* bit i: ball i */
} jump_case;

static const jump_case cases[] = {{"probes on both sides of a plane touch each other",
                                   0.25,
                                   3,
                                   {{0, 0, 0, 0.5}, {1, 0, 0, 0.5}, {0, 1, 0, 0.5}},
                                   {1, 1, 1},
                                   1,
                                   0,
                                   by_probe,
                                   -0.550505,
                                   2.5827,
                                   7},
                                  {"one more sphere contains a free circle",
                                   2,
                                   3,
                                   {{-1, 0, 0, 0.5}, {0, 0, 0, 0.5}, {2, 0, 0, 1.5}},
                                   {1, 1, 1},
                                   0,
                                   1,
                                   5,
                                   1.1223,
                                   -1.1223,
                                   7},
                                  {"balls of different weights touch from inside",
                                   2,
                                   2,
                                   {{0, 0, 0, 4}, {0, 2, 0, 2}},
                                   {1, 2},
                                   1,
                                   0,
                                   5,
                                   18.8496,
                                   0,
                                   3},
                                  {"one more sphere passes through a vertex",
                                   1,
                                   4,
                                   {{3, 0, 0, 2}, {0, 3, 0, 2}, {0, 0, 3, 2}, {1, 2, 2, 2}},
                                   {1, 1, 1, 1},
                                   0,
                                   1,
                                   15,
                                   23.468,
                                   22.882,
                                   15}};

/* tension * sum of sigma_i A_i + pressure * V; flags may be NULL. */
static double energy_of(uint32_t n, const double *xyz, const double *radius, double probe, const double *sigma,
                        double tension, double pressure, uint32_t *flags) {
  const hsp_model_options options = options_with_probe(probe);
  hsp_energy energy = {0};
  computed c;
  surface_result s;
  CHECK_EQUAL(computed_make(n, xyz, radius, &options, &c), HSP_OK);
  CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK);
  CHECK_EQUAL(hsp_surface_get_gradient(
                  s.surface, SIZED(hsp_gradient_request, .sigma = sigma, .tension = tension, .pressure = pressure),
                  SIZED(hsp_gradient_outputs, .energy = &energy, .flags = flags, .capacity = flags == NULL ? 0 : n)),
              HSP_OK);
  surface_result_release(&s);
  computed_release(&c);
  return energy.value;
}

static double moved(const jump_case *k, double by) {
  double xyz[12], radius[4], probe = k->probe;
  spread_balls(k->n, k->ball, xyz, radius);
  if (k->number == by_probe) {
    probe += by;
  } else if (k->number % 4 == 3) {
    radius[k->number / 4] += by;
  } else {
    xyz[3 * (k->number / 4) + k->number % 4] += by;
  }
  return energy_of(k->n, xyz, radius, probe, k->sigma, k->tension, k->pressure, NULL);
}

static uint32_t flags_of(const jump_case *k, const double *sigma, double probe) {
  double xyz[12], radius[4];
  uint32_t flags[4], i, all = 0;
  spread_balls(k->n, k->ball, xyz, radius);
  (void)energy_of(k->n, xyz, radius, probe, sigma, k->tension, k->pressure, flags);
  for (i = 0; i < k->n; ++i) all |= (flags[i] & HSP_SURFACE_DEGENERATE) << i;
  return all;
}

static void check_jump(const jump_case *k) {
  const double step = 1e-6, here = moved(k, 0);
  check_scene("%s", k->name);
  CHECK_NEAR((moved(k, step) - here) / step, k->right, 1e-3);
  CHECK_NEAR((here - moved(k, -step)) / step, k->left, 1e-3);
  CHECK_EQUAL(flags_of(k, k->sigma, k->probe), k->flagged);
}

/* The same sets where nothing jumps. */
static void check_beside(void) {
  check_scene("probes that do not quite touch");
  CHECK_EQUAL(flags_of(&cases[0], NULL, 0.250000001), 0);
  CHECK_EQUAL(flags_of(&cases[0], NULL, 0.249999999), 0);
  check_scene("equal weights have no kink");
  CHECK_EQUAL(flags_of(&cases[2], NULL, cases[2].probe), 0);
}

static void general_position(void) {
  static const double probes[] = {0.25, 0.5, 1, 2};
  uint64_t state = 3;
  uint32_t set, i, seen = 0;
  for (set = 0; set < 300; ++set) {
    double xyz[3 * most_balls], radius[most_balls], sigma[most_balls];
    uint32_t flags[most_balls];
    const uint32_t n = 2 + (uint32_t)random_below(&state, most_balls - 1);
    check_scene("general position, set %u", set);
    for (i = 0; i < 3 * n; ++i) xyz[i] = 1e-6 * random_below(&state, 6000000);
    for (i = 0; i < n; ++i) {
      radius[i] = 0.5 + 1e-3 * random_below(&state, 1000);
      sigma[i] = 1 + random_below(&state, 5);
    }
    (void)energy_of(n, xyz, radius, probes[random_below(&state, 4)], sigma, 1, 1, flags);
    for (i = 0; i < n; ++i, ++seen) CHECK_EQUAL(flags[i], 0);
  }
  CHECK(seen > 1000);
}

int main(void) {
  uint32_t k;
  for (k = 0; k < sizeof cases / sizeof cases[0]; ++k) check_jump(&cases[k]);
  check_beside();
  general_position();
  return check_report();
}
