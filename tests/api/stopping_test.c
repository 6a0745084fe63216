/* hsp_executor.proceed: computations by one worker and by three, stopped at some of their questions whether to go on,
 * say HSP_E_STOPPED, have no results or leave the ones that they read, and give the same as before when asked again. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "boundary_hash.h"
#include "check.h"
#include "contacts_result.h"
#include "loops.h"
#include "topology_result.h"

enum { BALLS = 400, HOLLOW = 26, TRIED = 6 };

typedef struct scene {
  computed base;
  contacts_result contacts;
  topology_result topology;
  double numbers[3 * BALL_SET_MOST];
} scene;

/* Each asks, and hands out a hash of what there is then; 0: no results. */
static int32_t compute_boundary(scene *s, const hsp_executor *executor, uint64_t *hash) {
  static unsigned char buffer[1 << 22];
  const hsp_boundary_request request = {.struct_size = sizeof request, .executor = executor};
  const int32_t status = hsp_boundary_compute_with(s->base.boundary, s->base.model, &request, NULL);
  CHECK(boundary_room(&s->base) * (sizeof(hsp_vertex) + sizeof(hsp_arc)) <= sizeof buffer);
  *hash = status == HSP_OK ? boundary_hash(s->base.boundary, &s->base, buffer, boundary_room(&s->base)) : 0;
  if (status != HSP_OK) {
    hsp_boundary_counts counts;
    CHECK_EQUAL(hsp_boundary_get_counts(s->base.boundary, &counts), HSP_E_STATE);
  }
  return status;
}
static int32_t measure(scene *s, const hsp_executor *executor, uint64_t *hash) {
  const hsp_measure_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_measure_outputs outputs = {.struct_size = sizeof outputs, .capacity = BALLS, .area = s->numbers};
  const int32_t status = hsp_boundary_get_measures(s->base.boundary, &request, &outputs);
  *hash = mixed_hash(1, s->numbers, BALLS * sizeof(double));
  return status;
}
static int32_t differentiate_energy(scene *s, const hsp_executor *executor, uint64_t *hash) {
  const hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1, .executor = executor};
  hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = BALLS, .d_centre = s->numbers};
  const int32_t status = hsp_boundary_get_gradient(s->base.boundary, &request, &outputs);
  *hash = mixed_hash(1, s->numbers, 3 * BALLS * sizeof(double));
  return status;
}
static int32_t differentiate(scene *s, const hsp_executor *executor, uint64_t *hash) {
  const hsp_derivatives_request request = {.struct_size = sizeof request, .executor = executor};
  hsp_derivatives_outputs outputs = {.struct_size = sizeof outputs, .capacity = BALLS, .area_centre = s->numbers};
  const int32_t status = hsp_boundary_get_derivatives(s->base.boundary, &request, &outputs);
  *hash = mixed_hash(1, s->numbers, 3 * BALLS * sizeof(double));
  return status;
}
static int32_t compute_contacts(scene *s, const hsp_executor *executor, uint64_t *hash) {
  const hsp_contacts_request request = {.struct_size = sizeof request, .executor = executor};
  const int32_t status = hsp_contacts_compute_with(s->contacts.contacts, s->base.boundary, &request, NULL);
  hsp_complex counts;
  CHECK_EQUAL(hsp_contacts_get_complex(s->contacts.contacts, &counts), status == HSP_OK ? HSP_OK : HSP_E_STATE);
  *hash = status == HSP_OK ? mixed_hash(1, &counts, sizeof counts) : 0;
  return status;
}
static int32_t compute_topology(scene *s, const hsp_executor *executor, uint64_t *hash) {
  const hsp_topology_request request = {.struct_size = sizeof request, .executor = executor};
  const int32_t status = hsp_topology_compute_with(s->topology.topology, s->base.boundary, &request, NULL);
  hsp_topology_counts counts;
  CHECK_EQUAL(hsp_topology_get_counts(s->topology.topology, &counts), status == HSP_OK ? HSP_OK : HSP_E_STATE);
  *hash = status == HSP_OK ? mixed_hash(1, &counts, sizeof counts) : 0;
  return status;
}

static const struct {
  const char *name;
  int32_t (*ask)(scene *s, const hsp_executor *executor, uint64_t *hash);
} asked[TRIED] = {{"boundary", compute_boundary}, {"measures", measure},          {"gradient", differentiate_energy},
                  {"derivatives", differentiate}, {"contacts", compute_contacts}, {"topology", compute_topology}};

static void stopped(scene *s, int which, uint32_t workers) {
  stopper own = {.own = loop_of(LOOP_SHUFFLED), .stop_at = UINT32_MAX};
  hsp_executor executor = executor_of(&own.own, workers);
  uint64_t expected, hash;
  uint32_t questions, k;
  check_scene("%s by %u workers", asked[which].name, (unsigned)workers);
  CHECK_EQUAL(asked[which].ask(s, &executor, &expected), HSP_OK); /* which has nothing to ask with */
  executor.proceed = stopper_proceed;
  CHECK_EQUAL(asked[which].ask(s, &executor, &hash), HSP_OK);
  CHECK(hash == expected);
  CHECK((questions = own.asked) >= 3);
  for (k = 0; k < questions; k += 1 + questions / 8) {
    own.asked = 0;
    own.stop_at = k;
    CHECK_EQUAL(asked[which].ask(s, &executor, &hash), HSP_E_STOPPED);
    own.stop_at = UINT32_MAX;
    CHECK_EQUAL(asked[which].ask(s, &executor, &hash), HSP_OK);
    CHECK(hash == expected);
  }
}

int main(void) {
  static ball_set set;
  static scene s;
  hsp_boundary_limits limits;
  size_t bytes;
  int which;
  ball_set_start(&set, "a chain", 0.001);
  ball_set_add_hollow(&set, 100, 0, 0, 1.5); /* which has a void */
  ball_set_add_chain(&set, BALLS - HOLLOW, 7);
  if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &s.base), HSP_OK)) {
    /* with parts for three */
    limits = s.base.needed;
    limits.workers = 3;
    CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
    free(s.base.boundary_memory);
    s.base.boundary_memory = test_zeros(bytes, 1);
    CHECK_EQUAL(hsp_boundary_init(s.base.boundary_memory, bytes, &limits, &s.base.boundary), HSP_OK);
    CHECK_EQUAL(hsp_boundary_compute(s.base.boundary, s.base.model, NULL), HSP_OK);
    CHECK_EQUAL(contacts_result_make(&s.base, &s.contacts), HSP_OK);
    CHECK_EQUAL(topology_result_make(&s.base, &s.topology), HSP_OK);
    for (which = 0; which < TRIED; ++which) {
      stopped(&s, which, 1);
      stopped(&s, which, 3);
    }
  }
  topology_result_release(&s.topology);
  contacts_result_release(&s.contacts);
  computed_release(&s.base);
  return check_report();
}
