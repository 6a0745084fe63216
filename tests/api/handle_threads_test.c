/* Handles that are passed as const may be read by any number of threads at a time, and distinct handles used by
 * distinct threads: four threads read one model and one handle of each kind while computing handles of their own. */
#include <hardsphere.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "handle_life.h"

enum { THREADS = 4, ROUNDS = 10 };

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
  if (computations_make(&set, &options, &all)) {
    for (kind = 0; kind < KINDS; ++kind) {
      work works[THREADS];
      pthread_t threads[THREADS];
      check_scene("threads, with %s", kinds_of_life[kind].name);
      for (t = 0; t < THREADS; ++t) {
        memset(&works[t], 0, sizeof works[t]);
        works[t].kind = kind;
        works[t].shared = &all;
        if (!CHECK_EQUAL(pthread_create(&threads[t], NULL, read_and_compute, &works[t]), 0)) exit(check_report());
      }
      for (t = 0; t < THREADS; ++t) {
        CHECK_EQUAL(pthread_join(threads[t], NULL), 0);
        CHECK(!works[t].failed);
        CHECK(works[t].answers == works[0].answers);
      }
    }
  }
  computations_release(&all);
}

int main(void) {
  in_threads();
  return check_report();
}
