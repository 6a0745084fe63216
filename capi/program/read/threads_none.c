#include "read/threads.h"

uint32_t threads_of_machine(void) {
  return 1;
}

void threads_run(uint32_t threads, uint32_t tasks, void task(void *data, uint32_t task), void *data) {
  (void)threads;
  for (uint32_t k = 0; k < tasks; ++k) task(data, k);
}

bool in_order_run(const struct in_order *loop) {
  uint64_t weight = 0;
  while (loop->take(loop->of, 0, &weight)) {
    loop->work(loop->of, 0, 0);
    if (!loop->give(loop->of, 0)) break;
  }
  return true;
}
