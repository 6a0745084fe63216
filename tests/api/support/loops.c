#define _POSIX_C_SOURCE 200112L /* barriers */
#include "loops.h"

#include <string.h>

#include "ball_sets.h"

#ifdef HSP_LOOP_THREADS
#include <pthread.h>
#include <stdlib.h>
#endif

loop loop_of(int way) {
  loop made;
  memset(&made, 0, sizeof made);
  made.way = way;
  return made;
}

/* The calls of one run, in their order. */
typedef struct calls {
  hsp_task *task;
  void *data;
  uint32_t count;
  uint32_t number[HSP_MAX_WORKERS + 1];
} calls;

#ifdef HSP_LOOP_THREADS

typedef struct call {
  const calls *all;
  uint32_t which;
  pthread_barrier_t *start;
  pthread_t thread;
} call;

static void *make_call(void *argument) {
  const call *const mine = argument;
  pthread_barrier_wait(mine->start);
  mine->all->task(mine->all->data, mine->all->number[mine->which]);
  return NULL;
}

/* Each in a thread of its own, and none before all threads are there: a sanitizer sees what no join has ordered. */
static void make_calls(const calls *all) {
  pthread_barrier_t start;
  pthread_attr_t small; /* the sanitizer clears what it knows of the whole stack of a thread that begins */
  call *const call_of = malloc((all->count + 1) * sizeof *call_of);
  uint32_t k;
  if (call_of == NULL || pthread_barrier_init(&start, NULL, all->count) != 0) abort();
  if (pthread_attr_init(&small) != 0 || pthread_attr_setstacksize(&small, 256 * 1024) != 0) abort();
  for (k = 0; k < all->count; ++k) {
    call_of[k].all = all;
    call_of[k].which = k;
    call_of[k].start = &start;
    if (pthread_create(&call_of[k].thread, &small, make_call, &call_of[k]) != 0) abort();
  }
  for (k = 0; k < all->count; ++k) pthread_join(call_of[k].thread, NULL);
  pthread_attr_destroy(&small);
  pthread_barrier_destroy(&start);
  free(call_of);
}

#else

static void make_calls(const calls *all) {
  uint32_t k;
  for (k = 0; k < all->count; ++k) all->task(all->data, all->number[k]);
}

#endif

static int32_t run(void *context, uint32_t tasks, hsp_task *task, void *data) {
  loop *const own = context;
  const int way = own->way >= LOOP_RIGHT_WAYS && own->runs < own->first_wrong ? LOOP_IN_ORDER : own->way;
  const uint32_t chosen = own->runs % tasks;
  uint32_t order[HSP_MAX_WORKERS], k;
  calls all;
  for (k = 0; k < tasks; ++k) order[k] = way == LOOP_REVERSED ? tasks - 1 - k : k;
  if (way == LOOP_SHUFFLED) ball_set_shuffle(tasks, own->seed + own->runs, order);
  ++own->runs;
  if (tasks > own->most_tasks) own->most_tasks = tasks;
  if (way == LOOP_DOES_NOTHING) return 0;
  all.task = task;
  all.data = data;
  all.count = 0;
  for (k = 0; k < tasks; ++k) {
    if (way != LOOP_FORGETS || order[k] != chosen) all.number[all.count++] = order[k];
  }
  if (way == LOOP_DOES_TWICE) all.number[all.count++] = chosen;
  if (way == LOOP_ADDS_ONE) all.number[all.count++] = tasks;
  make_calls(&all);
  return 0;
}

hsp_executor executor_of(loop *own, uint32_t workers) {
  return executor_with(run, own, workers);
}

hsp_executor executor_with(int32_t (*run_tasks)(void *, uint32_t, hsp_task *, void *), void *context,
                           uint32_t workers) {
  hsp_executor executor;
  memset(&executor, 0, sizeof executor);
  executor.struct_size = (uint32_t)sizeof executor;
  executor.workers = workers;
  executor.context = context;
  executor.run = run_tasks;
  return executor;
}

int32_t stopper_proceed(void *context) {
  stopper *const own = context;
  return __atomic_fetch_add(&own->asked, 1, __ATOMIC_RELAXED) >= own->stop_at ? 7 : 0;
}
