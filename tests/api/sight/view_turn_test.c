/* The direction of a view: hsp_view_options_turn against rotations computed here, defaults for zero and parallel
 * vectors, vectors of any length, and axes that are exact. */
#include <hardsphere.h>
#include <math.h>

#include "check.h"
#include "untouched.h"
#include "vectors.h"

enum { BALLS = 2 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char view_memory[HSP_VIEW_BYTES(BALLS, BALLS, 16)];
static hsp_model *model;
static hsp_view *view;

static hsp_view_options fresh(void) {
  hsp_view_options options;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  return options;
}

static hsp_view_info seen_with(const hsp_view_options *options) {
  hsp_view_info info;
  FILL(info);
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_OK);
  return info;
}

/* ---- turns ---- */

/* turned = rotation * turned, counter-clockwise about an axis seen from its positive end. */
static void turn_about(int axis, double degrees, double turned[3][3]) {
  static const double quarters[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const double quarter = degrees / 90;
  double c = cos(degrees * pi / 180), s = sin(degrees * pi / 180);
  int column;
  if (quarter == floor(quarter)) {
    const int which = (int)(((long)quarter % 4 + 4) % 4);
    c = quarters[which][0];
    s = quarters[which][1];
  }
  for (column = 0; column < 3; ++column) {
    const double first = turned[a][column], second = turned[b][column];
    turned[a][column] = c * first - s * second;
    turned[b][column] = s * first + c * second;
  }
}

/* The rows of the rotation are the axes of the view, as view coordinates are products with them. */
static void check_turn(double x, double y, double z, double tolerance) {
  double turned[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  hsp_view_options options = fresh();
  hsp_view_info info;
  int axis;
  check_scene("turned by %g %g %g", x, y, z);
  turn_about(0, x, turned);
  turn_about(1, y, turned);
  turn_about(2, z, turned);
  options.pieces = HSP_PIECES_OUTSIDE_ALL; /* what is not about the direction stays */
  options.flags = HSP_VIEW_ALL_BALLS;
  CHECK_EQUAL(hsp_view_options_turn(&options, x, y, z), HSP_OK);
  CHECK_EQUAL(options.struct_size, sizeof options);
  CHECK_EQUAL(options.pieces, HSP_PIECES_OUTSIDE_ALL);
  CHECK_EQUAL(options.flags, HSP_VIEW_ALL_BALLS);
  CHECK_EQUAL(options.reserved, 0);
  options.pieces = HSP_PIECES_OUTSIDE_FARTHER;
  info = seen_with(&options);
  for (axis = 0; axis < 3; ++axis) {
    CHECK_NEAR(info.right[axis], turned[0][axis], tolerance);
    CHECK_NEAR(info.up[axis], turned[1][axis], tolerance);
    CHECK_NEAR(info.towards[axis], turned[2][axis], tolerance);
  }
}

static void turns(void) {
  static const double angles[] = {0, 1, -17.5, 30, 45, 60, 89.999, 120, 179, 200.25, 359, -719, 1e6, -1e6};
  enum { ANGLES = sizeof angles / sizeof angles[0] };
  int i, j, k;
  /* quarter turns are exact, whatever the number of whole turns */
  for (i = -4; i <= 4; ++i) {
    for (j = -4; j <= 4; ++j) {
      for (k = -4; k <= 4; ++k) check_turn(90.0 * i, 90.0 * j, 90.0 * k, 0);
    }
  }
  check_turn(90 * 10001.0, -90 * 11111.0, 999990, 0);
  /* directions are rounded to 2^28, and 1e6 degrees lose digits */
  for (i = 0; i < ANGLES; ++i) {
    for (j = 0; j < ANGLES; ++j) {
      for (k = 0; k < ANGLES; ++k) check_turn(angles[i], angles[j], angles[k], 2e-8);
    }
  }
  /* right-handed, and x before y: what points to the viewer goes down and stays there, or goes right */
  {
    hsp_view_options options = fresh();
    hsp_view_info info;
    check_scene("%s", "a quarter about x");
    CHECK_EQUAL(hsp_view_options_turn(&options, 90, 0, 0), HSP_OK);
    info = seen_with(&options);
    CHECK(info.towards[1] == 1 && info.up[2] == -1 && info.right[0] == 1); /* +y has come to the viewer */
    CHECK_EQUAL(hsp_view_options_turn(&options, 90, 90, 0), HSP_OK);
    info = seen_with(&options);
    CHECK(info.up[2] == -1 && info.right[1] == 1 && info.towards[0] == -1);
  }
  check_scene("%s", "");
}

static void refused_turns(void) {
  static const double odd[3] = {NAN, INFINITY, -INFINITY};
  hsp_view_options options = fresh(), before;
  int i, k;
  options.towards[0] = 0.25;
  options.up[2] = 0.75;
  before = options;
  CHECK_EQUAL(hsp_view_options_turn(NULL, 0, 0, 0), HSP_E_ARGUMENT);
  for (i = 0; i < 3; ++i) {
    double angle[3] = {10, 20, 30};
    for (k = 0; k < 3; ++k) {
      angle[i] = odd[k];
      CHECK_EQUAL(hsp_view_options_turn(&options, angle[0], angle[1], angle[2]), HSP_E_NOT_FINITE);
    }
    angle[i] = nextafter(1e6, 2e6);
    CHECK_EQUAL(hsp_view_options_turn(&options, angle[0], angle[1], angle[2]), HSP_E_RANGE);
    angle[i] = -1e300;
    CHECK_EQUAL(hsp_view_options_turn(&options, angle[0], angle[1], angle[2]), HSP_E_RANGE);
  }
  CHECK_BYTES(&options, &before, sizeof options);
  options.struct_size = 0;
  before = options;
  CHECK_EQUAL(hsp_view_options_turn(&options, 1, 2, 3), HSP_E_VERSION);
  options.struct_size = before.struct_size = 1028;
  CHECK_EQUAL(hsp_view_options_turn(&options, 1, 2, 3), HSP_E_VERSION);
  CHECK_BYTES(&options, &before, sizeof options);
}

/* ---- directions ---- */

static void check_axes(const double towards[3], const double up[3], const double expected_towards[3],
                       const double expected_up[3], double tolerance) {
  hsp_view_options options = fresh();
  hsp_view_info info;
  double right[3];
  int axis;
  check_scene("towards %g %g %g, up %g %g %g", towards[0], towards[1], towards[2], up[0], up[1], up[2]);
  for (axis = 0; axis < 3; ++axis) {
    options.towards[axis] = towards[axis];
    options.up[axis] = up[axis];
  }
  info = seen_with(&options);
  cross(expected_up, expected_towards, right);
  for (axis = 0; axis < 3; ++axis) {
    CHECK_NEAR(info.towards[axis], expected_towards[axis], tolerance);
    CHECK_NEAR(info.up[axis], expected_up[axis], tolerance);
    CHECK_NEAR(info.right[axis], right[axis], tolerance);
  }
}

static void unit(double x, double y, double z, double v[3]) {
  const double size = sqrt(x * x + y * y + z * z);
  v[0] = x / size;
  v[1] = y / size;
  v[2] = z / size;
}

static void defaults(void) {
  static const double zero[3] = {0, 0, 0}, x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
  static const double back[3] = {0, 0, -1}, down[3] = {0, -1, 0};
  hsp_view_info info, again;
  hsp_view_options options = fresh();
  double towards[3], up[3];
  FILL(again);
  check_axes(zero, zero, z, y, 0);
  check_axes(z, zero, z, y, 0);
  check_axes(back, zero, back, y, 0);
  check_axes(x, zero, x, y, 0);
  check_axes(z, z, z, y, 0);    /* parallel */
  check_axes(z, back, z, y, 0); /* and opposite */
  check_axes(x, x, x, y, 0);
  check_axes(y, zero, y, z, 0); /* towards is parallel to the default */
  check_axes(y, y, y, z, 0);
  check_axes(down, zero, down, z, 0);
  check_axes(down, y, down, z, 0);
  check_axes(y, x, y, x, 0);
  check_axes(z, down, z, down, 0);
  unit(1, 1, 1, towards);
  unit(-1, 2, -1, up);
  check_axes(towards, zero, towards, up, 1e-8);
  check_axes(towards, towards, towards, up, 1e-8);
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_view_get_info(view, &again), HSP_OK);
  info = seen_with(&options);
  CHECK_BYTES(&info, &again, sizeof info);
}

static void any_length(void) {
  static const double lengths[] = {1, 5, 1e-3, 1e-150, 1e150, 1e300, 1e-300, 5e-324, 1.7e308};
  double one[3], up[3];
  size_t i, j;
  unit(1, 1, 1, one);
  unit(-1, 2, -1, up);
  for (i = 0; i < sizeof lengths / sizeof lengths[0]; ++i) {
    for (j = 0; j < sizeof lengths / sizeof lengths[0]; ++j) {
      const double towards[3] = {lengths[i], lengths[i], lengths[i]};
      const double upwards[3] = {0, lengths[j], 0};
      /* not across, so that only its part across counts */
      check_axes(towards, upwards, one, up, 1e-8);
    }
  }
}

/* Axes and diagonals are exact: balls at equal depths are in the order of their coordinates. */
static void exact_diagonals(void) {
  static const double towards[3] = {-7, 7, 0};
  static const double xyz[3 * BALLS] = {1.00000001, 1.00000001, 0, -4, -4, 7};
  static const double radius[BALLS] = {1, 1};
  hsp_view_piece pieces[BALLS];
  uint32_t needed = 0;
  hsp_view_options options = fresh();
  hsp_view_info info;
  int axis;
  check_scene("%s", "a diagonal");
  for (axis = 0; axis < 3; ++axis) options.towards[axis] = towards[axis];
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  info = seen_with(&options);
  CHECK(info.towards[0] == -info.towards[1] && info.towards[2] == 0);
  CHECK_NEAR(info.towards[1], sqrt(0.5), 1e-15);
  CHECK_EQUAL(hsp_view_get_pieces(view, pieces, BALLS, &needed), HSP_OK);
  CHECK_EQUAL(needed, 2);
  CHECK_EQUAL(pieces[0].ball, 1);
  CHECK(pieces[0].depth == pieces[1].depth);
}

int main(void) {
  static const double xyz[3 * BALLS] = {0, 0, 0, 2, 1, 0.5};
  static const double radius[BALLS] = {1.5, 1.25};
  hsp_view_limits limits;
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.arcs = 16;
  CHECK_EQUAL(hsp_view_init(view_memory, sizeof view_memory, &limits, &view), HSP_OK);
  turns();
  refused_turns();
  defaults();
  any_length();
  exact_diagonals();
  return check_report();
}
