/* Arguments of the model's functions that the header refuses: the status, what is written and what is not. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "untouched.h"

enum { BALLS = 6 };
static unsigned char memory[HSP_MODEL_BYTES(BALLS)];
static hsp_model *model;

static const double good_xyz[3 * BALLS] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, 5, 5, 5};
static const double good_radius[BALLS] = {1, 1, 1, 1, 0.5, 2};

static uint32_t balls_held(void) {
  hsp_model_info info;
  if (!CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK)) return HSP_NONE;
  return info.balls;
}

/* The model describes itself as it did when it was made. */
static void check_as_made(void) {
  static unsigned char other_memory[HSP_MODEL_BYTES(BALLS)];
  hsp_model *made = NULL;
  hsp_model_info info, expected;
  memset(&info, 0, sizeof info);
  memset(&expected, 0, sizeof expected);
  CHECK_EQUAL(hsp_model_init(other_memory, sizeof other_memory, BALLS, &made), HSP_OK);
  CHECK_EQUAL(hsp_model_get_info(made, &expected), HSP_OK);
  CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
  CHECK_EQUAL(info.balls, 0);
  CHECK(info.step == 1e-8);
  CHECK_BYTES(&info, &expected, sizeof info);
}

/* A refused call leaves an empty model, whatever it held before. */
static void check_refused(uint32_t n, const double *xyz, const double *radius, const hsp_model_options *options,
                          int32_t expected, uint32_t expected_bad) {
  uint32_t bad = 12345;
  CHECK_EQUAL(hsp_model_set(model, BALLS, good_xyz, good_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(balls_held(), BALLS);
  CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, options, &bad), expected);
  CHECK_EQUAL(bad, expected_bad);
  check_as_made();
  CHECK_EQUAL(hsp_model_set(model, BALLS, good_xyz, good_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, options, NULL), expected);
  check_as_made();
}

static void bytes_and_init(void) {
  size_t bytes;
  hsp_model *made;
  unsigned char small[64];
  FILL(bytes);
  FILL(made);
  FILL(small);
  CHECK_EQUAL(hsp_model_max_balls(), HSP_MAX_BALLS);
  CHECK_EQUAL(hsp_model_bytes(HSP_MAX_BALLS + 1, &bytes), HSP_E_RANGE);
  CHECK_UNTOUCHED(bytes);
  CHECK_EQUAL(hsp_model_bytes(HSP_NONE, &bytes), HSP_E_RANGE);
  CHECK_UNTOUCHED(bytes);

  CHECK_UNTOUCHED(made);
  FILL(memory);
  CHECK_UNTOUCHED(memory);
  CHECK_EQUAL(hsp_model_init(NULL, sizeof memory, BALLS, &made), HSP_E_ARGUMENT);
  CHECK_UNTOUCHED(made);
  CHECK_EQUAL(hsp_model_init(memory, sizeof memory, BALLS, NULL), HSP_E_ARGUMENT);
  CHECK_UNTOUCHED(memory);
  CHECK_EQUAL(hsp_model_init(small, 0, 0, &made), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_model_init(small, sizeof small, BALLS, &made), HSP_E_MEMORY);
  CHECK_UNTOUCHED(made);
  CHECK_UNTOUCHED(small);
  CHECK(hsp_model_init(small, sizeof small, HSP_NONE, &made) < 0);
  CHECK_UNTOUCHED(made);
  CHECK_UNTOUCHED(small);
}

static void options_init(void) {
  hsp_model_options options;
  FILL(options);
  CHECK_UNTOUCHED(options);
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(options.struct_size, sizeof options);
  CHECK_EQUAL(options.reserved, 0);
  CHECK(options.probe == 0);
  CHECK(options.step == 0);
  CHECK(options.largest_radius == 0);
}

static void null_pointers(void) {
  uint32_t bad = 12345;
  CHECK_EQUAL(hsp_model_set(NULL, BALLS, good_xyz, good_radius, NULL, &bad), HSP_E_ARGUMENT);
  CHECK_EQUAL(bad, HSP_NONE);
  check_refused(BALLS, NULL, good_radius, NULL, HSP_E_ARGUMENT, HSP_NONE);
  check_refused(BALLS, good_xyz, NULL, NULL, HSP_E_ARGUMENT, HSP_NONE);
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, &bad), HSP_OK);
  CHECK_EQUAL(bad, HSP_NONE);
  CHECK_EQUAL(balls_held(), 0);
  check_refused(BALLS + 1, good_xyz, good_radius, NULL, HSP_E_CAPACITY, HSP_NONE);
  check_refused(HSP_NONE, good_xyz, good_radius, NULL, HSP_E_CAPACITY, HSP_NONE);
}

static void bad_options(void) {
  static const struct {
    double probe, step;
    int32_t expected;
  } numbers[] = {{NAN, 0, HSP_E_NOT_FINITE},   {INFINITY, 0, HSP_E_NOT_FINITE}, {-INFINITY, 0, HSP_E_NOT_FINITE},
                 {0, NAN, HSP_E_NOT_FINITE},   {0, INFINITY, HSP_E_NOT_FINITE}, {0, -INFINITY, HSP_E_NOT_FINITE},
                 {-1, 0, HSP_E_NEGATIVE},      {-1e-300, 0, HSP_E_NEGATIVE},    {0, -1e-8, HSP_E_NEGATIVE},
                 {0, -1e300, HSP_E_NEGATIVE},  {1e300, 0, HSP_E_RANGE},         {1.7e308, 0, HSP_E_RANGE},
                 {1073741824, 1, HSP_E_RANGE}, {0, 5e-324, HSP_E_RANGE},        {0, 1e-300, HSP_E_RANGE},
                 {0, 1e-12, HSP_E_RANGE}};
  hsp_model_options options;
  size_t i;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.struct_size = 0;
  check_refused(BALLS, good_xyz, good_radius, &options, HSP_E_VERSION, HSP_NONE);
  options.struct_size = 20;
  check_refused(BALLS, good_xyz, good_radius, &options, HSP_E_VERSION, HSP_NONE);
  options.struct_size = 1028;
  check_refused(BALLS, good_xyz, good_radius, &options, HSP_E_VERSION, HSP_NONE);
  options.struct_size = (uint32_t)sizeof options;
  options.reserved = 1;
  check_refused(BALLS, good_xyz, good_radius, &options, HSP_E_VERSION, HSP_NONE);
  options.reserved = 0;
  for (i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
    uint32_t bad = 12345;
    check_scene("probe %g, step %g", numbers[i].probe, numbers[i].step);
    options.probe = numbers[i].probe;
    options.step = numbers[i].step;
    CHECK_EQUAL(hsp_model_set(model, BALLS, good_xyz, good_radius, &options, &bad), numbers[i].expected);
    CHECK_EQUAL(bad, HSP_NONE);
    check_as_made();
  }
  check_scene("options are checked without balls, too");
  options.probe = NAN;
  options.step = 0;
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, &options, NULL), HSP_E_NOT_FINITE);
  options.probe = -1;
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, &options, NULL), HSP_E_NEGATIVE);
  check_scene("largest radius");
  options.probe = 0;
  {
    static const struct {
      double largest;
      int32_t expected;
      uint32_t bad;
    } radii[] = {{NAN, HSP_E_NOT_FINITE, HSP_NONE},
                 {INFINITY, HSP_E_NOT_FINITE, HSP_NONE},
                 {-1, HSP_E_NEGATIVE, HSP_NONE},
                 {1.9, HSP_E_RANGE, 5},
                 {0.75, HSP_E_RANGE, 0},
                 {1e300, HSP_E_RANGE, HSP_NONE},
                 {2, HSP_OK, HSP_NONE},
                 {3, HSP_OK, HSP_NONE},
                 {-0.0, HSP_OK, HSP_NONE}};
    for (i = 0; i < sizeof radii / sizeof radii[0]; ++i) {
      uint32_t bad = 12345;
      options.largest_radius = radii[i].largest;
      CHECK_EQUAL(hsp_model_set(model, BALLS, good_xyz, good_radius, &options, &bad), radii[i].expected);
      CHECK_EQUAL(bad, radii[i].bad);
    }
  }
  {
    /* More than is expected, also of steps so small that one of the two has no number of them. */
    static const struct {
      double step, largest, radius;
      int32_t expected;
    } alone[] = {{0, 2, -0.5, HSP_E_NEGATIVE}, {1e-9, 2, 3, HSP_E_RANGE}, {1e-9, 0.5, 1.5, HSP_E_RANGE}};
    for (i = 0; i < sizeof alone / sizeof alone[0]; ++i) {
      uint32_t bad = 12345;
      options.step = alone[i].step;
      options.largest_radius = alone[i].largest;
      CHECK_EQUAL(hsp_model_set(model, 1, good_xyz, &alone[i].radius, &options, &bad), alone[i].expected);
      CHECK_EQUAL(bad, 0);
    }
    options.step = 0;
    options.largest_radius = 0;
  }
  check_scene("zeros with a minus sign are zeros");
  options.probe = -0.0;
  options.step = -0.0;
  CHECK_EQUAL(hsp_model_set(model, BALLS, good_xyz, good_radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(balls_held(), BALLS);
  check_scene("%s", "");
}

static void bad_balls(void) {
  static const double not_finite[3] = {NAN, INFINITY, -INFINITY};
  uint32_t ball, axis, v;
  for (ball = 0; ball < BALLS; ++ball) {
    double xyz[3 * BALLS], radius[BALLS];
    memcpy(xyz, good_xyz, sizeof xyz);
    memcpy(radius, good_radius, sizeof radius);
    for (v = 0; v < 3; ++v) {
      check_scene("ball %u, %g", (unsigned)ball, not_finite[v]);
      for (axis = 0; axis < 3; ++axis) {
        xyz[3 * ball + axis] = not_finite[v];
        check_refused(BALLS, xyz, radius, NULL, HSP_E_NOT_FINITE, ball);
        xyz[3 * ball + axis] = good_xyz[3 * ball + axis];
      }
      radius[ball] = not_finite[v];
      check_refused(BALLS, xyz, radius, NULL, HSP_E_NOT_FINITE, ball);
      /* a second bad ball behind it does not matter */
      radius[BALLS - 1] = not_finite[v];
      check_refused(BALLS, xyz, radius, NULL, HSP_E_NOT_FINITE, ball);
      memcpy(radius, good_radius, sizeof radius);
    }
    check_scene("ball %u, negative radius", (unsigned)ball);
    radius[ball] = -1;
    check_refused(BALLS, xyz, radius, NULL, HSP_E_NEGATIVE, ball);
    radius[ball] = -1e-300;
    check_refused(BALLS, xyz, radius, NULL, HSP_E_NEGATIVE, ball);
    radius[ball] = -0.0;
    CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
    radius[ball] = 1e300;
    check_scene("ball %u, huge radius", (unsigned)ball);
    check_refused(BALLS, xyz, radius, NULL, HSP_E_RANGE, ball);
    radius[ball] = good_radius[ball];
    for (axis = 0; axis < 3; ++axis) {
      check_scene("ball %u, far coordinate %u", (unsigned)ball, (unsigned)axis);
      xyz[3 * ball + axis] = 1e200;
      check_refused(BALLS, xyz, radius, NULL, HSP_E_RANGE, ball);
      xyz[3 * ball + axis] = -1e30;
      check_refused(BALLS, xyz, radius, NULL, HSP_E_RANGE, ball);
      xyz[3 * ball + axis] = good_xyz[3 * ball + axis];
    }
  }
  check_scene("%s", "");
}

/* With a step of 1 the limits are round numbers: radius below 2^30, coordinates up to 2^50. A step that is too small
 * for every radius is at fault itself. */
static void lattice_limits(void) {
  static const double most = 1125899906842624.0, radius_limit = 1073741824.0;
  hsp_model_options options;
  hsp_model_info info;
  double xyz[6] = {0, 0, 0, 0, 0, 0}, radius = 1, two[2] = {0, 0};
  int axis, side;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = 1;
  for (axis = 0; axis < 3; ++axis) {
    for (side = -1; side <= 1; side += 2) {
      xyz[axis] = side * most;
      CHECK_EQUAL(hsp_model_set(model, 1, xyz, &radius, &options, NULL), HSP_OK);
      xyz[axis] = side * (most + 1);
      check_refused(1, xyz, &radius, &options, HSP_E_RANGE, 0);
      xyz[axis] = 0;
    }
  }
  radius = radius_limit - 1;
  CHECK_EQUAL(hsp_model_set(model, 1, xyz, &radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
  CHECK(info.largest_radius == radius_limit - 1 && info.step == 1 && info.probe == 0);
  radius = two[1] = radius_limit;
  check_refused(1, xyz, &radius, &options, HSP_E_RANGE, HSP_NONE);
  check_refused(2, xyz, two, &options, HSP_E_RANGE, 1);
  radius = radius_limit - 3;
  options.probe = 2;
  CHECK_EQUAL(hsp_model_set(model, 1, xyz, &radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
  CHECK(info.largest_radius == radius_limit - 1 && info.probe == 2);
  two[1] = radius;
  options.probe = 3;
  check_refused(1, xyz, &radius, &options, HSP_E_RANGE, HSP_NONE);
  check_refused(2, xyz, two, &options, HSP_E_RANGE, 1);
}

static void info_and_figures(void) {
  hsp_model_info info;
  hsp_packing figures;
  FILL(info);
  FILL(figures);
  CHECK_UNTOUCHED(info);
  CHECK_UNTOUCHED(figures);
}

int main(void) {
  bytes_and_init();
  CHECK_EQUAL(hsp_model_init(memory, sizeof memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(balls_held(), 0);
  options_init();
  null_pointers();
  bad_options();
  bad_balls();
  lattice_limits();
  info_and_figures();
  return check_report();
}
