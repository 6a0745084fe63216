#include "core/executor.hpp"

#include "core/patience.hpp"

namespace hsp {
namespace {

// A byte for each task, so that no two tasks write the same.
enum Mark : uint8_t { waiting, begun, done };

struct MarkedTasks {
  Executor::Task *task;
  void *data;
  uint32_t tasks;
  uint8_t refused;  // not 0 if a task was called again, or one that there is not
  uint8_t mark[max_tasks];
};

// Marks a task as begun, and returns whether it was waiting. A compiler without an atomic instruction for the exchange
// is for a single core.
bool begin(uint8_t &mark) {
#if defined(__GCC_ATOMIC_CHAR_LOCK_FREE) && __GCC_ATOMIC_CHAR_LOCK_FREE == 2
  return __atomic_exchange_n(&mark, uint8_t{begun}, __ATOMIC_RELAXED) == waiting;
#else
  const bool first = mark == waiting;
  mark = begun;
  return first;
#endif
}

void run_marked(void *data, uint32_t task) {
  MarkedTasks &all = *static_cast<MarkedTasks *>(data);
  if (task >= all.tasks || !begin(all.mark[task])) {
    __atomic_store_n(&all.refused, uint8_t{1}, __ATOMIC_RELAXED);
    return;
  }
  all.task(all.data, task);
  __atomic_store_n(&all.mark[task], uint8_t{done}, __ATOMIC_RELEASE);
}

}  // namespace

bool Executor::run_all(uint32_t tasks, Task *task, void *data) const {
  MarkedTasks all;
  all.task = task;
  all.data = data;
  all.tasks = tasks;
  all.refused = 0;
  for (uint32_t k = 0; k < tasks; ++k) all.mark[k] = waiting;
  bool each = run_(context_, tasks, run_marked, &all);
  each = each && __atomic_load_n(&all.refused, __ATOMIC_RELAXED) == 0;
  for (uint32_t k = 0; k < tasks; ++k) each = each && __atomic_load_n(&all.mark[k], __ATOMIC_ACQUIRE) == done;
  return each && !is_stopped();
}

bool Executor::ask() const {
  if (is_stopped()) return false;
  if (proceed_(context_)) return true;
  __atomic_store_n(&stopped_, uint8_t{1}, __ATOMIC_RELAXED);
  return false;
}

bool Patience::still_allows(uint64_t instructions) {
  spent_ += instructions;
  if (spent_ < without_asking) return !executor_->is_stopped();
  spent_ = 0;
  return executor_->goes_on();
}

}  // namespace hsp
