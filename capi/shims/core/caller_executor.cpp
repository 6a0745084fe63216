#include "caller_executor.hpp"

#include <type_traits>

#include "core/small_code.hpp"

namespace hsp::capi {
namespace {

static_assert(std::is_same_v<hsp_task, hsp::Executor::Task>);
static_assert(max_tasks == HSP_MAX_WORKERS);

struct Work {
  hsp_task *task;
  void *data;
};

void do_task(void *data, uint32_t number) {
  const Work &work = *static_cast<const Work *>(data);
  const LibraryArithmetic arithmetic;
  work.task(work.data, number);
}

}  // namespace

int32_t Executor::read(const hsp_executor *given) {
  if (given == nullptr) return HSP_OK;
  if (const int32_t status = read_struct(given, {}, given_); status != HSP_OK) return status;
  if (given_.workers > 1 && given_.run == nullptr) return HSP_E_ARGUMENT;
  const bool asks = !small_code && given_.proceed != nullptr;
  static_cast<hsp::Executor &>(*this) = {given_.workers, run_given, this, asks ? proceed_given : nullptr};
  return HSP_OK;
}

bool Executor::run_given(void *context, uint32_t tasks, hsp_task *task, void *data) {
  const Executor &executor = *static_cast<const Executor *>(context);
  Work work{task, data};
  const CallersArithmetic callers(executor.arithmetic_);
  return executor.given_.run(executor.given_.context, tasks, do_task, &work) == 0;
}

bool Executor::proceed_given(void *context) {
  const Executor &executor = *static_cast<const Executor *>(context);
  const CallersQuestion question(executor.arithmetic_);
  return executor.given_.proceed(executor.given_.context) == 0;
}

}  // namespace hsp::capi
