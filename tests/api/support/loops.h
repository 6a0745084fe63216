/* Loops for executors (hsp_executor): loops that run tasks in several orders, and loops that break the rules by
 * forgetting, repeating or adding a task. */
#pragma once

#include <hardsphere.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifdef HSP_LOOP_THREADS
/* All tasks start together, in no order. */
enum { LOOP_IN_ORDER, LOOP_REVERSED = LOOP_IN_ORDER, LOOP_SHUFFLED = LOOP_IN_ORDER, LOOP_RIGHT_WAYS };
#else
enum { LOOP_IN_ORDER, LOOP_REVERSED, LOOP_SHUFFLED, LOOP_RIGHT_WAYS };
#endif
enum { LOOP_FORGETS = LOOP_RIGHT_WAYS, LOOP_DOES_TWICE, LOOP_ADDS_ONE, LOOP_DOES_NOTHING, LOOP_WAYS };

typedef struct loop {
  int way;
  uint32_t first_wrong; /* the run from which on a rule is broken; earlier runs do the tasks in order */
  uint32_t runs;        /* number of runs so far */
  uint32_t most_tasks;  /* largest number of tasks in a run so far */
  uint64_t seed;        /* of the order of LOOP_SHUFFLED */
} loop;

loop loop_of(int way);

hsp_executor executor_of(loop *own, uint32_t workers);

/* An executor for any other loop. */
hsp_executor executor_with(int32_t (*run_tasks)(void *, uint32_t, hsp_task *, void *), void *context, uint32_t workers);

/* A loop whose caller counts the questions whether to go on, and says no from question number `stop_at` on, counted
 * from 0. The executor's `proceed` is stopper_proceed. `own` is the first member, so that one context serves both
 * functions. */
typedef struct stopper {
  loop own;
  uint32_t asked, stop_at;
} stopper;

int32_t stopper_proceed(void *context);

#ifdef __cplusplus
}
#endif
