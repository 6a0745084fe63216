/* Flags and directions that the queries refuse, the limits of the lattice, and queries of models without balls. */
#include <hardsphere.h>
#include <math.h>

#include "check.h"
#include "untouched.h"

enum { BALLS = 3 };
static unsigned char memory[HSP_MODEL_BYTES(BALLS)];
static hsp_model *model;
static const double origin[3] = {0, 0, 0}, upwards[3] = {0, 0, 1};
static uint32_t ids[4], first[BALLS + 1], needed;
static uint32_t meets;
static hsp_ray_hit hit;

static void fill_outputs(void) {
  FILL(ids);
  FILL(first);
  FILL(needed);
  FILL(meets);
  FILL(hit);
}

static void check_outputs_untouched(void) {
  CHECK_UNTOUCHED(ids);
  CHECK_UNTOUCHED(first);
  CHECK_UNTOUCHED(needed);
  CHECK_UNTOUCHED(meets);
  CHECK_UNTOUCHED(hit);
}

static void unknown_flags(void) {
  fill_outputs();
  CHECK_EQUAL(hsp_query_pairs(model, 2, first, ids, 4, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_query_pairs(model, UINT32_C(0x80000001), first, ids, 4, &needed), HSP_E_ARGUMENT);
  check_outputs_untouched();
}

static void bad_directions(void) {
  static const double nothing[3] = {0, -0.0, 0}, too_far[3] = {1e30, 0, 0}, not_finite[3] = {0, 0, NAN};
  fill_outputs();
  CHECK_EQUAL(hsp_query_ray(model, origin, nothing, &hit), HSP_E_RANGE);
  CHECK_EQUAL(hsp_query_ray(model, too_far, not_finite, &hit), HSP_E_NOT_FINITE);
  check_outputs_untouched();
  CHECK_EQUAL(hsp_query_ball(model, origin, -0.0, ids, 4, &needed), HSP_OK);
}

/* Positions up to 2^50 and radii up to 2^51 steps are answered; one step further is refused. */
static void lattice_limits(void) {
  static const double most = 1125899906842624.0;
  static const double xyz[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
  static const double radius[3] = {2, 3, 4};
  double corner[3] = {0, 0, 0};
  hsp_model_options options;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = 1;
  CHECK_EQUAL(hsp_model_set(model, 3, xyz, radius, &options, NULL), HSP_OK);
  corner[0] = most;
  CHECK_EQUAL(hsp_query_point(model, corner, ids, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 0);
  CHECK_EQUAL(hsp_query_ball(model, corner, most, ids, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 3);
  CHECK_EQUAL(hsp_query_ball(model, corner, most - 3, ids, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 2);
  CHECK_EQUAL(ids[0], 1);
  CHECK_EQUAL(ids[1], 2);
  CHECK_EQUAL(hsp_query_ball(model, corner, most - 4, ids, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 1);
  CHECK_EQUAL(hsp_query_ball(model, corner, most - 5, ids, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 0);
  CHECK_EQUAL(hsp_query_meets(model, corner, most - 4, &meets), HSP_OK);
  CHECK_EQUAL(meets, 1);
  CHECK_EQUAL(hsp_query_meets(model, corner, most - 5, &meets), HSP_OK);
  CHECK_EQUAL(meets, 0);
  CHECK_EQUAL(hsp_query_ball(model, corner, 2 * most, ids, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 3);
  corner[1] = -most;
  corner[2] = most;
  CHECK_EQUAL(hsp_query_ball(model, corner, 2 * most, ids, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 3);
  CHECK_EQUAL(hsp_query_ball(model, corner, 2 * most + 1, ids, 4, &needed), HSP_E_RANGE);
  corner[0] = most + 1;
  CHECK_EQUAL(hsp_query_point(model, corner, ids, 4, &needed), HSP_E_RANGE);
}

/* With too little room `first` is written, and nothing else but the number. */
static void room_for_pairs(void) {
  fill_outputs();
  CHECK_EQUAL(hsp_query_pairs(model, 0, first, ids, 4, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 6);
  CHECK_EQUAL(first[0], 0);
  CHECK_EQUAL(first[BALLS], 6);
  CHECK_UNTOUCHED(ids);
  CHECK_EQUAL(hsp_query_pairs(model, HSP_PAIRS_ONCE, first, ids, 4, &needed), HSP_OK);
  CHECK_EQUAL(needed, 3);
  CHECK_EQUAL(first[1], 2);
  CHECK_EQUAL(first[BALLS], 3);
}

static void empty_models(void) {
  int round;
  for (round = 0; round < 2; ++round) {
    /* first as initialised, then as set to nothing */
    CHECK_EQUAL(hsp_model_init(memory, sizeof memory, BALLS, &model), HSP_OK);
    if (round == 1) CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
    needed = 7;
    CHECK_EQUAL(hsp_query_point(model, origin, NULL, 0, &needed), HSP_OK);
    CHECK_EQUAL(needed, 0);
    needed = 7;
    CHECK_EQUAL(hsp_query_ball(model, origin, 10, NULL, 0, &needed), HSP_OK);
    CHECK_EQUAL(needed, 0);
    meets = 7;
    CHECK_EQUAL(hsp_query_meets(model, origin, 10, &meets), HSP_OK);
    CHECK_EQUAL(meets, 0);
    fill_outputs();
    CHECK_EQUAL(hsp_query_neighbours(model, 0, ids, 4, &needed), HSP_E_ID);
    check_outputs_untouched();
    needed = 7;
    CHECK_EQUAL(hsp_query_pairs(model, 0, first, NULL, 0, &needed), HSP_OK);
    CHECK_EQUAL(needed, 0);
    CHECK_EQUAL(first[0], 0);
    CHECK_EQUAL(hsp_query_ray(model, origin, upwards, &hit), HSP_OK);
    CHECK_EQUAL(hit.ball, HSP_NONE);
    CHECK(isinf(hit.distance) && hit.distance > 0);
    CHECK(hit.xyz[0] == 0 && hit.xyz[1] == 0 && hit.xyz[2] == 0);
    CHECK_EQUAL(hit.reserved, 0);
  }
}

int main(void) {
  static const double xyz[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  static const double radius[3] = {1, 1, 1};
  CHECK_EQUAL(hsp_model_init(memory, sizeof memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, 3, xyz, radius, NULL, NULL), HSP_OK);
  unknown_flags();
  bad_directions();
  room_for_pairs();
  lattice_limits();
  empty_models();
  return check_report();
}
