/* Arguments that second derivatives refuse, and that nothing is written by a call that fails. */
#include <hardsphere.h>
#include <math.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "loops.h"
#include "untouched.h"

enum { ENTRIES = 9 };
static double block[ENTRIES][9], product[THREE_BALLS][3], direction[THREE_BALLS][3];
static uint32_t first[THREE_BALLS + 1], ball[ENTRIES], flags[THREE_BALLS + 1], needed;

static void check_untouched(void) {
  CHECK_UNTOUCHED(block);
  CHECK_UNTOUCHED(product);
  CHECK_UNTOUCHED(ball);
  CHECK_UNTOUCHED(flags);
}

static void refused(const computed *c) {
  const double inf = (double)INFINITY, sigma[THREE_BALLS] = {1, inf, 1};
  hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1};
  FILL(block);
  FILL(product);
  FILL(ball);
  FILL(flags);
  check_scene("rows that are refused");
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, NULL, NULL, ball, block[0], flags, 9, &needed),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, NULL, first, NULL, block[0], flags, 1, &needed),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, NULL, first, ball, NULL, flags, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, NULL, first, ball, block[0], flags, 8, &needed),
              HSP_E_CAPACITY);
  CHECK(needed == ENTRIES && first[0] == 0 && first[1] == 3 && first[2] == 6 && first[3] == ENTRIES);
  request.tension = inf;
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, &request, first, ball, block[0], flags, 9, &needed),
              HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, &request, direction[0], product[0], flags, 3, &needed),
              HSP_E_NOT_FINITE);
  request.tension = 1;
  request.sigma = sigma;
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, &request, first, ball, block[0], flags, 9, &needed),
              HSP_E_NOT_FINITE);
  request.sigma = NULL;
  request.tangency = 2;
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, &request, first, ball, block[0], flags, 9, &needed),
              HSP_E_ARGUMENT);
  check_scene("products that are refused");
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, NULL, NULL, product[0], flags, 3, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, NULL, direction[0], NULL, flags, 1, &needed),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, NULL, direction[0], product[0], flags, 2, &needed),
              HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 3);
  direction[2][2] = (double)NAN;
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, NULL, direction[0], product[0], flags, 3, &needed),
              HSP_E_NOT_FINITE);
  direction[2][2] = 0;
  check_untouched();
}

static void defaults(const computed *c) {
  uint32_t i;
  check_scene("without a request all is 0");
  CHECK_EQUAL(hsp_boundary_get_hessian_rows(c->boundary, NULL, first, ball, block[0], NULL, 9, NULL), HSP_OK);
  for (i = 0; i < 9 * ENTRIES; ++i) CHECK(block[i / 9][i % 9] == 0);
  direction[0][0] = 1;
  CHECK_EQUAL(hsp_boundary_get_hessian_product(c->boundary, NULL, direction[0], product[0], NULL, 3, NULL), HSP_OK);
  for (i = 0; i < 3 * THREE_BALLS; ++i) CHECK(product[i / 3][i % 3] == 0);
}

static void wrong_loops(void) {
  enum { ROOM = 12 * BALL_SET_MOST };
  static ball_set set;
  static double chain_direction[3 * BALL_SET_MOST], chain_product[3 * BALL_SET_MOST], chain_block[9 * ROOM];
  static uint32_t chain_first[BALL_SET_MOST + 1], chain_ball[ROOM];
  computed c;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 200, 3);
  if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
    int way;
    /* rows take two passes, either of which may fail */
    for (way = LOOP_RIGHT_WAYS; way < LOOP_WAYS; ++way) {
      uint32_t pass;
      check_scene("an executor of wrong way %d", way);
      for (pass = 0; pass < 3; ++pass) {
        loop own = loop_of(way);
        const hsp_executor executor = executor_of(&own, 2);
        const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = &executor};
        const int32_t expected = pass < 2 ? HSP_E_EXECUTOR : HSP_OK;
        own.first_wrong = pass;
        CHECK_EQUAL(
            hsp_boundary_get_hessian_rows(c.boundary, &request, chain_first, chain_ball, chain_block, NULL, ROOM, NULL),
            expected);
        own.runs = 0;
        CHECK_EQUAL(
            hsp_boundary_get_hessian_product(c.boundary, &request, chain_direction, chain_product, NULL, set.n, NULL),
            pass < 1 ? HSP_E_EXECUTOR : HSP_OK);
      }
    }
  }
  computed_release(&c);
}

int main(void) {
  computed c;
  if (CHECK_EQUAL(computed_make(THREE_BALLS, three_balls_xyz, three_balls_radius, NULL, &c), HSP_OK)) {
    refused(&c);
    defaults(&c);
  }
  computed_release(&c);
  wrong_loops();
  return check_report();
}
