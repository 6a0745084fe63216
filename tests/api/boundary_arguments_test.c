/* Every argument of the boundary's functions that the header refuses, and every call out of order. */
#include <hardsphere.h>

#include "ball_sets.h"
#include "check.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static hsp_model *model;
static hsp_boundary *boundary;

/* Every output of the reading functions, to be found untouched after a refusal. */
static hsp_boundary_counts counts;
static hsp_boundary_limits needed_limits;
static hsp_vertex vertices[16];
static hsp_arc arcs[24];
static hsp_circle circles[16];
static hsp_face faces[16];
static hsp_loop loops[16];
static hsp_loop_arc loop_arcs[48];
static hsp_ball balls[BALLS];
static hsp_totals totals;
static double area[BALLS], volume[BALLS];
static uint32_t needed, invariant, id;

static void fill_outputs(void) {
  FILL(counts);
  FILL(needed_limits);
  FILL(vertices);
  FILL(arcs);
  FILL(circles);
  FILL(faces);
  FILL(loops);
  FILL(loop_arcs);
  FILL(balls);
  FILL(totals);
  FILL(area);
  FILL(volume);
  FILL(needed);
  FILL(invariant);
  FILL(id);
}

static void check_outputs_untouched(void) {
  CHECK_UNTOUCHED(counts);
  CHECK_UNTOUCHED(needed_limits);
  CHECK_UNTOUCHED(vertices);
  CHECK_UNTOUCHED(arcs);
  CHECK_UNTOUCHED(circles);
  CHECK_UNTOUCHED(faces);
  CHECK_UNTOUCHED(loops);
  CHECK_UNTOUCHED(loop_arcs);
  CHECK_UNTOUCHED(balls);
  CHECK_UNTOUCHED(totals);
  CHECK_UNTOUCHED(area);
  CHECK_UNTOUCHED(volume);
  CHECK_UNTOUCHED(needed);
  CHECK_UNTOUCHED(invariant);
  CHECK_UNTOUCHED(id);
}

/* All reading functions with good arguments must say `status` and write nothing. */
static void check_all_readers(hsp_boundary *which, int32_t status) {
  fill_outputs();
  CHECK_EQUAL(hsp_boundary_get_counts(which, &counts), status);
  CHECK_EQUAL(hsp_boundary_get_vertices(which, vertices, 16, &needed), status);
  CHECK_EQUAL(hsp_boundary_get_arcs(which, arcs, 24, &needed), status);
  CHECK_EQUAL(hsp_boundary_get_circles(which, circles, 16, &needed), status);
  CHECK_EQUAL(hsp_boundary_get_faces(which, faces, 16, &needed), status);
  CHECK_EQUAL(hsp_boundary_get_loops(which, loops, 16, &needed), status);
  CHECK_EQUAL(hsp_boundary_get_loop_arcs(which, loop_arcs, 48, &needed), status);
  CHECK_EQUAL(hsp_boundary_get_balls(which, balls, BALLS, &needed), status);
  CHECK_EQUAL(hsp_boundary_measure(which, NULL, &totals, area, volume, BALLS, NULL), status);
  CHECK_EQUAL(hsp_boundary_measure(which, NULL, &totals, NULL, NULL, 0, NULL), status);
  CHECK_EQUAL(hsp_boundary_check(which, &invariant, &id), status);
  check_outputs_untouched();
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

  check_scene("nothing computed");
  check_all_readers(boundary, HSP_E_STATE);
  check_outputs_untouched();

  check_scene("null pointers");
  CHECK_EQUAL(hsp_boundary_compute(NULL, model, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_all_readers(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_all_readers(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_all_readers(NULL, HSP_E_ARGUMENT);
  fill_outputs();
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_vertices(boundary, NULL, 16, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_vertices(boundary, vertices, 16, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_arcs(boundary, NULL, 24, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_arcs(boundary, arcs, 24, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_circles(boundary, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_circles(boundary, circles, 16, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_faces(boundary, NULL, 16, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_faces(boundary, faces, 16, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_loops(boundary, NULL, 16, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_loops(boundary, loops, 16, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_loop_arcs(boundary, NULL, 48, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_loop_arcs(boundary, loop_arcs, 48, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_balls(boundary, NULL, BALLS, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_balls(boundary, balls, BALLS, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_check(boundary, NULL, &id), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_check(boundary, &invariant, NULL), HSP_E_ARGUMENT);
  check_outputs_untouched();

  check_scene("every output of hsp_boundary_measure may be left out");
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
  check_all_readers(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  check_scene("model set to nothing");
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  check_all_readers(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  CHECK_EQUAL(counts.balls, 0);
  check_scene("model emptied by a refusal");
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_all_readers(boundary, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
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
