/* The life of a handle: results depend on nothing but what it is computed from, not on what its memory held or what was
 * computed in it before; reading, checking and drawing change nothing; initialising again resets. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "handle_life.h"
#include "topology_sets.h"

static void same_results(int kind, const computations *all, const computations *other) {
  static const int fills[3] = {0x00, 0xFF, GUARDED_RANDOM};
  const kind_of_life *k = &kinds_of_life[kind];
  const void *source = source_of(all, kind);
  unsigned char *buffer = buffer_for(all);
  const uint64_t first = k->hash(handle_of(all, kind), source, buffer, all->room);
  limit_numbers limits = limits_of(all, kind);
  const limit_numbers more = limits_of(other, kind);
  size_t bytes = 0;
  int f, which;
  for (which = 1; which < LIMIT_NUMBERS; ++which) {
    if (more.number[which] > limits.number[which]) limits.number[which] = more.number[which];
  }
  CHECK(first != 0);
  CHECK_EQUAL(k->kind->bytes(&limits, &bytes), HSP_OK);
  for (f = 0; f < 3; ++f) {
    guarded_memory memory = guarded_take(bytes, (size_t)(5 * f), fills[f]);
    void *handle = NULL;
    CHECK_EQUAL(k->kind->init(memory.block, bytes, &limits, &handle), HSP_OK);
    CHECK_EQUAL(k->kind->compute(handle, source, NULL), HSP_OK);
    CHECK(k->hash(handle, source, buffer, all->room) == first);
    CHECK(k->use(handle));
    CHECK(k->hash(handle, source, buffer, all->room) == first);
    /* another computation in between leaves no trace */
    CHECK_EQUAL(k->kind->compute(handle, source_of(other, kind), NULL), HSP_OK);
    CHECK_EQUAL(k->kind->compute(handle, source, NULL), HSP_OK);
    CHECK(k->hash(handle, source, buffer, all->room) == first);
    /* initialising again resets */
    CHECK_EQUAL(k->kind->init(memory.block, bytes, &limits, &handle), HSP_OK);
    CHECK(k->hash(handle, source, buffer, all->room) == 0);
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
  }
  CHECK(k->hash(handle_of(all, kind), source, buffer, all->room) == first);
  free(buffer);
}

static void one_after_another(void) {
  static ball_set set, other_set;
  uint32_t which;
  int kind;
  for (which = 0; which < topology_set_count(); ++which) {
    computations all, other;
    hsp_view_options options;
    topology_set_make(which, &set);
    topology_set_make((which + 5) % topology_set_count(), &other_set);
    CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
    CHECK_EQUAL(hsp_view_options_turn(&options, 10.0 * which, 35, 0), HSP_OK);
    options.pieces = which % 2 == 0 ? HSP_PIECES_OUTSIDE_FARTHER : HSP_PIECES_OUTSIDE_ALL;
    check_scene("%s, then %s", set.name, other_set.name);
    memset(&other, 0, sizeof other);
    if (computations_make(&set, &options, &all) && computations_make(&other_set, &options, &other)) {
      for (kind = 0; kind < KINDS; ++kind) {
        if (handle_of(&all, kind) == NULL || handle_of(&other, kind) == NULL) continue;
        check_scene("%s, then %s, with %s", set.name, other_set.name, kinds_of_life[kind].name);
        same_results(kind, &all, &other);
      }
    }
    computations_release(&all);
    computations_release(&other);
  }
}

/* Earlier contents of the model's memory make no difference, nor does another set in between; init again resets. */
static void same_model(const ball_set *set, const ball_set *other) {
  static const int fills[3] = {0x00, 0xFF, GUARDED_RANDOM};
  const uint32_t room = set->n > other->n ? set->n : other->n;
  computations known, other_known, own;
  size_t model_bytes = 0;
  int f, round;
  CHECK_EQUAL(hsp_model_bytes(room, &model_bytes), HSP_OK);
  if (!computations_make(set, NULL, &known) || !computations_make(other, NULL, &other_known)) exit(check_report());
  own = known;
  for (f = 0; f < 3; ++f) {
    guarded_memory memory = guarded_take(model_bytes, (size_t)f, fills[f]);
    hsp_model *model = NULL;
    hsp_model_info info;
    CHECK_EQUAL(hsp_model_init(memory.block, model_bytes, room, &model), HSP_OK);
    own.boundary.model = model;
    for (round = 0; round < 3; ++round) {
      CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, set->radius, NULL, NULL), HSP_OK);
      same_results(BOUNDARY, &own, &other_known);
      CHECK_EQUAL(hsp_model_set(model, other->n, other->xyz, other->radius, NULL, NULL), HSP_OK);
    }
    CHECK_EQUAL(hsp_model_init(memory.block, model_bytes, room, &model), HSP_OK);
    CHECK_EQUAL(hsp_model_get_info(model, &info), HSP_OK);
    CHECK_EQUAL(info.balls, 0);
    CHECK_EQUAL(info.cubes, 0);
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
  }
  computations_release(&known);
  computations_release(&other_known);
}

/* Two boundaries of one model, and one boundary of two models in turn. */
static void several_handles(void) {
  static ball_set one_set, other_set;
  computed one, other;
  hsp_boundary_counts counts;
  ball_set_start(&one_set, "one", 1e-8);
  ball_set_add_chain(&one_set, 30, 31);
  ball_set_start(&other_set, "other", 1e-8);
  ball_set_add_chain(&other_set, 30, 32);
  CHECK_EQUAL(computed_make(one_set.n, one_set.xyz, one_set.radius, NULL, &one), HSP_OK);
  CHECK_EQUAL(computed_make(other_set.n, other_set.xyz, other_set.radius, NULL, &other), HSP_OK);
  if (one.needed.vertices > other.needed.vertices || one.needed.neighbours > other.needed.neighbours ||
      one.needed.circles > other.needed.circles) {
    /* the boundary of `other` may be too small for `one`; then it says so and recovers */
    const int32_t status = hsp_boundary_compute(other.boundary, one.model, NULL);
    CHECK(status == HSP_E_CAPACITY || status == HSP_OK);
  } else {
    CHECK_EQUAL(hsp_boundary_compute(other.boundary, one.model, NULL), HSP_OK);
    CHECK_EQUAL(hsp_boundary_get_counts(other.boundary, &counts), HSP_OK);
    CHECK_BYTES(&counts, &one.counts, sizeof counts);
  }
  CHECK_EQUAL(hsp_boundary_compute(other.boundary, other.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(other.boundary, &counts), HSP_OK);
  CHECK_BYTES(&counts, &other.counts, sizeof counts);
  /* what happens to the other model is no matter to results of this one */
  CHECK_EQUAL(hsp_model_set(one.model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(other.boundary, &counts), HSP_OK);
  CHECK_EQUAL(hsp_boundary_get_counts(one.boundary, &counts), HSP_E_STATE);
  computed_release(&one);
  computed_release(&other);
}

int main(void) {
  static ball_set set, other;
  uint32_t which;
  one_after_another();
  for (which = 0; which < ball_set_count(); ++which) {
    ball_set_make(which, &set);
    ball_set_make((which + 7) % ball_set_count(), &other);
    check_scene("%s, then %s", set.name, other.name);
    same_model(&set, &other);
  }
  check_scene("%s", "several handles");
  several_handles();
  return check_report();
}
