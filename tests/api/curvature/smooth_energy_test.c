/* The client capi/clients/smooth_energy.h: a scan of two balls from one inside the other to apart, against closed forms
 * of value, slope and second derivative; centres between the points of the lattice; and no memory. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static size_t most_bytes = SIZE_MAX;
static void *limited_malloc(size_t bytes) {
  return bytes <= most_bytes ? malloc(bytes) : NULL;
}
#define malloc limited_malloc
#include "../../../capi/clients/smooth_energy.h"
#undef malloc

#include "check.h"
#include "vectors.h"

/* The union of two balls at a distance d, and its derivatives by d: a disc that opens as they part. */
typedef struct lens {
  double volume, slope, bend;
} lens;

static lens lens_of(double d, double r, double s) {
  const double whole = 4 * pi / 3 * (r * r * r + s * s * s);
  lens l = {whole, 0, 0};
  if (d <= fabs(r - s)) {
    l.volume = 4 * pi / 3 * fmax(r * r * r, s * s * s);
  } else if (d < r + s) {
    const double h = (d * d + r * r - s * s) / (2 * d), k = d - h;
    l.volume = whole - pi / 3 * ((r - h) * (r - h) * (2 * r + h) + (s - k) * (s - k) * (2 * s + k));
    l.slope = pi * (r - h) * (r + h);
    l.bend = -2 * pi * h * k / d;
  }
  return l;
}

static void check_scan(double r, double s, double weight, double window) {
  const double sigma[2] = {1, weight}, radius[2] = {r, s};
  smooth_energy surface = {.window = window, .sigma = sigma, .step = 1e-8, .largest_radius = 3};
  int k;
  check_scene("two balls, weight %g, window %g", weight, window);
  for (k = 150; k < 3600; ++k) {
    const double d = 0.001 * k + 0.0003, xyz[6] = {0.125, -1, 2, 0.125 + d, -1, 2};
    double value, gradient[6], matrix[36] = {0};
    lens grown, shrunk;
    if (!CHECK_EQUAL(smooth_energy_set(&surface, 2, xyz, radius), HSP_OK)) break;
    CHECK_EQUAL(smooth_energy_gradient(&surface, &value, gradient), HSP_OK);
    CHECK_EQUAL(smooth_energy_add_matrix(&surface, 1, matrix), HSP_OK);
    grown = lens_of(d, r + window, s + window * weight);
    shrunk = lens_of(d, r - window, s - window * weight);
    CHECK_NEAR(value, (grown.volume - shrunk.volume) / (2 * window), 1e-11);
    CHECK_NEAR(gradient[3], (grown.slope - shrunk.slope) / (2 * window), 1e-11);
    CHECK_NEAR(gradient[0], -gradient[3], 1e-11);
    CHECK_NEAR(matrix[21], (grown.bend - shrunk.bend) / (2 * window), 1e-11 * (1 + 1 / d));
  }
  smooth_energy_free(&surface);
}

/* A coarse lattice: what it rounds away comes back to second order, from derivatives at the rounded centres. */
static void check_rounding_undone(double window) {
  const double xyz[9] = {0.0003, 0.0001, 0, 1.4002, 0.3, 0.0004, 0.7, 1.2003, 0.2}, radius[3] = {1, 1.25, 1.125};
  smooth_energy fine = {.window = window, .step = 1e-8, .largest_radius = 3}, coarse = fine;
  double value[2], gradient[2][9];
  int k;
  coarse.step = 0x1p-10;
  check_scene("a coarse lattice, window %g", window);
  CHECK_EQUAL(smooth_energy_set(&fine, 3, xyz, radius), HSP_OK);
  CHECK_EQUAL(smooth_energy_gradient(&fine, &value[0], gradient[0]), HSP_OK);
  CHECK_EQUAL(smooth_energy_set(&coarse, 3, xyz, radius), HSP_OK);
  CHECK_EQUAL(smooth_energy_gradient(&coarse, &value[1], gradient[1]), HSP_OK);
  CHECK_NEAR(value[0], value[1], 1e-7);
  for (k = 0; k < 9; ++k) CHECK_NEAR(gradient[0][k], gradient[1][k], 2e-5);
  smooth_energy_free(&fine);
  smooth_energy_free(&coarse);
}

/* Without memory there are no balls, and afterwards those that come. */
static void check_memory(void) {
  const double xyz[6] = {0, 0, 0, 1, 0, 0}, radius[2] = {1, 1}, area = 6 * pi;
  smooth_energy surface = {.step = 1e-8, .largest_radius = 3};
  double value, gradient[6];
  int k;
  check_scene("no memory");
  for (k = 0; k < 2; ++k) {
    CHECK_EQUAL(smooth_energy_set(&surface, 1, xyz, radius), HSP_OK);
    most_bytes = 10;
    CHECK_EQUAL(smooth_energy_set(&surface, 2, xyz, radius), HSP_E_MEMORY);
    most_bytes = SIZE_MAX;
    CHECK(surface.n == 0 && smooth_energy_gradient(&surface, &value, gradient) != HSP_OK);
    CHECK_EQUAL(smooth_energy_set(&surface, 2, xyz, radius), HSP_OK);
    CHECK_EQUAL(smooth_energy_gradient(&surface, &value, gradient), HSP_OK);
    CHECK_NEAR(value, area, 1e-12);
  }
  smooth_energy_free(&surface);
}

/* A negative radius, NaN and a window below 0 are refused, and not taken for 0. */
static void check_refused(void) {
  const double xyz[6] = {0, 0, 0, 1, 0, 0}, negative[2] = {1, -1}, unknown[2] = {1, NAN}, good[2] = {1, 1};
  smooth_energy surface = {.step = 1e-8, .largest_radius = 3};
  int k;
  check_scene("refused");
  for (k = 0; k < 2; ++k) {
    surface.window = k == 0 ? 0 : 0.0625;
    CHECK_EQUAL(smooth_energy_set(&surface, 2, xyz, negative), HSP_E_NEGATIVE);
    CHECK_EQUAL(smooth_energy_set(&surface, 2, xyz, unknown), HSP_E_NOT_FINITE);
    CHECK_EQUAL(smooth_energy_set(&surface, 2, xyz, good), HSP_OK);
  }
  surface.window = -0.0625;
  CHECK_EQUAL(smooth_energy_set(&surface, 2, xyz, good), HSP_E_NEGATIVE);
  surface.window = NAN;
  CHECK_EQUAL(smooth_energy_set(&surface, 2, xyz, good), HSP_E_NOT_FINITE);
  smooth_energy_free(&surface);
}

int main(void) {
  check_memory();
  check_refused();
  check_scan(1.2, 1, 1, 0.0625);
  check_scan(1.5, 1.25, 0.5, 0.125);
  check_scan(1, 0.75, -0.5, 0.0625);
  check_rounding_undone(0);
  check_rounding_undone(0.0625);
  return check_report();
}
