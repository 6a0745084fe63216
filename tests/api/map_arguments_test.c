/* Every argument of the map's functions that the header refuses, and every call out of order. */
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

/* Every output of the reading functions, to be found untouched after a refusal. */
static hsp_map_info info;
static hsp_map_vertex vertices[EDGES];
static hsp_map_edge edges[EDGES];
static hsp_map_face faces[EDGES];
static double areas[BALLS];
static uint32_t outline[EDGES];
static hsp_map_sight sight;
static hsp_map_point point;
static hsp_map_pole pole;
static uint32_t needed, invariant, id;

static void fill_outputs(void) {
  FILL(info);
  FILL(vertices);
  FILL(edges);
  FILL(faces);
  FILL(areas);
  FILL(outline);
  FILL(sight);
  FILL(point);
  FILL(pole);
  FILL(needed);
  FILL(invariant);
  FILL(id);
}

static void check_outputs_untouched(void) {
  CHECK_UNTOUCHED(info);
  CHECK_UNTOUCHED(vertices);
  CHECK_UNTOUCHED(edges);
  CHECK_UNTOUCHED(faces);
  CHECK_UNTOUCHED(areas);
  CHECK_UNTOUCHED(outline);
  CHECK_UNTOUCHED(sight);
  CHECK_UNTOUCHED(point);
  CHECK_UNTOUCHED(pole);
  CHECK_UNTOUCHED(needed);
  CHECK_UNTOUCHED(invariant);
  CHECK_UNTOUCHED(id);
}

/* All reading functions with good arguments must say `status` and write nothing. */
static void check_all_readers(hsp_map *which, int32_t status) {
  fill_outputs();
  CHECK_EQUAL(hsp_map_get_info(which, &info), status);
  CHECK_EQUAL(hsp_map_get_vertices(which, 0, 1, vertices), status);
  CHECK_EQUAL(hsp_map_get_vertices(which, 0, 0, NULL), status);
  CHECK_EQUAL(hsp_map_get_edges(which, 0, 1, edges), status);
  CHECK_EQUAL(hsp_map_get_faces(which, 0, 1, faces), status);
  CHECK_EQUAL(hsp_map_get_areas(which, areas, BALLS, &needed), status);
  CHECK_EQUAL(hsp_map_get_areas(which, NULL, 0, &needed), status);
  CHECK_EQUAL(hsp_map_get_outline(which, 0, outline, EDGES, &needed), status);
  CHECK_EQUAL(hsp_map_pick(which, 0, 0, &sight), status);
  CHECK_EQUAL(hsp_map_get_point(which, 0, 0, &point), status);
  CHECK_EQUAL(hsp_map_get_pole(which, 1, &pole), status);
  CHECK_EQUAL(hsp_map_check(which, &invariant, &id), status);
  CHECK_EQUAL(hsp_map_next(which, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_previous(which, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_next_loop(which, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_origin(which, 0), HSP_NONE);
  CHECK_EQUAL(hsp_map_left(which, 0), HSP_NONE);
  check_outputs_untouched();
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

static void refused_limits(void) {
  hsp_map_limits bad = good_limits();
  size_t bytes = 0;
  hsp_map *made = NULL;
  int which;
  CHECK_EQUAL(hsp_map_bytes(NULL, &bytes), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_bytes(&bad, NULL), HSP_E_ARGUMENT);
  for (which = 0; which < 5; ++which) {
    const int32_t status = which < 2 ? HSP_E_VERSION : HSP_E_RANGE;
    bad = good_limits();
    if (which == 0) bad.struct_size = 12;
    if (which == 1) bad.struct_size = 1028;
    if (which == 2) bad.balls = HSP_MAX_BALLS + 1;
    if (which == 3) bad.neighbours = HSP_NONE;
    if (which == 4) bad.edges = HSP_MAX_BALLS + 1;
    CHECK_EQUAL(hsp_map_bytes(&bad, &bytes), status);
    CHECK_EQUAL(hsp_map_init(map_memory, sizeof map_memory, &bad, &made), status);
  }
  CHECK_EQUAL(bytes, 0);
  bad = good_limits();
  CHECK_EQUAL(hsp_map_bytes(&bad, &bytes), HSP_OK);
  CHECK(bytes <= sizeof map_memory);
  CHECK_EQUAL(hsp_map_init(NULL, bytes, &bad, &made), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_init(map_memory, bytes, NULL, &made), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_init(map_memory, bytes, &bad, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_init(map_memory, bytes - 1, &bad, &made), HSP_E_MEMORY);
  CHECK(made == NULL);
  CHECK_EQUAL(hsp_map_limits_init(NULL, (uint32_t)sizeof bad, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_limits_init(&bad, 8, 1), HSP_E_VERSION);
  CHECK_EQUAL(hsp_map_limits_init(&bad, (uint32_t)sizeof bad, (HSP_MAX_BALLS - 64) / 12 + 1), HSP_E_RANGE);
}

/* A computation that must fail, after one that succeeded: the map holds no results. */
static void check_refused(const hsp_model *from, const hsp_view_options *options, int32_t expected) {
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_map_compute(map, from, options, NULL), expected);
  check_all_readers(map, HSP_E_STATE);
}

static void computing(void) {
  hsp_map_limits asked = good_limits();
  hsp_view_options options;
  check_all_readers(NULL, HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_init(map_memory, sizeof map_memory, &asked, &map), HSP_OK);
  check_all_readers(map, HSP_E_STATE);
  CHECK_EQUAL(hsp_map_compute(NULL, model, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, &asked), HSP_OK);
  CHECK(asked.balls == BALLS && asked.neighbours <= BALLS && asked.edges <= EDGES);
  check_has_results();
  check_refused(NULL, NULL, HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.struct_size = 4;
  check_refused(model, &options, HSP_E_VERSION);
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.flags = 2;
  check_refused(model, &options, HSP_E_ARGUMENT);
  options.flags = HSP_VIEW_ALL_BALLS;
  options.pieces = HSP_PIECES_OUTSIDE_ALL; /* without effect */
  CHECK_EQUAL(hsp_map_compute(map, model, &options, NULL), HSP_OK);
  check_has_results();
  options.pieces = 2;
  check_refused(model, &options, HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.towards[1] = (double)NAN;
  check_refused(model, &options, HSP_E_NOT_FINITE);
  options.towards[1] = 0;
  options.up[2] = (double)INFINITY;
  check_refused(model, &options, HSP_E_NOT_FINITE);
  asked.struct_size = 4;
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, &asked), HSP_E_VERSION);
  check_all_readers(map, HSP_E_STATE);
}

static void refused_requests(void) {
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_has_results();
  fill_outputs();
  CHECK_EQUAL(hsp_map_get_info(map, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_vertices(map, 0, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_edges(map, 0, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_faces(map, 0, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_vertices(map, EDGES, 1, vertices), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_edges(map, 0, EDGES, edges), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_edges(map, HSP_NONE, 2, edges), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_faces(map, 1, HSP_NONE, faces), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_areas(map, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_areas(map, areas, BALLS, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_outline(map, 0, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_outline(map, 0, outline, EDGES, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_outline(map, BALLS, outline, EDGES, &needed), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_outline(map, HSP_NONE, outline, EDGES, &needed), HSP_E_ID);
  CHECK_EQUAL(hsp_map_pick(map, 0, 0, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_pick(map, (double)NAN, 0, &sight), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_map_pick(map, 0, -(double)INFINITY, &sight), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_map_get_point(map, 0, 0, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_point(map, EDGES, 0, &point), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_pole(map, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_get_pole(map, 0, &pole), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_pole(map, EDGES, &pole), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_pole(map, HSP_NONE, &pole), HSP_E_ID);
  CHECK_EQUAL(hsp_map_get_point(map, 0, (double)NAN, &point), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_map_get_point(map, 0, 100, &point), HSP_E_RANGE);
  CHECK_EQUAL(hsp_map_get_point(map, 0, -100, &point), HSP_E_RANGE);
  CHECK_EQUAL(hsp_map_check(map, NULL, &id), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_map_check(map, &invariant, NULL), HSP_E_ARGUMENT);
  check_outputs_untouched();
  CHECK_EQUAL(hsp_map_next(map, HSP_NONE), HSP_NONE);
  CHECK_EQUAL(hsp_map_left(map, 2 * EDGES), HSP_NONE);
  CHECK_EQUAL(HSP_MAP_TWIN(HSP_NONE), HSP_NONE);
  /* too short */
  CHECK_EQUAL(hsp_map_get_areas(map, areas, BALLS - 1, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, BALLS);
  CHECK_EQUAL(hsp_map_get_outline(map, 0, NULL, 0, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 1);
  CHECK_UNTOUCHED(areas);
  CHECK_UNTOUCHED(outline);
}

static void order_of_calls(void) {
  static const double bad_radius[BALLS] = {1, -1, 1};
  const hsp_map_limits limits = good_limits();
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_all_readers(map, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_all_readers(map, HSP_E_STATE);
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_map_get_info(map, &info), HSP_OK);
  CHECK_EQUAL(info.balls, 0);
  CHECK_EQUAL(info.faces, 1);
  CHECK_EQUAL(hsp_map_init(map_memory, sizeof map_memory, &limits, &map), HSP_OK);
  check_all_readers(map, HSP_E_STATE);
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  refused_limits();
  computing();
  refused_requests();
  order_of_calls();
  return check_report();
}
