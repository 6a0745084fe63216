/* Executors: the same bits of a gradient for any number of workers and any order of their tasks, and what of an
 * executor is refused. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "gradients.h"
#include "loops.h"

static hsp_gradient_outputs outputs_into(uint32_t n, gradients *g) {
  hsp_gradient_outputs outputs = {.struct_size = sizeof(hsp_gradient_outputs)};
  memset(g, 0x5A, sizeof *g);
  outputs.capacity = n;
  outputs.energy = &g->energy;
  outputs.d_centre = g->centre;
  outputs.d_radius = g->radius;
  outputs.flags = g->flags;
  return outputs;
}

/* selected: or NULL for all balls. */
static void every_number_of_workers(const ball_set *set, const uint8_t *selected) {
  static gradients alone, shared;
  static double sigma[BALL_SET_MOST], areas[BALL_SET_MOST], measured[BALL_SET_MOST];
  const uint32_t n = set->n;
  const hsp_boundary_request of_some = {.struct_size = sizeof of_some, .selected = selected};
  hsp_gradient_request request = {.struct_size = sizeof request, .tangency = HSP_TANGENT_OVERLAP, .tension = 0.7};
  computed c;
  uint32_t workers, i;
  request.pressure = selected == NULL ? -1.3 : 0;
  for (i = 0; i < n; ++i) sigma[i] = i % 4 == 1 ? 0 : 0.75 * i - 2;
  if (CHECK_EQUAL(computed_make(n, set->xyz, set->radius, NULL, &c), HSP_OK) &&
      CHECK_EQUAL(hsp_boundary_measure(c.boundary, NULL, NULL, measured, NULL, n, NULL), HSP_OK) &&
      CHECK_EQUAL(hsp_boundary_compute_with(c.boundary, c.model, &of_some, NULL), HSP_OK)) {
    for (i = 0; selected != NULL && i < n; ++i) measured[i] = selected[i] != 0 ? measured[i] : 0;
    for (workers = 0; workers <= 9; ++workers) {
      loop own = loop_of(LOOP_SHUFFLED);
      hsp_executor executor = executor_of(&own, workers);
      hsp_gradient_outputs outputs = outputs_into(n, &alone);
      check_scene("%s by %u workers", set->name, (unsigned)workers);
      request.sigma = workers % 2 == 0 ? sigma : NULL;
      request.tangency = workers % 3 == 0 ? HSP_TANGENT_DISJOINT : HSP_TANGENT_OVERLAP;
      request.executor = NULL;
      outputs.area = areas;
      CHECK_EQUAL(hsp_boundary_get_gradient(c.boundary, &request, &outputs), HSP_OK);
      CHECK_BYTES(areas, measured, n * sizeof *areas);
      outputs = outputs_into(n, &shared);
      request.executor = &executor;
      CHECK_EQUAL(hsp_boundary_get_gradient(c.boundary, &request, &outputs), HSP_OK);
      CHECK_BYTES(&shared, &alone, sizeof alone);
      CHECK(outputs.needed == n && outputs.first_bad == HSP_NONE);
      /* More balls than are worth two tasks. */
      CHECK_EQUAL(own.runs, workers > 1 && n > 64);
      CHECK(own.most_tasks > 1 || own.runs == 0);
    }
  }
  computed_release(&c);
}

static void refused(const ball_set *set) {
  gradients g, untouched;
  loop own = loop_of(LOOP_IN_ORDER);
  hsp_executor executor = executor_of(&own, 2);
  hsp_gradient_request request;
  hsp_gradient_outputs outputs = outputs_into(set->n, &g);
  computed c;
  memcpy(&untouched, &g, sizeof g);
  CHECK_EQUAL(hsp_gradient_request_init(&request, (uint32_t)sizeof request), HSP_OK);
  request.executor = &executor;
  check_scene("executors that are refused");
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &c), HSP_OK)) {
    executor.run = NULL;
    CHECK_EQUAL(hsp_boundary_get_gradient(c.boundary, &request, &outputs), HSP_E_ARGUMENT);
    executor = executor_of(&own, 2);
    --executor.struct_size;
    CHECK_EQUAL(hsp_boundary_get_gradient(c.boundary, &request, &outputs), HSP_E_VERSION);
    executor.struct_size = 0;
    CHECK_EQUAL(hsp_boundary_get_gradient(c.boundary, &request, &outputs), HSP_E_VERSION);
    CHECK(own.runs == 0 && outputs.needed == 0);
    CHECK_BYTES(&g, &untouched, sizeof g);
    /* One worker needs no loop. */
    executor = executor_of(NULL, 1);
    executor.run = NULL;
    CHECK_EQUAL(hsp_boundary_get_gradient(c.boundary, &request, &outputs), HSP_OK);
  }
  computed_release(&c);
}

int main(void) {
  static ball_set set;
  static uint8_t selected[BALL_SET_MOST];
  uint32_t which, i;
  for (which = 0; which < ball_set_count(); which += 5) {
    ball_set_make(which, &set);
    every_number_of_workers(&set, NULL);
  }
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, BALL_SET_MOST, 77);
  every_number_of_workers(&set, NULL);
  for (i = 0; i < set.n; ++i) selected[i] = i / 3 % 5 != 1;
  every_number_of_workers(&set, selected);
  refused(&set);
  return check_report();
}
