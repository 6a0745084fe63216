/* One boundary computed, measured and differentiated by several threads of C11, which are started anew for each loop. A
 * program with a pool of threads hands the tasks to that.
 *   split_threads FILE.xyzr [THREADS]       x y z r on each line */
#include <stdatomic.h>
#include <threads.h>

#include "split_work.h"

enum { MOST_THREADS = 64 };

struct loop {
  uint32_t tasks;
  hsp_task *task;
  void *data;
  atomic_uint next;
};

static int take_part(void *argument) {
  struct loop *loop = argument;
  for (uint32_t k; (k = atomic_fetch_add(&loop->next, 1)) < loop->tasks;) loop->task(loop->data, k);
  return 0;
}

/* context: how many threads, the calling one among them. */
static int32_t run(void *context, uint32_t tasks, hsp_task *task, void *data) {
  const unsigned long *threads = context;
  struct loop loop = {tasks, task, data, 0};
  thrd_t thread[MOST_THREADS];
  unsigned long started = 0;
  while (started + 1 < *threads && thrd_create(&thread[started], take_part, &loop) == thrd_success) ++started;
  take_part(&loop);
  while (started > 0) thrd_join(thread[--started], NULL);
  return 0;
}

int main(int count, char **arguments) {
  unsigned long threads = count == 3 ? strtoul(arguments[2], NULL, 10) : 2;
  if (count < 2 || count > 3 || threads < 1 || threads > MOST_THREADS) {
    fprintf(stderr, "usage: split_threads FILE.xyzr [THREADS]\n");
    return 2;
  }
  const hsp_executor executor = {sizeof executor, (uint32_t)threads, &threads, run, NULL};
  return compare_with_one(arguments[1], &executor);
}
