// Work that threads of the caller's share.
#pragma once

#include <type_traits>

#include "core/executor.hpp"
#include "library_arithmetic.hpp"
#include "versioned_struct.hpp"

namespace hsp::capi {

static_assert(std::is_same_v<hsp_task, hsp::Executor::Task>);
static_assert(max_tasks == HSP_MAX_WORKERS);

// An executor of the caller's, or null for none. Its loop runs in the caller's floating-point environment, each task in
// the library's: a thread has registers of its own.
class Executor : public hsp::Executor {
 public:
  explicit Executor(LibraryArithmetic &arithmetic) : arithmetic_(arithmetic) {}
  // A loop has its address.
  Executor(const Executor &) = delete;
  Executor &operator=(const Executor &) = delete;

  int32_t read(const hsp_executor *given) {
    if (given == nullptr) return HSP_OK;
    if (const int32_t status = read_struct(given, {}, given_); status != HSP_OK) return status;
    if (given_.workers > 1 && given_.run == nullptr) return HSP_E_ARGUMENT;
    static_cast<hsp::Executor &>(*this) = {given_.workers, run_given, this};
    return HSP_OK;
  }

 private:
  struct Work {
    hsp_task *task;
    void *data;
  };

  static void run_given(void *context, uint32_t tasks, hsp_task *task, void *data) {
    const Executor &executor = *static_cast<const Executor *>(context);
    Work work{task, data};
    const CallersArithmetic callers(executor.arithmetic_);
    executor.given_.run(executor.given_.context, tasks, do_task, &work);
  }
  static void do_task(void *data, uint32_t number) {
    const Work &work = *static_cast<const Work *>(data);
    const LibraryArithmetic arithmetic;
    work.task(work.data, number);
  }

  LibraryArithmetic &arithmetic_;
  hsp_executor given_;
};

// A request, or null for defaults, with an executor in it.
template <class Request>
int32_t read_request(const Request *given, Request &request, Executor &executor) {
  if (const int32_t status = read_request(given, request); status != HSP_OK) return status;
  return request.reserved != 0 ? HSP_E_VERSION : executor.read(request.executor);
}

}  // namespace hsp::capi
