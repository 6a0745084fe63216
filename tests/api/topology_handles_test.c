/* The life of a topology: results depend on nothing but the balls, not on what the memory held or what was computed in
 * it before; reading, locating and checking change nothing; several topologies of one boundary; and several threads
 * that read one. */
#include <hardsphere.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "topology_result.h"
#include "topology_sets.h"

/* ---- a hash over everything that can be read ---- */

static uint64_t mixed(uint64_t hash, const void *bytes, size_t size) {
  const unsigned char *from = bytes;
  size_t i;
  for (i = 0; i < size; ++i) hash = (hash ^ from[i]) * UINT64_C(0x100000001B3);
  return hash;
}

/* The records, in buffers of the caller's; 0 if a call fails. */
static uint64_t everything(const hsp_topology *topology, unsigned char *buffer, uint32_t room) {
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_topology_counts counts;
  hsp_topology_limits needed_limits;
  uint32_t needed = 0, q, id;
  int bad = 0;
  if (hsp_topology_get_counts(topology, &counts) != HSP_OK) return 0;
  bad |= hsp_topology_get_needed(topology, &needed_limits) != HSP_OK;
  hash = mixed(mixed(hash, &counts, sizeof counts), &needed_limits, sizeof needed_limits);
  bad |= hsp_topology_get_vertices(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_topology_vertex));
  bad |= hsp_topology_get_edges(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_topology_edge));
  bad |= hsp_topology_get_faces(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_simple_face));
  bad |= hsp_topology_get_quad_edges(topology, (void *)buffer, NULL, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * 4 * sizeof(uint32_t));
  bad |= hsp_topology_get_shells(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_shell));
  bad |= hsp_topology_get_components(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_component));
  bad |= hsp_topology_get_cells(topology, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed(hash, buffer, needed * sizeof(hsp_cell));
  for (id = 0; id < counts.cells; ++id) {
    bad |= hsp_topology_get_cell_shells(topology, id, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed(hash, buffer, needed * sizeof(uint32_t));
  }
  for (id = 0; id < counts.shells; ++id) {
    bad |= hsp_topology_get_scan(topology, id, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed(hash, buffer, needed * sizeof(uint32_t));
  }
  for (q = 0; q < 4 * counts.edges; q += 3) {
    uint32_t steps[5];
    steps[0] = hsp_topology_onext(topology, q);
    steps[1] = hsp_topology_lprev(topology, q);
    steps[2] = hsp_topology_origin(topology, q);
    steps[3] = hsp_topology_left(topology, q);
    steps[4] = hsp_topology_ball(topology, q);
    hash = mixed(hash, steps, sizeof steps);
  }
  return bad ? 0 : hash;
}

static unsigned char *buffer_for(const topology_result *t, uint32_t *room) {
  unsigned char *buffer;
  *room = t->counts.edges + t->counts.shells + t->counts.cells + 1;
  buffer = malloc(*room * (sizeof(hsp_topology_edge) + sizeof(hsp_shell))); /* no record is larger */
  if (buffer == NULL) exit(2);
  return buffer;
}

/* ---- one handle after another ---- */

static uint32_t larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

static void same_bytes(const topology_result *t, const topology_result *other) {
  static const int fills[3] = {0x00, 0xFF, GUARDED_RANDOM};
  static const double place[3] = {0.5, 0.25, 0.125};
  hsp_topology_limits limits = t->needed;
  hsp_topology_counts counts;
  size_t bytes = 0;
  uint32_t room, law, where, cell;
  unsigned char *buffer = buffer_for(t, &room);
  uint64_t first;
  int f;
  limits.balls = larger(limits.balls, other->needed.balls);
  limits.neighbours = larger(limits.neighbours, other->needed.neighbours);
  limits.edges = larger(limits.edges, other->needed.edges);
  limits.extra_arcs = larger(limits.extra_arcs, other->needed.extra_arcs);
  first = everything(t->topology, buffer, room);
  CHECK(first != 0);
  CHECK_EQUAL(hsp_topology_bytes(&limits, &bytes), HSP_OK);
  for (f = 0; f < 3; ++f) {
    guarded_memory memory = guarded_take(bytes, (size_t)(5 * f), fills[f]);
    hsp_topology *topology = NULL;
    CHECK_EQUAL(hsp_topology_init(memory.block, bytes, &limits, &topology), HSP_OK);
    CHECK_EQUAL(hsp_topology_compute(topology, t->base->boundary), HSP_OK);
    CHECK(everything(topology, buffer, room) == first);
    /* what uses scratch memory leaves results alone */
    CHECK_EQUAL(hsp_topology_check(topology, &law, &where), HSP_OK);
    CHECK_EQUAL(hsp_topology_locate(topology, place, &cell, NULL, 0, NULL), HSP_OK);
    CHECK(everything(topology, buffer, room) == first);
    /* another boundary in between leaves no trace */
    CHECK_EQUAL(hsp_topology_compute(topology, other->base->boundary), HSP_OK);
    CHECK_EQUAL(hsp_topology_compute(topology, t->base->boundary), HSP_OK);
    CHECK(everything(topology, buffer, room) == first);
    /* initialising again resets */
    CHECK_EQUAL(hsp_topology_init(memory.block, bytes, &limits, &topology), HSP_OK);
    CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_E_STATE);
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
  }
  CHECK(everything(t->topology, buffer, room) == first);
  free(buffer);
}

static void one_after_another(void) {
  static ball_set set, other_set;
  uint32_t which;
  for (which = 0; which < topology_set_count(); ++which) {
    computed c, other_c;
    topology_result t, other;
    topology_set_make(which, &set);
    topology_set_make((which + 5) % topology_set_count(), &other_set);
    check_scene("%s, then %s", set.name, other_set.name);
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    CHECK_EQUAL(computed_make(other_set.n, other_set.xyz, other_set.radius, NULL, &other_c), HSP_OK);
    memset(&other, 0, sizeof other);
    if (CHECK_EQUAL(topology_result_make(&c, &t), HSP_OK) &&
        CHECK_EQUAL(topology_result_make(&other_c, &other), HSP_OK)) {
      same_bytes(&t, &other);
    }
    topology_result_release(&t);
    topology_result_release(&other);
    computed_release(&c);
    computed_release(&other_c);
  }
}

/* ---- threads ---- */

enum { THREADS = 4, ROUNDS = 10 };

typedef struct work {
  const topology_result *shared;
  uint64_t answers;
  int failed;
} work;

/* Reads the shared topology and computes one of its own from the shared boundary. */
static void *read_and_compute(void *argument) {
  work *mine = argument;
  const topology_result *t = mine->shared;
  uint32_t room;
  unsigned char *buffer = buffer_for(t, &room);
  hsp_topology *own = NULL;
  size_t bytes = 0;
  void *memory;
  int round;
  mine->failed = hsp_topology_bytes(&t->needed, &bytes) != HSP_OK;
  memory = malloc(bytes);
  if (memory == NULL) exit(2);
  mine->failed |= hsp_topology_init(memory, bytes, &t->needed, &own) != HSP_OK;
  for (round = 0; round < ROUNDS && !mine->failed; ++round) {
    uint32_t law = 77, where = 77;
    const uint64_t shared = everything(t->topology, buffer, room);
    mine->failed |= hsp_topology_compute(own, t->base->boundary) != HSP_OK;
    mine->failed |= everything(own, buffer, room) != shared;
    mine->failed |= hsp_topology_check(own, &law, &where) != HSP_OK;
    mine->answers = mixed(mine->answers, &shared, sizeof shared);
  }
  free(memory);
  free(buffer);
  return NULL;
}

static void in_threads(void) {
  static ball_set set;
  computed c;
  topology_result t;
  work works[THREADS];
  pthread_t threads[THREADS];
  int k;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 120, 77);
  check_scene("%s", "threads");
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  if (CHECK_EQUAL(topology_result_make(&c, &t), HSP_OK)) {
    for (k = 0; k < THREADS; ++k) {
      memset(&works[k], 0, sizeof works[k]);
      works[k].shared = &t;
      if (!CHECK_EQUAL(pthread_create(&threads[k], NULL, read_and_compute, &works[k]), 0)) exit(check_report());
    }
    for (k = 0; k < THREADS; ++k) {
      CHECK_EQUAL(pthread_join(threads[k], NULL), 0);
      CHECK(!works[k].failed);
      CHECK(works[k].answers == works[0].answers);
    }
  }
  topology_result_release(&t);
  computed_release(&c);
}

int main(void) {
  one_after_another();
  in_threads();
  return check_report();
}
