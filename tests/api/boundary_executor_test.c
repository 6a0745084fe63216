/* hsp_boundary_compute_with, hsp_boundary_get_measures: the same results for every number of workers and parts and
 * every order of tasks, whatever the limits; what of requests and executors is refused; and that a loop that breaks the
 * rules spoils nothing, nor a gradient. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "boundary_hash.h"
#include "check.h"
#include "gradients.h"
#include "guarded_memory.h"
#include "loops.h"
#include "topology_sets.h"

static hsp_boundary_request request_for(const hsp_executor *executor) {
  hsp_boundary_request request = {.struct_size = sizeof request};
  request.executor = executor;
  return request;
}

/* A boundary with room for so many parts and the rest of what a set needs. */
static hsp_boundary *make(const hsp_boundary_limits *needed, uint32_t parts, guarded_memory *memory) {
  hsp_boundary_limits limits = *needed;
  hsp_boundary *boundary = NULL;
  size_t bytes = 0;
  limits.workers = parts;
  CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
  /* hsp_boundary_bytes, property 1 */
  CHECK(bytes <= HSP_BOUNDARY_BYTES(limits.balls, limits.neighbours, limits.vertices, limits.circles) +
                     (parts < 1 ? 0 : parts - 1) *
                         HSP_WORKER_BYTES(limits.balls, limits.neighbours, limits.vertices, limits.circles));
  *memory = guarded_take(bytes, parts % 64, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_boundary_init(memory->block, bytes, &limits, &boundary), HSP_OK);
  return boundary;
}

static int32_t compute(hsp_boundary *boundary, const hsp_model *model, loop *own, uint32_t workers,
                       hsp_boundary_limits *limits) {
  const hsp_executor executor = executor_of(own, workers);
  const hsp_boundary_request request = request_for(&executor);
  return hsp_boundary_compute_with(boundary, model, &request, limits);
}

static uint64_t hash_of(const hsp_boundary *boundary, const computed *c, unsigned char *buffer) {
  return boundary_hash(boundary, c, buffer, boundary_room(c));
}

static unsigned char *buffer_for(const computed *c) {
  return test_zeros(boundary_room(c), sizeof(hsp_vertex) + sizeof(hsp_arc));
}

static int make_computed(const ball_set *set, computed *c) {
  return CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, c), HSP_OK);
}

/* ---- the same bits ---- */

static const uint32_t workers_tried[] = {0, 1, 2, 3, 7};
enum { NUMBERS_TRIED = sizeof workers_tried / sizeof workers_tried[0] };

/* hsp_boundary_compute_with, property 1; with as many parts as there are workers, some more, and more than cubes. */
static void every_split(const ball_set *set) {
  computed all;
  int which, way;
  if (make_computed(set, &all)) {
    const computed *c = &all;
    unsigned char *buffer = buffer_for(&all);
    const uint64_t expected = hash_of(c->boundary, &all, buffer);
    CHECK(expected != 0);
    for (which = 0; which < NUMBERS_TRIED; ++which) {
      const uint32_t workers = workers_tried[which];
      const uint32_t parts = which % 2 == 0 ? workers : which == 3 ? set->n % 50 + 40 : 2 * workers;
      guarded_memory memory;
      hsp_boundary *const boundary = make(&c->needed, parts, &memory);
      for (way = 0; way < LOOP_RIGHT_WAYS; ++way) {
        loop own = loop_of(way);
        hsp_boundary_limits needed = c->needed;
        check_scene("%s by %u workers in %u parts, way %d", set->name, (unsigned)workers, (unsigned)parts, way);
        needed.vertices = 12345;
        CHECK_EQUAL(compute(boundary, c->model, &own, workers, &needed), HSP_OK);
        CHECK_EQUAL(needed.workers, parts);
        needed.workers = c->needed.workers;
        CHECK_BYTES(&needed, &c->needed, sizeof needed);
        CHECK(hash_of(boundary, &all, buffer) == expected);
        CHECK(use_boundary(boundary));
        CHECK(workers > 1 ? own.runs > 1 && own.most_tasks == parts : own.runs == 0);
      }
      CHECK_EQUAL(hsp_boundary_compute(boundary, c->model, NULL), HSP_OK);
      CHECK(hash_of(boundary, &all, buffer) == expected);
      CHECK(guarded_clean(&memory));
      guarded_give_back(&memory);
    }
    free(buffer);
  }
  computed_release(&all);
}

/* hsp_boundary_compute_with, properties 1 and 2: areas and gradient of some balls are those of the whole. */
static void every_split_of_some(const ball_set *set) {
  static double area[BALL_SET_MOST], whole_area[BALL_SET_MOST];
  static gradients some, whole;
  computed all;
  int which, way;
  uint32_t i;
  if (make_computed(set, &all)) {
    const computed *c = &all;
    uint8_t selected[BALL_SET_MOST];
    guarded_memory memory;
    hsp_boundary *const boundary = make(&c->needed, 9, &memory);
    hsp_gradient_request tension = {.struct_size = sizeof tension, .tangency = HSP_TANGENT_OVERLAP, .tension = 0.7};
    hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = set->n};
    hsp_measure_outputs measured = {.struct_size = sizeof measured, .capacity = set->n};
    measured.area = whole_area;
    CHECK_EQUAL(hsp_boundary_get_measures(c->boundary, NULL, &measured), HSP_OK);
    outputs.d_radius = whole.radius;
    CHECK_EQUAL(hsp_boundary_get_gradient(c->boundary, &tension, &outputs), HSP_OK);
    for (i = 0; i < set->n; ++i) {
      selected[i] = i % 3 != 1;
      if (!selected[i]) whole_area[i] = whole.radius[i] = 0;
    }
    measured.area = area;
    outputs.d_radius = some.radius;
    for (which = 0; which < NUMBERS_TRIED; ++which) {
      for (way = 0; way < LOOP_RIGHT_WAYS; ++way) {
        loop own = loop_of(way);
        const hsp_executor executor = executor_of(&own, workers_tried[which]);
        hsp_boundary_request request = request_for(&executor);
        check_scene("some balls of %s by %u workers, way %d", set->name, (unsigned)executor.workers, way);
        request.selected = selected;
        CHECK_EQUAL(hsp_boundary_compute_with(boundary, c->model, &request, NULL), HSP_OK);
        CHECK(executor.workers > 1 ? own.runs > 1 : own.runs == 0);
        CHECK_EQUAL(hsp_boundary_get_measures(boundary, NULL, &measured), HSP_OK);
        CHECK_BYTES(area, whole_area, set->n * sizeof *area);
        CHECK_EQUAL(hsp_boundary_get_gradient(boundary, &tension, &outputs), HSP_OK);
        CHECK_BYTES(some.radius, whole.radius, set->n * sizeof *area);
      }
    }
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
  }
  computed_release(&all);
}

typedef struct measures {
  hsp_totals totals;
  double area[BALL_SET_MOST], volume[BALL_SET_MOST];
} measures;

static hsp_measure_outputs outputs_into(measures *m, uint32_t n, int which) {
  hsp_measure_outputs outputs = {.struct_size = sizeof outputs};
  memset(m, 0xA5, sizeof *m);
  outputs.capacity = n;
  if ((which & 1) == 0) outputs.totals = &m->totals;
  if ((which & 2) == 0) outputs.area = m->area;
  if ((which & 4) == 0) outputs.volume_term = m->volume;
  return outputs;
}

/* hsp_boundary_get_measures, property 1, with and without each of its outputs. */
static void every_measure(const ball_set *set) {
  static measures alone, shared;
  computed all;
  int number, way, which;
  uint32_t i;
  if (make_computed(set, &all)) {
    const computed *c = &all;
    const uint32_t n = set->n;
    uint8_t selected[BALL_SET_MOST];
    for (i = 0; i < n; ++i) selected[i] = i % 3 != 1;
    for (number = 0; number < NUMBERS_TRIED; ++number) {
      for (way = 0; way < LOOP_RIGHT_WAYS; ++way) {
        for (which = 0; which < 8; ++which) {
          loop own = loop_of(way);
          const hsp_executor executor = executor_of(&own, workers_tried[number]);
          hsp_measure_request request = {.struct_size = sizeof request};
          hsp_measure_outputs outputs = outputs_into(&alone, n, which);
          check_scene("%s measured by %u workers, way %d, outputs %d", set->name, (unsigned)executor.workers, way,
                      which);
          request.selected = (number + way) % 2 == 0 ? selected : NULL;
          request.executor = &executor;
          CHECK_EQUAL(hsp_boundary_measure(c->boundary, request.selected, outputs.totals, outputs.area,
                                           outputs.volume_term, n, NULL),
                      HSP_OK);
          outputs = outputs_into(&shared, n, which);
          CHECK_EQUAL(hsp_boundary_get_measures(c->boundary, &request, &outputs), HSP_OK);
          CHECK_BYTES(&shared, &alone, sizeof alone);
          CHECK_EQUAL(outputs.needed, n);
          /* More balls than are worth two tasks. */
          CHECK_EQUAL(own.runs, executor.workers > 1 && n > 64);
        }
      }
    }
    {
      hsp_measure_outputs outputs = outputs_into(&shared, n, 0);
      CHECK_EQUAL(hsp_boundary_measure(c->boundary, NULL, &alone.totals, alone.area, alone.volume, n, NULL), HSP_OK);
      CHECK_EQUAL(hsp_boundary_get_measures(c->boundary, NULL, &outputs), HSP_OK);
      CHECK_BYTES(shared.area, alone.area, n * sizeof(double));
      CHECK_BYTES(shared.volume, alone.volume, n * sizeof(double));
      CHECK_BYTES(&shared.totals, &alone.totals, sizeof alone.totals);
    }
  }
  computed_release(&all);
}

/* ---- what is refused ---- */

/* Limits that are too small are said as hsp_boundary_compute says them. */
static void small_limits(const ball_set *set) {
  computed all;
  int which;
  if (make_computed(set, &all)) {
    const computed *c = &all;
    for (which = 1; which <= 4; ++which) {
      limit_numbers given = {{0}};
      uint32_t workers;
      memcpy(&given, &c->needed, sizeof c->needed);
      if (given.number[which] == 0) continue;
      given.number[which] = which == 3 ? given.number[which] / 2 : given.number[which] - 1;
      for (workers = 1; workers <= 4; ++workers) {
        loop own = loop_of(LOOP_SHUFFLED);
        hsp_boundary_limits small, by_workers = c->needed, by_one = c->needed;
        guarded_memory memory;
        hsp_boundary_counts counts;
        hsp_boundary *boundary;
        check_scene("%s by %u workers, limit %d too small", set->name, (unsigned)workers, which);
        memcpy(&small, &given, sizeof small);
        boundary = make(&small, workers, &memory);
        CHECK_EQUAL(compute(boundary, c->model, &own, workers, &by_workers), HSP_E_CAPACITY);
        CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
        CHECK_EQUAL(hsp_boundary_compute(boundary, c->model, &by_one), HSP_E_CAPACITY);
        CHECK_BYTES(&by_workers, &by_one, sizeof by_one);
        CHECK_EQUAL(by_one.workers, workers);
        CHECK(guarded_clean(&memory));
        guarded_give_back(&memory);
      }
    }
  }
  computed_release(&all);
}

/* Fewer parts than workers: limits become some with a part for each. */
static void more_workers_than_parts(const computed *c) {
  static const uint32_t workers[] = {2, 9, HSP_MAX_WORKERS, HSP_MAX_WORKERS + 1, UINT32_MAX};
  uint32_t k, parts;
  for (parts = 0; parts < 2; ++parts) {
    guarded_memory memory;
    hsp_boundary *const boundary = make(&c->needed, parts, &memory);
    for (k = 0; k < 5; ++k) {
      loop own = loop_of(LOOP_IN_ORDER);
      hsp_boundary_limits limits = c->needed, expected = c->needed;
      hsp_boundary_counts counts;
      check_scene("%u workers for %u parts", (unsigned)workers[k], (unsigned)parts);
      CHECK_EQUAL(compute(boundary, c->model, &own, workers[k], &limits), HSP_E_CAPACITY);
      CHECK_EQUAL(compute(boundary, c->model, &own, workers[k], NULL), HSP_E_CAPACITY);
      expected.workers = workers[k] < HSP_MAX_WORKERS ? workers[k] : HSP_MAX_WORKERS;
      CHECK_BYTES(&limits, &expected, sizeof limits);
      CHECK_EQUAL(own.runs, 0);
      CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
    }
    guarded_give_back(&memory);
  }
}

static void refused_requests(const computed *c, uint32_t n) {
  static measures m, untouched;
  loop own = loop_of(LOOP_IN_ORDER);
  guarded_memory memory;
  hsp_boundary *const boundary = make(&c->needed, 2, &memory);
  hsp_executor executor = executor_of(&own, 2);
  hsp_boundary_request request = request_for(&executor);
  hsp_measure_request measuring = {.struct_size = sizeof measuring};
  hsp_measure_outputs outputs = outputs_into(&m, n, 0);
  hsp_boundary_limits bad_size = c->needed;
  size_t bytes;
  uint8_t selected[BALL_SET_MOST] = {1};
  const hsp_boundary_request of_some = {.struct_size = sizeof of_some, .selected = selected};
  hsp_derivatives_outputs derivatives = {.struct_size = sizeof derivatives, .capacity = n};
  hsp_boundary_counts counts;
  check_scene("requests that are refused");
  memcpy(&untouched, &m, sizeof m);
  measuring.executor = &executor;
#define REFUSED(status)                                                                                     \
  do {                                                                                                      \
    CHECK_EQUAL(hsp_boundary_compute(boundary, c->model, NULL), HSP_OK);                                    \
    CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, &outputs), status);                         \
    CHECK_EQUAL(hsp_boundary_compute_with(boundary, c->model, &request, NULL), status); /* drops results */ \
    CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);                                   \
  } while (0)
  executor.run = NULL;
  REFUSED(HSP_E_ARGUMENT);
  executor = executor_of(&own, 2);
  --executor.struct_size;
  REFUSED(HSP_E_VERSION);
  executor = executor_of(&own, 2);
  request.reserved = measuring.reserved = 1;
  REFUSED(HSP_E_VERSION);
  request.reserved = measuring.reserved = 0;
  request.struct_size = measuring.struct_size = 8;
  REFUSED(HSP_E_VERSION);
#undef REFUSED
  request.struct_size = sizeof request;
  measuring.struct_size = sizeof measuring;
  CHECK_EQUAL(hsp_boundary_compute(boundary, c->model, NULL), HSP_OK);
  outputs.reserved = 1;
  CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, &outputs), HSP_E_VERSION);
  executor.run = NULL;
  CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, &outputs), HSP_E_VERSION);
  executor = executor_of(&own, 2);
  outputs.reserved = 0;
  outputs.struct_size = 0;
  CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, &outputs), HSP_E_VERSION);
  CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, NULL), HSP_E_ARGUMENT);
  outputs = outputs_into(&m, n - 1, 0);
  CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, &outputs), HSP_E_CAPACITY);
  CHECK_EQUAL(outputs.needed, n);
  CHECK_EQUAL(own.runs, 0);
  CHECK_BYTES(&m, &untouched, sizeof m);
  /* Totals alone need no room. */
  outputs = outputs_into(&m, 0, 2 | 4);
  CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, &outputs), HSP_OK);
  bad_size.workers = HSP_MAX_WORKERS + 1;
  CHECK_EQUAL(hsp_boundary_bytes(&bad_size, &bytes), HSP_E_RANGE);
  CHECK_EQUAL(hsp_boundary_bytes(&c->needed, NULL), HSP_E_ARGUMENT);
  bad_size.struct_size = 3;
  CHECK_EQUAL(hsp_boundary_bytes(&bad_size, NULL), HSP_E_VERSION);
  CHECK_EQUAL(hsp_boundary_compute_with(NULL, c->model, &request, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_compute_with(boundary, NULL, &request, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, &outputs), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute_with(boundary, c->model, &request, &bad_size), HSP_E_VERSION);
  /* Of some balls there are areas and their derivatives alone. */
  CHECK_EQUAL(hsp_boundary_compute_with(boundary, c->model, &of_some, NULL), HSP_OK);
  derivatives.volume_radius = m.area;
  CHECK_EQUAL(hsp_boundary_get_derivatives(boundary, NULL, &derivatives), HSP_E_STATE);
  derivatives.volume_radius = NULL;
  derivatives.area_radius = m.area;
  CHECK_EQUAL(hsp_boundary_get_derivatives(boundary, NULL, &derivatives), HSP_OK);
  /* One worker needs no loop. */
  executor.workers = 1;
  executor.run = NULL;
  CHECK_EQUAL(hsp_boundary_compute_with(boundary, c->model, &request, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute_with(boundary, c->model, NULL, NULL), HSP_OK);
  CHECK(guarded_clean(&memory));
  guarded_give_back(&memory);
}

/* ---- loops that break the rules ---- */

/* In every stage; afterwards the handle serves as before. */
static void broken_loops(const computed *c, const ball_set *set) {
  static measures alone, shared;
  static gradients gradient, shared_gradient;
  const uint32_t n = set->n;
  unsigned char *buffer = buffer_for(c);
  const uint64_t expected = hash_of(c->boundary, c, buffer);
  guarded_memory memory;
  hsp_boundary *const boundary = make(&c->needed, 5, &memory);
  hsp_measure_outputs outputs = outputs_into(&alone, n, 0);
  hsp_gradient_outputs derivatives = {.struct_size = sizeof derivatives};
  loop right = loop_of(LOOP_IN_ORDER);
  int way;
  uint32_t stages, stage;
  CHECK_EQUAL(hsp_boundary_get_measures(c->boundary, NULL, &outputs), HSP_OK);
  memset(&gradient, 0, sizeof gradient);
  memset(&shared_gradient, 0, sizeof shared_gradient);
  derivatives.capacity = n;
  derivatives.d_centre = gradient.centre;
  CHECK_EQUAL(hsp_boundary_get_gradient(c->boundary, NULL, &derivatives), HSP_OK);
  derivatives.d_centre = shared_gradient.centre;
  CHECK_EQUAL(compute(boundary, c->model, &right, 3, NULL), HSP_OK);
  stages = right.runs;
  for (way = LOOP_FORGETS; way < LOOP_WAYS; ++way) {
    for (stage = 0; stage < stages; ++stage) {
      loop own = loop_of(way);
      hsp_boundary_limits limits = c->needed;
      hsp_boundary_counts counts;
      own.first_wrong = stage;
      check_scene("way %d from stage %u on", way, (unsigned)stage);
      CHECK_EQUAL(compute(boundary, c->model, &own, 3, &limits), HSP_E_EXECUTOR);
      CHECK_EQUAL(own.runs, stage + 1);
      CHECK_BYTES(&limits, &c->needed, sizeof limits);
      CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
      CHECK_EQUAL(compute(boundary, c->model, &right, 3, NULL), HSP_OK);
      CHECK(hash_of(boundary, c, buffer) == expected);
    }
    {
      loop own = loop_of(way);
      const hsp_executor executor = executor_of(&own, 3);
      hsp_measure_request measuring = {.struct_size = sizeof measuring};
      hsp_gradient_request differentiating = {.struct_size = sizeof differentiating, .tangency = HSP_TANGENT_OVERLAP};
      int32_t status;
      measuring.executor = differentiating.executor = &executor;
      check_scene("way %d of measures", way);
      outputs = outputs_into(&shared, n, 0);
      status = hsp_boundary_get_measures(boundary, &measuring, &outputs);
      /* Code for small machines does it all in one thread. */
      CHECK_EQUAL(status, own.runs > 0 ? HSP_E_EXECUTOR : HSP_OK);
      CHECK_EQUAL(hsp_boundary_get_gradient(boundary, &differentiating, &derivatives), status);
      own.way = LOOP_SHUFFLED;
      CHECK_EQUAL(hsp_boundary_get_measures(boundary, &measuring, &outputs), HSP_OK);
      CHECK_EQUAL(hsp_boundary_get_gradient(boundary, &differentiating, &derivatives), HSP_OK);
      CHECK_BYTES(&shared, &alone, sizeof alone);
      CHECK_BYTES(&shared_gradient, &gradient, sizeof gradient);
    }
  }
  CHECK(guarded_clean(&memory));
  guarded_give_back(&memory);
  free(buffer);
}

int main(void) {
  static ball_set set;
  computed all;
  uint32_t which;
  for (which = 0; which < topology_set_count(); ++which) {
    topology_set_make(which, &set);
    every_split(&set);
    every_split_of_some(&set);
    every_measure(&set);
    small_limits(&set);
  }
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, BALL_SET_MOST, 11);
  every_split(&set);
  every_split_of_some(&set);
  every_measure(&set);
  small_limits(&set);
  if (make_computed(&set, &all)) {
    more_workers_than_parts(&all);
    refused_requests(&all, set.n);
    broken_loops(&all, &set);
  }
  computed_release(&all);
  return check_report();
}
