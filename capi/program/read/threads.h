/* The program's own threads: loops whose tasks are divided among threads, and items that are worked on in parallel, but
 * whose results are given in order. On a system without threads, threads_none.c does the same with the calling one. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MOST_THREADS 1024

/* The number of processors on which this process may run. */
uint32_t threads_of_machine(void);

/* Call task(data, 0) to task(data, tasks - 1), each once, by that many threads (fewer if the system gives no more); the
 * calling thread is one of them. Returns when all calls have returned. */
void threads_run(uint32_t threads, uint32_t tasks, void task(void *data, uint32_t task), void *data);

/* Items that come one after the other. Each has a slot for its data and its results. Slots are used again: there are
 * never more items between `take` and `give` than slots. */
struct in_order {
  void *of;
  uint32_t workers; /* 1 .. MOST_THREADS */
  uint32_t slots;   /* at least as many */
  /* The largest weight of all items between `take` and `give` together; one alone may have more. 0: no limit. */
  uint64_t most;
  /* Take the next item into the slot, by one thread at a time, in the order of the items. False: there is none. */
  bool (*take)(void *of, uint32_t slot, uint64_t *weight);
  /* Work on it, by one of the workers. */
  void (*work)(void *of, uint32_t worker, uint32_t slot);
  /* Give its results, by one thread at a time, in the order of the items, as soon as all before it are given. False:
   * nothing more is to be taken or given. */
  bool (*give)(void *of, uint32_t slot);
};

/* Run until all items taken are given, or until `give` ends it. False: memory is short, and nothing was taken. */
bool in_order_run(const struct in_order *loop);
