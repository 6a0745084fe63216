/* Every argument of the mesh's functions that the header refuses, and every call out of order. */
#include <hardsphere.h>
#include <math.h>

#include "ball_sets.h"
#include "check.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS, SPHERES = BALLS + 4, CURVES = 32, VERTICES = 600, TRIANGLES = 1200, POINTS = 300 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static unsigned char surface_memory[HSP_SURFACE_BYTES(16, 16, 16, 16, 64, 16)];
static unsigned char mesh_memory[HSP_MESH_BYTES(SPHERES, CURVES, VERTICES, TRIANGLES, POINTS)];
static hsp_model *model;
static hsp_boundary *boundary;
static hsp_surface *surface;
static hsp_mesh *mesh;
static double edge; /* less than half the first ball's radius */

static hsp_mesh_limits limits;
static hsp_mesh_counts counts;
static double xyz[3 * VERTICES], normals[3 * VERTICES], areas[VERTICES];
static uint32_t vertex_balls[VERTICES];
static uint32_t corners[3 * TRIANGLES], kinds[TRIANGLES], patches[TRIANGLES], balls[TRIANGLES];
static uint32_t needed;

static void fill_outputs(void) {
  FILL(limits);
  FILL(counts);
  FILL(xyz);
  FILL(normals);
  FILL(areas);
  FILL(vertex_balls);
  FILL(corners);
  FILL(kinds);
  FILL(patches);
  FILL(balls);
  FILL(needed);
}

static void check_arrays_untouched(void) {
  CHECK_UNTOUCHED(limits);
  CHECK_UNTOUCHED(counts);
  CHECK_UNTOUCHED(xyz);
  CHECK_UNTOUCHED(normals);
  CHECK_UNTOUCHED(areas);
  CHECK_UNTOUCHED(vertex_balls);
  CHECK_UNTOUCHED(corners);
  CHECK_UNTOUCHED(kinds);
  CHECK_UNTOUCHED(patches);
  CHECK_UNTOUCHED(balls);
}

/* All reading functions with good arguments must say `status` and write nothing. */
static void check_all_readers(const hsp_mesh *which, int32_t status) {
  fill_outputs();
  CHECK_EQUAL(hsp_mesh_get_counts(which, &counts), status);
  CHECK_EQUAL(hsp_mesh_get_vertices(which, xyz, normals, areas, vertex_balls, VERTICES, &needed), status);
  CHECK_EQUAL(hsp_mesh_get_triangles(which, corners, kinds, patches, balls, TRIANGLES, &needed), status);
  CHECK_EQUAL(hsp_mesh_get_vertices(which, NULL, NULL, NULL, NULL, 0, NULL), status);
  CHECK_EQUAL(hsp_mesh_get_triangles(which, NULL, NULL, NULL, NULL, 0, NULL), status);
  CHECK_EQUAL(hsp_mesh_get_patch(which, 0, &needed, &needed), status);
  check_arrays_untouched();
  CHECK_UNTOUCHED(needed);
}

static void check_has_results(void) {
  CHECK_EQUAL(hsp_mesh_get_counts(mesh, &counts), HSP_OK);
  CHECK(counts.vertices > 20 && counts.triangles == 2 * (counts.vertices - 2));
  CHECK_EQUAL(hsp_mesh_get_vertices(mesh, NULL, NULL, NULL, NULL, 0, &needed), HSP_OK);
  CHECK_EQUAL(needed, counts.vertices);
  CHECK_EQUAL(hsp_mesh_get_triangles(mesh, NULL, NULL, NULL, NULL, 0, &needed), HSP_OK);
  CHECK_EQUAL(needed, counts.triangles);
}

static void set_balls(void) {
  hsp_model_options options;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = 0.5 * three_balls_radius[0];
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, &options, NULL), HSP_OK);
  edge = 0.4 * three_balls_radius[0];
}

static hsp_mesh_limits good_limits(void) {
  const hsp_mesh_limits good = {(uint32_t)sizeof good, SPHERES, CURVES, VERTICES, TRIANGLES, POINTS};
  return good;
}

static void make_mesh(void) {
  const hsp_mesh_limits good = good_limits();
  CHECK_EQUAL(hsp_mesh_init(mesh_memory, sizeof mesh_memory, &good, &mesh), HSP_OK);
}

static void refused_limits(void) {
  hsp_mesh_limits bad;
  size_t bytes = 0;
  hsp_mesh *made = NULL;
  int which;
  CHECK_EQUAL(hsp_mesh_bytes(NULL, &bytes), HSP_E_ARGUMENT);
  for (which = 0; which < 7; ++which) {
    const int32_t status = which < 2 ? HSP_E_VERSION : HSP_E_RANGE;
    bad = good_limits();
    if (which == 0) bad.struct_size = 12;
    if (which == 1) bad.struct_size = 1028;
    if (which == 2) bad.balls = HSP_MAX_BALLS + 1;
    if (which == 3) bad.curves = HSP_MAX_BALLS + 1;
    if (which == 4) bad.vertices = HSP_NONE;
    if (which == 5) bad.triangles = HSP_MAX_BALLS + 1;
    if (which == 6) bad.points = HSP_NONE;
    CHECK_EQUAL(hsp_mesh_bytes(&bad, &bytes), status);
    CHECK_EQUAL(hsp_mesh_init(mesh_memory, sizeof mesh_memory, &bad, &made), status);
  }
  bad = good_limits();
  CHECK_EQUAL(hsp_mesh_bytes(&bad, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(bytes, 0);
  CHECK_EQUAL(hsp_mesh_bytes(&bad, &bytes), HSP_OK);
  CHECK(bytes <= sizeof mesh_memory);
  CHECK_EQUAL(hsp_mesh_init(NULL, bytes, &bad, &made), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_init(mesh_memory, bytes, NULL, &made), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_init(mesh_memory, bytes, &bad, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_init(mesh_memory, bytes - 1, &bad, &made), HSP_E_MEMORY);
  CHECK(made == NULL);
}

static void defaults(void) {
  const uint32_t size = (uint32_t)sizeof limits;
  fill_outputs();
  CHECK_EQUAL(hsp_mesh_limits_init(NULL, size, boundary, edge), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, 8, boundary, edge), HSP_E_VERSION);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, NULL, edge), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, edge), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, 0.0), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, -1.0), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, (double)NAN), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, (double)INFINITY), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, 1e-6 * edge), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, 1e-300), HSP_E_RANGE);
  check_arrays_untouched();
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, edge), HSP_OK);
  CHECK(limits.struct_size == size && limits.balls == BALLS && limits.vertices > 20);
}

static void surface_defaults(void) {
  const uint32_t size = (uint32_t)sizeof limits;
  fill_outputs();
  CHECK_EQUAL(hsp_mesh_limits_init_surface(NULL, size, surface, edge), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, 8, surface, edge), HSP_E_VERSION);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, NULL, edge), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, edge), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_compute(surface, boundary, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, 0.0), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, (double)NAN), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, 1e-6 * edge), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, 1e-300), HSP_E_RANGE);
  check_arrays_untouched();
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, edge), HSP_OK);
  CHECK(limits.struct_size == size && limits.balls > BALLS && limits.vertices > 20);
}

static void computing_surface(void) {
  hsp_mesh_limits asked = good_limits();
  uint32_t first = 0, count = 0;
  CHECK_EQUAL(hsp_mesh_compute_surface(NULL, surface, edge, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, NULL, edge, NULL), HSP_E_ARGUMENT);
  check_all_readers(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, edge, &asked), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_mesh_get_patch(mesh, 0, NULL, &count), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_get_patch(mesh, 0, &first, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_get_patch(mesh, 0, &first, &count), HSP_OK);
  CHECK(first == 0 && count > 0);
  CHECK_EQUAL(hsp_mesh_get_patch(mesh, HSP_NONE, &first, &count), HSP_OK);
  CHECK_EQUAL(count, 0);
  asked.struct_size = 4;
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, edge, &asked), HSP_E_VERSION);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, 0.0, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, (double)NAN, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, 1e-300, NULL), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, edge / 32, NULL), HSP_E_CAPACITY);
  check_all_readers(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, edge, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
}

static void computing(void) {
  hsp_mesh_limits asked = good_limits();
  check_all_readers(NULL, HSP_E_ARGUMENT);
  make_mesh();
  check_all_readers(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_compute(NULL, boundary, edge, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute(mesh, NULL, edge, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, &asked), HSP_OK);
  check_has_results();
  CHECK(asked.vertices <= VERTICES && asked.points <= POINTS);
  asked.struct_size = 4;
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, &asked), HSP_E_VERSION);
  check_all_readers(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, 0.0, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, -edge, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, (double)NAN, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, (double)-INFINITY, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, 1e-300, NULL), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge / 32, NULL), HSP_E_CAPACITY);
  check_all_readers(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_mesh_get_counts(mesh, NULL), HSP_E_ARGUMENT);
}

/* One record too few, in each array alone. */
static void capacities(void) {
  const uint32_t v = counts.vertices - 1, t = counts.triangles - 1;
  fill_outputs();
  CHECK_EQUAL(hsp_mesh_get_vertices(mesh, xyz, NULL, NULL, NULL, v, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, v + 1);
  CHECK_EQUAL(hsp_mesh_get_vertices(mesh, NULL, normals, NULL, NULL, v, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_mesh_get_vertices(mesh, NULL, NULL, areas, NULL, v, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_mesh_get_vertices(mesh, NULL, NULL, NULL, vertex_balls, v, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_mesh_get_triangles(mesh, corners, NULL, NULL, NULL, t, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, t + 1);
  CHECK_EQUAL(hsp_mesh_get_triangles(mesh, NULL, kinds, NULL, NULL, t, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_mesh_get_triangles(mesh, NULL, NULL, patches, NULL, t, NULL), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_mesh_get_triangles(mesh, NULL, NULL, NULL, balls, t, NULL), HSP_E_CAPACITY);
  check_arrays_untouched();
  CHECK_EQUAL(hsp_mesh_get_vertices(mesh, xyz, normals, areas, vertex_balls, v + 1, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_get_triangles(mesh, corners, kinds, patches, balls, t + 1, NULL), HSP_OK);
}

/* What lies behind a mesh changes: it must not be read. */
static void changes(void) {
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_all_readers(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_all_readers(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_E_STATE);
  set_balls();
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_OK);
  check_has_results();
  check_all_readers((const hsp_mesh *)(const void *)boundary, HSP_E_HANDLE);
}

int main(void) {
  const hsp_surface_limits of_surface = {(uint32_t)sizeof of_surface, 16, 16, 16, 16, 64, 16};
  const hsp_boundary_limits of_boundary = {(uint32_t)sizeof of_boundary, BALLS, BALLS, 16, 16, 0};
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &of_boundary, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_surface_init(surface_memory, sizeof surface_memory, &of_surface, &surface), HSP_OK);
  set_balls();
  refused_limits();
  defaults();
  computing();
  surface_defaults();
  computing_surface();
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_OK);
  check_has_results();
  capacities();
  changes();
  return check_report();
}
