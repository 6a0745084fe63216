/* Second derivatives of every set of the catalogue: their laws for either tangency, in any order of the balls, by
 * several threads, of selected balls; closed forms for two balls; and difference quotients of the gradient. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "hessian_invariants.h"
#include "loops.h"
#include "vectors.h"

static void check_nothing_broken(const char *broken) {
  check_true(broken == NULL, broken == NULL ? "second derivatives" : broken, __FILE__, __LINE__);
}

static int has_equal_balls(const ball_set *set) {
  uint32_t i, j;
  for (i = 0; i < set->n; ++i)
    for (j = 0; j < i; ++j)
      if (memcmp(set->xyz + 3 * i, set->xyz + 3 * j, 3 * sizeof *set->xyz) == 0 && set->radius[i] == set->radius[j])
        return 1;
  return 0;
}

static void check_order(const ball_set *set, const computed *c, uint32_t tangency) {
  static ball_set permuted;
  uint32_t order[BALL_SET_MOST], place[BALL_SET_MOST], i;
  computed d;
  ball_set_shuffle(set->n, 5, order);
  for (i = 0; i < set->n; ++i) place[order[i]] = i;
  ball_set_permute(set, order, &permuted);
  if (CHECK_EQUAL(computed_make(permuted.n, permuted.xyz, permuted.radius, NULL, &d), HSP_OK))
    check_nothing_broken(hessian_difference_after_permutation(c, &d, place, tangency));
  computed_release(&d);
}

/* Rows and product by the tasks of an executor have the bits of those by one thread. */
static void check_executor(const computed *c) {
  static double direction[3 * BALL_SET_MOST], alone[3 * BALL_SET_MOST], shared[3 * BALL_SET_MOST];
  loop own = loop_of(LOOP_SHUFFLED);
  const hsp_executor executor = executor_of(&own, 3);
  hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .pressure = 0.5};
  hessian one, many;
  uint32_t i;
  for (i = 0; i < 3 * c->n; ++i) direction[i] = sin(i);
  CHECK_EQUAL(hessian_make(c, &request, &one), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, &request, direction, alone, NULL, c->n, NULL), HSP_OK);
  request.executor = &executor;
  CHECK_EQUAL(hessian_make(c, &request, &many), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, &request, direction, shared, NULL, c->n, NULL), HSP_OK);
  CHECK_BYTES(many.ball, one.ball, one.entries * sizeof *one.ball);
  CHECK_BYTES(many.block, one.block, 9 * (size_t)one.entries * sizeof *one.block);
  CHECK_BYTES(many.flags, one.flags, c->n * sizeof *one.flags);
  CHECK_BYTES(shared, alone, 3 * c->n * sizeof *alone);
  hessian_release(&one);
  hessian_release(&many);
}

/* hsp_boundary_get_hessian_product, property 2, of every other ball; there are no rows of a part. */
static void check_selected(const computed *c, int equal_balls) {
  static double direction[3 * BALL_SET_MOST], all[3 * BALL_SET_MOST], some[3 * BALL_SET_MOST];
  static uint32_t all_flags[BALL_SET_MOST], some_flags[BALL_SET_MOST], first[BALL_SET_MOST + 1];
  static uint8_t selected[BALL_SET_MOST];
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .pressure = 0.5};
  hsp_boundary_request part = {.struct_size = sizeof part, .selected = selected};
  uint32_t i, axis;
  for (i = 0; i < 3 * c->n; ++i) direction[i] = cos(i);
  for (i = 0; i < c->n; ++i) selected[i] = (uint8_t)(i % 2);
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, &request, direction, all, all_flags, c->n, NULL), HSP_OK);
  if (!CHECK_EQUAL(hsp_boundary_compute_with(c->boundary, c->model, &part, NULL), HSP_OK)) return;
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, &request, direction, some, some_flags, c->n, NULL), HSP_OK);
  for (i = 0; i < c->n; ++i) {
    if (i % 2 == 0) {
      for (axis = 0; axis < 3; ++axis) all[3 * i + axis] = 0;
      all_flags[i] = 0;
    }
  }
  CHECK_BYTES(some, all, 3 * c->n * sizeof *all);
  /* of equal balls of which one is selected flags may be set without need */
  if (!equal_balls) CHECK_BYTES(some_flags, all_flags, c->n * sizeof *all_flags);
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, &request, first, NULL, NULL, NULL, 0, NULL), HSP_E_STATE);
}

/* Two balls with a free circle between them, along an axis that is none of the coordinates'. */
static void check_two_balls(void) {
  static const double xyz[6] = {0.5, -0.25, 1, 0.5 + 1.2, -0.25 + 0.9, 1}, radius[2] = {1.25, 1};
  const double d = 1.5, h = (d * d + 1.25 * 1.25 - 1) / (2 * d), below = d - h, square = 1.25 * 1.25 - h * h;
  const double u[3] = {0.8, 0.6, 0};
  /* h' and Q of the weighted area, weights 2 and -1 (lib/curvature/curvature/hessians.hpp) */
  const double sigma[2] = {2, -1}, speed = (1.25 * 2 + 1) / d, growth = 1.25 * 2 - h * speed;
  const double along[2] = {2 * pi * h * below / d, -2 * pi / d * speed * (h - below)};
  const double across[2] = {-pi * square / d, -2 * pi / d * growth};
  uint32_t which, k, l;
  computed c;
  check_scene("two balls");
  if (CHECK_EQUAL(computed_make(2, xyz, radius, NULL, &c), HSP_OK)) {
    for (which = 0; which < 2; ++which) {
      const hsp_gradient_request request = {
          .struct_size = sizeof request, .tension = which, .pressure = 1 - which, .sigma = sigma};
      const double *block;
      hessian rows;
      CHECK_EQUAL(hessian_make(&c, &request, &rows), HSP_OK);
      CHECK_EQUAL(rows.entries, 4);
      block = hessian_block(&rows, 0, 1);
      for (k = 0; k < 3 && block != NULL; ++k) {
        for (l = 0; l < 3; ++l) {
          const double expected = along[which] * u[k] * u[l] + across[which] * ((k == l) - u[k] * u[l]);
          CHECK_NEAR(block[3 * k + l], expected, 1e-13);
          CHECK_NEAR(hessian_block(&rows, 0, 0)[3 * k + l], -expected, 1e-13);
        }
      }
      hessian_release(&rows);
    }
  }
  computed_release(&c);
}

static int32_t gradient_at(const ball_set *set, const hsp_gradient_request *request, double *gradient) {
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = set->n, .d_centre = gradient};
  hsp_model_options options;
  computed c;
  int32_t status;
  hsp_model_options_init(&options, (uint32_t)sizeof options);
  options.step = set->step;
  status = computed_make(set->n, set->xyz, set->radius, &options, &c);
  if (status == HSP_OK) status = hsp_boundary_get_gradient(c.boundary, request, &outputs);
  computed_release(&c);
  return status;
}

/* A chain of atoms, in which every ball moves along each axis by 2^-16: quotients of the gradient by four steps. */
static void check_differences(void) {
  static ball_set set, moved;
  static double at[4][3 * BALL_SET_MOST];
  static const double steps[4] = {-2, -1, 1, 2}, weights[4] = {1.0 / 12, -2.0 / 3, 2.0 / 3, -1.0 / 12};
  const double step = 0x1p-16;
  hsp_gradient_request request = {.struct_size = sizeof request, .tension = 0.75, .pressure = -0.5};
  hsp_model_options options;
  uint32_t i, j, axis, k, p, beyond = 0, compared = 0;
  hessian rows;
  computed c;
  check_scene("difference quotients");
  ball_set_start(&set, "chain", 0x1p-26);
  ball_set_add_chain(&set, 40, 11);
  for (i = 0; i < 3 * set.n; ++i) set.xyz[i] = floor(set.xyz[i] * 0x1p10) * 0x1p-10 + i % 7 * 0x1p-13;
  for (i = 0; i < set.n; ++i) set.radius[i] = floor(set.radius[i] * 0x1p10) * 0x1p-10;
  hsp_model_options_init(&options, (uint32_t)sizeof options);
  options.step = set.step;
  if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, &options, &c), HSP_OK) &&
      CHECK_EQUAL(hessian_make(&c, &request, &rows), HSP_OK)) {
    for (j = 0; j < set.n; ++j) {
      for (axis = 0; axis < 3; ++axis) {
        for (k = 0; k < 4; ++k) {
          moved = set;
          moved.xyz[3 * j + axis] += steps[k] * step;
          CHECK_EQUAL(gradient_at(&moved, &request, at[k]), HSP_OK);
        }
        for (i = 0; i < set.n; ++i) {
          const double *const block = hessian_block(&rows, i, j);
          for (p = 0; p < 3; ++p) {
            double quotient = 0;
            for (k = 0; k < 4; ++k) quotient += weights[k] * at[k][3 * i + p] / step;
            ++compared;
            /* where an arc is born or dies near by, quotients are the weaker side */
            beyond += !near(quotient, block == NULL ? 0 : block[3 * p + axis], 1e-7);
          }
        }
      }
    }
    CHECK(compared == 9 * set.n * set.n && beyond * 100 <= compared);
    hessian_release(&rows);
  }
  computed_release(&c);
}

/* Four spheres through a point in the plane of their centres: the area has no second derivatives, the volume has. */
static void check_singular(void) {
  static ball_set set;
  const hsp_gradient_request area = {.struct_size = sizeof area, .tension = 1};
  const hsp_gradient_request volume = {.struct_size = sizeof volume, .pressure = 1};
  uint32_t i, k, singular = 0;
  hessian rows;
  computed c;
  check_scene("a vertex in the plane of its centres");
  ball_set_start(&set, "square", 0.25);
  for (i = 0; i < 4; ++i) ball_set_add(&set, i % 2 == 0 ? 3 : -3, i / 2 == 0 ? 4 : -4, 0, 5);
  if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
    CHECK_EQUAL(hessian_make(&c, &area, &rows), HSP_OK);
    for (i = 0; i < set.n; ++i) singular += (rows.flags[i] & HSP_HESSIAN_SINGULAR) != 0;
    CHECK(singular > 0);
    for (k = 0; k < 9 * rows.entries; ++k) CHECK(fabs(rows.block[k]) < 100);
    hessian_release(&rows);
    CHECK_EQUAL(hessian_make(&c, &volume, &rows), HSP_OK);
    for (i = 0; i < set.n; ++i) CHECK((rows.flags[i] & HSP_HESSIAN_SINGULAR) == 0);
    hessian_release(&rows);
  }
  computed_release(&c);
}

int main(void) {
  static ball_set set;
  static double sigma[BALL_SET_MOST];
  uint32_t which, tangency, i;
  for (which = 0; which < ball_set_count(); ++which) {
    computed c;
    ball_set_make(which, &set);
    for (i = 0; i < set.n; ++i) sigma[i] = i % 5 == 2 ? 0 : sin(3.0 * i) + 0.25;
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      for (tangency = HSP_TANGENT_OVERLAP; tangency <= HSP_TANGENT_DISJOINT; ++tangency) {
        check_scene("%s, tangency %u", set.name, (unsigned)tangency);
        check_nothing_broken(broken_hessian(&c, NULL, 0, 2.5, tangency));
        check_nothing_broken(broken_hessian(&c, sigma, -0.75, 0, tangency));
        check_nothing_broken(broken_hessian(&c, sigma, -0.75, 2.5, tangency));
        if (!has_equal_balls(&set)) check_order(&set, &c, tangency);
      }
      check_executor(&c);
      check_selected(&c, has_equal_balls(&set));
    }
    computed_release(&c);
  }
  check_two_balls();
  check_differences();
  check_singular();
  return check_report();
}
