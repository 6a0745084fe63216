/* The contents of a handle after a failed set or compute, as the header's section of that name says: none. The tests of
 * arguments go through all arguments that are refused; here are the sequences of calls. */
#include <hardsphere.h>
#include <math.h>

#include "check.h"
#include "four_handles.h"

static const double bad_radius[BALLS] = {1.5, 1.5, -1, 1};
static unsigned char other_memory[SIZE], small_memory[SIZE];

/* A failed set leaves nothing to ask for, whatever the model held before; it describes itself as it did when it was
 * made. */
static void failed_set(void) {
  const four_handles h = four_handles_make(BALLS);
  hsp_model_options options;
  model_contents made, read;
  int before;
  made = contents_of_model(h.model);
  CHECK_EQUAL(made.info.balls, 0);
  CHECK(made.info.step == 1e-8);
  CHECK(made.info.probe == 0 && made.info.largest_radius == 0);
  CHECK_EQUAL(made.status, HSP_OK);
  CHECK_EQUAL(made.hit_count, 0);
  CHECK_EQUAL(made.neighbours_status, HSP_E_ID);
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  for (before = 0; before < 4; ++before) {
    static const int32_t expected[] = {HSP_E_ARGUMENT, HSP_E_CAPACITY, HSP_E_NEGATIVE, HSP_E_NOT_FINITE, HSP_E_RANGE};
    const hsp_model_options good = {(uint32_t)sizeof options, 0, 0.25, before == 3 ? 0.5 : 0, 0};
    int refusal;
    for (refusal = 0; refusal < 5; ++refusal) {
      const double far_away[3] = {1e300, 0, 0}, nowhere[3] = {NAN, 0, 0};
      int32_t status = HSP_OK;
      check_scene("refusal %d of a model set in way %d", refusal, before);
      if (before == 1) four_handles_set(&h, BALLS);
      if (before >= 2) CHECK_EQUAL(hsp_model_set(h.model, BALLS, four_xyz, four_radius, &good, NULL), HSP_OK);
      if (refusal == 0) status = hsp_model_set(h.model, BALLS, NULL, four_radius, &good, NULL);
      if (refusal == 1) status = hsp_model_set(h.model, BALLS + 1, four_xyz, four_radius, &good, NULL);
      if (refusal == 2) status = hsp_model_set(h.model, BALLS, four_xyz, bad_radius, &good, NULL);
      if (refusal == 3) status = hsp_model_set(h.model, 1, nowhere, four_radius, &good, NULL);
      if (refusal == 4) status = hsp_model_set(h.model, 1, far_away, four_radius, &good, NULL);
      CHECK_EQUAL(status, expected[refusal]);
      read = contents_of_model(h.model);
      CHECK_BYTES(&read.info, &made.info, sizeof made.info);
      CHECK_EQUAL(read.status, HSP_E_STATE);
      CHECK_EQUAL(read.neighbours_status, HSP_E_STATE);
      CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_E_STATE);
      CHECK_EQUAL(hsp_view_compute(h.view, h.model, NULL, NULL, NULL), HSP_E_STATE);
    }
  }
  check_scene("no balls, but a step");
  options.step = 0.5;
  CHECK_EQUAL(hsp_model_set(h.model, 0, NULL, NULL, &options, NULL), HSP_OK);
  read = contents_of_model(h.model);
  CHECK_EQUAL(read.status, HSP_OK);
  CHECK_EQUAL(read.info.balls, 0);
  CHECK(read.info.step == 0.5);
}

/* Results are of the model as it was: a failed set makes them unreadable, like one that succeeds. */
static void failed_set_behind_results(void) {
  const four_handles h = four_handles_make(BALLS);
  four_handles_compute(&h);
  CHECK_EQUAL(hsp_model_set(h.model, BALLS, four_xyz, bad_radius, NULL, NULL), HSP_E_NEGATIVE);
  check_status(contents_of_map(h.map), HSP_E_STATE);
  check_status(contents_of_boundary(h.boundary), HSP_E_STATE);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  check_status(contents_of_view(h.view), HSP_E_STATE);
  four_handles_compute(&h);
}

/* A boundary computed, then refused, too small, refused, and computed again. */
static void failed_boundary(void) {
  four_handles h = four_handles_make(BALLS);
  const hsp_boundary_limits small = four_boundary_limits(FEW);
  contents one;
  CHECK_EQUAL(hsp_boundary_init(h.boundary_memory, SIZE, &small, &h.boundary), HSP_OK);
  check_status(contents_of_boundary(h.boundary), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_status(contents_of_boundary(h.boundary), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(h.model, FEW, four_xyz, four_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  one = contents_of_boundary(h.boundary);
  check_status(one, HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(h.topology, h.boundary, NULL), HSP_OK);
  check_status(contents_of_topology(h.topology), HSP_OK);
  check_scene("no model");
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_status(contents_of_boundary(h.boundary), HSP_E_STATE);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  check_same_contents(&one, contents_of_boundary(h.boundary));
  check_status(contents_of_topology(h.topology), HSP_OK);
  check_scene("too small");
  four_handles_set(&h, BALLS);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_E_CAPACITY);
  check_status(contents_of_boundary(h.boundary), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_status(contents_of_boundary(h.boundary), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(h.model, FEW, four_xyz, four_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  check_same_contents(&one, contents_of_boundary(h.boundary));
  check_scene("%s", "");
}

static void failed_topology(void) {
  const four_handles h = four_handles_make(FEW);
  hsp_boundary_limits limits = four_boundary_limits(BALLS);
  hsp_boundary *empty = NULL;
  contents one;
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_compute(h.topology, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_compute(h.topology, h.boundary, NULL), HSP_E_STATE);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(h.model, FEW, four_xyz, four_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(h.topology, h.boundary, NULL), HSP_OK);
  one = contents_of_topology(h.topology);
  check_status(one, HSP_OK);
  check_scene("no boundary");
  CHECK_EQUAL(hsp_topology_compute(h.topology, NULL, NULL), HSP_E_ARGUMENT);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_onext(h.topology, 0), HSP_NONE);
  CHECK_EQUAL(hsp_topology_compute(h.topology, h.boundary, NULL), HSP_OK);
  check_same_contents(&one, contents_of_topology(h.topology));
  check_scene("a boundary without results");
  CHECK_EQUAL(hsp_boundary_init(small_memory, SIZE, &limits, &empty), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(h.topology, empty, NULL), HSP_E_STATE);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  check_scene("too small");
  four_handles_set(&h, BALLS);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(h.topology, h.boundary, NULL), HSP_E_CAPACITY);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_compute(h.topology, empty, NULL), HSP_E_STATE);
  check_status(contents_of_topology(h.topology), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(h.model, FEW, four_xyz, four_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(h.topology, h.boundary, NULL), HSP_OK);
  check_same_contents(&one, contents_of_topology(h.topology));
  check_scene("%s", "");
}

/* Every way in which a view is refused, from a view that holds results and from one that was too small. */
static void failed_view(void) {
  const four_handles h = four_handles_make(FEW);
  hsp_model *other = NULL;
  contents one;
  int refusal, too_small;
  check_status(contents_of_view(h.view), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_init(other_memory, SIZE, BALLS, &other), HSP_OK);
  CHECK_EQUAL(hsp_model_set(other, FEW, four_xyz, four_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_view_compute(h.view, other, NULL, NULL, NULL), HSP_OK);
  one = contents_of_view(h.view);
  check_status(one, HSP_OK);
  four_handles_set(&h, BALLS);
  for (too_small = 0; too_small < 2; ++too_small) {
    static const int32_t expected[] = {HSP_E_ARGUMENT,   HSP_E_VERSION,   HSP_E_ARGUMENT, HSP_E_ARGUMENT,
                                       HSP_E_VERSION,    HSP_E_ARGUMENT,  HSP_E_ARGUMENT, HSP_E_STATE,
                                       HSP_E_NOT_FINITE, HSP_E_NOT_FINITE};
    for (refusal = 0; refusal < 10; ++refusal) {
      const hsp_model *from = other;
      const hsp_boundary *cut_from = NULL;
      hsp_view_options options;
      check_scene("refusal %d, too small before: %d", refusal, too_small);
      CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
      CHECK_EQUAL(hsp_view_compute(h.view, too_small ? h.model : other, NULL, NULL, NULL),
                  too_small ? HSP_E_CAPACITY : HSP_OK);
      check_status(contents_of_view(h.view), too_small ? HSP_E_STATE : HSP_OK);
      CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
      if (refusal == 0) from = NULL;
      if (refusal == 1) options.struct_size = 0;
      if (refusal == 2) options.pieces = 2;
      if (refusal == 3) options.flags = 2;
      if (refusal == 4) options.reserved = 1;
      if (refusal == 5) options.pieces = HSP_PIECES_OUTSIDE_ALL;
      if (refusal == 6) cut_from = h.boundary;
      if (refusal == 7) {
        CHECK_EQUAL(hsp_boundary_compute(h.boundary, NULL, NULL), HSP_E_ARGUMENT);
        cut_from = h.boundary;
      }
      if (refusal == 8) options.towards[1] = NAN;
      if (refusal == 9) options.up[2] = INFINITY;
      CHECK_EQUAL(hsp_view_compute(h.view, from, cut_from, &options, NULL), expected[refusal]);
      check_status(contents_of_view(h.view), HSP_E_STATE);
    }
  }
  CHECK_EQUAL(hsp_view_compute(h.view, other, NULL, NULL, NULL), HSP_OK);
  check_same_contents(&one, contents_of_view(h.view));
  check_scene("%s", "");
}

static void failed_surface(void) {
  const four_handles h = four_handles_make(FEW);
  const fifth_handles f = fifth_handles_make(FEW);
  const hsp_boundary_limits limits = four_boundary_limits(BALLS);
  const uint32_t no_shell = HSP_NONE, shell = 0;
  hsp_boundary *empty = NULL;
  contents one, triangles;
  check_status(contents_of_surface(f.surface), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_compute(f.surface, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_surface_compute(f.surface, h.boundary, NULL), HSP_E_STATE);
  check_status(contents_of_surface(f.surface), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(h.model, FEW, four_xyz, four_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_surface_compute(f.surface, h.boundary, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_compute_surface(f.mesh, f.surface, 2, NULL), HSP_OK);
  one = contents_of_surface(f.surface);
  triangles = contents_of_mesh(f.mesh);
  check_status(one, HSP_OK);
  check_status(triangles, HSP_OK);
  check_scene("no boundary");
  CHECK_EQUAL(hsp_surface_compute(f.surface, NULL, NULL), HSP_E_ARGUMENT);
  check_status(contents_of_surface(f.surface), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_next(f.surface, 0), HSP_NONE);
  check_same_contents(&triangles, contents_of_mesh(f.mesh)); /* they are of the boundary */
  CHECK_EQUAL(hsp_surface_compute(f.surface, h.boundary, NULL), HSP_OK);
  check_same_contents(&one, contents_of_surface(f.surface));
  check_scene("a shell that is not there");
  CHECK_EQUAL(hsp_surface_compute_shells(f.surface, h.boundary, &no_shell, 1, NULL), HSP_E_ID);
  check_status(contents_of_surface(f.surface), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_compute_shells(f.surface, h.boundary, &shell, 1, NULL), HSP_OK);
  check_same_contents(&one, contents_of_surface(f.surface));
  check_scene("a boundary without results");
  CHECK_EQUAL(hsp_boundary_init(small_memory, SIZE, &limits, &empty), HSP_OK);
  CHECK_EQUAL(hsp_surface_compute(f.surface, empty, NULL), HSP_E_STATE);
  check_status(contents_of_surface(f.surface), HSP_E_STATE);
  check_scene("too small");
  four_handles_set(&h, BALLS);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  check_status(contents_of_mesh(f.mesh), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_compute(f.surface, h.boundary, NULL), HSP_E_CAPACITY);
  check_status(contents_of_surface(f.surface), HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_compute_surface(f.mesh, f.surface, 2, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_compute(f.surface, empty, NULL), HSP_E_STATE);
  check_status(contents_of_surface(f.surface), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(h.model, FEW, four_xyz, four_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_surface_compute(f.surface, h.boundary, NULL), HSP_OK);
  check_same_contents(&one, contents_of_surface(f.surface));
  check_scene("%s", "");
}

/* Every way in which triangles are refused, from a mesh that holds results and from one that was too small. */
static void failed_mesh(void) {
  const four_handles h = four_handles_make(BALLS);
  const fifth_handles f = fifth_handles_make(BALLS);
  const hsp_surface_limits limits = four_surface_limits(BALLS);
  hsp_surface *empty = NULL;
  contents one;
  int refusal, too_small;
  check_status(contents_of_mesh(f.mesh), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_init(small_memory, SIZE, &limits, &empty), HSP_OK);
  four_handles_compute(&h);
  CHECK_EQUAL(hsp_surface_compute(f.surface, h.boundary, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_compute(f.mesh, h.boundary, 2, NULL), HSP_OK);
  one = contents_of_mesh(f.mesh);
  check_status(one, HSP_OK);
  for (too_small = 0; too_small < 2; ++too_small) {
    static const int32_t expected[] = {HSP_E_ARGUMENT,   HSP_E_ARGUMENT, HSP_E_ARGUMENT, HSP_E_ARGUMENT,
                                       HSP_E_NOT_FINITE, HSP_E_RANGE,    HSP_E_STATE,    HSP_E_NOT_FINITE};
    for (refusal = 0; refusal < 8; ++refusal) {
      int32_t status = HSP_OK;
      check_scene("refusal %d, too small before: %d", refusal, too_small);
      CHECK_EQUAL(hsp_mesh_compute(f.mesh, h.boundary, too_small ? 0.05 : 2, NULL),
                  too_small ? HSP_E_CAPACITY : HSP_OK);
      check_status(contents_of_mesh(f.mesh), too_small ? HSP_E_STATE : HSP_OK);
      if (refusal == 0) status = hsp_mesh_compute(f.mesh, NULL, 2, NULL);
      if (refusal == 1) status = hsp_mesh_compute(f.mesh, h.boundary, 0, NULL);
      if (refusal == 2) status = hsp_mesh_compute_surface(f.mesh, NULL, 2, NULL);
      if (refusal == 3) status = hsp_mesh_compute_surface(f.mesh, f.surface, -1, NULL);
      if (refusal == 4) status = hsp_mesh_compute(f.mesh, h.boundary, NAN, NULL);
      if (refusal == 5) status = hsp_mesh_compute(f.mesh, h.boundary, 1e-12, NULL);
      if (refusal == 6) status = hsp_mesh_compute_surface(f.mesh, empty, 2, NULL);
      if (refusal == 7) status = hsp_mesh_compute_surface(f.mesh, f.surface, INFINITY, NULL);
      CHECK_EQUAL(status, expected[refusal]);
      check_status(contents_of_mesh(f.mesh), HSP_E_STATE);
    }
  }
  CHECK_EQUAL(hsp_mesh_compute(f.mesh, h.boundary, 2, NULL), HSP_OK);
  check_same_contents(&one, contents_of_mesh(f.mesh));
  check_scene("%s", "");
}

/* Every way in which a map is refused. */
static void failed_map(void) {
  const four_handles h = four_handles_make(FEW);
  hsp_model *other = NULL;
  contents one;
  int refusal, too_small;
  check_status(contents_of_map(h.map), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_init(other_memory, SIZE, BALLS, &other), HSP_OK);
  CHECK_EQUAL(hsp_model_set(other, FEW, four_xyz, four_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_map_compute(h.map, other, NULL, NULL), HSP_OK);
  one = contents_of_map(h.map);
  check_status(one, HSP_OK);
  four_handles_set(&h, BALLS);
  for (too_small = 0; too_small < 2; ++too_small) {
    static const int32_t expected[] = {HSP_E_ARGUMENT, HSP_E_VERSION,    HSP_E_ARGUMENT,
                                       HSP_E_VERSION,  HSP_E_NOT_FINITE, HSP_E_NOT_FINITE};
    for (refusal = 0; refusal < 6; ++refusal) {
      hsp_view_options options;
      check_scene("refusal %d of a map, too small before: %d", refusal, too_small);
      CHECK_EQUAL(hsp_map_compute(h.map, too_small ? h.model : other, NULL, NULL), too_small ? HSP_E_CAPACITY : HSP_OK);
      check_status(contents_of_map(h.map), too_small ? HSP_E_STATE : HSP_OK);
      CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
      if (refusal == 1) options.struct_size = 0;
      if (refusal == 2) options.pieces = 2;
      if (refusal == 3) options.reserved = 1;
      if (refusal == 4) options.towards[1] = NAN;
      if (refusal == 5) options.up[2] = INFINITY;
      CHECK_EQUAL(hsp_map_compute(h.map, refusal == 0 ? NULL : other, &options, NULL), expected[refusal]);
      check_status(contents_of_map(h.map), HSP_E_STATE);
      CHECK_EQUAL(hsp_map_next(h.map, 0), HSP_NONE);
    }
  }
  CHECK_EQUAL(hsp_map_compute(h.map, other, NULL, NULL), HSP_OK);
  check_same_contents(&one, contents_of_map(h.map));
  check_scene("%s", "");
}

int main(void) {
  failed_set();
  failed_set_behind_results();
  failed_boundary();
  failed_topology();
  failed_view();
  failed_map();
  failed_surface();
  failed_mesh();
  return check_report();
}
