/* The model: its lattice, what it tells about itself, and the figures of Section 2 against the definitions, which are
 * evaluated over all pairs in integers. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"

static unsigned char memory[HSP_MODEL_BYTES(BALL_SET_MOST)];
static hsp_model *model;

/* The smallest power of ten with r_max/step < 2^30, as the header defines the default step. */
static void default_steps(void) {
  static const struct {
    double largest, step;
  } cases[] = {{0, 1e-8},      {1, 1e-9},      {1.073741823, 1e-9}, {1.073741824, 1e-8}, {1.08, 1e-8}, {1.7, 1e-8},
               {3.2, 1e-8},    {10.7, 1e-8},   {10.8, 1e-7},        {107.3, 1e-7},       {108, 1e-6},  {1000, 1e-6},
               {1e6, 1e-3},    {1e9, 1},       {2e9, 10},           {1e15, 1e6},         {1e30, 1e21}, {1e-3, 1e-12},
               {1e-10, 1e-19}, {1e-13, 1e-22}, {1e-15, 1e-22},      {1.05e-16, 1e-22},   {1e31, 1e22}};
  size_t i;
  for (i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
    double xyz[6] = {0, 0, 0, 0, 0, 0}, radius[2] = {0, 0};
    hsp_model_info info;
    hsp_model_options options;
    check_scene("largest radius %.10g", cases[i].largest);
    radius[1] = cases[i].largest;
    CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    CHECK(info.step == cases[i].step);
    CHECK(info.probe == 0);
    CHECK_NEAR(info.largest_radius, cases[i].largest, 0.5 * info.step + 1e-15 * cases[i].largest);
    /* the probe counts as radius */
    radius[1] = 0;
    CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
    options.probe = cases[i].largest;
    CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, &options, NULL), HSP_OK);
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    CHECK(info.step == cases[i].step);
    CHECK_NEAR(info.probe, cases[i].largest, 0.5 * info.step + 1e-15 * cases[i].largest);
    CHECK(info.largest_radius == info.probe);
  }
}

/* Text with no more decimals than the lattice is represented exactly: sums of decimals that are no sums of doubles. */
static void decimals_are_exact(void) {
  static const struct {
    double distance, r, s;
  } tangent[] = {{3.4, 1.7, 1.7},   {3.25, 1.7, 1.55}, {0.3, 0.1, 0.2},
                 {2.62, 1.52, 1.1}, {0.7, 0.6, 0.1},   {1.1, 0.4, 0.7}};
  size_t i;
  for (i = 0; i < sizeof tangent / sizeof tangent[0]; ++i) {
    double xyz[6] = {0, 0, 0, 0, 0, 0}, radius[2];
    uint32_t needed = 7;
    hsp_packing figures;
    int axis, away;
    radius[0] = tangent[i].r;
    radius[1] = tangent[i].s;
    for (axis = 0; axis < 3; ++axis) {
      for (away = -1; away <= 1; away += 2) {
        check_scene("%g + %g against %g, axis %d", tangent[i].r, tangent[i].s, tangent[i].distance, axis);
        xyz[3 + axis] = away * tangent[i].distance;
        CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, NULL, NULL), HSP_OK);
        /* touching counts as meeting ... */
        (void)hsp_query_neighbours(model, 0, NULL, 0, &needed);
        CHECK_EQUAL(needed, 1);
        /* ... but not as overlapping */
        CHECK_EQUAL(hsp_model_get_packing(model, &figures), HSP_OK);
        CHECK_EQUAL(figures.max_overlaps, 0);
        xyz[3 + axis] = away * (tangent[i].distance + 1e-8);
        CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, NULL, NULL), HSP_OK);
        (void)hsp_query_neighbours(model, 0, NULL, 0, &needed);
        CHECK_EQUAL(needed, 0);
        xyz[3 + axis] = away * (tangent[i].distance - 1e-8);
        CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, NULL, NULL), HSP_OK);
        CHECK_EQUAL(hsp_model_get_packing(model, &figures), HSP_OK);
        CHECK_EQUAL(figures.max_overlaps, 1);
        xyz[3 + axis] = 0;
      }
    }
  }
}

static int64_t steps(double value) {
  return (int64_t)floor(value * 1000 + 0.5);
}

/* k, rho and overlaps over all pairs, on a lattice of 0.001 so that squares fit 64 bits. */
static void figures_by_definition(const ball_set *set, double probe) {
  hsp_model_options options;
  hsp_packing figures;
  hsp_model_info info;
  const int64_t p = steps(probe);
  int64_t smallest = INT64_MAX, largest = 0, all = 0;
  uint32_t i, j, most = 0, flags = 0;
  double rho = HUGE_VAL;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = 1e-3;
  options.probe = probe;
  CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, set->radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_get_packing(model, &figures), HSP_OK);
  CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
  for (i = 0; i < set->n; ++i) {
    const int64_t r = steps(set->radius[i]) + p;
    uint32_t overlaps = 0;
    if (r < smallest) smallest = r;
    if (r > largest) largest = r;
    if (r == 0) flags |= HSP_PACKING_ZERO_RADIUS;
    for (j = 0; j < set->n; ++j) {
      const int64_t s = steps(set->radius[j]) + p;
      int64_t squared = 0;
      int axis;
      if (i == j) continue;
      for (axis = 0; axis < 3; ++axis) {
        const int64_t d = steps(set->xyz[3 * i + (uint32_t)axis]) - steps(set->xyz[3 * j + (uint32_t)axis]);
        squared += d * d;
      }
      if (squared < (r + s) * (r + s)) ++overlaps;
      if (squared == 0) {
        flags |= HSP_PACKING_COINCIDENT;
        rho = 0;
      }
      if ((r > s ? r : s) > 0) rho = fmin(rho, sqrt((double)squared) / (double)(r > s ? r : s));
    }
    all += overlaps;
    if (overlaps > most) most = overlaps;
  }
  if (set->n < 2 || largest == 0) flags |= HSP_PACKING_NO_PAIR;
  CHECK_EQUAL(figures.flags, flags);
  CHECK_EQUAL(figures.max_overlaps, most);
  CHECK_NEAR(figures.mean_overlaps, set->n == 0 ? 0.0 : (double)all / set->n, 1e-14 * (double)most);
  if (set->n == 0 || smallest == 0) {
    CHECK(figures.k == 0);
  } else {
    CHECK_NEAR(figures.k, (double)largest / (double)smallest, 1e-15 * figures.k);
  }
  if ((flags & HSP_PACKING_NO_PAIR) != 0) {
    CHECK(figures.rho == 0);
  } else {
    CHECK_NEAR(figures.rho, rho, 4e-16 * rho);
  }
  if (figures.rho > 0 && figures.k > 0) {
    const double ratio = figures.k / figures.rho;
    CHECK_NEAR(figures.neighbour_bound, 216 * ratio * ratio * ratio, 1e-14 * figures.neighbour_bound);
    /* Theorem 2.1 */
    CHECK((double)most <= figures.neighbour_bound);
  } else {
    CHECK(figures.neighbour_bound == 0);
  }

  CHECK_EQUAL(info.balls, set->n);
  CHECK(info.step == 1e-3);
  CHECK_NEAR(info.probe, probe, 1e-15);
  CHECK_NEAR(info.largest_radius, (double)largest * 1e-3, 1e-15 * (double)largest);
  CHECK(info.cubes <= set->n && (info.cubes > 0) == (set->n > 0));
  CHECK(info.table_slots >= 2 * info.cubes);
  CHECK(info.longest_probe <= info.table_slots && (info.longest_probe > 0) == (set->n > 0));
}

/* Models with the same options have the same lattice, and a ball with the same neighbours the same area to the last
 * bit, whatever else is there. Without the option a far, larger ball changes the lattice. */
static void same_grid(void) {
  static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(4, 4, 16, 8)];
  static const double xyz[12] = {0.123456789012, 0, 0, 1.3, 0.2, 0.1, 0.4, 1.1, -0.2, 50, 0, 0};
  static const double radius[4] = {1.2, 1.0, 0.9, 20};
  hsp_boundary_limits limits;
  hsp_boundary *boundary = NULL;
  int with_option;
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, 4), HSP_OK);
  limits.neighbours = 4, limits.vertices = 16, limits.circles = 8;
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  for (with_option = 0; with_option < 2; ++with_option) {
    double area[2][4];
    hsp_model_info info[2];
    uint32_t n;
    for (n = 3; n <= 4; ++n) {
      hsp_model_options options;
      CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
      options.probe = 0.25;
      if (with_option) options.largest_radius = 20;
      CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, &options, NULL), HSP_OK);
      CHECK_EQUAL(hsp_model_get_info(model, &info[n - 3]), HSP_OK);
      CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
      CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, area[n - 3], NULL, n, NULL), HSP_OK);
    }
    CHECK((info[0].step == info[1].step) == with_option);
    CHECK((memcmp(area[0], area[1], 3 * sizeof area[0][0]) == 0) == with_option);
    CHECK(info[0].largest_radius == 1.45 && info[1].largest_radius == 20.25); /* of the balls that are there */
  }
}

int main(void) {
  uint32_t which;
  CHECK_EQUAL(hsp_model_init(memory, sizeof memory, BALL_SET_MOST, &model), HSP_OK);
  default_steps();
  same_grid();
  decimals_are_exact();
  for (which = 0; which < ball_set_count(); ++which) {
    static ball_set set;
    ball_set_make(which, &set);
    check_scene("%s", set.name);
    figures_by_definition(&set, 0);
    check_scene("%s, probe", set.name);
    figures_by_definition(&set, 1.4);
  }
  return check_report();
}
