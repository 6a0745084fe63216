/* Every limit of hsp_model and hsp_boundary, for every set of the catalogue, at 0, 1, needed-1, needed and needed+1,
 * with guard bytes around memory of exactly the size that the bytes function tells. */
#include <hardsphere.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "guarded_memory.h"
#include "limit_sweep.h"
#include "output_sweep.h"

static void sweep_model(const ball_set *set) {
  uint32_t limits[AROUND], i;
  values_around(set->n, limits);
  for (i = 0; i < AROUND; ++i) {
    size_t bytes = 0;
    guarded_memory memory;
    hsp_model *model = NULL;
    hsp_model_info info;
    uint32_t bad = 12345;
    CHECK_EQUAL(hsp_model_bytes(limits[i], &bytes), HSP_OK);
    memory = guarded_take(bytes, i, GUARDED_RANDOM);
    if (CHECK_EQUAL(hsp_model_init(memory.block, bytes, limits[i], &model), HSP_OK)) {
      CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, set->radius, NULL, &bad),
                  limits[i] < set->n ? HSP_E_CAPACITY : HSP_OK);
      CHECK_EQUAL(bad, HSP_NONE);
      CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
      CHECK_EQUAL(info.balls, limits[i] < set->n ? 0 : set->n);
    }
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
  }
}

static void check_results(const void *boundary, const void *source) {
  const computed *all = source;
  hsp_boundary_counts counts;
  hsp_totals totals;
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  CHECK_BYTES(&counts, &all->counts, sizeof counts);
  CHECK_EQUAL(hsp_boundary_measure(boundary, &totals, NULL, NULL, 0), HSP_OK);
  CHECK_BYTES(&totals, &all->totals, sizeof totals);
}

static void check_no_results(const void *boundary) {
  hsp_boundary_counts counts;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_get_faces(boundary, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, NULL, 0), HSP_E_STATE);
  CHECK_EQUAL(count, 12345);
}

/* Exactly the limits that are too small are reported with more than was given, and with what the full computation
 * needs: balls first, then neighbours, then vertices and circles. */
static void check_asked(const limit_numbers *given, const limit_numbers *says, const limit_numbers *exact) {
  static const int stages[3][2] = {{1, 1}, {2, 2}, {3, 4}};
  int stage, which, enough = 1;
  for (stage = 0; stage < 3 && enough; ++stage) {
    for (which = stages[stage][0]; which <= stages[stage][1]; ++which) {
      const int more = says->number[which] > given->number[which];
      CHECK_EQUAL(more, exact->number[which] > given->number[which]);
      CHECK(!more || says->number[which] == exact->number[which]);
      if (more) enough = 0;
    }
  }
}

static void sweep_boundary(const computed *all, const char *name) {
  const known_handle known = {&boundary_handle, all, &all->needed, check_results, check_no_results, check_asked};
  sweep_limits(&known, name);
  if (all->needed.vertices > 0 || all->needed.circles > 0) {
    limit_numbers limits = {{0}};
    memcpy(&limits, &all->needed, sizeof all->needed);
    limits.number[3] = limits.number[4] = 0;
    check_scene("%s, neither vertices nor circles", name);
    try_limits(&known, &limits, 5);
  }
}

/* One boundary goes from failure to success and back; nothing of the failure stays. */
static void fail_and_succeed(const computed *all) {
  static const double one_xyz[3] = {0, 0, 0};
  static const double one_radius[1] = {1};
  hsp_boundary_limits limits = all->needed, needed;
  hsp_boundary_counts counts;
  size_t bytes = 0, model_bytes = 0;
  guarded_memory memory, model_memory;
  hsp_boundary *boundary = NULL;
  hsp_model *model = NULL;
  if (limits.vertices == 0) return;
  limits.vertices -= 1;
  CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
  CHECK_EQUAL(hsp_model_bytes(1, &model_bytes), HSP_OK);
  memory = guarded_take(bytes, 0, GUARDED_RANDOM);
  model_memory = guarded_take(model_bytes, 0, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_boundary_init(memory.block, bytes, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_model_init(model_memory.block, model_bytes, 1, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, 1, one_xyz, one_radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, all->model), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  CHECK_EQUAL(counts.balls, 1);
  CHECK_EQUAL(counts.faces, 1);
  CHECK_EQUAL(hsp_boundary_compute(boundary, all->model), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_get_needed(boundary, &needed), HSP_OK);
  CHECK_EQUAL(needed.vertices, all->needed.vertices);
  CHECK(guarded_clean(&memory) && guarded_clean(&model_memory));
  guarded_give_back(&memory);
  guarded_give_back(&model_memory);
}

int main(void) {
  uint32_t which;
  for (which = 0; which < ball_set_count(); ++which) {
    static ball_set set;
    computed all;
    ball_set_make(which, &set);
    check_scene("%s", set.name);
    sweep_model(&set);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &all), HSP_OK)) {
      sweep_boundary(&all, set.name);
      check_scene("%s", set.name);
      fail_and_succeed(&all);
    }
    computed_release(&all);
  }
  return check_report();
}
