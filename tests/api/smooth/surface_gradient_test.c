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

static void must_sum_to_zero(uint32_t n, const double *at, double limit) {
  double sum[3] = {0, 0, 0}, torque[3] = {0, 0, 0};
  uint32_t i, k;
  for (i = 0; i < n; ++i) {
    CHECK_EQUAL(alone.flags[i], 0);
    for (k = 0; k < 3; ++k) {
      const uint32_t l = (k + 1) % 3, m = (k + 2) % 3;
      sum[k] += alone.centre[3 * i + k];
      torque[k] += at[3 * i + l] * alone.centre[3 * i + m] - at[3 * i + m] * alone.centre[3 * i + l];
    }
  }
  for (k = 0; k < 3; ++k) CHECK(fabs(sum[k]) < limit && fabs(torque[k]) < limit);
}

/* Moved by so many steps of 1e-8, into `alone`. */
static void get_moved(uint32_t n, const double *xyz, const double *radius, const signed char *way, double steps,
                      double probe, const double *weights, double limit) {
  const hsp_model_options options = options_with_probe(probe);
  double at[24], r[8];
  uint32_t i;
  computed c;
  surface_result s;
  hsp_gradient_outputs out;
  for (i = 0; i < n; ++i) {
    uint32_t k;
    for (k = 0; k < 3; ++k) at[3 * i + k] = xyz[3 * i + k] + 1e-8 * steps * way[4 * i + k];
    r[i] = radius[i] + 1e-8 * steps * way[4 * i + 3];
  }
  if (CHECK_EQUAL(computed_make(n, at, r, &options, &c), HSP_OK) && CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK)) {
    CHECK_EQUAL(get(s.surface, n, weights, NULL, &alone, &out), HSP_OK);
    must_sum_to_zero(n, at, limit);
    surface_result_release(&s);
  }
  computed_release(&c);
}

/* A probe touches seven balls in a ring, but for a step of 1e-8 or two: five vertices are as near each other, with
 * creases from cusp to cusp. */
static void ring_of_probes(void) {
  static const double xyz[24] = {1.94241407,  0,           0, 1.21107536,  1.51864047,  0,
                                 -0.43222779, 1.89371369,  0, -1.75005461, 0.84278188,  0,
                                 -1.75005461, -0.84278188, 0, -0.43222779, -1.89371369, 0,
                                 1.21107536,  -1.51864047, 0, 0,           0,           -1.93248145};
  static const double radius[8] = {.64939098, .64939098, .64939098, .64939098,
                                   .64939098, .64939098, .64939098, .46072747};
  static const double weights[8] = {-2, 0, -0.5, 0.25, 0, 1.75, 2.5, 0};
  static const signed char way[32] = {-1, -1, -1, 1,  1,  -1, 1, -1, 1,  1, 1, -1, -1, 1, 1, 1,
                                      -1, 1,  -1, -1, -1, -1, 0, 1,  -1, 0, 1, 0,  0,  0, 0, 0};
  check_scene("a ring of probes");
  get_moved(8, xyz, radius, way, 1, 1.4, weights, 1e-10);
}

/* Vertices of seven balls, 1e-8 apart, whose creases end in corners of three. Derivatives are nearly those of the same
 * balls moved a hundred times as far: of the first ball, as others have a vertex that is nearly none. */
static void corners_of_probes(void) {
  static const double xyz[21] = {1.28599311,  -1.19099788, -0.71468176, -1.41061278, 1.04039695, -0.71468176,
                                 -0.70231998, 1.69070948,  -0.74648323, 1.77501814,  0.44839996, -0.74648323,
                                 2.27450490,  1.51200899,  -1.11362829, 2.33128229,  0.37567647, -0.96282176,
                                 -0.41989026, -2.32372591, -0.96282176};
  static const double radius[7] = {0.31195376, 0.31195376, 0.39618233, 0.39618233, 1.36859333, 0.96917099, 0.96917099};
  static const double weights[7] = {0.814388, 1.643222, 1.821910, -0.565840, 1.366868, -0.129317, 0.000000};
  static const signed char way[28] = {3,  -3, 2, -1, 2,  -2, -3, 0, -2, -1, -2, -1, -2, -1,
                                      -1, -1, 2, -3, -2, -2, 3,  0, -1, -1, -3, 0,  1,  1};
  double moved[3], steps;
  uint32_t k;
  check_scene("corners of near probes");
  get_moved(7, xyz, radius, way, 100, 1.58093404, weights, 1e-7);
  for (k = 0; k < 3; ++k) moved[k] = alone.centre[k];
  for (steps = 1; steps < 100; steps *= 3) {
    check_scene("corners of near probes, balls moved by %g steps", steps);
    get_moved(7, xyz, radius, way, steps, 1.58093404, weights, 1e-5);
    for (k = 0; k < 3; ++k) CHECK(fabs(alone.centre[k] - moved[k]) < 5e-4);
  }
}

/* On either side of a ring of five balls are vertices a few steps of 1e-8 apart. Where the creases of one across the
 * ring to two of these meet, their planes are nearly one. */
static void probes_across_a_ring(void) {
  static const double xyz[15] = {2.83390753,  -6e-8,       -0.93146044, 0.87572562,  2.69520626,
                                 -0.93146044, -2.29267936, 1.66572903,  -0.93146040, -2.29267934,
                                 -1.66572911, -0.93146042, 0.87572554,  -2.69520624, -0.93146044};
  static const double radius[5] = {0.93912885, 0.93912885, 0.93912881, 0.93912883, 0.93912883};
  static const double weights[5] = {1, 0.1, -0.5, -0.6, 1.8};
  static const signed char way[20] = {0};
  check_scene("probes across a ring");
  get_moved(5, xyz, radius, way, 0, 2.04393179, weights, 1e-10);
}

/* By closed forms, in 60 digits: the saddle between two balls is as narrow as they are near each other, and derivatives
 * are divided by that. */
static void balls_two_steps_apart(void) {
  static const double xyz[6] = {0, 0, 0, 2e-8, 0, 0};
  static const double radius[2] = {1.22521372, 1.22521371};
  static const double weights[2] = {1, 1};
  static const signed char way[8] = {0};
  check_scene("balls two steps apart");
  get_moved(2, xyz, radius, way, 0, 3.24383570, weights, 1e-13);
  CHECK(fabs(alone.centre[3] + 0.55651909719893416) < 1e-13);
  CHECK(fabs(alone.radius[0] + 2.2260765150092296) < 1e-13);
  CHECK(fabs(alone.radius[1] + 0.74202547695563361) < 1e-13);
}

/* Sets that are nearly tied, in steps of 1e-8: x, y, z, radius, weight. */
typedef struct tied_set {
  const char *name;
  double limit; /* of the sums */
  uint32_t n;
  double probe;
  double ball[4][5];
} tied_set;
static const tied_set tied_sets[] = {
    {"two balls a step apart, whose circle lies beyond a centre",
     1e-12,
     2,
     324383570,
     {{50000001, 100000000, 0, 122521372, 1}, {50000001, 99999999, 1, 122521371, 1}}},
    {"a circle that is nearly as large as the probe",
     1e-13,
     2,
     50000000,
     {{99999972, 300000016, 200000021, 100000024, 0}, {100000016, 100000024, -14, 99999994, -0.865}}},
    {"a circle whose plane nearly goes through a centre",
     1e-12,
     2,
     200000000,
     {{100000003, 400000000, 299999998, 50000000, 0}, {199999999, 200000002, 199999997, 149999998, 0.181}}},
    {"points 37 steps apart, which are cusps of a crease",
     1e-9,
     3,
     141355143,
     {{99999990, 199999990, 10, 0, 0}, {100000000, 199999970, -20, 0, -0.625}, {100000030, 20, 20, 50000010, 0}}},
    {"points 41 steps apart, at cusps between creases of unequal weights",
     1e-11,
     4,
     204747818,
     {{20, 199999990, 200000000, 0, 0},
      {200000020, 199999980, 99999980, 100000000, 0},
      {-10, 200000010, 199999970, 0, 0},
      {10, 0, 20, 100000010, 1.5}}},
    {"a concave patch between two balls 4 steps apart and a third one",
     1e-12,
     3,
     50000000,
     {{0, 0, 0, 100000000, 0}, {3, 1, -2, 100000000, 0}, {50000000, 210000000, 0, 110000000, 1}}},
    {"creases that end at one between vertices 7 millionths of the probe apart",
     1e-11,
     4,
     174175107,
     {{12820963, 166482867, -81679276, 11707739, 1},
      {-137370868, 27746224, -202412628, 72018872, 0},
      {-78600438, -211824394, 10849411, 52022434, 0},
      {124061543, 21932760, -178672894, 44448556, 0}}},
    {"the same where doubles cut the patches",
     1e-10,
     4,
     154473905,
     {{14180113, 142351021, -135616445, 42646847, 0},
      {-150735919, -41161496, -141119808, 56073804, 0},
      {151501872, 169873354, 13732205, 73557910, 2},
      {29875947, 84885101, 181477646, 48089766, 0}}}};

static void nearly_tied(void) {
  static const signed char way[16] = {0};
  uint32_t k, i, x;
  for (k = 0; k < sizeof tied_sets / sizeof *tied_sets; ++k) {
    const tied_set *set = &tied_sets[k];
    double xyz[12], radius[4], weights[4];
    for (i = 0; i < set->n; ++i) {
      for (x = 0; x < 3; ++x) xyz[3 * i + x] = 1e-8 * set->ball[i][x];
      radius[i] = 1e-8 * set->ball[i][3];
      weights[i] = set->ball[i][4];
    }
    check_scene("%s", set->name);
    get_moved(set->n, xyz, radius, way, 0, 1e-8 * set->probe, weights, set->limit);
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
  ring_of_probes();
  corners_of_probes();
  probes_across_a_ring();
  balls_two_steps_apart();
  nearly_tied();
  return check_report();
}
