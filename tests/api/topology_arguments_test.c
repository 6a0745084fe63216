/* First ids that are not there, steps that lead nowhere, and every call of the topology's functions out of order. */
#include <hardsphere.h>
#include <math.h>

#include "ball_sets.h"
#include "check.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS, EDGES = 40, EXTRA = 8 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static unsigned char topology_memory[HSP_TOPOLOGY_BYTES(BALLS, BALLS, EDGES, EXTRA)];
static hsp_model *model;
static hsp_boundary *boundary;
static hsp_topology *topology;

static hsp_topology_limits needed_limits;
static hsp_topology_counts counts;
static hsp_topology_vertex vertices[EDGES];
static hsp_topology_edge edges[EDGES];
static hsp_simple_face faces[EDGES];
static uint32_t ids[EDGES], needed, invariant, id;

/* Steps from a quarter-edge have no status: without results they lead nowhere. */
static void check_no_steps(const hsp_topology *which) {
  uint32_t q;
  for (q = 0; q < 8; ++q) {
    CHECK_EQUAL(hsp_topology_onext(which, q), HSP_NONE);
    CHECK_EQUAL(HSP_TOPOLOGY_OPREV(which, q), HSP_NONE);
    CHECK_EQUAL(hsp_topology_lnext(which, q), HSP_NONE);
    CHECK_EQUAL(HSP_TOPOLOGY_LPREV(which, q), HSP_NONE);
    CHECK_EQUAL(hsp_topology_origin(which, q), HSP_NONE);
    CHECK_EQUAL(hsp_topology_left(which, q), HSP_NONE);
  }
}

static void check_reading(hsp_topology *which, int32_t status) {
  CHECK_EQUAL(hsp_topology_get_counts(which, &counts), status);
}

static void check_has_results(void) {
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_OK);
  CHECK_EQUAL(counts.components, 1);
  CHECK(counts.edges > 0 && counts.edges <= EDGES);
  CHECK(hsp_topology_onext(topology, 0) != HSP_NONE);
}

static hsp_topology_limits good_limits(void) {
  const hsp_topology_limits limits = {(uint32_t)sizeof limits, BALLS, BALLS, EDGES, EXTRA, 0};
  return limits;
}

static void bad_ids(void) {
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_OK);
  CHECK_EQUAL(hsp_topology_get_vertices(topology, counts.vertices, 1, vertices), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_edges(topology, counts.edges, 1, edges), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_simple_faces(topology, counts.simple_faces, 1, faces), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_region_shells(topology, counts.regions, ids, EDGES, &needed), HSP_E_ID);
  CHECK_EQUAL(hsp_topology_get_traversal(topology, counts.shells, ids, EDGES, &needed), HSP_E_ID);
  CHECK_EQUAL(HSP_QUAD_ROT(HSP_NONE), HSP_NONE);
  CHECK_EQUAL(HSP_QUAD_INVERSE_ROT(HSP_NONE), HSP_NONE);
  CHECK_EQUAL(HSP_QUAD_SYM(HSP_NONE), HSP_NONE);
  CHECK_EQUAL(hsp_topology_onext(topology, HSP_NONE), HSP_NONE);
}

static void compute_and_read(void) {
  const hsp_topology_limits limits = good_limits();
  CHECK_EQUAL(hsp_topology_init(topology_memory, sizeof topology_memory, &limits, &topology), HSP_OK);
  check_scene("nothing computed");
  check_reading(topology, HSP_E_STATE);
  check_scene("the boundary holds nothing");
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_E_STATE);
  check_reading(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_reading(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  check_has_results();
  check_scene("ids");
  bad_ids();
  check_has_results();
}

/* A changed model or boundary makes results unreadable until the topology is computed again. */
static void changes(void) {
  static const double bad_radius[BALLS] = {1, -1, 1};
  static unsigned char small_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 0, 0)];
  hsp_boundary_limits small;
  hsp_boundary *too_small = NULL;
  check_scene("boundary computed again");
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_reading(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  check_has_results();
  check_scene("model set to fewer balls, then the same again");
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_reading(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_reading(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  check_has_results();
  check_scene("model emptied by a refusal");
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_reading(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK); /* no balls are something else */
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_OK);
  CHECK_EQUAL(counts.edges, 0);
  check_no_steps(topology);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  check_scene("another boundary of the model fails");
  CHECK_EQUAL(hsp_boundary_limits_init(&small, (uint32_t)sizeof small, BALLS), HSP_OK);
  small.neighbours = BALLS;
  small.vertices = small.circles = 0;
  CHECK_EQUAL(hsp_boundary_init(small_memory, sizeof small_memory, &small, &too_small), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(too_small, model, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_topology_compute(topology, too_small, NULL), HSP_E_STATE);
  check_reading(topology, HSP_E_STATE); /* results of the other boundary are gone, too */
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  check_has_results();
  check_scene("figures, queries, measures and checks change nothing");
  {
    hsp_packing figures;
    hsp_totals totals;
    CHECK_EQUAL(hsp_model_get_packing(model, &figures), HSP_OK);
    CHECK_EQUAL(hsp_query_point(model, three_balls_xyz, NULL, 0, &needed), HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_check(boundary, &invariant, &id), HSP_OK);
    CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, &totals, NULL, NULL, 0, NULL), HSP_OK);
    CHECK_EQUAL(hsp_topology_check(topology, &invariant, &id), HSP_OK);
    check_has_results();
  }
  check_scene("%s", "");
}

/* After a computation for which a limit was too small, the topology is empty of results; it recovers. */
static void too_small(void) {
  hsp_topology_limits limits = good_limits();
  needed_limits.struct_size = sizeof needed_limits;
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, &needed_limits), HSP_OK);
  limits.edges = needed_limits.edges - 1;
  check_scene("one edge too few");
  CHECK_EQUAL(hsp_topology_init(topology_memory, sizeof topology_memory, &limits, &topology), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, &needed_limits), HSP_E_CAPACITY);
  CHECK_EQUAL(needed_limits.edges, limits.edges + 1);
  check_reading(topology, HSP_E_STATE);
  check_scene("%s", "");
}

static void limits_init(void) {
  hsp_topology_limits limits;
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, boundary), HSP_OK);
  CHECK_EQUAL(limits.balls, BALLS);
  CHECK_EQUAL(limits.neighbours, BALLS - 1);
  CHECK_EQUAL(limits.shells, 1);
}

int main(void) {
  hsp_boundary_limits limits;
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.neighbours = BALLS;
  limits.vertices = limits.circles = 16;
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  limits_init();
  compute_and_read();
  changes();
  too_small();
  return check_report();
}
