#include "loops.h"

#include <string.h>

#include "ball_sets.h"

loop loop_of(int way) {
  loop made;
  memset(&made, 0, sizeof made);
  made.way = way;
  return made;
}

static void run(void *context, uint32_t tasks, hsp_task *task, void *data) {
  loop *const own = context;
  const int way = own->way >= LOOP_RIGHT_WAYS && own->runs < own->first_wrong ? LOOP_IN_ORDER : own->way;
  const uint32_t chosen = own->runs % tasks;
  uint32_t order[HSP_MAX_WORKERS], k;
  for (k = 0; k < tasks; ++k) order[k] = way == LOOP_REVERSED ? tasks - 1 - k : k;
  if (way == LOOP_SHUFFLED) ball_set_shuffle(tasks, own->seed + own->runs, order);
  ++own->runs;
  if (tasks > own->most_tasks) own->most_tasks = tasks;
  if (way == LOOP_DOES_NOTHING) return;
  for (k = 0; k < tasks; ++k) {
    if (way != LOOP_FORGETS || order[k] != chosen) task(data, order[k]);
  }
  if (way == LOOP_DOES_TWICE) task(data, chosen);
  if (way == LOOP_ADDS_ONE) task(data, tasks);
}

hsp_executor executor_of(loop *own, uint32_t workers) {
  hsp_executor executor;
  memset(&executor, 0, sizeof executor);
  executor.struct_size = (uint32_t)sizeof executor;
  executor.workers = workers;
  executor.context = own;
  executor.run = run;
  return executor;
}
