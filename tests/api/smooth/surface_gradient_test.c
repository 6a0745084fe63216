/* The gradient of the smooth surface: short arrays and weights that are no numbers, executors, and probes that are
 * near each other. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "gradients.h"
#include "loops.h"
#include "surface_result.h"

static gradients alone, other;
static double sigma[BALL_SET_MOST];

static int32_t get(const hsp_surface *surface, uint32_t n, const double *weights, const hsp_executor *executor,
                   gradients *g, hsp_gradient_outputs *out) {
  memset(g, 0x5A, sizeof *g);
  memset(out, 0, sizeof *out);
  out->struct_size = sizeof *out;
  out->capacity = n;
  out->energy = &g->energy;
  out->d_centre = g->centre;
  out->d_radius = g->radius;
  out->flags = g->flags;
  return hsp_surface_get_gradient(
      surface, SIZED(hsp_gradient_request, .tension = 0.7, .pressure = -1.3, .sigma = weights, .executor = executor),
      out);
}

static void refused(const hsp_surface *surface, uint32_t n) {
  hsp_gradient_outputs out;
  if (n == 0) return;
  check_scene("refused");
  CHECK_EQUAL(get(surface, n - 1, sigma, NULL, &alone, &out), HSP_E_CAPACITY);
  CHECK_EQUAL(out.needed, n);
  sigma[n - 1] = NAN;
  CHECK_EQUAL(get(surface, n, sigma, NULL, &alone, &out), HSP_E_NOT_FINITE);
  CHECK_EQUAL(out.first_bad, n - 1);
  sigma[n - 1] = 1;
}

static void by_workers(const hsp_surface *surface, uint32_t n) {
  hsp_gradient_outputs out;
  uint32_t workers;
  int way;
  CHECK_EQUAL(get(surface, n, sigma, NULL, &alone, &out), HSP_OK);
  for (workers = 0; workers <= 9; ++workers) {
    loop own = loop_of(LOOP_SHUFFLED);
    const hsp_executor executor = executor_of(&own, workers);
    check_scene("%u balls by %u workers", (unsigned)n, (unsigned)workers);
    CHECK_EQUAL(get(surface, n, sigma, &executor, &other, &out), HSP_OK);
    CHECK_BYTES(&other, &alone, sizeof alone);
    CHECK_EQUAL(own.runs, workers > 1 && n > 64);
  }
  for (way = LOOP_RIGHT_WAYS; way < LOOP_WAYS && n > 64; ++way) {
    loop own = loop_of(way);
    const hsp_executor executor = executor_of(&own, 4);
    check_scene("%u balls by wrong way %d", (unsigned)n, way);
    CHECK_EQUAL(get(surface, n, sigma, &executor, &other, &out), HSP_E_EXECUTOR);
  }
}

static void check_set(const ball_set *set) {
  const hsp_model_options options = options_with_probe(1.4 * set->radius[0]);
  computed c;
  surface_result s;
  uint32_t i;
  for (i = 0; i < set->n; ++i) sigma[i] = i % 4 == 1 ? 0 : 0.75 * i - 2;
  check_scene("%s", set->name);
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK)) {
    if (CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK)) {
      refused(s.surface, set->n);
      by_workers(s.surface, set->n);
    }
    surface_result_release(&s);
  }
  computed_release(&c);
}

/* Three probes are a few 1e-5 of their radius apart: their creases end in cusps where planes are nearly one.
 * Derivatives of a share are as right as elsewhere: they sum to zero. Balls are moved by more and more. */
static void near_probes(void) {
  static const double xyz[12] = {3, 0, 3, 0, 1, 2, 2, 2, 0, 2, 1, 1};
  static const double way[12] = {1, -3, 2, -1, 2, 3, -2, 1, 1, 3, -1, -2};
  static const double radius[4] = {0, 1.5, 1, 0};
  static const double weights[4] = {0, 1, 0, 0};
  const hsp_model_options options = options_with_probe(2.58523282);
  double moved;
  for (moved = 0; moved<1e-3; moved = moved> 0 ? 10 * moved : 1e-7) {
    double at[12];
    int i, k;
    computed c;
    surface_result s;
    hsp_gradient_outputs out;
    check_scene("near probes, balls moved by %g", moved);
    for (i = 0; i < 12; ++i) at[i] = xyz[i] + moved * way[i];
    if (CHECK_EQUAL(computed_make(4, at, radius, &options, &c), HSP_OK) &&
        CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK)) {
      CHECK_EQUAL(get(s.surface, 4, weights, NULL, &alone, &out), HSP_OK);
      for (k = 0; k < 3; ++k) {
        double sum = 0;
        for (i = 0; i < 4; ++i) sum += alone.centre[3 * i + k];
        CHECK(fabs(sum) < 1e-8);
      }
      surface_result_release(&s);
    }
    computed_release(&c);
  }
}

int main(void) {
  static ball_set set;
  ball_set_make(3, &set);
  check_set(&set);
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, BALL_SET_MOST, 77);
  check_set(&set);
  near_probes();
  return check_report();
}
