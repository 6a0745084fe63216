/* The numbered properties of the header and the meaning of every record, for every set of the catalogue and for what
 * must not matter: the order of the balls, where the molecule lies, which axis is called x, and the unit. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "ball_sets.h"
#include "boundary_invariants.h"
#include "check.h"

static void check_sound(const computed *c) {
  const char *broken = broken_boundary(c);
  check_true(broken == NULL, broken == NULL ? "boundary" : broken, __FILE__, __LINE__);
}

/* hsp_model_set, property 1; hsp_boundary_compute, property 1; hsp_boundary_measure, property 1. */
static void any_order(const ball_set *set, const computed *reference) {
  static ball_set permuted;
  uint32_t order[BALL_SET_MOST], i;
  int round;
  for (round = 0; round < 4; ++round) {
    computed other;
    if (round == 0) {
      for (i = 0; i < set->n; ++i) order[i] = set->n - 1 - i;
    } else {
      ball_set_shuffle(set->n, (uint64_t)round, order);
    }
    check_scene("%s, order %d", set->name, round);
    ball_set_permute(set, order, &permuted);
    if (CHECK_EQUAL(computed_make(permuted.n, permuted.xyz, permuted.radius, NULL, &other), HSP_OK)) {
      const char *what = boundary_difference_after_permutation(reference, &other, order);
      check_sound(&other);
      check_true(what == NULL, what == NULL ? "order" : what, __FILE__, __LINE__);
      CHECK_NEAR(other.totals.area, reference->totals.area, 1e-14 * reference->totals.area);
      CHECK_NEAR(other.totals.volume, reference->totals.volume, 1e-13 * reference->totals.volume);
    }
    computed_release(&other);
  }
}

/* A translation by whole steps changes no record but positions. */
static void any_place(const ball_set *set, const computed *reference) {
  static const double shifts[3][3] = {{1, 0, 0}, {-1000, 2000, 3000}, {12345, -54321, 4096}};
  static ball_set moved;
  uint32_t i;
  int s, axis;
  for (s = 0; s < 3; ++s) {
    computed other;
    check_scene("%s, moved by %g %g %g", set->name, shifts[s][0], shifts[s][1], shifts[s][2]);
    moved = *set;
    for (i = 0; i < set->n; ++i) {
      for (axis = 0; axis < 3; ++axis) moved.xyz[3 * i + (uint32_t)axis] += shifts[s][axis];
    }
    if (CHECK_EQUAL(computed_make(moved.n, moved.xyz, moved.radius, NULL, &other), HSP_OK)) {
      check_sound(&other);
      CHECK_BYTES(&other.counts, &reference->counts, sizeof other.counts);
      CHECK_NEAR(other.totals.area, reference->totals.area, 1e-13 * reference->totals.area);
      CHECK_NEAR(other.totals.volume, reference->totals.volume, 1e-12 * reference->totals.volume);
      for (i = 0; i < set->n; ++i) {
        CHECK_NEAR(other.area[i], reference->area[i], 1e-13 * (1 + reference->area[i]));
        CHECK_EQUAL(other.balls[i].faces, reference->balls[i].faces);
        CHECK_EQUAL(other.balls[i].flags, reference->balls[i].flags);
      }
    }
    computed_release(&other);
  }
}

/* Turned axes and mirrors: ties may be broken otherwise, but never the topology of the closed balls; without ties
 * everything is the same. */
static void any_axes(const ball_set *set, const computed *reference) {
  static const int axes[5][3] = {{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  static ball_set turned;
  uint32_t i;
  int t, axis;
  for (t = 0; t < 5; ++t) {
    computed other;
    check_scene("%s, axes %d %d %d", set->name, axes[t][0], axes[t][1], axes[t][2]);
    turned = *set;
    for (i = 0; i < set->n; ++i) {
      for (axis = 0; axis < 3; ++axis) {
        turned.xyz[3 * i + (uint32_t)axis] = (t % 2 == 0 ? 1 : -1) * set->xyz[3 * i + (uint32_t)axes[t][axis]];
      }
    }
    if (CHECK_EQUAL(computed_make(turned.n, turned.xyz, turned.radius, NULL, &other), HSP_OK)) {
      check_sound(&other);
      CHECK_EQUAL(other.counts.components, reference->counts.components);
      CHECK_EQUAL(other.counts.voids, reference->counts.voids);
      CHECK_EQUAL(other.counts.shells, reference->counts.shells);
      CHECK_EQUAL(other.counts.euler, reference->counts.euler);
      CHECK_NEAR(other.totals.area, reference->totals.area, 1e-12 * reference->totals.area);
      CHECK_NEAR(other.totals.volume, reference->totals.volume, 1e-12 * reference->totals.volume);
      if (strncmp(set->name, "a chain", 7) == 0 && reference->counts.tied_vertices == 0) {
        CHECK_EQUAL(other.counts.vertices, reference->counts.vertices);
        CHECK_EQUAL(other.counts.circles, reference->counts.circles);
        CHECK_EQUAL(other.counts.faces, reference->counts.faces);
        CHECK_EQUAL(other.counts.contained_balls, reference->counts.contained_balls);
      }
    }
    computed_release(&other);
  }
}

/* Another unit by a power of ten with the step in the same proportion: the same integers, hence the same records. */
static void any_unit(const ball_set *set, const computed *reference) {
  static const double units[3] = {1e6, 1e3, 1e1}, unit_steps[3] = {1, 1e-3, 1e-5};
  static ball_set scaled;
  uint32_t i;
  int u;
  for (u = 0; u < 3; ++u) {
    const double unit = units[u];
    hsp_model_options options;
    computed other, plain;
    check_scene("%s, unit %g", set->name, unit);
    scaled = *set;
    for (i = 0; i < 3 * set->n; ++i) scaled.xyz[i] *= unit;
    for (i = 0; i < set->n; ++i) scaled.radius[i] *= unit;
    CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
    options.step = 1e-6;
    CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &plain), HSP_OK);
    options.step = unit_steps[u];
    CHECK_EQUAL(computed_make(set->n, scaled.xyz, scaled.radius, &options, &other), HSP_OK);
    CHECK_BYTES(&other.counts, &plain.counts, sizeof other.counts);
    CHECK_NEAR(other.totals.area, unit * unit * plain.totals.area, 1e-13 * unit * unit * plain.totals.area);
    CHECK_NEAR(other.totals.volume, unit * unit * unit * plain.totals.volume,
               1e-13 * unit * unit * unit * plain.totals.volume);
    check_sound(&plain);
    /* the catalogue's numbers are multiples of 1e-6 or so: a coarser lattice moves nothing much */
    CHECK_NEAR(plain.totals.area, reference->totals.area, 1e-4 * reference->totals.area);
    computed_release(&other);
    computed_release(&plain);
  }
}

int main(void) {
  uint32_t which;
  for (which = 0; which < ball_set_count(); ++which) {
    static ball_set set;
    computed reference;
    ball_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &reference), HSP_OK)) {
      check_sound(&reference);
      any_order(&set, &reference);
      any_place(&set, &reference);
      any_axes(&set, &reference);
      any_unit(&set, &reference);
    }
    computed_release(&reference);
  }
  return check_report();
}
