/* The life of a view: results depend on nothing but the balls and the options, not on what the memory held or what was
 * computed in it before; pictures change nothing; several views of one model, and several threads that read one. */
#include <hardsphere.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "picture_sink.h"
#include "topology_sets.h"
#include "view_result.h"

static uint64_t mixed(uint64_t hash, const void *bytes, size_t size) {
  const unsigned char *from = bytes;
  size_t i;
  for (i = 0; i < size; ++i) hash = (hash ^ from[i]) * UINT64_C(0x100000001B3);
  return hash;
}

/* A hash over all records, in a buffer of the caller's; 0 if a call fails. */
static uint64_t everything(const hsp_view *view, void *buffer, uint32_t room) {
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_view_info info;
  hsp_view_limits limits;
  uint32_t needed = 0;
  int bad = 0;
  if (hsp_view_get_info(view, &info) != HSP_OK) return 0;
  bad |= hsp_view_get_needed(view, &limits) != HSP_OK;
  hash = mixed(mixed(hash, &info, sizeof info), &limits, sizeof limits);
  bad |= hsp_view_get_pieces(view, buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_view_piece));
  bad |= hsp_view_get_loops(view, buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_view_loop));
  bad |= hsp_view_get_arcs(view, buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_view_arc));
  return bad ? 0 : hash;
}

static void *buffer_for(const view_result *v) {
  void *buffer = malloc((v->info.arcs + 1) * sizeof(hsp_view_arc)); /* no record is larger, and none are more */
  if (buffer == NULL) exit(2);
  return buffer;
}

static uint32_t larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

/* ---- one handle after another ---- */

static int32_t compute_as(hsp_view *view, const view_result *v) {
  return hsp_view_compute(view, v->base->model, v->with_boundary ? v->base->boundary : NULL, &v->options);
}

static void same_bytes(const view_result *v, const view_result *other) {
  static const int fills[3] = {0x00, 0xFF, GUARDED_RANDOM};
  hsp_view_limits limits = v->needed;
  hsp_view_info info;
  size_t bytes = 0;
  void *buffer = buffer_for(v);
  const uint32_t room = v->info.arcs;
  const uint64_t first = everything(v->view, buffer, room);
  int f;
  limits.balls = larger(limits.balls, other->needed.balls);
  limits.neighbours = larger(limits.neighbours, other->needed.neighbours);
  limits.arcs = larger(limits.arcs, other->needed.arcs);
  CHECK(first != 0);
  CHECK_EQUAL(hsp_view_bytes(&limits, &bytes), HSP_OK);
  for (f = 0; f < 3; ++f) {
    guarded_memory memory = guarded_take(bytes, (size_t)(5 * f), fills[f]);
    hsp_view *view = NULL;
    picture_sink sink;
    CHECK_EQUAL(hsp_view_init(memory.block, bytes, &limits, &view), HSP_OK);
    CHECK_EQUAL(compute_as(view, v), HSP_OK);
    CHECK(everything(view, buffer, room) == first);
    /* a picture uses scratch memory, but leaves results alone */
    picture_sink_start(&sink, SIZE_MAX);
    CHECK_EQUAL(hsp_picture_write(view, NULL, NULL, NULL, NULL, picture_sink_take, &sink, NULL), HSP_OK);
    picture_sink_release(&sink);
    CHECK(everything(view, buffer, room) == first);
    /* another view in between leaves no trace */
    CHECK_EQUAL(compute_as(view, other), HSP_OK);
    CHECK_EQUAL(compute_as(view, v), HSP_OK);
    CHECK(everything(view, buffer, room) == first);
    /* initialising again resets */
    CHECK_EQUAL(hsp_view_init(memory.block, bytes, &limits, &view), HSP_OK);
    CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_E_STATE);
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
  }
  CHECK(everything(v->view, buffer, room) == first);
  free(buffer);
}

static void one_after_another(void) {
  static ball_set set, other_set;
  uint32_t which;
  for (which = 0; which < topology_set_count(); ++which) {
    computed c, other_c;
    view_result v, other;
    hsp_view_options options;
    topology_set_make(which, &set);
    topology_set_make((which + 5) % topology_set_count(), &other_set);
    check_scene("%s, then %s", set.name, other_set.name);
    CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
    CHECK_EQUAL(hsp_view_options_turn(&options, 10.0 * which, 35, 0), HSP_OK);
    options.pieces = which % 2 == 0 ? HSP_PIECES_G : HSP_PIECES_H;
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    CHECK_EQUAL(computed_make(other_set.n, other_set.xyz, other_set.radius, NULL, &other_c), HSP_OK);
    memset(&other, 0, sizeof other);
    if (CHECK_EQUAL(view_result_make(&c, &options, 1, &v), HSP_OK) &&
        CHECK_EQUAL(view_result_make(&other_c, &options, 1, &other), HSP_OK)) {
      same_bytes(&v, &other);
    }
    view_result_release(&v);
    view_result_release(&other);
    computed_release(&c);
    computed_release(&other_c);
  }
}

/* ---- threads ---- */

enum { THREADS = 4, ROUNDS = 10 };

typedef struct work {
  const view_result *shared;
  uint64_t answers;
  int failed;
} work;

/* Reads the shared view and computes one of its own from the shared model and boundary. */
static void *read_and_compute(void *argument) {
  work *mine = argument;
  const view_result *v = mine->shared;
  void *buffer = buffer_for(v), *memory;
  const uint32_t room = v->info.arcs;
  hsp_view *own = NULL;
  size_t bytes = 0;
  int round;
  mine->failed = hsp_view_bytes(&v->needed, &bytes) != HSP_OK;
  memory = malloc(bytes);
  if (memory == NULL) exit(2);
  mine->failed |= hsp_view_init(memory, bytes, &v->needed, &own) != HSP_OK;
  for (round = 0; round < ROUNDS && !mine->failed; ++round) {
    const uint64_t shared = everything(v->view, buffer, room);
    mine->failed |= compute_as(own, v) != HSP_OK;
    mine->failed |= everything(own, buffer, room) != shared;
    mine->answers = mixed(mine->answers, &shared, sizeof shared);
  }
  free(memory);
  free(buffer);
  return NULL;
}

static void in_threads(void) {
  static ball_set set;
  computed c;
  view_result v;
  hsp_view_options options;
  work works[THREADS];
  pthread_t threads[THREADS];
  int k;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 120, 77);
  check_scene("%s", "threads");
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  if (CHECK_EQUAL(view_result_make(&c, &options, 1, &v), HSP_OK)) {
    for (k = 0; k < THREADS; ++k) {
      memset(&works[k], 0, sizeof works[k]);
      works[k].shared = &v;
      if (!CHECK_EQUAL(pthread_create(&threads[k], NULL, read_and_compute, &works[k]), 0)) exit(check_report());
    }
    for (k = 0; k < THREADS; ++k) {
      CHECK_EQUAL(pthread_join(threads[k], NULL), 0);
      CHECK(!works[k].failed);
      CHECK(works[k].answers == works[0].answers);
    }
  }
  view_result_release(&v);
  computed_release(&c);
}

int main(void) {
  one_after_another();
  in_threads();
  return check_report();
}
