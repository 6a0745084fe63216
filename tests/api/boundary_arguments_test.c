/* Outputs of the boundary that are left out, and models that change behind it. Rules for the arguments of every
 * function are in tests/laws. */
#include <hardsphere.h>

#include "ball_sets.h"
#include "check.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static hsp_model *model;
static hsp_boundary *boundary;

static hsp_boundary_counts counts;
static hsp_totals totals;
static double area[BALLS], volume[BALLS];
static uint32_t needed;

static void check_reading(hsp_boundary *which, int32_t status) {
  CHECK_EQUAL(hsp_boundary_get_counts(which, &counts), status);
}

static hsp_boundary_limits good_limits(void) {
  hsp_boundary_limits limits;
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.neighbours = BALLS;
  limits.vertices = 16;
  limits.circles = 16;
  return limits;
}

static void compute_and_read(void) {
  hsp_boundary_limits limits = good_limits();
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_scene("every output of hsp_boundary_measure may be left out");
  FILL(volume);
  FILL(totals);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, area, NULL, BALLS, NULL), HSP_OK);
  CHECK(area[0] > 0);
  CHECK_UNTOUCHED(volume);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, NULL, volume, BALLS, NULL), HSP_OK);
  CHECK_UNTOUCHED(totals);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_NEAR(area[0] + area[1] + area[2], totals.area, 1e-13 * totals.area);
  CHECK_NEAR(volume[0] + volume[1] + volume[2], totals.volume, 1e-13 * totals.volume);
}

/* A changed model makes earlier results unreadable, whether or not the change succeeded, until the next computation. */
static void model_changed(void) {
  static const double bad_radius[BALLS] = {1, -1, 1};
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  check_scene("model set to fewer balls, then the same again");
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_reading(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  check_scene("model set to nothing");
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  check_reading(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  CHECK_EQUAL(counts.balls, 0);
  check_scene("model emptied by a refusal");
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_reading(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_E_STATE);
  check_reading(boundary, HSP_E_STATE);
  check_scene("figures and queries change nothing");
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  {
    hsp_packing figures;
    CHECK_EQUAL(hsp_model_get_packing(model, &figures), HSP_OK);
    CHECK_EQUAL(hsp_query_point(model, three_balls_xyz, NULL, 0, &needed), HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
    CHECK_EQUAL(counts.balls, BALLS);
  }
  check_scene("%s", "");
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  compute_and_read();
  model_changed();
  return check_report();
}
