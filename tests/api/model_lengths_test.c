/* Lengths of every size: what is too small for the lattice is refused, not answered with area 0; points have a lattice
 * that follows from where they are; what a coarse lattice does to small radii, the model says; and the largest radius
 * that is reported is one that the same balls can be set with again. */
#include <float.h>
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { MOST = 40 };
static unsigned char memory[HSP_MODEL_BYTES(MOST)], boundary_memory[HSP_AREAS_BYTES(MOST)];
static hsp_model *model;
static const double pi = 3.14159265358979323846;

static uint64_t state = 1;
static double between(double least, double most) {
  state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return least + (most - least) * (double)(state >> 11) * 0x1p-53;
}

static hsp_model_options options_of(double probe, double step, double largest_radius) {
  const hsp_model_options options = {(uint32_t)sizeof options, 0, probe, step, largest_radius};
  return options;
}

static double area_of(uint32_t n) {
  hsp_boundary_limits limits;
  hsp_boundary *boundary;
  hsp_totals totals = {-1, -1, {0, 0}};
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, n), HSP_OK);
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, &totals, NULL, NULL, 0, NULL), HSP_OK);
  return totals.area;
}

/* Two balls of radii 1.5 and 1.2, 1.7 apart, in units that become smaller: the same area in that unit, or HSP_E_RANGE.
 * */
static void units(void) {
  const double d = 1.7, r = 1.5, s = 1.2, at = (d * d + r * r - s * s) / (2 * d);
  const double area = 2 * pi * (r * (r + at) + s * (s + d - at));
  int k, part;
  for (k = 290; k >= -300; --k) {
    for (part = 0; part < 4; ++part) {
      const double unit = pow(10, k) * (1 + 2.3 * part);
      const double xyz[6] = {0, 0, 0, d * unit, 0, 0}, radius[2] = {r * unit, s * unit};
      const int32_t expected = k > 30 || r * unit < 0x1p20 * 1e-22 ? HSP_E_RANGE : HSP_OK;
      const hsp_model_options given = options_of(0, 1e-8 * unit, 0), largest = options_of(0, 0, r * unit);
      hsp_model_options probed;
      size_t bytes = sizeof boundary_memory;
      hsp_totals totals = {-1, -1, {0, 0}};
      uint32_t bad = 77;
      if (k == 30 || k == -16) continue; /* near either end */
      check_scene("unit %g", unit);
      if (!CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, NULL, &bad), expected)) continue;
      CHECK_EQUAL(bad, k > 30 ? 0 : HSP_NONE);
      CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, &largest, NULL), expected);
      CHECK_EQUAL(hsp_areas(2, xyz, radius, 0, boundary_memory, &bytes, &totals, NULL), expected);
      if (expected == HSP_OK) CHECK_NEAR(totals.area / unit / unit, area, 3e-6 * area);
      /* The probe alone is that small, too; and with a step of the caller's nothing is too small. */
      probed = options_of(r * unit, 0, 0);
      if (k < 0) CHECK_EQUAL(hsp_model_set(model, 1, xyz, xyz, &probed, NULL), expected);
      if (k > -150 && k < 30 && CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, &given, NULL), HSP_OK))
        CHECK_NEAR(area_of(2) / unit / unit, area, 1e-7 * area);
    }
  }
}

/* Small balls and points beside a large one, or with a probe, stay as they are. */
static void small_beside_large(void) {
  static const double small[] = {0, 5e-324, 1e-300, 1e-24, 1e-16};
  size_t k;
  for (k = 0; k < sizeof small / sizeof small[0]; ++k) {
    const double xyz[6] = {0, 0, 0, 5, 0, 0};
    double radius[2] = {1.5, 0};
    const hsp_model_options probe = options_of(1.5, 0, 0);
    hsp_model_info info;
    radius[1] = small[k];
    check_scene("radius %g beside 1.5", small[k]);
    CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, NULL, NULL), HSP_OK);
    CHECK_NEAR(area_of(2), 4 * pi * 2.25, 1e-12);
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    CHECK_EQUAL(info.largest_rounding * 1e9, k == 0 ? 3 : 1000000000);
    radius[0] = radius[1];
    CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, &probe, NULL), HSP_OK);
    CHECK_NEAR(area_of(2), 8 * pi * 2.25, 1e-12);
  }
}

/* Points in any unit: those that are apart do not meet, those in one place do. */
static void points(void) {
  static const double zero[MOST];
  int k;
  for (k = -300; k <= 300; ++k) {
    const double unit = pow(10, k);
    double xyz[3 * MOST];
    uint32_t rows[MOST + 1], ids[MOST], needed = 77, i;
    const int32_t expected = 39 * 3 * unit < 0x1p20 * 1e-22 ? HSP_E_RANGE : k > 35 ? HSP_E_RANGE : HSP_OK;
    hsp_model_info info;
    hsp_model_options own;
    if (k == -17 || k == -18 || k == 35) continue; /* near either end */
    check_scene("points, unit %g", unit);
    for (i = 0; i < MOST; ++i) {
      xyz[3 * i] = (i < MOST - 1 ? 3.0 * i : 0) * unit;
      xyz[3 * i + 1] = xyz[3 * i + 2] = -1.5 * unit;
    }
    if (!CHECK_EQUAL(hsp_model_set(model, MOST, xyz, zero, NULL, &needed), expected)) continue;
    CHECK(k > 35 ? needed < MOST : needed == HSP_NONE);
    if (expected != HSP_OK) continue;
    CHECK_EQUAL(hsp_query_pairs(model, HSP_PAIRS_ONCE, rows, ids, MOST, &needed), HSP_OK);
    CHECK_EQUAL(needed, 1); /* the last one is where the first is */
    CHECK_EQUAL(ids[0], MOST - 1);
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    CHECK(info.step <= 1e-8 || 117 * unit > 0x1p50 * 0.1 * info.step);
    CHECK(117 * unit < (info.step < 1e-8 ? 0x1p30 : 0x1p50) * info.step * 1.000001);
    CHECK(info.largest_rounding == 0);
    /* A part has that lattice if it is given, or else one of its own. */
    own = options_of(0, info.step, 0);
    CHECK_EQUAL(hsp_model_set(model, 2, xyz, zero, &own, NULL), HSP_OK);
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    CHECK(info.step == own.step);
  }
  check_scene("a coordinate that is no number");
  {
    const double xyz[6] = {3e-10, 0, 0, 0, NAN, 0}, infinite[6] = {3e-10, 0, 0, 0, 0, INFINITY};
    uint32_t bad = 77;
    CHECK_EQUAL(hsp_model_set(model, 2, xyz, zero, NULL, &bad), HSP_E_NOT_FINITE);
    CHECK_EQUAL(bad, 1);
    CHECK_EQUAL(hsp_model_set(model, 2, infinite, zero, NULL, &bad), HSP_E_NOT_FINITE);
    CHECK_EQUAL(bad, 1);
  }
}

#if HSP_HAS_BOXES
/* Of a box its vectors count, too. */
static void points_in_a_box(void) {
  static unsigned char box_memory[1 << 20];
  const double xyz[6] = {1e-3, 0, 0, 1.1e-3, 0, 0}, zero[2] = {0, 0}, box[9] = {900, 0, 0, 0, 900, 0, 0, 0, 900};
  hsp_periodic_limits limits;
  hsp_periodic *periodic;
  check_scene("points in a box");
  CHECK_EQUAL(hsp_periodic_limits_init(&limits, (uint32_t)sizeof limits, 2), HSP_OK);
  CHECK_EQUAL(hsp_periodic_init(box_memory, sizeof box_memory, &limits, &periodic), HSP_OK);
  CHECK_EQUAL(hsp_periodic_compute(periodic, 2, xyz, zero, box, NULL, NULL, NULL), HSP_OK);
}
#endif

/* The report on roundings against the roundings. */
static void roundings(void) {
  int turn;
  for (turn = 0; turn < 2000; ++turn) {
    const uint32_t n = 1 + (uint32_t)between(0, MOST - 1);
    const double probe = turn % 3 == 0 ? between(0, 2) : 0, size = pow(10, between(-9, 9));
    const hsp_model_options options = options_of(probe, 0, 0);
    double xyz[3 * MOST], radius[MOST], rounded[3 * MOST], rounded_radius[MOST], smallest = DBL_MAX;
    hsp_model_info info;
    int became_0 = 0;
    uint32_t i, axis;
    check_scene("roundings, turn %d", turn);
    for (i = 0; i < n; ++i) {
      for (axis = 0; axis < 3; ++axis) xyz[3 * i + axis] = between(-9, 9) * fmin(1, 1e5 * size);
      radius[i] = i % 5 == 4 ? 0 : between(0.5, 1.5) * (i == 0 ? size : turn % 2 == 0 ? 1 : pow(size, between(-1, 0)));
      if (radius[i] + probe > 0) smallest = fmin(smallest, radius[i] + probe);
    }
    if (!CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, &options, NULL), HSP_OK)) continue;
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    CHECK_EQUAL(hsp_model_get_balls(model, rounded, rounded_radius, n, NULL), HSP_OK);
    for (i = 0; i < n; ++i) {
      if (radius[i] + probe > 0 && rounded_radius[i] == 0) became_0 = 1;
      if (radius[i] + probe > 0 && !(rounded_radius[i] == 0)) {
        for (axis = 0; axis < 3; ++axis)
          CHECK(fabs(rounded[3 * i + axis] - xyz[3 * i + axis]) <=
                info.largest_rounding * rounded_radius[i] * (1 + 1e-9) + 1e-15);
      }
    }
    if (became_0) {
      CHECK(info.largest_rounding == 1);
    } else if (smallest < DBL_MAX) {
      CHECK(info.largest_rounding <= 0.5 * info.step / (smallest - info.step) || smallest < 2 * info.step);
      CHECK(info.largest_rounding >= 0.5 * info.step / (smallest + info.step) * (1 - 1e-9));
    } else {
      CHECK(info.largest_rounding == 0);
    }
    CHECK(info.reserved[0] == 0 && info.reserved[1] == 0);
  }
}

/* The largest radius as reported, given back, takes the same balls to the same lattice and cubes; a step more is too
 * large. */
static void largest_radius_given_back(void) {
  int turn;
  for (turn = 0; turn < 3000; ++turn) {
    const uint32_t n = 2 + (uint32_t)turn % 5;
    const double probe = turn % 2 == 0 ? between(0, 2) : 0, scale = pow(10, between(-6, 6));
    hsp_model_options options = options_of(probe * scale, turn % 3 == 0 ? scale * between(1e-8, 1e-3) : 0, 0);
    double xyz[3 * MOST], radius[MOST];
    hsp_model_info info, again;
    uint32_t i, bad = 77;
    check_scene("largest radius, turn %d", turn);
    for (i = 0; i < n; ++i) {
      xyz[3 * i] = scale * between(-5, 5);
      xyz[3 * i + 1] = xyz[3 * i + 2] = 0;
      radius[i] = scale * between(0, 2);
    }
    CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, &options, NULL), HSP_OK);
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    options.step = info.step;
    options.probe = info.probe;
    options.largest_radius = info.largest_radius - info.probe;
    if (!(options.largest_radius > 0)) continue;
    CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, &options, &bad), HSP_OK);
    CHECK_EQUAL(hsp_model_get_info(model, &again), HSP_OK);
    CHECK_BYTES(&again, &info, sizeof info);
    for (i = 0; i < n; ++i) radius[i] += 0.25 * info.step;
    radius[n - 1] = options.largest_radius + 0.75 * info.step;
    CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, &options, &bad), HSP_E_RANGE);
    CHECK(bad < n);
    radius[0] = radius[n - 1];
    radius[1] = NAN;
    CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, &options, &bad), HSP_E_RANGE);
    CHECK_EQUAL(bad, 0);
  }
}

#if HSP_HAS_MOTION
/* A model that balls that move have written describes itself as one that is set. */
static void written_by_moving(void) {
  static unsigned char moving_memory[HSP_MOVING_BYTES(MOST, MOST)], other_memory[HSP_MODEL_BYTES(MOST)];
  const double xyz[9] = {0, 0, 0, 1, 0, 0, 9, 0, 0}, radius[3] = {1.7, 1.52, 0};
  const hsp_moving_limits limits = {(uint32_t)sizeof limits, MOST, MOST};
  hsp_moving *moving;
  hsp_model *other;
  hsp_model_info info, expected;
  check_scene("a model that was written");
  CHECK_EQUAL(hsp_model_init(other_memory, sizeof other_memory, MOST, &other), HSP_OK);
  CHECK_EQUAL(hsp_moving_init(moving_memory, sizeof moving_memory, &limits, &moving), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, 3, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_get_info(model, &expected), HSP_OK);
  CHECK_EQUAL(expected.largest_rounding * 304e6, 1);
  CHECK_EQUAL(hsp_moving_set(moving, model, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_set(other, 1, NULL, NULL, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_moving_get_model(moving, other), HSP_OK);
  CHECK_EQUAL(hsp_model_get_info(other, &info), HSP_OK);
  CHECK_BYTES(&info, &expected, sizeof info);
  CHECK_EQUAL(hsp_query_pairs(other, 0, (uint32_t[4]){0}, (uint32_t[9]){0}, 9, NULL), HSP_OK);
}
#endif

int main(void) {
  CHECK_EQUAL(hsp_model_init(memory, sizeof memory, MOST, &model), HSP_OK);
  units();
  small_beside_large();
  points();
#if HSP_HAS_BOXES
  points_in_a_box();
#endif
  roundings();
  largest_radius_given_back();
#if HSP_HAS_MOTION
  written_by_moving();
#endif
  return check_report();
}
