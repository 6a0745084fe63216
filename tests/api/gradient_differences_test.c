/* Every entry of the Jacobian against differences of areas between neighbouring positions and radii, which
 * hsp_boundary_measure gives: central differences where areas are smooth, one-sided ones where balls touch. Moved
 * numbers are multiples of the lattice step, so that nothing is lost in rounding. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "gradients.h"

/* Areas and volume after coordinate or radius `which` (0..2, 3) of ball j has moved. */
typedef struct measured {
  double area[BALL_SET_MOST];
  double volume;
} measured;

static void measure_moved(const ball_set *set, uint32_t j, int which, double by, measured *result) {
  static ball_set moved;
  computed c;
  moved = *set;
  if (which < 3) {
    moved.xyz[3 * j + (uint32_t)which] += by;
  } else {
    moved.radius[j] += by;
  }
  CHECK_EQUAL(computed_make(moved.n, moved.xyz, moved.radius, NULL, &c), HSP_OK);
  memcpy(result->area, c.area, c.n * sizeof(double));
  result->volume = c.totals.volume;
  computed_release(&c);
}

/* Fourth order from four points. */
static double central(const double at[4], double h) {
  return (at[0] - 8 * at[1] + 8 * at[2] - at[3]) / (12 * h);
}

/* Third order from four points on one side, the first at 0 and h of either sign. */
static double one_sided(const double at[4], double h) {
  return (-11 * at[0] + 18 * at[1] - 9 * at[2] + 2 * at[3]) / (6 * h);
}

static double entry_number(const hsp_area_derivative *entry, int which) {
  if (entry == NULL) return 0;
  return which < 3 ? entry->centre[which] : entry->radius;
}

/* The derivatives by number `which` of ball j of all areas and of the volume against differences over the points
 * times[k] h. */
static void check_column(const ball_set *set, const jacobian *rows, const gradients *volume, uint32_t j, int which,
                         double h, const int times[4], double (*slope)(const double *, double), double tolerance) {
  static measured at[4];
  double values[4];
  uint32_t i;
  int k;
  for (k = 0; k < 4; ++k) measure_moved(set, j, which, times[k] * h, &at[k]);
  for (i = 0; i < set->n; ++i) {
    for (k = 0; k < 4; ++k) values[k] = at[k].area[i];
    CHECK_NEAR(entry_number(jacobian_entry(rows, i, j), which), slope(values, h), tolerance);
  }
  for (k = 0; k < 4; ++k) values[k] = at[k].volume;
  CHECK_NEAR(which < 3 ? volume->centre[3 * j + (uint32_t)which] : volume->radius[j], slope(values, h), tolerance);
}

static void smooth(const ball_set *set, double h, double tolerance) {
  static const int times[4] = {-2, -1, 1, 2};
  static gradients volume;
  computed c;
  jacobian rows;
  uint32_t j;
  int which;
  check_scene("%s", set->name);
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(jacobian_make(&c, HSP_TANGENT_OVERLAP, &rows), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 0, 1, HSP_TANGENT_OVERLAP, &volume), HSP_OK);
  for (j = 0; j < set->n; ++j) {
    for (which = 0; which < 4; ++which) {
      check_scene("%s, number %d of ball %u", set->name, which, (unsigned)j);
      check_column(set, &rows, &volume, j, which, h, times, central, tolerance);
    }
  }
  jacobian_release(&rows);
  computed_release(&c);
}

/* Balls in a row that touch, of several sizes; one touch is covered by a fourth ball. */
static void touching(void) {
  static const int times[4] = {0, 1, 2, 3};
  static const uint32_t tangencies[2] = {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT};
  static ball_set set;
  static gradients volume;
  computed c;
  jacobian rows;
  int t;
  ball_set_start(&set, "balls that touch", 1e-8);
  ball_set_add(&set, 0, 0, 0, 1.5);
  ball_set_add(&set, 2.5, 0, 0, 1);
  ball_set_add(&set, 5.5, 0, 0, 2);
  ball_set_add(&set, 3.5, 0.25, 0.5, 0.75);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  for (t = 0; t < 2; ++t) {
    /* ball 0 towards ball 1 or away from it; larger or smaller */
    const double sign = tangencies[t] == HSP_TANGENT_OVERLAP ? 1 : -1;
    CHECK_EQUAL(jacobian_make(&c, tangencies[t], &rows), HSP_OK);
    CHECK_EQUAL(gradients_make(&c, NULL, 0, 1, tangencies[t], &volume), HSP_OK);
    check_scene("%s, tangency %u", set.name, (unsigned)tangencies[t]);
    CHECK_EQUAL(volume.flags[0], HSP_GRADIENT_ONE_SIDED);
    CHECK_EQUAL(volume.flags[1], HSP_GRADIENT_ONE_SIDED);
    CHECK_EQUAL(volume.flags[2], 0);
    CHECK_EQUAL(volume.flags[3], 0);
    check_column(&set, &rows, &volume, 0, 0, sign * 1e-4, times, one_sided, 1e-7);
    check_column(&set, &rows, &volume, 0, 3, sign * 1e-4, times, one_sided, 1e-7);
    check_column(&set, &rows, &volume, 1, 3, sign * 1e-4, times, one_sided, 1e-7);
    check_column(&set, &rows, &volume, 1, 0, -sign * 1e-4, times, one_sided, 1e-7);
    jacobian_release(&rows);
  }
  computed_release(&c);
}

int main(void) {
  static ball_set set;
  uint32_t i;
  ball_set_start(&set, "three balls", 1e-8);
  ball_set_add_three(&set);
  smooth(&set, 1e-3, 1e-7);
  ball_set_start(&set, "a chain of atoms", 1e-8);
  ball_set_add_chain(&set, 24, 101);
  smooth(&set, 1e-4, 1e-7);
  ball_set_start(&set, "a chain of atoms with a probe", 1e-8);
  ball_set_add_chain(&set, 24, 102);
  for (i = 0; i < set.n; ++i) set.radius[i] += 1.4;
  smooth(&set, 1e-4, 1e-7);
  touching();
  return check_report();
}
