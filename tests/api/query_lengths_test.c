/* Answers of every length from none to far more than a query keeps in hand, with balls that are looked at and do not
 * belong to the answer before, between and after those that do. */
#include <hardsphere.h>

#include "check.h"

enum { BALLS = 300, LONGEST = 270 };

static unsigned char memory[HSP_MODEL_BYTES(BALLS)];
static hsp_model *model;

/* Which `hits` of the balls belong to the answer: the first, the last, or spread evenly. */
static int belongs(uint32_t ball, uint32_t hits, int arrangement) {
  if (arrangement == 0) return ball < hits;
  if (arrangement == 1) return ball >= BALLS - hits;
  return ball * hits / BALLS != (ball + 1) * hits / BALLS;
}

static void check_answer(const uint32_t *ids, uint32_t needed, const uint32_t *expected, uint32_t hits) {
  if (CHECK_EQUAL(needed, hits)) CHECK_BYTES(ids, expected, hits * sizeof ids[0]);
}

static void check_length(uint32_t hits, int arrangement) {
  static const double point[3] = {0.5, 0.5, 0.5};
  double xyz[3 * BALLS], radius[BALLS];
  uint32_t expected[BALLS], ids[BALLS], i, found = 0, needed = 0;
  int axis;
  check_scene("%u hits, arrangement %d", (unsigned)hits, arrangement);
  /* All centres lie in one cube of the grid, whose side is 2; those of the answer near the point, the others 2.4 away,
   * which is too far for radii 1. */
  for (i = 0; i < BALLS; ++i) {
    const int hit = belongs(i, hits, arrangement);
    for (axis = 0; axis < 3; ++axis) xyz[3 * i + (uint32_t)axis] = hit ? 0.5 + 1e-4 * i : 1.9;
    radius[i] = 1;
    if (hit) expected[found++] = i;
  }
  CHECK_EQUAL(found, hits);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_query_point(model, point, ids, BALLS, &needed), HSP_OK);
  check_answer(ids, needed, expected, hits);
  CHECK_EQUAL(hsp_query_ball(model, point, 0.25, ids, BALLS, &needed), HSP_OK);
  check_answer(ids, needed, expected, hits);
  if (hits > 0) {
    /* the first of them leaves itself out */
    CHECK_EQUAL(hsp_query_neighbours(model, expected[0], ids, BALLS, &needed), HSP_OK);
    check_answer(ids, needed, expected + 1, hits - 1);
  }
}

int main(void) {
  uint32_t hits;
  int arrangement;
  if (!CHECK_EQUAL(hsp_model_init(memory, sizeof memory, BALLS, &model), HSP_OK)) return check_report();
  for (hits = 0; hits <= LONGEST; ++hits) {
    for (arrangement = 0; arrangement < 3; ++arrangement) check_length(hits, arrangement);
  }
  return check_report();
}
