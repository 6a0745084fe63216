// A loop of the caller's, which does the tasks of a piece of work, side by side if it likes; and the caller's word on
// whether to go on. Nothing here starts a thread.
//
// As an example ten tasks and a loop of two threads: run() calls task(data, 0) to task(data, 9), the even ones on one
// thread and the odd ones on the other, say, and returns when both are done.
#pragma once

#include <cstdint>

#include "core/small_code.hpp"
#include "core/status.hpp"

namespace hsp {

// The most tasks of one loop, and the most workers that a loop is shared out among.
inline constexpr uint32_t max_tasks = 1024;

class Executor {
 public:
  using Task = void(void *data, uint32_t task);
  using Run = bool(void *context, uint32_t tasks, Task *task, void *data);
  using Proceed = bool(void *context);

  // The caller's own thread.
  Executor() = default;
  // run(context, tasks, task, data) calls task(data, k) once for each k below `tasks`, in any order and on any threads,
  // and returns when all are done; false if it could not. One worker takes no run, and 0 is 1. proceed(context) says
  // whether to go on, in any thread; null does always.
  Executor(uint32_t workers, Run *run, void *context, Proceed *proceed = nullptr)
      : workers_(workers < 1           ? 1
                 : workers < max_tasks ? workers
                                       : max_tasks),
        run_(run),
        proceed_(proceed),
        context_(context) {}

  uint32_t workers() const { return workers_; }
  // Whether work that could be done by one is worth code for several.
  bool is_parallel() const { return !small_code && workers_ > 1; }

  // Whether the caller may stop the work, which takes code for asking.
  bool may_stop() const { return !small_code && proceed_ != nullptr; }
  // Whether to go on. Asks until the answer is no.
  bool goes_on() const { return !may_stop() || ask(); }
  bool is_stopped() const { return may_stop() && __atomic_load_n(&stopped_, __ATOMIC_RELAXED) != 0; }
  // Of what was left off.
  Status failure() const { return is_stopped() ? Status::stopped : Status::executor; }

  // Does work(0) .. work(tasks - 1), side by side; false unless each was done once, or if the caller has stopped it:
  // each then asks itself whether to go on. A task that is called a second time, or is none of them, is not done.
  // tasks <= max_tasks.
  template <class Work>
  bool for_each(uint32_t tasks, const Work &work) const {
    if (workers_ > 1 && tasks > 1) {
      const auto do_one = [](void *data, uint32_t task) { (*static_cast<const Work *>(data))(task); };
      return run_all(tasks, do_one, const_cast<Work *>(&work));
    }
    for (uint32_t task = 0; task < tasks; ++task) work(task);
    return !is_stopped();
  }

 private:
  bool run_all(uint32_t tasks, Task *task, void *data) const;
  [[gnu::noinline]] bool ask() const;

  uint32_t workers_ = 1;
  mutable uint8_t stopped_ = 0;
  Run *run_ = nullptr;
  Proceed *proceed_ = nullptr;
  void *context_ = nullptr;
};

}  // namespace hsp
