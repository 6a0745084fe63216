/* Options of the view that the header refuses, boundaries of other models, and every call out of order. */
#include <hardsphere.h>
#include <math.h>

#include "ball_sets.h"
#include "check.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS, ARCS = 40 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)], other_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static unsigned char other_boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static unsigned char view_memory[HSP_VIEW_BYTES(BALLS, BALLS, ARCS)];
static hsp_model *model, *other_model;
static hsp_boundary *boundary, *other_boundary;
static hsp_view *view;

static hsp_view_limits needed_limits;
static hsp_view_info info;
static hsp_view_arc arcs[ARCS];
static uint32_t needed;

static void check_reading(const hsp_view *which, int32_t status) {
  CHECK_EQUAL(hsp_view_get_info(which, &info), status);
}

static void check_has_results(void) {
  CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_OK);
  CHECK_EQUAL(info.pieces, 3);
  CHECK_EQUAL(hsp_view_get_arcs(view, arcs, ARCS, &needed), HSP_OK);
  CHECK_EQUAL(needed, info.arcs);
}

static hsp_view_options good_options(void) {
  hsp_view_options options;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  return options;
}

static void options_init(void) {
  hsp_view_options options;
  int axis;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(options.struct_size, sizeof options);
  CHECK_EQUAL(options.pieces, HSP_PIECES_OUTSIDE_FARTHER);
  CHECK_EQUAL(options.flags, 0);
  CHECK_EQUAL(options.reserved, 0);
  /* zero and what is documented as default are the same view */
  for (axis = 0; axis < 3; ++axis) {
    CHECK(options.towards[axis] == 0 || options.towards[axis] == (axis == 2));
    CHECK(options.up[axis] == 0 || options.up[axis] == (axis == 1));
  }
}

/* A computation that must fail, after one that succeeded: the view holds no results. */
static void check_refused(const hsp_model *from, const hsp_boundary *cut_from, const hsp_view_options *options,
                          int32_t expected) {
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_view_compute(view, from, cut_from, options, NULL), expected);
  check_reading(view, HSP_E_STATE);
}

static void bad_options(void) {
  hsp_view_options options = good_options();
  int k;
  check_scene("unknown pieces");
  options.pieces = HSP_PIECES_OUTSIDE_ALL + 1;
  check_refused(model, boundary, &options, HSP_E_ARGUMENT);
  options.pieces = HSP_NONE;
  check_refused(model, boundary, &options, HSP_E_ARGUMENT);
  check_scene("unknown flags");
  options = good_options();
  for (k = 1; k < 32; ++k) {
    options.flags = HSP_VIEW_ALL_BALLS | (UINT32_C(1) << k);
    CHECK_EQUAL(hsp_view_compute(view, model, NULL, &options, NULL), HSP_E_ARGUMENT);
  }
  options.flags = 2;
  check_refused(model, NULL, &options, HSP_E_ARGUMENT);
  check_scene("%s", "");
}

/* A boundary that does not go with the model or holds nothing. */
static void bad_boundaries(void) {
  hsp_view_options options = good_options();
  check_scene("another model's boundary");
  CHECK_EQUAL(hsp_boundary_compute(other_boundary, other_model, NULL), HSP_OK);
  check_refused(model, other_boundary, NULL, HSP_E_ARGUMENT);
  check_refused(other_model, boundary, NULL, HSP_E_ARGUMENT);
  options.pieces = HSP_PIECES_OUTSIDE_ALL;
  check_refused(model, other_boundary, &options, HSP_E_ARGUMENT);
  check_scene("H-pieces without a boundary");
  check_refused(model, NULL, &options, HSP_E_ARGUMENT);
  check_scene("H-pieces");
  CHECK_EQUAL(hsp_view_compute(view, model, boundary, &options, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(info.kind, HSP_PIECES_OUTSIDE_ALL);
  check_scene("a boundary without results");
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_refused(model, boundary, &options, HSP_E_STATE);
  check_refused(model, boundary, NULL, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_view_compute(view, model, boundary, &options, NULL), HSP_OK);
  check_has_results();
  check_scene("the boundary is not needed after the call");
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_has_results();
  FILL(boundary_memory);
  check_has_results();
  check_scene("%s", "");
}

static void order_of_calls(void) {
  static const double bad_radius[BALLS] = {1, -1, 1};
  hsp_view_limits limits;
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.neighbours = BALLS;
  limits.arcs = ARCS;
  CHECK_EQUAL(hsp_view_init(view_memory, sizeof view_memory, &limits, &view), HSP_OK);
  check_scene("nothing computed");
  check_reading(view, HSP_E_STATE);
  needed_limits.struct_size = sizeof needed_limits;
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, NULL, &needed_limits), HSP_OK);
  check_has_results();
  CHECK_EQUAL(needed_limits.struct_size, sizeof needed_limits);
  CHECK_EQUAL(needed_limits.balls, BALLS);
  CHECK_EQUAL(needed_limits.neighbours, BALLS - 1);
  check_scene("model set to fewer balls, then the same again");
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_reading(view, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_has_results();
  check_scene("model emptied by a refusal");
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_reading(view, HSP_E_STATE);
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, NULL, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK); /* no balls are something else */
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_OK);
  CHECK_EQUAL(info.pieces, 0);
  CHECK_EQUAL(hsp_view_get_pieces(view, NULL, 0, &needed), HSP_OK);
  CHECK_EQUAL(needed, 0);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, NULL, NULL), HSP_OK);
  check_scene("figures and queries change nothing");
  {
    hsp_packing figures;
    CHECK_EQUAL(hsp_model_get_packing(model, &figures), HSP_OK);
    CHECK_EQUAL(hsp_query_point(model, three_balls_xyz, NULL, 0, &needed), HSP_E_CAPACITY);
    check_has_results();
  }
  check_scene("initialised again");
  CHECK_EQUAL(hsp_view_init(view_memory, sizeof view_memory, &limits, &view), HSP_OK);
  check_reading(view, HSP_E_STATE);
  check_scene("%s", "");
}

static hsp_boundary *a_boundary(void *memory, size_t bytes) {
  hsp_boundary_limits limits;
  hsp_boundary *made = NULL;
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.neighbours = BALLS;
  limits.vertices = limits.circles = 16;
  CHECK_EQUAL(hsp_boundary_init(memory, bytes, &limits, &made), HSP_OK);
  return made;
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_init(other_memory, sizeof other_memory, BALLS, &other_model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(other_model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  boundary = a_boundary(boundary_memory, sizeof boundary_memory);
  other_boundary = a_boundary(other_boundary_memory, sizeof other_boundary_memory);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  options_init();
  order_of_calls();
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  bad_options();
  bad_boundaries();
  return check_report();
}
