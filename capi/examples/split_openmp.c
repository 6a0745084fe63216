/* One boundary computed, measured and differentiated by the threads of OpenMP.
 *   split_openmp FILE.xyzr [THREADS]       x y z r on each line */
#include "split_work.h"

static int32_t run(void *context, uint32_t tasks, hsp_task *task, void *data) {
  (void)context;
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < (int)tasks; ++k) task(data, (uint32_t)k);
  return 0;
}

int main(int count, char **arguments) {
  const unsigned long threads = count == 3 ? strtoul(arguments[2], NULL, 10) : 16;
  if (count < 2 || count > 3 || threads < 1 || threads > HSP_MAX_WORKERS) {
    fprintf(stderr, "usage: split_openmp FILE.xyzr [THREADS]\n");
    return 2;
  }
  const hsp_executor executor = {sizeof executor, (uint32_t)threads, NULL, run, NULL};
  return compare_with_one(arguments[1], &executor);
}
