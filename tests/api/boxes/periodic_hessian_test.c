/* Second derivatives in boxes: arguments that are refused, nothing written by a call that fails, the same bits by
 * several threads and of areas alone; in a box that is turned, as well. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "loops.h"
#include "random_numbers.h"
#include "untouched.h"

enum { MOST = 200, IMAGES = 4000, NEIGHBOURS = 300, VERTICES = 30000, CIRCLES = 4000, CONTACTS = 30000, ROOM = 8000 };
static unsigned char memory[HSP_PERIODIC_BYTES(MOST, IMAGES, NEIGHBOURS, VERTICES, CIRCLES, CONTACTS) +
                            3 * HSP_WORKER_BYTES(MOST + IMAGES, NEIGHBOURS, VERTICES, CIRCLES)];
static hsp_periodic *periodic;
static double xyz[3 * MOST], radius[MOST], sigma[MOST];
static double block[9 * ROOM], other[9 * ROOM];
static uint32_t first[MOST + 1], ball[ROOM], flags[MOST + 1], other_ball[ROOM], other_flags[MOST + 1], needed;

static void make(void) {
  const hsp_periodic_limits limits = {
      (uint32_t)sizeof limits, MOST, IMAGES, NEIGHBOURS, VERTICES, CIRCLES, CONTACTS, 4};
  CHECK_EQUAL(hsp_periodic_init(memory, sizeof memory, &limits, &periodic), HSP_OK);
}

static void refused(void) {
  static const double chain[9] = {0, 0, 0, 1.5, 0, 0, 3, 0, 0}, three[3] = {1, 1, 1};
  static const double box[9] = {9, 0, 0, 0, 9, 0, 0, 0, 9};
  const double inf = (double)INFINITY, weights[3] = {1, inf, 1};
  hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1};
  uint32_t i;
  make();
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, ball, block, flags, ROOM, &needed), HSP_E_STATE);
  CHECK_EQUAL(hsp_periodic_compute(periodic, 3, chain, three, box, NULL, NULL, NULL), HSP_OK);
  FILL(block);
  FILL(ball);
  FILL(flags);
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, NULL, NULL, ball, block, flags, 9, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, NULL, first, NULL, block, flags, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, NULL, first, ball, NULL, flags, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, NULL, first, ball, block, flags, 6, &needed), HSP_E_CAPACITY);
  CHECK(needed == 7 && first[0] == 0 && first[1] == 2 && first[2] == 5 && first[3] == 7);
  request.tension = inf;
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, ball, block, flags, 7, NULL), HSP_E_NOT_FINITE);
  request.tension = 1;
  request.sigma = weights;
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, ball, block, flags, 7, NULL), HSP_E_NOT_FINITE);
  request.sigma = NULL;
  request.tangency = 2;
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, ball, block, flags, 7, NULL), HSP_E_ARGUMENT);
  request.tangency = 0;
  CHECK_UNTOUCHED(block);
  CHECK_UNTOUCHED(ball);
  CHECK_UNTOUCHED(flags);
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, NULL, first, ball, block, NULL, 7, NULL), HSP_OK);
  for (i = 0; i < 63; ++i) CHECK(block[i] == 0);
}

static void known_flags(void) {
  /* Balls that touch across a face, and four spheres through a point in the plane of three centres. */
  static const double pair[6] = {0.5, 1, 1, 4.5, 5, 1}, ones[2] = {1, 1}, cube[9] = {4, 0, 0, 0, 4, 0, 0, 0, 4};
  static const double square[12] = {1, 1, 1, 3, 1, 1, 1, 3, 1, 3, 3, 1};
  static const double wide[9] = {12, 0, 0, 0, 12, 0, 0, 0, 12};
  static const double through[4] = {1.4142135623730951, 1.4142135623730951, 1.4142135623730951, 1.4142135623730951};
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1};
  make();
  CHECK_EQUAL(hsp_periodic_compute(periodic, 2, pair, ones, cube, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, ball, block, flags, ROOM, &needed), HSP_OK);
  CHECK(flags[0] == HSP_GRADIENT_ONE_SIDED && flags[1] == HSP_GRADIENT_ONE_SIDED && flags[2] == HSP_GRADIENT_ONE_SIDED);
  CHECK_EQUAL(hsp_periodic_compute(periodic, 4, square, through, wide, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, ball, block, flags, ROOM, &needed), HSP_OK);
  CHECK_EQUAL(flags[4], flags[0] | flags[1] | flags[2] | flags[3]);
}

/* With any number of workers, and of areas alone. */
static void check_bits(uint32_t n, const double *box) {
  hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .pressure = 0.5, .sigma = sigma};
  loop forgetful = loop_of(LOOP_FORGETS);
  const hsp_executor wrong = executor_of(&forgetful, 2);
  uint32_t workers;
  make();
  CHECK_EQUAL(hsp_periodic_compute(periodic, n, xyz, radius, box, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, ball, block, flags, ROOM, &needed), HSP_OK);
  CHECK(needed > 4 * n);
  for (workers = 0; workers <= 4; ++workers) {
    loop own = loop_of((int)workers % LOOP_RIGHT_WAYS);
    const hsp_executor executor = executor_of(&own, workers);
    const hsp_periodic_request alone = {.struct_size = sizeof alone, .areas_alone = 1, .executor = &executor};
    if (workers % 2 == 1)
      CHECK_EQUAL(hsp_periodic_compute_with(periodic, n, xyz, radius, box, &alone, NULL, NULL), HSP_OK);
    request.executor = &executor;
    CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, other_ball, other, other_flags, ROOM, &needed),
                HSP_OK);
    CHECK_BYTES(other_ball, ball, needed * sizeof *ball);
    CHECK_BYTES(other, block, 9 * (size_t)needed * sizeof *block);
    CHECK_BYTES(other_flags, flags, (n + 1) * sizeof *flags);
  }
  request.executor = &wrong;
  CHECK_EQUAL(hsp_periodic_get_hessian_rows(periodic, &request, first, other_ball, other, other_flags, ROOM, &needed),
              HSP_E_EXECUTOR);
}

int main(void) {
  static const double upright[9] = {11, 0, 0, 2.5, 10, 0, -3, 1.25, 12}, turned[9] = {3, 10, 1, -9, 3, 4, 2, -5, -11};
  uint64_t seed = 77;
  uint32_t i;
  refused();
  known_flags();
  for (i = 0; i < 3 * MOST; ++i) xyz[i] = 12 * random_fraction(&seed);
  for (i = 0; i < MOST; ++i) {
    radius[i] = i % 3 == 0 ? 1.25 : 0.75 + 0.5 * random_fraction(&seed);
    sigma[i] = 2 * random_fraction(&seed) - 0.5;
  }
  check_scene("upright");
  check_bits(MOST, upright);
  check_scene("turned");
  check_bits(MOST, turned);
  return check_report();
}
