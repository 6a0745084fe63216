/* Threads of the program's own: loops whose tasks they share, and items that they work on side by side and give in
 * order. Where a system has no threads, threads_none.c does the same with the calling one. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MOST_THREADS 1024

/* As many as there are processors that this process may run on. */
uint32_t threads_of_machine(void);

/* Call task(data, 0) to task(data, tasks - 1), each once, by as many threads, the calling one among them; fewer if the
 * system has no more. Returns when all have returned. */
void threads_run(uint32_t threads, uint32_t tasks, void task(void *data, uint32_t task), void *data);

/* Items that come one after the other. Each has a slot for what is read of it and for its results, and slots are used
 * again; there are no more items between `take` and `give` than slots. */
struct in_order {
  void *of;
  uint32_t workers; /* 1 .. MOST_THREADS */
  uint32_t slots;   /* at least as many */
  /* That items between `take` and `give` may weigh together; one alone may weigh more. 0: any weight. */
  uint64_t most;
  /* Take the next item into the slot, by one thread at a time, in the order of the items. False: there is none. */
  bool (*take)(void *of, uint32_t slot, uint64_t *weight);
  /* Work on it, by one of the workers. */
  void (*work)(void *of, uint32_t worker, uint32_t slot);
  /* Give its results, by one thread at a time, in the order of the items, as soon as all before it are given. False:
   * nothing more is to be taken or given. */
  bool (*give)(void *of, uint32_t slot);
};

/* Until all that is taken is given, or `give` ends it. False: memory is short, and nothing was taken. */
bool in_order_run(const struct in_order *loop);
