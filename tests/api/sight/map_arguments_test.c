/* Options, ids and points of the map that are not there, and every call of its functions out of order. */
#include <hardsphere.h>
#include <math.h>

#include "ball_sets.h"
#include "check.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS, EDGES = 40 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char map_memory[HSP_MAP_BYTES(BALLS, BALLS, EDGES)];
static hsp_model *model;
static hsp_map *map;

static hsp_map_info info;
static hsp_map_vertex vertices[EDGES];
static hsp_map_edge edges[EDGES];
static uint32_t outline[EDGES];
static hsp_map_point point;
static hsp_map_pole pole;
static uint32_t needed;

static void check_reading(hsp_map *which, int32_t status) {
  CHECK_EQUAL(hsp_map_get_info(which, &info), status);
}

static void check_has_results(void) {
  CHECK_EQUAL(hsp_map_get_info(map, &info), HSP_OK);
  CHECK_EQUAL(info.balls, 3);
  CHECK(info.edges > 2 && info.edges <= EDGES);
  CHECK_EQUAL(hsp_map_get_edges(map, 0, info.edges, edges), HSP_OK);
}

static hsp_map_limits good_limits(void) {
  const hsp_map_limits good = {(uint32_t)sizeof good, BALLS, BALLS, EDGES};
  return good;
}

static void default_limits(void) {
  hsp_map_limits limits;
  CHECK_EQUAL(hsp_map_limits_init(&limits, (uint32_t)sizeof limits, (HSP_MAX_BALLS - 64) / 12 + 1), HSP_E_RANGE);
}

/* A computation that must fail, after one that succeeded: the map holds no results. */
static void check_refused(const hsp_model *from, const hsp_view_options *options, int32_t expected) {
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_map_compute(map, from, options, NULL), expected);
  check_reading(map, HSP_E_STATE);
}

static void computing(void) {
  hsp_map_limits asked = good_limits();
  hsp_view_options options;
  CHECK_EQUAL(hsp_map_init(map_memory, sizeof map_memory, &asked, &map), HSP_OK);
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, &asked), HSP_OK);
  CHECK(asked.balls == BALLS && asked.neighbours <= BALLS && asked.edges <= EDGES);
  check_has_results();
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.flags = 2;
  check_refused(model, &options, HSP_E_ARGUMENT);
  options.flags = HSP_VIEW_ALL_BALLS;
  options.pieces = HSP_PIECES_OUTSIDE_ALL; /* without effect */
  CHECK_EQUAL(hsp_map_compute(map, model, &options, NULL), HSP_OK);
  check_has_results();
  options.pieces = 2;
  check_refused(model, &options, HSP_E_ARGUMENT);
}

static void refused_requests(void) {
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_map_get_vertices(map, EDGES, 1, vertices), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_edges(map, 0, EDGES, edges), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_outline(map, BALLS, outline, EDGES, &needed), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_point(map, EDGES, 0, &point), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_pole(map, 0, &pole), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_pole(map, EDGES, &pole), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_point(map, 0, 100, &point), HSP_E_RANGE);
  CHECK_EQUAL(hsp_map_get_point(map, 0, -100, &point), HSP_E_RANGE);
  CHECK_EQUAL(hsp_map_next(map, HSP_NONE), HSP_NONE);
  CHECK_EQUAL(hsp_map_left(map, 2 * EDGES), HSP_NONE);
  CHECK_EQUAL(HSP_MAP_TWIN(HSP_NONE), HSP_NONE);
  CHECK_EQUAL(hsp_map_get_areas(map, NULL, 0, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, BALLS);
  CHECK_EQUAL(hsp_map_get_outline(map, 0, NULL, 0, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 1);
}

static void order_of_calls(void) {
  static const double bad_radius[BALLS] = {1, -1, 1};
  const hsp_map_limits limits = good_limits();
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_reading(map, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_reading(map, HSP_E_STATE);
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK); /* no balls are something else */
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_map_get_info(map, &info), HSP_OK);
  CHECK_EQUAL(info.balls, 0);
  CHECK_EQUAL(info.faces, 1);
  CHECK_EQUAL(hsp_map_init(map_memory, sizeof map_memory, &limits, &map), HSP_OK);
  check_reading(map, HSP_E_STATE);
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  default_limits();
  computing();
  refused_requests();
  order_of_calls();
  return check_report();
}
