/* Edges of the mesh that are too long or too short, lengths of any size, and its functions out of order. */
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
static uint32_t needed;

static void check_reading(const hsp_mesh *which, int32_t status) {
  CHECK_EQUAL(hsp_mesh_get_counts(which, &counts), status);
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

static void defaults(void) {
  const uint32_t size = (uint32_t)sizeof limits;
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, 0.0), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, -1.0), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, 1e-6 * edge), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, 1e-300), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_limits_init(&limits, size, boundary, edge), HSP_OK);
  CHECK(limits.struct_size == size && limits.balls == BALLS && limits.vertices > 20);
}

static void surface_defaults(void) {
  const uint32_t size = (uint32_t)sizeof limits;
  CHECK_EQUAL(hsp_surface_compute(surface, boundary, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, 0.0), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, 1e-6 * edge), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, 1e-300), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, size, surface, edge), HSP_OK);
  CHECK(limits.struct_size == size && limits.balls > BALLS && limits.vertices > 20);
}

static void computing_surface(void) {
  hsp_mesh_limits asked = good_limits();
  uint32_t first = 0, count = 0;
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, edge, &asked), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_mesh_get_patch(mesh, 0, &first, &count), HSP_OK);
  CHECK(first == 0 && count > 0);
  CHECK_EQUAL(hsp_mesh_get_patch(mesh, HSP_NONE, &first, &count), HSP_OK);
  CHECK_EQUAL(count, 0);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, 0.0, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, 1e-300, NULL), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, edge / 32, NULL), HSP_E_CAPACITY);
  check_reading(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute_surface(mesh, surface, edge, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
}

static void computing(void) {
  hsp_mesh_limits asked = good_limits();
  make_mesh();
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, &asked), HSP_OK);
  check_has_results();
  CHECK(asked.vertices <= VERTICES && asked.points <= POINTS);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, 0.0, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, -edge, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, 1e-300, NULL), HSP_E_RANGE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge / 32, NULL), HSP_E_CAPACITY);
  check_reading(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_OK);
  check_has_results();
}

/* The handles behind a mesh change: it must not be read. */
static void changes(void) {
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_reading(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_reading(mesh, HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_E_STATE);
  set_balls();
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_OK);
  check_has_results();
}

/* The areas of a mesh, and weights of patches that each have the area 1, both in squares of a step. */
static void measure_on(double step, double *area, double *weight) {
  static const double steps[BALLS][4] = {{0, 0, 0, 2e6}, {3e6, 0, 0, 2e6}, {0, 3e6, 0, 2e6}};
  static double areas[VERTICES], weights[VERTICES];
  const hsp_model_options options = {(uint32_t)sizeof options, 0, 0, step, 0};
  double xyz[3 * BALLS], radius[BALLS], of_patch[32];
  uint32_t k, axis;
  *area = *weight = 0;
  for (k = 0; k < BALLS; ++k) {
    for (axis = 0; axis < 3; ++axis) xyz[3 * k + axis] = steps[k][axis] * step;
    radius[k] = steps[k][3] * step;
  }
  for (k = 0; k < 32; ++k) of_patch[k] = step * step;
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, 9e5 * step, NULL), HSP_OK);
  if (!CHECK_EQUAL(hsp_mesh_get_vertices(mesh, NULL, NULL, areas, NULL, VERTICES, &needed), HSP_OK)) return;
  CHECK_EQUAL(hsp_mesh_get_weights(mesh, of_patch, 32, weights, VERTICES, NULL), HSP_OK);
  for (k = 0; k < needed; ++k) {
    *area += areas[k] / step / step;
    *weight += weights[k] / step / step;
  }
}

/* Lengths scale: also where squares of areas are no doubles. */
static void lengths_of_any_size(void) {
  static const double sizes[6] = {1e-99, 1e-90, 1e-80, 1e65, 1e75, 1e89};
  double area, weight, scaled_area, scaled_weight;
  uint32_t k;
  measure_on(1.0, &area, &weight);
  CHECK_NEAR(weight, 3, 1e-12);
  for (k = 0; k < 6; ++k) {
    measure_on(sizes[k], &scaled_area, &scaled_weight);
    CHECK_NEAR(scaled_area, area, 1e-10 * area);
    CHECK_NEAR(scaled_weight, weight, 1e-12);
  }
}

int main(void) {
  const hsp_surface_limits of_surface = {(uint32_t)sizeof of_surface, 16, 16, 16, 16, 64, 16};
  const hsp_boundary_limits of_boundary = {(uint32_t)sizeof of_boundary, BALLS, BALLS, 16, 16, 0};
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &of_boundary, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_surface_init(surface_memory, sizeof surface_memory, &of_surface, &surface), HSP_OK);
  set_balls();
  defaults();
  computing();
  surface_defaults();
  computing_surface();
  CHECK_EQUAL(hsp_mesh_compute(mesh, boundary, edge, NULL), HSP_OK);
  check_has_results();
  changes();
  lengths_of_any_size();
  return check_report();
}
