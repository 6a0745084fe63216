/* Derivatives, morphometric energies and what boxes have of them, by executors: the same bits for any number of workers
 * and any order of their tasks, and loops that break the rules. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "computed.h"
#include "gradients.h"
#include "loops.h"
#include "periodic_result.h"

typedef struct numbers {
  hsp_energy energy;
  hsp_morphometric_energy morphometric;
  double centre[3 * BALL_SET_MOST], radius[BALL_SET_MOST], more_centre[3 * BALL_SET_MOST], more_radius[BALL_SET_MOST];
  double strain[9], box[9], area[BALL_SET_MOST];
  uint32_t flags[BALL_SET_MOST];
} numbers;

static double sigma[BALL_SET_MOST];

static int32_t get_derivatives(const void *boundary, uint32_t n, const hsp_executor *executor, numbers *x) {
  hsp_derivatives_outputs out = {.struct_size = sizeof out,
                                 .capacity = n,
                                 .area_centre = x->centre,
                                 .area_radius = x->radius,
                                 .volume_centre = x->more_centre,
                                 .volume_radius = x->more_radius,
                                 .flags = x->flags};
  return hsp_boundary_get_derivatives(boundary, SIZED(hsp_derivatives_request, .sigma = sigma, .executor = executor),
                                      &out);
}

static int32_t get_morphometry(const void *boundary, uint32_t n, const hsp_executor *executor, numbers *x) {
  hsp_morphometry_outputs out = {.struct_size = sizeof out,
                                 .capacity = n,
                                 .energy = &x->morphometric,
                                 .d_centre = x->centre,
                                 .d_radius = x->radius,
                                 .flags = x->flags,
                                 .area = x->area};
  return hsp_boundary_get_morphometry(boundary,
                                      SIZED(hsp_morphometry_request, .pressure = -0.5, .tension = 1.5, .bending = 0.75,
                                            .gaussian = 2, .sigma = sigma, .executor = executor),
                                      &out);
}

static int32_t get_gradient_in_box(const void *periodic, uint32_t n, const hsp_executor *executor, numbers *x) {
  hsp_periodic_gradient_outputs out = {.struct_size = sizeof out,
                                       .capacity = n,
                                       .energy = &x->energy,
                                       .d_centre = x->centre,
                                       .d_radius = x->radius,
                                       .flags = x->flags,
                                       .d_strain = x->strain,
                                       .d_box = x->box};
  return hsp_periodic_get_gradient(
      periodic, SIZED(hsp_gradient_request, .tension = 0.7, .pressure = -1.3, .sigma = sigma, .executor = executor),
      &out);
}

static int32_t get_morphometry_in_box(const void *periodic, uint32_t n, const hsp_executor *executor, numbers *x) {
  hsp_periodic_morphometry_outputs out = {.struct_size = sizeof out,
                                          .capacity = n,
                                          .energy = &x->morphometric,
                                          .d_centre = x->centre,
                                          .d_radius = x->radius,
                                          .flags = x->flags,
                                          .d_strain = x->strain,
                                          .d_box = x->box,
                                          .area = x->area};
  return hsp_periodic_get_morphometry(periodic,
                                      SIZED(hsp_morphometry_request, .pressure = -0.5, .tension = 1.5, .bending = 0.75,
                                            .gaussian = 2, .sigma = sigma, .executor = executor),
                                      &out);
}

static const struct {
  const char *name;
  int32_t (*get)(const void *handle, uint32_t n, const hsp_executor *executor, numbers *x);
  int in_box;
} functions[] = {
    {"derivatives", get_derivatives, 0},
    {"morphometry", get_morphometry, 0},
    {"gradient in a box", get_gradient_in_box, 1},
    {"morphometry in a box", get_morphometry_in_box, 1},
};

static void check_function(size_t which, const void *handle, const ball_set *set) {
  static numbers alone, shared;
  uint32_t workers;
  int way;
  memset(&alone, 0x5A, sizeof alone);
  CHECK_EQUAL(functions[which].get(handle, set->n, NULL, &alone), HSP_OK);
  for (workers = 0; workers <= 9; ++workers) {
    loop own = loop_of(LOOP_SHUFFLED);
    const hsp_executor executor = executor_of(&own, workers);
    check_scene("%s of %s by %u workers", functions[which].name, set->name, (unsigned)workers);
    memset(&shared, 0x5A, sizeof shared);
    CHECK_EQUAL(functions[which].get(handle, set->n, &executor, &shared), HSP_OK);
    CHECK_BYTES(&shared, &alone, sizeof alone);
    /* More balls than are worth two tasks. */
    CHECK_EQUAL(own.runs, workers > 1 && set->n > 64);
    CHECK(own.most_tasks > 1 || own.runs == 0);
  }
  for (way = LOOP_RIGHT_WAYS; way < LOOP_WAYS && set->n > 64; ++way) {
    loop own = loop_of(way);
    const hsp_executor executor = executor_of(&own, 4);
    check_scene("%s of %s by wrong way %d", functions[which].name, set->name, way);
    CHECK_EQUAL(functions[which].get(handle, set->n, &executor, &shared), HSP_E_EXECUTOR);
  }
}

static void check_set(const ball_set *set) {
  computed c;
  periodic_result p;
  size_t which;
  uint32_t i;
  for (i = 0; i < set->n; ++i) sigma[i] = i % 4 == 1 ? 0 : 0.75 * i - 2;
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &c), HSP_OK)) {
    if (CHECK_EQUAL(periodic_result_make(&c, &p), HSP_OK)) {
      for (which = 0; which < sizeof functions / sizeof *functions; ++which) {
        check_function(which, functions[which].in_box ? (const void *)p.periodic : (const void *)c.boundary, set);
      }
    }
    periodic_result_release(&p);
  }
  computed_release(&c);
}

int main(void) {
  static ball_set set;
  ball_set_make(3, &set);
  check_set(&set);
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, BALL_SET_MOST, 77);
  check_set(&set);
  return check_report();
}
