/* Handles that are passed as const may be read by any number of threads at a time, and distinct handles used by
 * distinct threads: four threads read one model and one handle of each kind while computing handles of their own, and
 * four threads locate points by one topology. An executor of four threads: they compute, measure and differentiate one
 * boundary, and may even call all tasks each, which is refused and harms nothing. */
#define _POSIX_C_SOURCE 200112L
#include <hardsphere.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "boundary_hash.h"
#include "check.h"
#include "gradients.h"
#include "handle_life.h"
#include "topology_sets.h"

enum { THREADS = 4, ROUNDS = 10 };

/* Each thread with one of so many works of this size. */
static void run_in_threads(void *(*run)(void *), void *works, size_t size) {
  pthread_t threads[THREADS];
  int t;
  for (t = 0; t < THREADS; ++t) {
    void *own = (unsigned char *)works + (size_t)t * size;
    if (!CHECK_EQUAL(pthread_create(&threads[t], NULL, run, own), 0)) exit(check_report());
  }
  for (t = 0; t < THREADS; ++t) CHECK_EQUAL(pthread_join(threads[t], NULL), 0);
}

typedef struct work {
  int kind;
  const computations *shared;
  uint64_t answers;
  int failed;
} work;

/* Reads the shared handle and computes one of its own from what that was computed from. */
static void *read_and_compute(void *argument) {
  work *mine = argument;
  const kind_of_life *k = &kinds_of_life[mine->kind];
  const void *source = source_of(mine->shared, mine->kind), *shared = handle_of(mine->shared, mine->kind);
  unsigned char *buffer = buffer_for(mine->shared);
  const limit_numbers limits = limits_of(mine->shared, mine->kind);
  size_t bytes = 0;
  void *memory, *own = NULL;
  int round;
  mine->failed = k->kind->bytes(&limits, &bytes) != HSP_OK;
  memory = test_zeros(bytes, 1);
  mine->failed |= k->kind->init(memory, bytes, &limits, &own) != HSP_OK;
  for (round = 0; round < ROUNDS && !mine->failed; ++round) {
    const uint64_t answer = k->hash(shared, source, buffer, mine->shared->room);
    mine->failed |= answer == 0;
    mine->failed |= k->kind->compute(own, source, NULL) != HSP_OK;
    mine->failed |= k->hash(own, source, buffer, mine->shared->room) != answer;
    mine->failed |= !k->use(own);
    mine->answers = mixed_hash(mine->answers, &answer, sizeof answer);
  }
  free(memory);
  free(buffer);
  return NULL;
}

static void in_threads(void) {
  static ball_set set;
  computations all;
  hsp_view_options options;
  int kind, t;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 120, 77);
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  if (computations_make(&set, &options, &all) && computations_add_slow(&all, &options)) {
    for (kind = 0; kind < KINDS; ++kind) {
      work works[THREADS];
      if (kind == GATE) continue; /* of so many balls it takes too long */
      check_scene("threads, with %s", kinds_of_life[kind].name);
      for (t = 0; t < THREADS; ++t) {
        memset(&works[t], 0, sizeof works[t]);
        works[t].kind = kind;
        works[t].shared = &all;
      }
      run_in_threads(read_and_compute, works, sizeof works[0]);
      for (t = 0; t < THREADS; ++t) {
        CHECK(!works[t].failed);
        CHECK(works[t].answers == works[0].answers);
      }
    }
  }
  computations_release(&all);
}

/* ---- places ---- */

enum { LINES = 26, PLACES_ON_A_LINE = 40, PLACES = LINES * PLACES_ON_A_LINE };

typedef struct search {
  const hsp_topology *topology;
  uint32_t regions[PLACES];
  int failed;
} search;

/* From the origin in all directions, through the nested voids and out: every place twice as far as the third before
 * it. */
static void *locate_places(void *argument) {
  search *mine = argument;
  uint32_t found = 0;
  int line, place;
  mine->failed = 0;
  for (line = 0; line <= LINES; ++line) {
    double at[3], distance = 0.1;
    if (line == LINES / 2) continue; /* no direction */
    for (place = 0; place < PLACES_ON_A_LINE; ++place) {
      at[0] = (line % 3 - 1) * distance;
      at[1] = (line / 3 % 3 - 1) * distance * 0.9375;
      at[2] = (line / 9 - 1) * distance * 0.875;
      mine->failed |= hsp_topology_locate(mine->topology, at, &mine->regions[found++]) != HSP_OK;
      distance *= 1.25992104989487;
    }
  }
  return NULL;
}

static void located_in_threads(void) {
  static ball_set set;
  static search searches[THREADS + 1];
  computed c;
  topology_result topology;
  uint32_t regions_seen = 0, k;
  int t;
  memset(&topology, 0, sizeof topology);
  topology_set_nested(&set);
  check_scene("threads that locate in %s", set.name);
  if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK) &&
      CHECK_EQUAL(topology_result_make(&c, &topology), HSP_OK)) {
    for (t = 0; t <= THREADS; ++t) searches[t].topology = topology.topology;
    locate_places(&searches[THREADS]);
    for (k = 0; k < PLACES; ++k) {
      const uint32_t region = searches[THREADS].regions[k];
      if (region != HSP_NONE) regions_seen |= UINT32_C(1) << region;
    }
    CHECK_EQUAL(regions_seen, 15);
    run_in_threads(locate_places, searches, sizeof searches[0]);
    for (t = 0; t < THREADS; ++t) {
      CHECK(!searches[t].failed);
      CHECK_BYTES(searches[t].regions, searches[THREADS].regions, sizeof searches[t].regions);
    }
  }
  topology_result_release(&topology);
  computed_release(&c);
}

/* ---- one boundary ---- */

typedef struct share {
  hsp_task *task;
  void *data;
  uint32_t tasks, first, step;
} share;

/* Of all tasks, every step-th from the first on, and round about. */
static void *do_tasks(void *argument) {
  const share *const mine = argument;
  uint32_t k;
  for (k = 0; k < mine->tasks; k += mine->step) {
    if (mine->first + k < mine->tasks || mine->step == 1) mine->task(mine->data, (mine->first + k) % mine->tasks);
  }
  return NULL;
}

/* context: the step of each thread. 1: every task is called by all of them. */
static int32_t run(void *context, uint32_t tasks, hsp_task *task, void *data) {
  share shares[THREADS];
  uint32_t t;
  for (t = 0; t < THREADS; ++t) {
    shares[t].task = task;
    shares[t].data = data;
    shares[t].tasks = tasks;
    shares[t].first = t;
    shares[t].step = *(const uint32_t *)context;
  }
  run_in_threads(do_tasks, shares, sizeof shares[0]);
  return 0;
}

static void measured_in_threads(const computed *c, const hsp_executor *executor) {
  static gradients alone, shared;
  static double area[2][BALL_SET_MOST], volume[2][BALL_SET_MOST];
  hsp_totals totals[2];
  hsp_measure_request request = {.struct_size = sizeof request};
  hsp_measure_outputs outputs = {.struct_size = sizeof outputs};
  hsp_gradient_request differentiating = {
      .struct_size = sizeof differentiating, .tangency = HSP_TANGENT_OVERLAP, .tension = 1, .pressure = 2};
  hsp_gradient_outputs derivatives = {.struct_size = sizeof derivatives};
  int which;
  for (which = 0; which < 2; ++which) {
    gradients *const into = which == 0 ? &alone : &shared;
    outputs.capacity = derivatives.capacity = c->n;
    outputs.totals = &totals[which];
    outputs.area = area[which];
    outputs.volume_term = volume[which];
    derivatives.energy = &into->energy;
    derivatives.d_centre = into->centre;
    derivatives.d_radius = into->radius;
    derivatives.flags = into->flags;
    request.executor = differentiating.executor = which == 0 ? NULL : executor;
    CHECK_EQUAL(hsp_boundary_get_measures(c->boundary, &request, &outputs), HSP_OK);
    CHECK_EQUAL(hsp_boundary_get_gradient(c->boundary, &differentiating, &derivatives), HSP_OK);
  }
  CHECK_BYTES(&totals[1], &totals[0], sizeof totals[0]);
  CHECK_BYTES(area[1], area[0], c->n * sizeof(double));
  CHECK_BYTES(volume[1], volume[0], c->n * sizeof(double));
  CHECK_BYTES(&shared, &alone, sizeof alone);
}

/* hsp_boundary_compute_with, property 1. The balls of a chain meet their neighbours, so each shell is of many parts. */
static void split_among_threads(void) {
  static ball_set set;
  computations all;
  int round;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 200, 31);
  check_scene("threads that compute one boundary");
  if (computations_make(&set, NULL, &all)) {
    const kind_of_life *k = &kinds_of_life[BOUNDARY];
    unsigned char *buffer = buffer_for(&all);
    const uint64_t expected = k->hash(all.boundary.boundary, &all.boundary, buffer, all.room);
    uint32_t step = THREADS;
    hsp_executor executor = {sizeof executor, THREADS, NULL, run, NULL};
    hsp_boundary_request request = {.struct_size = sizeof request};
    hsp_boundary_limits limits = all.boundary.needed;
    hsp_boundary *boundary = NULL;
    size_t bytes = 0;
    void *memory;
    executor.context = &step;
    request.executor = &executor;
    limits.workers = 2 * THREADS;
    CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
    memory = test_zeros(bytes, 1);
    CHECK_EQUAL(hsp_boundary_init(memory, bytes, &limits, &boundary), HSP_OK);
    CHECK(expected != 0);
    for (round = 0; round < 10 * ROUNDS; ++round) {
      step = round % 5 == 4 ? 1 : THREADS;
      CHECK_EQUAL(hsp_boundary_compute_with(boundary, all.boundary.model, &request, NULL),
                  step == 1 ? HSP_E_EXECUTOR : HSP_OK);
      if (step == 1) continue;
      CHECK(k->hash(boundary, &all.boundary, buffer, all.room) == expected);
      measured_in_threads(&all.boundary, &executor);
    }
    step = THREADS;
    CHECK_EQUAL(hsp_boundary_compute_with(boundary, all.boundary.model, &request, NULL), HSP_OK);
    CHECK(k->use(boundary));
    free(memory);
    free(buffer);
  }
  computations_release(&all);
}

int main(void) {
  in_threads();
  located_in_threads();
  split_among_threads();
  return check_report();
}
