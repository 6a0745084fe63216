/* hsp_boundary_begin, hsp_boundary_work and hsp_boundary_end: the same results for every number of workers and every
 * order of their work, whatever the limits; and the status of every call at a wrong time. The same areas and volumes
 * for all ranges in which they are measured. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "handle_life.h"
#include "random_numbers.h"
#include "topology_sets.h"
#include "untouched.h"

enum { MOST_WORKERS = 9 };

/* A boundary with room for so many workers and the rest of what a set needs. */
static hsp_boundary *make(const hsp_boundary_limits *needed, uint32_t workers, guarded_memory *memory) {
  hsp_boundary_limits limits = *needed;
  hsp_boundary *boundary = NULL;
  size_t bytes = 0;
  limits.workers = workers;
  CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
  /* hsp_boundary_bytes, property 1 */
  CHECK(bytes <= HSP_BOUNDARY_BYTES(limits.balls, limits.neighbours, limits.vertices, limits.circles) +
                     (workers < 1 ? 0 : workers - 1) *
                         HSP_WORKER_BYTES(limits.balls, limits.neighbours, limits.vertices, limits.circles));
  *memory = guarded_take(bytes, workers % 64, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_boundary_init(memory->block, bytes, &limits, &boundary), HSP_OK);
  return boundary;
}

/* All stages, in each of them the workers in an order of its own. */
static void work(hsp_boundary *boundary, const hsp_model *model, uint32_t workers, uint64_t seed) {
  uint32_t order[BALL_SET_MOST], stages = 0, stage, k;
  CHECK_EQUAL(hsp_boundary_begin(boundary, model, workers, &stages), HSP_OK);
  CHECK(stages > 0);
  for (stage = 0; stage < stages; ++stage) {
    ball_set_shuffle(workers, seed + stage, order);
    for (k = 0; k < workers; ++k) CHECK_EQUAL(hsp_boundary_work(boundary, stage, order[k]), HSP_OK);
  }
}

static uint64_t hash_of(const hsp_boundary *boundary, const computations *all, unsigned char *buffer) {
  return kinds_of_life[BOUNDARY].hash(boundary, &all->boundary, buffer, all->room);
}

/* hsp_boundary_begin, property 1. */
static void every_split(const ball_set *set) {
  computations all;
  uint32_t workers;
  if (computations_make(set, NULL, &all)) {
    const computed *c = &all.boundary;
    unsigned char *buffer = buffer_for(&all);
    const uint64_t expected = hash_of(c->boundary, &all, buffer);
    CHECK(expected != 0);
    for (workers = 1; workers <= MOST_WORKERS; ++workers) {
      /* The last has more workers than there are cubes. */
      const uint32_t count = workers < MOST_WORKERS ? workers : set->n % 50 + 40;
      hsp_boundary_limits needed = c->needed;
      guarded_memory memory;
      hsp_boundary *boundary;
      check_scene("%s by %u workers", set->name, (unsigned)count);
      boundary = make(&c->needed, count, &memory);
      work(boundary, c->model, count, workers);
      needed.vertices = 12345;
      CHECK_EQUAL(hsp_boundary_end(boundary, &needed), HSP_OK);
      CHECK_EQUAL(needed.workers, count);
      needed.workers = c->needed.workers;
      CHECK_BYTES(&needed, &c->needed, sizeof needed);
      CHECK(hash_of(boundary, &all, buffer) == expected);
      CHECK(kinds_of_life[BOUNDARY].use(boundary));
      /* The same memory once more, by fewer, and by one. */
      work(boundary, c->model, 1 + count / 2, 77);
      CHECK_EQUAL(hsp_boundary_end(boundary, NULL), HSP_OK);
      CHECK(hash_of(boundary, &all, buffer) == expected);
      CHECK_EQUAL(hsp_boundary_compute(boundary, c->model, NULL), HSP_OK);
      CHECK(hash_of(boundary, &all, buffer) == expected);
      CHECK(guarded_clean(&memory));
      guarded_give_back(&memory);
    }
    free(buffer);
  }
  computations_release(&all);
}

/* hsp_boundary_measure_end, property 1. */
static void every_range(const ball_set *set) {
  computations all;
  uint32_t parts, i;
  if (computations_make(set, NULL, &all)) {
    const computed *c = &all.boundary;
    const uint32_t n = set->n;
    double area[2][BALL_SET_MOST], volume[2][BALL_SET_MOST];
    uint8_t selected[BALL_SET_MOST];
    uint32_t order[BALL_SET_MOST];
    for (i = 0; i < n; ++i) selected[i] = i % 3 != 1;
    for (parts = 1; parts <= 9; ++parts) {
      const uint8_t *const chosen = parts % 2 == 0 ? selected : NULL;
      hsp_totals totals[2];
      check_scene("%s measured in %u parts", set->name, (unsigned)parts);
      memset(area, 0xA5, sizeof area);
      memset(volume, 0xA5, sizeof volume);
      CHECK_EQUAL(hsp_boundary_measure(c->boundary, chosen, &totals[0], area[0], volume[0], n, NULL), HSP_OK);
      ball_set_shuffle(parts, parts, order);
      for (i = 0; i < parts; ++i) {
        const uint32_t first = n * order[i] / parts, last = n * (order[i] + 1) / parts;
        CHECK_EQUAL(hsp_boundary_measure_range(c->boundary, chosen, first, last - first, area[1], volume[1]), HSP_OK);
      }
      CHECK_EQUAL(hsp_boundary_measure_end(c->boundary, &totals[1], area[1], volume[1]), HSP_OK);
      CHECK_BYTES(area[1], area[0], sizeof area[0]);
      CHECK_BYTES(volume[1], volume[0], sizeof volume[0]);
      CHECK_BYTES(&totals[1], &totals[0], sizeof totals[0]);
      CHECK_EQUAL(hsp_boundary_measure_end(c->boundary, NULL, area[1], volume[1]), HSP_OK);
    }
    memset(area[1], 0xA5, sizeof area[1]);
    memcpy(area[0], area[1], sizeof area[0]);
    CHECK_EQUAL(hsp_boundary_measure_range(NULL, NULL, 0, n, area[1], area[1]), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_measure_range(c->boundary, NULL, 0, n, NULL, area[1]), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_measure_range(c->boundary, NULL, 0, n, area[1], NULL), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_measure_range(c->boundary, NULL, 0, n + 1, area[1], area[1]), HSP_E_ID);
    CHECK_EQUAL(hsp_boundary_measure_range(c->boundary, NULL, n, 1, area[1], area[1]), HSP_E_ID);
    CHECK_EQUAL(hsp_boundary_measure_range(c->boundary, NULL, 2, HSP_NONE, area[1], area[1]), HSP_E_ID);
    CHECK_EQUAL(hsp_boundary_measure_range(c->boundary, NULL, n, 0, area[1], area[1]), HSP_OK);
    CHECK_EQUAL(hsp_boundary_measure_end(NULL, NULL, area[1], area[1]), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_measure_end(c->boundary, NULL, NULL, area[1]), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_measure_end(c->boundary, NULL, area[1], NULL), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_compute(c->boundary, NULL, NULL), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_measure_range(c->boundary, NULL, 0, n, area[1], area[1]), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_measure_end(c->boundary, NULL, area[1], area[1]), HSP_E_STATE);
    CHECK_BYTES(area[1], area[0], sizeof area[0]);
  }
  computations_release(&all);
}

/* What is refused of gradients in parts, with nothing written. */
static void refused_gradients(const computed *c, uint32_t n) {
  static const double nan_twice[2] = {NAN, NAN};
  double numbers[3 * BALL_SET_MOST], kept[3 * BALL_SET_MOST];
  uint32_t flags[BALL_SET_MOST], kept_flags[BALL_SET_MOST], bad = 12345;
  hsp_energy energy, no_energy;
  memset(numbers, 0xA5, sizeof numbers);
  memset(flags, 0xA5, sizeof flags);
  memset(&energy, 0xA5, sizeof energy);
  memcpy(kept, numbers, sizeof kept);
  memcpy(kept_flags, flags, sizeof kept_flags);
  memcpy(&no_energy, &energy, sizeof energy);
#define RANGE(boundary, sigma, tension, pressure, tangency, first, count)                                          \
  hsp_boundary_gradient_range(boundary, sigma, tension, pressure, tangency, first, count, numbers, numbers, flags, \
                              numbers, &bad)
  CHECK_EQUAL(RANGE(NULL, NULL, 1, 1, HSP_TANGENT_OVERLAP, 0, n), HSP_E_ARGUMENT);
  CHECK_EQUAL(RANGE(c->boundary, NULL, 1, 1, 2, 0, n), HSP_E_ARGUMENT);
  CHECK_EQUAL(RANGE(c->boundary, NULL, 1, 1, HSP_TANGENT_OVERLAP, 0, n + 1), HSP_E_ID);
  CHECK_EQUAL(RANGE(c->boundary, NULL, 1, 1, HSP_TANGENT_OVERLAP, n, 1), HSP_E_ID);
  CHECK_EQUAL(RANGE(c->boundary, NULL, 1, 1, HSP_TANGENT_OVERLAP, 2, HSP_NONE), HSP_E_ID);
  CHECK_EQUAL(bad, 12345);
  CHECK_EQUAL(RANGE(c->boundary, NULL, NAN, 1, HSP_TANGENT_OVERLAP, 0, n), HSP_E_NOT_FINITE);
  CHECK_EQUAL(bad, HSP_NONE);
  CHECK_EQUAL(RANGE(c->boundary, NULL, 1, INFINITY, HSP_TANGENT_OVERLAP, 0, n), HSP_E_NOT_FINITE);
  if (n > 1) {
    /* Weights outside of a range are not looked at, but for those of neighbours: of none, if it is empty. */
    CHECK_EQUAL(RANGE(c->boundary, nan_twice, 1, 1, HSP_TANGENT_OVERLAP, 1, 1), HSP_E_NOT_FINITE);
    CHECK_EQUAL(bad, 1);
    CHECK_EQUAL(RANGE(c->boundary, nan_twice, 1, 1, HSP_TANGENT_OVERLAP, 1, 0), HSP_OK);
    CHECK_EQUAL(bad, HSP_NONE);
  }
  CHECK_EQUAL(RANGE(c->boundary, NULL, 1, 1, HSP_TANGENT_DISJOINT, n, 0), HSP_OK);
  CHECK_EQUAL(hsp_boundary_gradient_end(NULL, 1, 1, &energy, flags, numbers), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_gradient_end(c->boundary, 1, 1, &energy, flags, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_gradient_end(c->boundary, NAN, 1, &energy, flags, numbers), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_boundary_gradient_end(c->boundary, 1, -INFINITY, &energy, flags, numbers), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_boundary_gradient_end(c->boundary, 1, 1, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(c->boundary, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(RANGE(c->boundary, NULL, 1, 1, HSP_TANGENT_OVERLAP, 0, n), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_gradient_end(c->boundary, 1, 1, &energy, flags, numbers), HSP_E_STATE);
#undef RANGE
  CHECK_BYTES(numbers, kept, sizeof kept);
  CHECK_BYTES(flags, kept_flags, sizeof kept_flags);
  CHECK_BYTES(&energy, &no_energy, sizeof energy);
}

/* hsp_boundary_gradient_end, property 1. */
static void every_gradient_range(const ball_set *set) {
  computations all;
  uint32_t parts, i;
  if (computations_make(set, NULL, &all)) {
    const computed *c = &all.boundary;
    const uint32_t n = set->n;
    double centre[2][3 * BALL_SET_MOST], radius[2][BALL_SET_MOST], shares[3 * BALL_SET_MOST], sigma[BALL_SET_MOST];
    uint32_t flags[2][BALL_SET_MOST], order[BALL_SET_MOST];
    for (i = 0; i < n; ++i) sigma[i] = i % 4 == 1 ? 0 : 0.75 * i - 2;
    for (parts = 1; parts <= 9; ++parts) {
      const double *const weights = parts % 2 == 0 ? sigma : NULL;
      const uint32_t tangency = parts % 3 == 0 ? HSP_TANGENT_DISJOINT : HSP_TANGENT_OVERLAP;
      hsp_energy energy[2];
      check_scene("gradient of %s in %u parts", set->name, (unsigned)parts);
      memset(centre, 0xA5, sizeof centre);
      memset(radius, 0xA5, sizeof radius);
      memset(flags, 0xA5, sizeof flags);
      CHECK_EQUAL(hsp_boundary_gradient(c->boundary, weights, 0.7, -1.3, tangency, &energy[0], centre[0], radius[0],
                                        flags[0], n, NULL, NULL),
                  HSP_OK);
      ball_set_shuffle(parts, parts, order);
      for (i = 0; i < parts; ++i) {
        const uint32_t first = n * order[i] / parts, last = n * (order[i] + 1) / parts;
        CHECK_EQUAL(hsp_boundary_gradient_range(c->boundary, weights, 0.7, -1.3, tangency, first, last - first,
                                                centre[1], radius[1], flags[1], shares, NULL),
                    HSP_OK);
      }
      CHECK_EQUAL(hsp_boundary_gradient_end(c->boundary, 0.7, -1.3, &energy[1], flags[1], shares), HSP_OK);
      CHECK_BYTES(centre[1], centre[0], sizeof centre[0]);
      CHECK_BYTES(radius[1], radius[0], sizeof radius[0]);
      CHECK_BYTES(flags[1], flags[0], sizeof flags[0]);
      CHECK_BYTES(&energy[1], &energy[0], sizeof energy[0]);
      /* Every array may be missing. */
      CHECK_EQUAL(
          hsp_boundary_gradient_range(c->boundary, weights, 0.7, -1.3, tangency, 0, n, NULL, NULL, NULL, NULL, NULL),
          HSP_OK);
    }
    refused_gradients(c, n);
  }
  computations_release(&all);
}

/* Limits that are too small are reported as by hsp_boundary_compute. */
static void small_limits(const ball_set *set) {
  computations all;
  int which;
  if (computations_make(set, NULL, &all)) {
    const computed *c = &all.boundary;
    for (which = 1; which <= 4; ++which) {
      limit_numbers given = {{0}};
      uint32_t workers;
      memcpy(&given, &c->needed, sizeof c->needed);
      if (given.number[which] == 0) continue;
      given.number[which] = which == 3 ? given.number[which] / 2 : given.number[which] - 1;
      for (workers = 1; workers <= 4; ++workers) {
        hsp_boundary_limits small, by_workers, by_one;
        guarded_memory memory;
        hsp_boundary_counts counts;
        hsp_boundary *boundary;
        check_scene("%s by %u workers, limit %d too small", set->name, (unsigned)workers, which);
        memcpy(&small, &given, sizeof small);
        boundary = make(&small, workers, &memory);
        by_workers = by_one = c->needed;
        work(boundary, c->model, workers, 5);
        CHECK_EQUAL(hsp_boundary_end(boundary, &by_workers), HSP_E_CAPACITY);
        CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
        CHECK_EQUAL(hsp_boundary_end(boundary, &by_workers), HSP_E_STATE);
        CHECK_EQUAL(hsp_boundary_compute(boundary, c->model, &by_one), HSP_E_CAPACITY);
        CHECK_BYTES(&by_workers, &by_one, sizeof by_one);
        CHECK_EQUAL(by_one.workers, workers);
        CHECK(guarded_clean(&memory));
        guarded_give_back(&memory);
      }
    }
  }
  computations_release(&all);
}

/* ---- calls at a wrong time ---- */

static void wrong_times(void) {
  static ball_set set;
  computations all;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 60, 3);
  check_scene("wrong times");
  if (computations_make(&set, NULL, &all)) {
    const computed *c = &all.boundary;
    unsigned char *buffer = buffer_for(&all);
    const uint64_t expected = hash_of(c->boundary, &all, buffer);
    guarded_memory memory, untouched;
    hsp_boundary *boundary = make(&c->needed, 3, &memory), *single = make(&c->needed, 0, &untouched);
    hsp_boundary_limits bad_size = c->needed, limits = c->needed;
    hsp_boundary_counts counts;
    uint32_t stages, unset, stage;
    bad_size.struct_size = 3;
    FILL(unset);
    /* Nothing has begun. */
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 0), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_end(boundary, NULL), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_compute(boundary, c->model, NULL), HSP_OK);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 0), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_end(boundary, NULL), HSP_E_STATE);
    CHECK(hash_of(boundary, &all, buffer) == expected);
    /* Bad arguments drop results, as those of hsp_boundary_compute do. */
    CHECK_EQUAL(hsp_boundary_begin(NULL, c->model, 1, &unset), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_begin(boundary, NULL, 1, &unset), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_begin(boundary, c->model, 1, NULL), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_begin(boundary, c->model, 0, &unset), HSP_E_RANGE);
    CHECK_EQUAL(hsp_boundary_begin(boundary, c->model, 4, &unset), HSP_E_RANGE);
    CHECK_EQUAL(hsp_boundary_begin(single, c->model, 2, &unset), HSP_E_RANGE);
    CHECK_UNTOUCHED(unset);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 0), HSP_E_STATE);
    /* In the middle. */
    CHECK_EQUAL(hsp_boundary_begin(boundary, c->model, 3, &stages), HSP_OK);
    CHECK_EQUAL(hsp_boundary_work(NULL, 0, 0), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 3), HSP_E_ID);
    CHECK_EQUAL(hsp_boundary_work(boundary, stages, 0), HSP_E_ID);
    CHECK_EQUAL(hsp_boundary_work(boundary, HSP_NONE, HSP_NONE), HSP_E_ID);
    CHECK_EQUAL(hsp_boundary_work(boundary, 1, 0), HSP_E_STATE);
    for (stage = 0; stage < stages; ++stage) {
      CHECK_EQUAL(hsp_boundary_work(boundary, stage, 1), HSP_OK);
      CHECK_EQUAL(hsp_boundary_work(boundary, stage, 1), HSP_E_STATE);
      CHECK_EQUAL(hsp_boundary_work(boundary, stage, 2), HSP_OK);
      CHECK_EQUAL(hsp_boundary_work(boundary, stage + 1, 1), stage + 1 < stages ? HSP_E_STATE : HSP_E_ID);
      CHECK_EQUAL(hsp_boundary_end(boundary, NULL), HSP_E_STATE);
      CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
      CHECK_EQUAL(hsp_boundary_work(boundary, stage, 0), HSP_OK);
    }
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 0), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_end(NULL, NULL), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_end(boundary, &bad_size), HSP_E_VERSION);
    CHECK_EQUAL(hsp_boundary_end(boundary, &limits), HSP_OK);
    CHECK(hash_of(boundary, &all, buffer) == expected);
    CHECK_EQUAL(hsp_boundary_end(boundary, &limits), HSP_E_STATE);
    CHECK(hash_of(boundary, &all, buffer) == expected);
    /* Given up. */
    CHECK_EQUAL(hsp_boundary_begin(boundary, c->model, 2, &stages), HSP_OK);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 2), HSP_E_ID);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 0), HSP_OK);
    CHECK_EQUAL(hsp_boundary_compute(boundary, c->model, NULL), HSP_OK);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 1), HSP_E_STATE);
    CHECK(hash_of(boundary, &all, buffer) == expected);
    CHECK_EQUAL(hsp_boundary_begin(boundary, c->model, 2, &stages), HSP_OK);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 0), HSP_OK);
    CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 1), HSP_E_STATE);
    /* Another model, while it is computed. */
    CHECK_EQUAL(hsp_boundary_begin(boundary, c->model, 1, &stages), HSP_OK);
    CHECK_EQUAL(hsp_model_set(c->model, set.n - 1, set.xyz, set.radius, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_boundary_work(boundary, 0, 0), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_end(boundary, &limits), HSP_E_STATE);
    work(boundary, c->model, 3, 1);
    CHECK_EQUAL(hsp_model_set(c->model, set.n, set.xyz, set.radius, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_boundary_end(boundary, &limits), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
    guarded_give_back(&untouched);
    free(buffer);
  }
  computations_release(&all);
}

int main(void) {
  static ball_set set;
  uint32_t which;
  for (which = 0; which < topology_set_count(); ++which) {
    topology_set_make(which, &set);
    every_split(&set);
    every_range(&set);
    every_gradient_range(&set);
    small_limits(&set);
  }
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, BALL_SET_MOST, 11);
  every_split(&set);
  small_limits(&set);
  wrong_times();
  return check_report();
}
