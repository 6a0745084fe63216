// The caller's loop, which runs the tasks of a piece of work, in several threads if the caller likes; and the caller's
// function that says whether to go on. Nothing here starts a thread.
//
// As an example ten tasks and a loop of two threads: run() calls task(data, 0) to task(data, 9), say the even ones on
// one thread and the odd ones on the other, and returns when both are done.
#pragma once

#include <cstdint>

#include "core/small_code.hpp"
#include "core/status.hpp"

namespace hsp {

// The largest number of tasks of one loop, and of workers among which a loop is divided.
inline constexpr uint32_t max_tasks = 1024;

class Executor {
 public:
  using Task = void(void *data, uint32_t task);
  using Run = bool(void *context, uint32_t tasks, Task *task, void *data);
  using Proceed = bool(void *context);

  // All work is done in the caller's own thread.
  Executor() = default;
  // run(context, tasks, task, data) calls task(data, k) once for each k below `tasks`, in any order and on any threads,
  // and returns when all are done; false if it could not. With one worker `run` is not used; 0 workers mean 1.
  // proceed(context) says whether to go on, and may be called in any thread; null means always.
  Executor(uint32_t workers, Run *run, void *context, Proceed *proceed = nullptr)
      : workers_(workers < 1           ? 1
                 : workers < max_tasks ? workers
                                       : max_tasks),
        run_(run),
        proceed_(proceed),
        context_(context) {}

  uint32_t workers() const { return workers_; }
  // Whether there are several workers, and code for several is worth its size.
  bool is_parallel() const { return !small_code && workers_ > 1; }

  // Whether the caller may stop the work. Small code never asks.
  bool may_stop() const { return !small_code && proceed_ != nullptr; }
  // Whether to go on. Asks the caller, until the answer is no once.
  bool goes_on() const { return !may_stop() || ask(); }
  bool is_stopped() const { return may_stop() && __atomic_load_n(&stopped_, __ATOMIC_RELAXED) != 0; }
  // The status of work that was left off: stopped, or else the loop failed.
  Status failure() const { return is_stopped() ? Status::stopped : Status::executor; }

  // Does work(0) .. work(tasks - 1) by the caller's loop. False unless each was done once, and false if the caller has
  // stopped the work; each task asks by itself whether to go on. If the loop calls a task a second time, or one that
  // there is not, this call does nothing. tasks <= max_tasks.
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
