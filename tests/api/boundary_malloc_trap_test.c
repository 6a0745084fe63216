/* The library never allocates: malloc and its relatives are replaced by functions that end the program while armed, and
 * every entry point is called armed. For glibc only, and not for sanitizer builds, which bring their own malloc. */
#include <hardsphere.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "malloc_trap.h"

enum { BALLS = 60, VERTICES = 8 * BALLS + 64, CIRCLES = 2 * BALLS + 16 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, VERTICES, CIRCLES)];
static hsp_vertex vertices[VERTICES];
static hsp_arc arcs[2 * VERTICES];
static hsp_circle circles[CIRCLES];
static hsp_face faces[2 * VERTICES];
static hsp_ball balls[BALLS];
static double area[BALLS], volume[BALLS];
static double face_area[2 * VERTICES], face_volume[2 * VERTICES];
static double by_centre[3 * BALLS], by_radius[BALLS];
static uint32_t flags[BALLS];
static hsp_area_derivative row[BALLS];
static const uint8_t selected[BALLS] = {1, 0, 1};

/* Every entry point but the topology's, which have a test of their own; the number of calls that did not succeed. */
static int call_everything(const ball_set *set) {
  hsp_model *model = NULL;
  hsp_boundary *boundary = NULL;
  hsp_model_options options;
  hsp_model_info info;
  hsp_figures figures;
  hsp_boundary_limits limits, needed_limits;
  hsp_boundary_counts counts;
  hsp_totals totals;
  hsp_energy energy;
  uint32_t ids[BALLS], needed, law, where;
  int32_t meets;
  size_t bytes;
  int bad = 0;
  bad += hsp_version() != HSP_VERSION_NUMBER;
  bad += hsp_status_text(HSP_OK) == NULL;
  bad += hsp_model_bytes(BALLS, &bytes) != HSP_OK;
  bad += hsp_model_init(model_memory, sizeof model_memory, BALLS, &model) != HSP_OK;
  bad += hsp_model_options_init(&options, (uint32_t)sizeof options) != HSP_OK;
  bad += hsp_model_set(model, set->n, set->xyz, set->radius, &options, NULL) != HSP_OK;
  bad += hsp_model_get_info(model, &info) != HSP_OK;
  bad += hsp_model_get_figures(model, &figures) != HSP_OK;
  bad += hsp_query_point(model, set->xyz, ids, BALLS, &needed) != HSP_OK;
  bad += hsp_query_ball(model, set->xyz, 3, ids, BALLS, &needed) != HSP_OK;
  bad += hsp_query_meets(model, set->xyz, 3, &meets) != HSP_OK;
  bad += hsp_query_neighbours(model, 0, ids, BALLS, &needed) != HSP_OK;
  bad += hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, BALLS) != HSP_OK;
  bad += hsp_boundary_bytes(&limits, &bytes) != HSP_OK;
  bad += hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary) != HSP_OK;
  bad += hsp_boundary_compute(boundary, model) != HSP_OK;
  bad += hsp_boundary_get_needed(boundary, &needed_limits) != HSP_OK;
  bad += hsp_boundary_get_counts(boundary, &counts) != HSP_OK;
  bad += hsp_boundary_get_vertices(boundary, vertices, VERTICES, &needed) != HSP_OK;
  bad += hsp_boundary_get_arcs(boundary, arcs, 2 * VERTICES, &needed) != HSP_OK;
  bad += hsp_boundary_get_circles(boundary, circles, CIRCLES, &needed) != HSP_OK;
  bad += hsp_boundary_get_faces(boundary, faces, 2 * VERTICES, &needed) != HSP_OK;
  bad += hsp_boundary_get_balls(boundary, balls, BALLS, &needed) != HSP_OK;
  bad += hsp_boundary_measure(boundary, &totals, area, volume, BALLS) != HSP_OK;
  bad += hsp_boundary_measure_selected(boundary, selected, &totals, area, volume, BALLS) != HSP_OK;
  bad += hsp_boundary_measure_faces(boundary, face_area, face_volume, 2 * VERTICES) != HSP_OK;
  bad += hsp_boundary_gradient(boundary, NULL, 1, 1, HSP_TANGENT_MEETING, &energy, by_centre, by_radius, flags,
                               BALLS) != HSP_OK;
  bad += hsp_boundary_get_area_row(boundary, 0, HSP_TANGENT_APART, row, BALLS, &needed) != HSP_OK;
  bad += hsp_boundary_check(boundary, &law, &where) != HSP_OK;
  return bad;
}

int main(void) {
  static ball_set set;
  uint32_t which;
  void *volatile bait;
  armed = 1;
  bait = malloc(10);
  free(bait);
  armed = 0;
  CHECK_EQUAL(caught, 2);
  for (which = 0; which < ball_set_count(); ++which) {
    int bad, allocations;
    ball_set_make(which, &set);
    if (set.n == 0 || set.n > BALLS) continue;
    caught = 0;
    armed = 1;
    bad = call_everything(&set);
    armed = 0;
    allocations = caught;
    check_scene("%s", set.name);
    CHECK_EQUAL(bad, 0);
    CHECK_EQUAL(allocations, 0);
  }
  return check_report();
}
