/* Ranges and shells of the surface, and every call of its functions out of order. */
#include <hardsphere.h>
#include <math.h>

#include "ball_sets.h"
#include "check.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS, VERTICES = 8, FACES = 6, NEIGHBOURS = 4, PIECES = 8, ARCS = 32, CUSPED = 3 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static unsigned char surface_memory[HSP_SURFACE_BYTES(VERTICES, FACES, NEIGHBOURS, PIECES, ARCS, CUSPED)];
static hsp_model *model;
static hsp_boundary *boundary;
static hsp_surface *surface;

static hsp_surface_limits limits;
static hsp_surface_counts counts;
static hsp_surface_totals totals, balls[BALLS];
static hsp_energy energy;
static double d_centre[3 * BALLS], d_radius[BALLS];
static uint32_t flags[BALLS];
static hsp_surface_part_counts map;
static hsp_surface_patch patches[4];
static hsp_surface_edge edges[4];
static hsp_surface_corner corners[4];
static hsp_surface_shell shells[2];
static uint32_t needed, first_bad, invariant, id;
static double sigma[BALLS] = {1, -2, 0.5};

/* hsp_surface_get_gradient with all outputs. */
static int32_t weighted_with(const hsp_surface *which, double tension, double pressure, uint32_t capacity) {
  hsp_gradient_outputs all = {.struct_size = sizeof all,
                              .capacity = capacity,
                              .energy = &energy,
                              .d_centre = d_centre,
                              .d_radius = d_radius,
                              .flags = flags};
  const int32_t status = hsp_surface_get_gradient(
      which, SIZED(hsp_gradient_request, .sigma = sigma, .tension = tension, .pressure = pressure), &all);
  needed = all.needed;
  first_bad = all.first_bad;
  return status;
}

static void check_reading(const hsp_surface *which, int32_t status) {
  CHECK_EQUAL(hsp_surface_get_counts(which, &counts), status);
}

static void check_has_results(void) {
  CHECK_EQUAL(hsp_surface_get_counts(surface, &counts), HSP_OK);
  CHECK_EQUAL(counts.concave_patches, 2);
  CHECK_EQUAL(hsp_surface_measure(surface, &totals, balls, BALLS, &needed), HSP_OK);
  CHECK(totals.area > 0.0 && needed == BALLS);
  CHECK_EQUAL(hsp_surface_get_gradient(surface, SIZED(hsp_gradient_request, .tension = 1, .pressure = 1),
                                       SIZED(hsp_gradient_outputs, .energy = &energy, .d_centre = d_centre,
                                             .d_radius = d_radius, .flags = flags, .capacity = BALLS)),
              HSP_OK);
  CHECK_NEAR(energy.value, totals.area + totals.volume, 1e-12 * energy.value);
  /* Balls that touch overlap here. */
  CHECK_EQUAL(hsp_surface_get_gradient(surface, SIZED(hsp_gradient_request, .tangency = HSP_TANGENT_DISJOINT),
                                       SIZED(hsp_gradient_outputs, .capacity = 0)),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_surface_get_gradient(surface, SIZED(hsp_gradient_request, .tension = 1, .pressure = 1),
                                       SIZED(hsp_gradient_outputs, .capacity = 0)),
              HSP_OK);
  CHECK_EQUAL(weighted_with(surface, 1, 1, BALLS), HSP_OK);
  CHECK(needed == BALLS && first_bad == HSP_NONE);
  CHECK_NEAR(energy.area, balls[0].area - 2 * balls[1].area + 0.5 * balls[2].area, 1e-12 * totals.area);
  CHECK_NEAR(energy.value, energy.area + totals.volume, 1e-12 * totals.volume);
  CHECK_EQUAL(
      hsp_surface_get_gradient(surface, SIZED(hsp_gradient_request, .sigma = sigma, .tension = 1, .pressure = 1),
                               SIZED(hsp_gradient_outputs, .capacity = 0)),
      HSP_OK);
  CHECK_EQUAL(hsp_surface_get_part_counts(surface, &map), HSP_OK);
  CHECK_EQUAL(map.shells, 1);
  CHECK_EQUAL(hsp_surface_check(surface, &invariant, &id), HSP_OK);
  CHECK(invariant == 0 && id == HSP_NONE);
}

/* Ranges up to the last record, and beyond it. */
static void ranges(void) {
  check_scene("ranges");
  CHECK_EQUAL(hsp_surface_get_part_counts(surface, &map), HSP_OK);
  CHECK_EQUAL(hsp_surface_get_part_counts(surface, &map), HSP_OK);
  CHECK_EQUAL(hsp_surface_get_patches(surface, map.patches - 1, 2, patches), HSP_E_ID);
  CHECK_EQUAL(hsp_surface_get_edges(surface, map.edges + 1, 0, NULL), HSP_E_ID);
  CHECK_EQUAL(hsp_surface_next(surface, 2 * map.edges), HSP_NONE);
  CHECK_EQUAL(hsp_surface_left(surface, HSP_NONE), HSP_NONE);
  CHECK_EQUAL(hsp_surface_get_patches(surface, map.patches, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_surface_get_patches(surface, map.patches - 1, 1, patches), HSP_OK);
  CHECK_EQUAL(hsp_surface_get_edges(surface, map.edges - 1, 1, edges), HSP_OK);
  CHECK_EQUAL(hsp_surface_get_corners(surface, map.corners - 1, 1, corners), HSP_OK);
  CHECK_EQUAL(hsp_surface_get_shells(surface, shells, 2, &needed), HSP_OK);
}

static void set_balls(void) {
  hsp_model_options options;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = 0.25;
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, &options, NULL), HSP_OK);
}

static hsp_surface_limits good_limits(void) {
  const hsp_surface_limits good = {(uint32_t)sizeof good, VERTICES, FACES, NEIGHBOURS, PIECES, ARCS, CUSPED};
  return good;
}

static void make_surface(void) {
  const hsp_surface_limits good = good_limits();
  CHECK_EQUAL(hsp_surface_init(surface_memory, sizeof surface_memory, &good, &surface), HSP_OK);
}

static void defaults(void) {
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_surface_limits_init(&limits, (uint32_t)sizeof limits, boundary), HSP_OK);
  CHECK_EQUAL(limits.struct_size, sizeof limits);
  CHECK_EQUAL(limits.vertices, 2);
  CHECK_EQUAL(limits.faces, 3);
  CHECK_EQUAL(limits.neighbours, 64);
  CHECK_EQUAL(limits.pieces, 16);
  CHECK_EQUAL(limits.arcs, 66);
  CHECK_EQUAL(limits.cusped_circles, 16);
}

static void out_of_order(void) {
  CHECK_EQUAL(hsp_surface_compute(surface, boundary, NULL), HSP_OK);
  check_has_results();
  ranges();
  check_scene("shells");
  {
    const uint32_t chosen[3] = {0, 0, 1};
    hsp_surface_totals whole, part;
    CHECK_EQUAL(hsp_surface_measure(surface, &whole, NULL, 0, NULL), HSP_OK);
    CHECK_EQUAL(hsp_surface_compute_shells(surface, boundary, chosen, 3, NULL), HSP_E_ID);
    check_reading(surface, HSP_E_STATE);
    CHECK_EQUAL(hsp_surface_compute_shells(surface, boundary, chosen, 2, NULL), HSP_OK);
    check_has_results();
    CHECK_EQUAL(hsp_surface_measure(surface, &part, NULL, 0, NULL), HSP_OK);
    CHECK(memcmp(&whole, &part, sizeof whole) == 0);
    CHECK_EQUAL(hsp_surface_compute_shells(surface, boundary, NULL, 0, NULL), HSP_OK);
    CHECK_EQUAL(hsp_surface_measure(surface, &part, NULL, 0, NULL), HSP_OK);
    CHECK(part.area == 0 && part.volume == 0);
  }

  check_scene("the model has changed");
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_reading(surface, HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_get_gradient(surface, SIZED(hsp_gradient_request, .tangency = HSP_TANGENT_DISJOINT),
                                       SIZED(hsp_gradient_outputs, .capacity = 0)),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_surface_compute(surface, boundary, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_surface_compute_shells(surface, boundary, NULL, 0, NULL), HSP_E_STATE);
  set_balls();
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_surface_compute(surface, boundary, NULL), HSP_OK);
  check_has_results();

  check_scene("the boundary has been computed again");
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_reading(surface, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_surface_compute(surface, boundary, NULL), HSP_OK);
  check_has_results();
}

static void too_small(void) {
  hsp_surface_limits few = {(uint32_t)sizeof few, 1, 2, 0, 0, 0, 0};
  check_scene("a limit is too small");
  CHECK_EQUAL(hsp_surface_init(surface_memory, sizeof surface_memory, &few, &surface), HSP_OK);
  CHECK_EQUAL(hsp_surface_compute(surface, boundary, &few), HSP_E_CAPACITY);
  CHECK_EQUAL(few.vertices, 2);
  CHECK_EQUAL(few.faces, 3);
  CHECK_EQUAL(few.neighbours, 0);
  check_reading(surface, HSP_E_STATE);
}

int main(void) {
  const hsp_boundary_limits of_boundary = {(uint32_t)sizeof of_boundary, BALLS, BALLS, 16, 16, 0};
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  set_balls();
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &of_boundary, &boundary), HSP_OK);
  defaults();
  make_surface();
  out_of_order();
  too_small();
  return check_report();
}
