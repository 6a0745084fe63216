#include "ball_sets.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "random_numbers.h"

/* The double that a text file with `decimals` decimals would give. */
static double decimal(double value, double per_unit) {
  return floor(value * per_unit + 0.5) / per_unit;
}

void ball_set_start(ball_set *set, const char *name, double step) {
  set->name = name;
  set->n = 0;
  set->step = step;
}

void ball_set_add(ball_set *set, double x, double y, double z, double radius) {
  if (set->n == BALL_SET_MOST) {
    fprintf(stderr, "the test set %s is too large\n", set->name);
    exit(2);
  }
  set->xyz[3 * set->n] = x;
  set->xyz[3 * set->n + 1] = y;
  set->xyz[3 * set->n + 2] = z;
  set->radius[set->n] = radius;
  ++set->n;
}

const double three_balls_xyz[3 * THREE_BALLS] = {0, 0, 0, 2, 0, 0, 1, 1.5, 0};
const double three_balls_radius[THREE_BALLS] = {1.5, 1.5, 1.25};

void ball_set_add_three(ball_set *set) {
  int i;
  for (i = 0; i < THREE_BALLS; ++i) {
    const double *centre = three_balls_xyz + 3 * i;
    ball_set_add(set, centre[0], centre[1], centre[2], three_balls_radius[i]);
  }
}

void ball_set_add_grid(ball_set *set, const int counts[3], const double spacing[3], double radius) {
  int x, y, z;
  for (x = 0; x < counts[0]; ++x) {
    for (y = 0; y < counts[1]; ++y) {
      for (z = 0; z < counts[2]; ++z) ball_set_add(set, x * spacing[0], y * spacing[1], z * spacing[2], radius);
    }
  }
}

void ball_set_add_hollow(ball_set *set, double x, double y, double z, double spacing) {
  int i, j, k;
  for (i = -1; i <= 1; ++i) {
    for (j = -1; j <= 1; ++j) {
      for (k = -1; k <= 1; ++k) {
        if (i == 0 && j == 0 && k == 0) continue;
        ball_set_add(set, x + i * spacing, y + j * spacing, z + k * spacing, 0.75 * spacing);
      }
    }
  }
}

void ball_set_add_ring(ball_set *set, double x, int other_axis, double radius) {
  static const int positions[8][2] = {{5, 0}, {4, 3}, {0, 5}, {-4, 3}, {-5, 0}, {-4, -3}, {0, -5}, {4, -3}};
  int i;
  for (i = 0; i < 8; ++i) {
    const int across = positions[i][1];
    ball_set_add(set, x + positions[i][0], other_axis == 1 ? across : 0, other_axis == 2 ? across : 0, radius);
  }
}

void ball_set_add_chain(ball_set *set, uint32_t atoms, uint64_t seed) {
  static const double radii[4] = {1.7, 1.55, 1.52, 1.8};
  uint64_t state = seed;
  double at[3] = {0, 0, 0};
  uint32_t made = 0;
  while (made < atoms) {
    double towards[3], length, other[3];
    int axis, free_place = 1;
    uint32_t j;
    do {
      for (axis = 0; axis < 3; ++axis) towards[axis] = random_below(&state, 2001) - 1000;
      length = sqrt(towards[0] * towards[0] + towards[1] * towards[1] + towards[2] * towards[2]);
    } while (length < 100 || length > 1000);
    for (axis = 0; axis < 3; ++axis) other[axis] = decimal(at[axis] + 1.5 * towards[axis] / length, 1000);
    for (j = set->n - made; j < set->n; ++j) {
      const double dx = other[0] - set->xyz[3 * j], dy = other[1] - set->xyz[3 * j + 1];
      const double dz = other[2] - set->xyz[3 * j + 2];
      if (dx * dx + dy * dy + dz * dz < 1.4 * 1.4) free_place = 0;
    }
    /* A walk that is walled in steps back to an earlier atom and branches there. */
    if (!free_place) {
      const uint32_t back = set->n - made + (uint32_t)random_below(&state, (int)made);
      for (axis = 0; axis < 3; ++axis) at[axis] = set->xyz[3 * back + (uint32_t)axis];
      continue;
    }
    for (axis = 0; axis < 3; ++axis) at[axis] = other[axis];
    ball_set_add(set, at[0], at[1], at[2], radii[random_below(&state, 4)]);
    ++made;
  }
}

void ball_set_permute(const ball_set *set, const uint32_t *order, ball_set *permuted) {
  uint32_t i;
  ball_set_start(permuted, set->name, set->step);
  for (i = 0; i < set->n; ++i) {
    const uint32_t from = order[i];
    ball_set_add(permuted, set->xyz[3 * from], set->xyz[3 * from + 1], set->xyz[3 * from + 2], set->radius[from]);
  }
}

void ball_set_shuffle(uint32_t n, uint64_t seed, uint32_t *order) {
  uint64_t state = seed;
  uint32_t i;
  for (i = 0; i < n; ++i) order[i] = i;
  for (i = n; i > 1; --i) {
    const uint32_t j = (uint32_t)random_below(&state, (int)i);
    const uint32_t kept = order[i - 1];
    order[i - 1] = order[j];
    order[j] = kept;
  }
}

/* ---- the catalogue ------------------------------------------------------------------------------------------------
 */

static void empty(ball_set *s) {
  ball_set_start(s, "no balls", 1e-8);
}

static void one(ball_set *s) {
  ball_set_start(s, "one ball", 1e-8);
  ball_set_add(s, 1.25, -2.5, 3.75, 1.5);
}

static void two_overlapping(ball_set *s) {
  ball_set_start(s, "two overlapping balls", 1e-8);
  ball_set_add(s, 0, 0, 0, 1.5);
  ball_set_add(s, 1.75, 0, 0, 1.25);
}

static void two_apart(ball_set *s) {
  ball_set_start(s, "two balls apart", 1e-8);
  ball_set_add(s, 0, 0, 0, 1.5);
  ball_set_add(s, 100, 200, 300, 1.25);
}

static void touching(ball_set *s) {
  ball_set_start(s, "two balls that touch", 1e-8);
  ball_set_add(s, 0, 0, 0, 1.5);
  ball_set_add(s, 0, 4, 0, 2.5);
}

static void identical(ball_set *s) {
  ball_set_start(s, "three equal balls and a neighbour", 1e-8);
  ball_set_add(s, 0, 0, 0, 1.5);
  ball_set_add(s, 0, 0, 0, 1.5);
  ball_set_add(s, 2, 0, 0, 1.5);
  ball_set_add(s, 0, 0, 0, 1.5);
}

static void contained(ball_set *s) {
  ball_set_start(s, "balls inside balls, concentric and touching from inside", 1e-8);
  ball_set_add(s, 0, 0, 0, 3);
  ball_set_add(s, 0, 0, 0, 2);
  ball_set_add(s, 0, 0, 1, 2);
  ball_set_add(s, 0.5, 0.25, 0, 1);
}

static void zero_radii(ball_set *s) {
  ball_set_start(s, "points: inside, on, outside and equal", 1e-8);
  ball_set_add(s, 0, 0, 0, 2);
  ball_set_add(s, 1, 0, 0, 0);
  ball_set_add(s, 2, 0, 0, 0);
  ball_set_add(s, 5, 0, 0, 0);
  ball_set_add(s, 5, 0, 0, 0);
}

static void all_points(ball_set *s) {
  ball_set_start(s, "points only", 1e-8);
  ball_set_add(s, 0, 0, 0, 0);
  ball_set_add(s, 1, 0, 0, 0);
  ball_set_add(s, 0, 0, 0, 0);
}

static void collinear(ball_set *s) {
  int i;
  ball_set_start(s, "five collinear balls", 1e-8);
  for (i = 0; i < 5; ++i) ball_set_add(s, i, i, i, 1.25);
}

static void three_with_vertices(ball_set *s) {
  ball_set_start(s, "three balls with two vertices", 1e-8);
  ball_set_add_three(s);
}

static void common_point(ball_set *s) {
  ball_set_start(s, "four spheres through a covered point", 1e-8);
  ball_set_add(s, 1, 2, 2, 3);
  ball_set_add(s, -1, -2, 2, 3);
  ball_set_add(s, 1, -2, -2, 3);
  ball_set_add(s, -1, 2, -2, 3);
}

static void exposed_common_point(ball_set *s) {
  ball_set_start(s, "five spheres through an exposed point", 1e-8);
  ball_set_add(s, 3, 0, 0, 3);
  ball_set_add(s, 1, 2, 2, 3);
  ball_set_add(s, 1, -2, 2, 3);
  ball_set_add(s, 1, 2, -2, 3);
  ball_set_add(s, 1, -2, -2, 3);
}

static void cubic_grid(ball_set *s) {
  static const int counts[3] = {3, 3, 3};
  static const double spacing[3] = {1, 1, 1};
  ball_set_start(s, "cubic grid with radius 1", 1e-8);
  ball_set_add_grid(s, counts, spacing, 1);
}

static void pored_grid(ball_set *s) {
  static const int counts[3] = {4, 3, 3};
  static const double spacing[3] = {1, 1, 1};
  ball_set_start(s, "cubic grid with twelve voids", 1e-8);
  ball_set_add_grid(s, counts, spacing, 0.75);
}

static void tangent_grid(ball_set *s) {
  static const int counts[3] = {3, 3, 3};
  static const double spacing[3] = {2, 2, 2};
  ball_set_start(s, "cubic grid of touching balls", 1e-8);
  ball_set_add_grid(s, counts, spacing, 1);
}

static void eightfold_grid(ball_set *s) {
  static const int counts[3] = {3, 3, 3};
  static const double spacing[3] = {2, 4, 4};
  ball_set_start(s, "box grid with eight spheres through each cell's centre", 1e-8);
  ball_set_add_grid(s, counts, spacing, 3);
}

static void cavity(ball_set *s) {
  ball_set_start(s, "closed cavity of 26 balls", 1e-8);
  ball_set_add_hollow(s, 1, 1, 1, 1);
}

static void belt(ball_set *s) {
  /* Points with integer coordinates on a circle of radius 25: 20 of them, at most 10.3 apart. */
  static const int ring[20][2] = {{25, 0},   {24, 7},   {20, 15}, {15, 20},  {7, 24},   {0, 25},    {-7, 24},
                                  {-15, 20}, {-20, 15}, {-24, 7}, {-25, 0},  {-24, -7}, {-20, -15}, {-15, -20},
                                  {-7, -24}, {0, -25},  {7, -24}, {15, -20}, {20, -15}, {24, -7}};
  int i;
  ball_set_start(s, "a ball with a belt and a bump on its pole", 1e-7);
  ball_set_add(s, 0, 0, 0, 26);
  for (i = 0; i < 20; ++i) ball_set_add(s, ring[i][0], ring[i][1], 0, 6);
  ball_set_add(s, 0, 0, 26, 3);
}

static void ring(ball_set *s) {
  ball_set_start(s, "a ring of balls with a hole", 1e-8);
  ball_set_add_ring(s, 0, 1, 2.5);
}

static void chain(ball_set *s) {
  ball_set_start(s, "a chain of 60 atoms", 1e-8);
  ball_set_add_chain(s, 60, 11);
}

static void soft_chain(ball_set *s) {
  uint32_t i;
  ball_set_start(s, "a chain of 40 atoms with solvent radii", 1e-8);
  ball_set_add_chain(s, 40, 12);
  for (i = 0; i < s->n; ++i) s->radius[i] = decimal(s->radius[i] + 1.4, 1000);
}

static void doubled_chain(ball_set *s) {
  uint32_t i, n;
  ball_set_start(s, "a chain of 20 atoms, each twice, with half-size balls inside", 1e-8);
  ball_set_add_chain(s, 20, 13);
  n = s->n;
  for (i = 0; i < n; ++i) {
    const double x = s->xyz[3 * i], y = s->xyz[3 * i + 1], z = s->xyz[3 * i + 2], r = s->radius[i];
    ball_set_add(s, x, y, z, r);
    ball_set_add(s, x, y, z, decimal(r / 2, 1000));
  }
}

static void two_molecules(ball_set *s) {
  uint32_t i;
  ball_set_start(s, "two chains far apart", 1e-8);
  ball_set_add_chain(s, 15, 14);
  ball_set_add_chain(s, 15, 15);
  for (i = 15; i < 30; ++i) s->xyz[3 * i] = decimal(s->xyz[3 * i] - 5000, 1000);
}

static void integer_cloud(ball_set *s) {
  uint64_t state = 16;
  int i;
  ball_set_start(s, "random integer balls with many ties", 1e-8);
  for (i = 0; i < 40; ++i) {
    const int x = random_below(&state, 7), y = random_below(&state, 7), z = random_below(&state, 5);
    ball_set_add(s, x, y, z, random_below(&state, 4));
  }
}

static void one_size_differs(ball_set *s) {
  uint64_t state = 17;
  int i;
  ball_set_start(s, "small balls around a very large one", 1e-6);
  ball_set_add(s, 0, 0, 0, 500);
  for (i = 0; i < 60; ++i) {
    const double u = random_below(&state, 1001) - 500, v = random_below(&state, 1001) - 500;
    ball_set_add(s, u, v, 400, 1 + random_below(&state, 3));
  }
}

static void (*const catalogue[])(ball_set *) = {empty,
                                                one,
                                                two_overlapping,
                                                two_apart,
                                                touching,
                                                identical,
                                                contained,
                                                zero_radii,
                                                all_points,
                                                collinear,
                                                three_with_vertices,
                                                common_point,
                                                exposed_common_point,
                                                cubic_grid,
                                                pored_grid,
                                                tangent_grid,
                                                eightfold_grid,
                                                cavity,
                                                belt,
                                                ring,
                                                chain,
                                                soft_chain,
                                                doubled_chain,
                                                two_molecules,
                                                integer_cloud,
                                                one_size_differs};

uint32_t ball_set_count(void) {
  return (uint32_t)(sizeof catalogue / sizeof catalogue[0]);
}

void ball_set_make(uint32_t which, ball_set *set) {
  catalogue[which](set);
}
