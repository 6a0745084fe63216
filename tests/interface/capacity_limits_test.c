/* Every limit of hsp_model and hsp_boundary, for every set of the catalogue, at 0, 1, needed-1, needed and needed+1,
 * with guard bytes around memory of exactly the size that the bytes function tells. */
#include <hardsphere.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "guarded_memory.h"

static void sweep_model(const ball_set *set) {
  uint32_t limits[5], i;
  limits[0] = 0;
  limits[1] = 1;
  limits[2] = set->n == 0 ? 0 : set->n - 1;
  limits[3] = set->n;
  limits[4] = set->n + 1;
  for (i = 0; i < 5; ++i) {
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

/* A boundary with room for `limits`; what it says about them must agree with what the full computation needed. */
static void try_limits(const computed *all, const hsp_boundary_limits *limits, size_t misalignment) {
  const hsp_boundary_limits *suffices = &all->needed;
  const int enough = limits->balls >= suffices->balls && limits->neighbours >= suffices->neighbours &&
                     limits->vertices >= suffices->vertices && limits->circles >= suffices->circles;
  size_t bytes = 0;
  guarded_memory memory;
  hsp_boundary *boundary = NULL;
  hsp_boundary_limits needed;
  hsp_boundary_counts counts;
  uint32_t count = 12345;
  if (!CHECK_EQUAL(hsp_boundary_bytes(limits, &bytes), HSP_OK)) return;
  memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_boundary_init(memory.block, bytes, limits, &boundary), HSP_OK);
  memset(&needed, 0, sizeof needed);
  if (enough) {
    hsp_totals totals;
    CHECK_EQUAL(hsp_boundary_compute(boundary, all->model), HSP_OK);
    CHECK_EQUAL(hsp_boundary_get_needed(boundary, &needed), HSP_OK);
    CHECK_BYTES(&needed, suffices, sizeof needed);
    CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
    CHECK_BYTES(&counts, &all->counts, sizeof counts);
    CHECK_EQUAL(hsp_boundary_measure(boundary, &totals, NULL, NULL, 0), HSP_OK);
    CHECK_BYTES(&totals, &all->totals, sizeof totals);
  } else {
    CHECK_EQUAL(hsp_boundary_compute(boundary, all->model), HSP_E_CAPACITY);
    CHECK_EQUAL(hsp_boundary_get_needed(boundary, &needed), HSP_OK);
    CHECK_EQUAL(needed.struct_size, sizeof needed);
    CHECK_EQUAL(needed.reserved, 0);
    /* exactly the limits that are too small are reported with more than was given */
    CHECK_EQUAL(needed.balls > limits->balls, suffices->balls > limits->balls);
    if (limits->balls >= suffices->balls) {
      CHECK_EQUAL(needed.neighbours > limits->neighbours, suffices->neighbours > limits->neighbours);
      CHECK(needed.neighbours <= limits->neighbours || needed.neighbours == suffices->neighbours);
      if (limits->neighbours >= suffices->neighbours) {
        CHECK_EQUAL(needed.vertices > limits->vertices, suffices->vertices > limits->vertices);
        CHECK_EQUAL(needed.circles > limits->circles, suffices->circles > limits->circles);
        CHECK(needed.vertices <= limits->vertices || needed.vertices == suffices->vertices);
        CHECK(needed.circles <= limits->circles || needed.circles == suffices->circles);
      }
    }
    check_scene("%s", "no results after HSP_E_CAPACITY");
    CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_get_faces(boundary, NULL, 0, &count), HSP_E_STATE);
    CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, NULL, 0), HSP_E_STATE);
    CHECK_EQUAL(count, 12345);
  }
  CHECK(guarded_clean(&memory));
  guarded_give_back(&memory);
}

static uint32_t *limit_number(hsp_boundary_limits *limits, int which) {
  switch (which) {
    case 0:
      return &limits->balls;
    case 1:
      return &limits->neighbours;
    case 2:
      return &limits->vertices;
    default:
      return &limits->circles;
  }
}

static void sweep_boundary(const computed *all, const char *name) {
  static const char *const names[4] = {"balls", "neighbours", "vertices", "circles"};
  hsp_boundary_limits limits = all->needed;
  int which, i;
  check_scene("%s, all limits exact", name);
  try_limits(all, &limits, 1);
  for (which = 0; which < 4; ++which) {
    const uint32_t needed = *limit_number(&limits, which);
    uint32_t values[5];
    values[0] = 0;
    values[1] = 1;
    values[2] = needed == 0 ? 0 : needed - 1;
    values[3] = needed;
    values[4] = needed + 1;
    for (i = 0; i < 5; ++i) {
      check_scene("%s, %s %u of %u", name, names[which], (unsigned)values[i], (unsigned)needed);
      *limit_number(&limits, which) = values[i];
      try_limits(all, &limits, (size_t)(3 * i + which));
    }
    *limit_number(&limits, which) = needed;
  }
  if (all->needed.vertices > 0 || all->needed.circles > 0) {
    check_scene("%s, neither vertices nor circles", name);
    limits.vertices = 0;
    limits.circles = 0;
    try_limits(all, &limits, 5);
  }
  check_scene("%s, nothing at all", name);
  limits = all->needed;
  limits.balls = limits.neighbours = limits.vertices = limits.circles = 0;
  try_limits(all, &limits, 7);
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
