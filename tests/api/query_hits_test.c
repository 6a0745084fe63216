/* The queries of Section 3 against all balls one by one, in integers: points and balls at centres, on spheres, between,
 * far away, with radius 0 and with radii much larger than any ball. All pairs likewise. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"

static unsigned char memory[HSP_MODEL_BYTES(BALL_SET_MOST)];
static hsp_model *model;
static const double probe = 0.25;

/* The lattice of these tests is 0.001, so that squares of distances fit 64 bits. */
static int64_t steps(double value) {
  return (int64_t)floor(value * 1000 + 0.5);
}

/* The balls that meet the ball (xyz, reach), without ball `but`. */
static uint32_t expected_hits(const ball_set *set, const double *xyz, int64_t reach, uint32_t but, uint32_t *ids) {
  uint32_t i, hits = 0;
  for (i = 0; i < set->n; ++i) {
    const int64_t within = steps(set->radius[i]) + steps(probe) + reach;
    int64_t squared = 0;
    int axis;
    for (axis = 0; axis < 3; ++axis) {
      const int64_t d = steps(set->xyz[3 * i + (uint32_t)axis]) - steps(xyz[axis]);
      squared += d * d;
    }
    if (i != but && squared <= within * within) ids[hits++] = i;
  }
  return hits;
}

static void check_place(const ball_set *set, const double *xyz, double reach) {
  uint32_t expected[BALL_SET_MOST], ids[BALL_SET_MOST], hits, needed = 0;
  uint32_t meets = 77;
  hits = expected_hits(set, xyz, 0, HSP_NONE, expected);
  CHECK_EQUAL(hsp_query_point(model, xyz, ids, BALL_SET_MOST, &needed), HSP_OK);
  if (CHECK_EQUAL(needed, hits)) CHECK_BYTES(ids, expected, hits * sizeof ids[0]);
  hits = expected_hits(set, xyz, steps(reach), HSP_NONE, expected);
  CHECK_EQUAL(hsp_query_ball(model, xyz, reach, ids, BALL_SET_MOST, &needed), HSP_OK);
  if (CHECK_EQUAL(needed, hits)) CHECK_BYTES(ids, expected, hits * sizeof ids[0]);
  CHECK_EQUAL(hsp_query_meets(model, xyz, reach, &meets), HSP_OK);
  CHECK_EQUAL(meets, hits > 0);
}

/* Row i of the lists of all pairs is what hsp_query_neighbours lists for ball i, or the larger part of it. */
static void check_pairs(const ball_set *set, uint32_t flags) {
  static uint32_t first[BALL_SET_MOST + 1], ids[BALL_SET_MOST * BALL_SET_MOST];
  uint32_t needed = 0, i, place = 0;
  check_scene("%s, pairs, flags %u", set->name, (unsigned)flags);
  CHECK_EQUAL(hsp_query_pairs(model, flags, first, ids, BALL_SET_MOST * BALL_SET_MOST, &needed), HSP_OK);
  for (i = 0; i < set->n; ++i) {
    uint32_t expected[BALL_SET_MOST], smaller = 0, hits;
    hits = expected_hits(set, set->xyz + 3 * i, steps(set->radius[i]) + steps(probe), i, expected);
    while (flags == HSP_PAIRS_ONCE && smaller < hits && expected[smaller] < i) ++smaller;
    CHECK_EQUAL(first[i], place);
    place += hits - smaller;
    if (CHECK_EQUAL(first[i + 1], place)) {
      CHECK_BYTES(ids + first[i], expected + smaller, (hits - smaller) * sizeof ids[0]);
    }
  }
  CHECK_EQUAL(first[set->n], needed);
  CHECK_EQUAL(needed, place);
}

/* All pairs of centres at most a cutoff apart, exactly that far included: radii 0 and half the cutoff as probe. */
static void check_cutoff(const ball_set *set, double cutoff) {
  static const double radius[BALL_SET_MOST];
  static uint32_t first[BALL_SET_MOST + 1], ids[BALL_SET_MOST * BALL_SET_MOST];
  uint32_t needed = 0, i, j, place = 0;
  hsp_model_options options;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = 1e-3;
  options.probe = cutoff / 2;
  check_scene("%s, cutoff %g", set->name, cutoff);
  CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_query_pairs(model, 0, first, ids, BALL_SET_MOST * BALL_SET_MOST, &needed), HSP_OK);
  for (i = 0; i < set->n; ++i) {
    CHECK_EQUAL(first[i], place);
    for (j = 0; j < set->n; ++j) {
      int64_t squared = 0;
      int axis;
      for (axis = 0; axis < 3; ++axis) {
        const int64_t d = steps(set->xyz[3 * i + (uint32_t)axis]) - steps(set->xyz[3 * j + (uint32_t)axis]);
        squared += d * d;
      }
      if (i != j && squared <= steps(cutoff) * steps(cutoff)) {
        if (CHECK(place < needed)) CHECK_EQUAL(ids[place], j);
        ++place;
      }
    }
  }
  CHECK_EQUAL(needed, place);
}

/* The closed ball that a ray meets first, ball by ball in doubles, and how far along the ray that is. If another one is
 * met within 1e-7 of it, or one is grazed, *others becomes 1. */
static uint32_t expected_on_ray(const ball_set *set, const double *origin, const double *direction, double *at,
                                int *others) {
  const double size = sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
  uint32_t i, first = HSP_NONE;
  *at = INFINITY;
  *others = 0;
  for (i = 0; i < set->n; ++i) {
    const double r = 0.001 * (double)(steps(set->radius[i]) + steps(probe));
    double u[3], foot = 0, beside = 0, entry;
    int axis;
    for (axis = 0; axis < 3; ++axis) {
      u[axis] = 0.001 * (double)(steps(set->xyz[3 * i + (uint32_t)axis]) - steps(origin[axis]));
      foot += u[axis] * direction[axis] / size;
    }
    for (axis = 0; axis < 3; ++axis) beside += pow(u[axis] - foot * direction[axis] / size, 2);
    /* a ball that is only grazed may be missed */
    if (fabs(beside - r * r) < 1e-9) *others = 1;
    if (beside > r * r) continue;
    entry = foot - sqrt(r * r - beside);
    if (foot + sqrt(r * r - beside) < 0) continue;
    entry = entry > 0 ? entry : 0;
    if (fabs(entry - *at) < 1e-7) *others = 1;
    if (entry >= *at) continue;
    *at = entry;
    first = i;
  }
  return first;
}

static void check_ray(const ball_set *set, const double *origin, const double *direction) {
  hsp_ray_hit hit;
  double at;
  int others, axis;
  const uint32_t first = expected_on_ray(set, origin, direction, &at, &others);
  const double size = sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
  CHECK_EQUAL(hsp_query_ray(model, origin, direction, &hit), HSP_OK);
  CHECK_EQUAL(hit.reserved, 0);
  if (!others) CHECK_EQUAL(hit.ball, first);
  if (others || first == HSP_NONE) return;
  CHECK_NEAR(hit.distance, at, 1e-4);
  for (axis = 0; axis < 3; ++axis) {
    CHECK_NEAR(hit.xyz[axis], 0.001 * (double)steps(origin[axis]) + hit.distance * direction[axis] / size,
               1e-12 * (1 + fabs(origin[axis]) + hit.distance));
  }
}

/* Rays past the ball and through it, from outside and from its centre. */
static void check_rays(const ball_set *set, const double *centre) {
  static const double directions[][3] = {{1, 0, 0},   {0, -1, 0}, {0, 0, 3},   {1, 1, 0},
                                         {-1, 1, -1}, {1, 2, -3}, {-5, 1, .1}, {-.3, 7, 2}};
  static const double back[] = {0, 3, 25, 4000};
  size_t d, b;
  for (d = 0; d < sizeof directions / sizeof directions[0]; ++d) {
    for (b = 0; b < sizeof back / sizeof back[0]; ++b) {
      double origin[3];
      int axis;
      for (axis = 0; axis < 3; ++axis) {
        origin[axis] = centre[axis] - back[b] * directions[d][axis] + (axis == 1 ? 0.137 : 0.041);
      }
      check_ray(set, origin, directions[d]);
    }
  }
}

static void check_set(const ball_set *set) {
  static const double reaches[] = {0, 0.001, 0.5, 1, 1.25, 3, 10, 777, 20000};
  static const double around[][3] = {{0, 0, 0},        {1, 0, 0}, {0, -1, 0},      {0, 0, 1.001},
                                     {0.5, 0.5, -0.5}, {2, 2, 2}, {-3.5, 1, 0.25}, {6000, -6000, 6000}};
  uint32_t i;
  size_t a, r;
  hsp_model_options options;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = 1e-3;
  options.probe = probe;
  CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, set->radius, &options, NULL), HSP_OK);
  for (i = 0; i < set->n; i += 1 + set->n / 25) {
    uint32_t expected[BALL_SET_MOST], ids[BALL_SET_MOST], hits, needed = 0;
    const double *centre = set->xyz + 3 * i;
    double xyz[3];
    int axis;
    check_scene("%s, neighbours of %u", set->name, (unsigned)i);
    hits = expected_hits(set, centre, steps(set->radius[i]) + steps(probe), i, expected);
    CHECK_EQUAL(hsp_query_neighbours(model, i, ids, BALL_SET_MOST, &needed), HSP_OK);
    if (CHECK_EQUAL(needed, hits)) CHECK_BYTES(ids, expected, hits * sizeof ids[0]);
    check_scene("%s, rays near %u", set->name, (unsigned)i);
    check_rays(set, centre);
    for (a = 0; a < sizeof around / sizeof around[0]; ++a) {
      for (r = 0; r < sizeof reaches / sizeof reaches[0]; ++r) {
        check_scene("%s, near %u, offset %u, reach %g", set->name, (unsigned)i, (unsigned)a, reaches[r]);
        for (axis = 0; axis < 3; ++axis) xyz[axis] = centre[axis] + around[a][axis];
        check_place(set, xyz, reaches[r]);
      }
    }
    /* exactly on the sphere, one step outside, and a ball that touches */
    memcpy(xyz, centre, sizeof xyz);
    check_scene("%s, on sphere %u", set->name, (unsigned)i);
    xyz[0] = centre[0] + set->radius[i] + probe;
    check_place(set, xyz, 0);
    xyz[0] += 0.001;
    check_place(set, xyz, 0);
    check_place(set, xyz, 0.001);
    xyz[0] = centre[0] - set->radius[i] - probe - 2.5;
    check_place(set, xyz, 2.5);
    check_place(set, xyz, 2.499);
  }
  check_pairs(set, 0);
  check_pairs(set, HSP_PAIRS_ONCE);
  check_cutoff(set, 1);
  check_cutoff(set, 3);
  check_cutoff(set, 8);
}

int main(void) {
  uint32_t which;
  CHECK_EQUAL(hsp_model_init(memory, sizeof memory, BALL_SET_MOST, &model), HSP_OK);
  for (which = 0; which < ball_set_count(); ++which) {
    static ball_set set;
    ball_set_make(which, &set);
    check_set(&set);
  }
  return check_report();
}
