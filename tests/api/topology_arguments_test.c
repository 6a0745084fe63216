/* Every argument of the topology's functions that the header refuses, and every call out of order. */
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

static const double outside[3] = {10, 0, 0};

/* Every output of the reading functions, to be found untouched after a refusal. */
static hsp_topology_limits needed_limits;
static hsp_topology_counts counts;
static uint32_t onext[4 * EDGES], origin[4 * EDGES];
static hsp_topology_vertex vertices[EDGES];
static hsp_topology_edge edges[EDGES];
static hsp_simple_face faces[EDGES];
static hsp_shell shells[BALLS];
static hsp_component components[BALLS];
static hsp_cell cells[BALLS];
static uint32_t ids[EDGES], needed, invariant, id, cell;

static void fill_outputs(void) {
  FILL(needed_limits);
  FILL(counts);
  FILL(onext);
  FILL(origin);
  FILL(vertices);
  FILL(edges);
  FILL(faces);
  FILL(shells);
  FILL(components);
  FILL(cells);
  FILL(ids);
  FILL(needed);
  FILL(invariant);
  FILL(id);
  FILL(cell);
}

static void check_outputs_untouched(void) {
  CHECK_UNTOUCHED(needed_limits);
  CHECK_UNTOUCHED(counts);
  CHECK_UNTOUCHED(onext);
  CHECK_UNTOUCHED(origin);
  CHECK_UNTOUCHED(vertices);
  CHECK_UNTOUCHED(edges);
  CHECK_UNTOUCHED(faces);
  CHECK_UNTOUCHED(shells);
  CHECK_UNTOUCHED(components);
  CHECK_UNTOUCHED(cells);
  CHECK_UNTOUCHED(ids);
  CHECK_UNTOUCHED(needed);
  CHECK_UNTOUCHED(invariant);
  CHECK_UNTOUCHED(id);
  CHECK_UNTOUCHED(cell);
}

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

/* All reading functions with good arguments must say `status` and write nothing. */
static void check_all_readers(hsp_topology *which, int32_t status) {
  fill_outputs();
  CHECK_EQUAL(hsp_topology_get_counts(which, &counts), status);
  CHECK_EQUAL(hsp_topology_get_quad_edges(which, 0, 1, onext, origin), status);
  CHECK_EQUAL(hsp_topology_get_quad_edges(which, 0, 0, NULL, NULL), status);
  CHECK_EQUAL(hsp_topology_get_vertices(which, 0, 1, vertices), status);
  CHECK_EQUAL(hsp_topology_get_vertices(which, 0, 0, NULL), status);
  CHECK_EQUAL(hsp_topology_get_edges(which, 0, 1, edges), status);
  CHECK_EQUAL(hsp_topology_get_simple_faces(which, 0, 1, faces), status);
  CHECK_EQUAL(hsp_topology_get_shells(which, shells, BALLS, &needed), status);
  CHECK_EQUAL(hsp_topology_get_components(which, components, BALLS, &needed), status);
  CHECK_EQUAL(hsp_topology_get_cells(which, cells, BALLS, &needed), status);
  CHECK_EQUAL(hsp_topology_get_cell_shells(which, 0, ids, EDGES, &needed), status);
  CHECK_EQUAL(hsp_topology_get_traversal(which, 0, ids, EDGES, &needed), status);
  CHECK_EQUAL(hsp_topology_locate(which, outside, &cell), status);
  CHECK_EQUAL(hsp_topology_check(which, &invariant, &id), status);
  check_outputs_untouched();
  check_no_steps(which);
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

static void null_pointers(void) {
  fill_outputs();
  CHECK_EQUAL(hsp_topology_compute(NULL, boundary, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_counts(topology, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_quad_edges(topology, 0, 1, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_vertices(topology, 0, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_edges(topology, 0, EDGES, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_simple_faces(topology, HSP_NONE, HSP_NONE, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_shells(topology, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_shells(topology, shells, BALLS, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_components(topology, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_components(topology, components, BALLS, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_cells(topology, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_cells(topology, cells, BALLS, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_cell_shells(topology, 0, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_cell_shells(topology, 0, ids, EDGES, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_traversal(topology, 0, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_traversal(topology, 0, ids, EDGES, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_locate(topology, NULL, &cell), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_locate(topology, outside, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_check(topology, NULL, &id), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_check(topology, &invariant, NULL), HSP_E_ARGUMENT);
  check_outputs_untouched();
}

static void bad_ids(void) {
  static const uint32_t far_off[3] = {HSP_MAX_BALLS + 1, HSP_NONE - 1, HSP_NONE};
  int i;
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_OK);
  {
    const hsp_topology_counts all = counts;
    fill_outputs();
    CHECK_EQUAL(hsp_topology_get_vertices(topology, all.vertices, 1, vertices), HSP_E_ID);
    CHECK_EQUAL(hsp_topology_get_edges(topology, all.edges, 1, edges), HSP_E_ID);
    CHECK_EQUAL(hsp_topology_get_simple_faces(topology, all.simple_faces, 1, faces), HSP_E_ID);
    CHECK_EQUAL(hsp_topology_get_cell_shells(topology, all.cells, ids, EDGES, &needed), HSP_E_ID);
    CHECK_EQUAL(hsp_topology_get_traversal(topology, all.shells, ids, EDGES, &needed), HSP_E_ID);
  }
  for (i = 0; i < 3; ++i) {
    CHECK_EQUAL(hsp_topology_get_vertices(topology, far_off[i], 1, vertices), HSP_E_ID);
    CHECK_EQUAL(hsp_topology_get_edges(topology, far_off[i], 1, edges), HSP_E_ID);
    CHECK_EQUAL(hsp_topology_get_simple_faces(topology, far_off[i], 1, faces), HSP_E_ID);
    CHECK_EQUAL(hsp_topology_get_cell_shells(topology, far_off[i], ids, EDGES, &needed), HSP_E_ID);
    CHECK_EQUAL(hsp_topology_get_traversal(topology, far_off[i], ids, EDGES, &needed), HSP_E_ID);
  }
  check_outputs_untouched();
  CHECK_EQUAL(HSP_QUAD_ROT(HSP_NONE), HSP_NONE);
  CHECK_EQUAL(HSP_QUAD_INVERSE_ROT(HSP_NONE), HSP_NONE);
  CHECK_EQUAL(HSP_QUAD_SYM(HSP_NONE), HSP_NONE);
  CHECK_EQUAL(hsp_topology_onext(topology, HSP_NONE), HSP_NONE);
}

static void bad_places(void) {
  static const double odd[4] = {NAN, INFINITY, -INFINITY, 1e300};
  int i, axis;
  fill_outputs();
  for (i = 0; i < 4; ++i) {
    const int32_t expected = i < 3 ? HSP_E_NOT_FINITE : HSP_E_RANGE;
    for (axis = 0; axis < 3; ++axis) {
      double place[3] = {1, 2, 3};
      place[axis] = odd[i];
      CHECK_EQUAL(hsp_topology_locate(topology, place, &cell), expected);
    }
  }
  check_outputs_untouched();
}

static void compute_and_read(void) {
  const hsp_topology_limits limits = good_limits();
  CHECK_EQUAL(hsp_topology_init(topology_memory, sizeof topology_memory, &limits, &topology), HSP_OK);
  check_scene("nothing computed");
  check_all_readers(topology, HSP_E_STATE);
  check_outputs_untouched();
  check_scene("the boundary holds nothing");
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_E_STATE);
  check_all_readers(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_all_readers(topology, HSP_E_STATE);
  check_scene("null pointers");
  CHECK_EQUAL(hsp_topology_compute(topology, NULL, NULL), HSP_E_ARGUMENT);
  check_all_readers(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  check_has_results();
  check_all_readers(NULL, HSP_E_ARGUMENT);
  null_pointers();
  check_has_results();
  check_scene("ids");
  bad_ids();
  check_scene("places");
  bad_places();
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
  check_all_readers(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  check_has_results();
  check_scene("model set to fewer balls, then the same again");
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_all_readers(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_all_readers(topology, HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_compute(topology, boundary, NULL), HSP_OK);
  check_has_results();
  check_scene("model emptied by a refusal");
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_all_readers(topology, HSP_E_STATE);
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
  check_all_readers(topology, HSP_E_STATE); /* results of the other boundary are gone, too */
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
  check_all_readers(topology, HSP_E_STATE);
  check_scene("%s", "");
}

static void limits_init(void) {
  hsp_topology_limits limits;
  FILL(limits);
  CHECK_EQUAL(hsp_topology_limits_init(NULL, (uint32_t)sizeof limits, boundary), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, 0, boundary), HSP_E_VERSION);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, 1028, boundary), HSP_E_VERSION);
  CHECK_UNTOUCHED(limits);
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, boundary), HSP_E_STATE);
  CHECK_UNTOUCHED(limits);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
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
