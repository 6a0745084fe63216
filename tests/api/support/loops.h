/* Loops for executors: tasks in several orders, and loops that break the rules. */
#pragma once

#include <hardsphere.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { LOOP_IN_ORDER, LOOP_REVERSED, LOOP_SHUFFLED, LOOP_RIGHT_WAYS };
enum { LOOP_FORGETS = LOOP_RIGHT_WAYS, LOOP_DOES_TWICE, LOOP_ADDS_ONE, LOOP_DOES_NOTHING, LOOP_WAYS };

typedef struct loop {
  int way;
  uint32_t first_wrong; /* run in which a wrong way begins; before, tasks are done in order */
  uint32_t runs;        /* made so far */
  uint32_t most_tasks;  /* of them */
  uint64_t seed;        /* of LOOP_SHUFFLED */
} loop;

loop loop_of(int way);

hsp_executor executor_of(loop *own, uint32_t workers);

/* Of a loop of one's own. */
hsp_executor executor_with(int32_t (*run_tasks)(void *, uint32_t, hsp_task *, void *), void *context, uint32_t workers);

/* A loop that counts the questions whether to go on, and says no from number `stop_at` on, the first being 0. It comes
 * first, as it is the context of what runs it; `proceed` of the executor is stopper_proceed. */
typedef struct stopper {
  loop own;
  uint32_t asked, stop_at;
} stopper;

int32_t stopper_proceed(void *context);

#ifdef __cplusplus
}
#endif
