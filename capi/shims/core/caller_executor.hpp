// Executors: work that is shared by threads of the caller.
#pragma once

#include "conversion.hpp"
#include "core/executor.hpp"
#include "library_arithmetic.hpp"
#include "versioned_struct.hpp"

namespace hsp::capi {

// An executor of the caller, or none, for null. Its loop runs in the caller's floating-point environment, and each task
// in the library's, as every thread has registers of its own. The caller's question whether to go on runs in the
// caller's.
class Executor : public hsp::Executor {
 public:
  explicit Executor(LibraryArithmetic &arithmetic) : arithmetic_(arithmetic) {}
  // Not copied: a loop has its address.
  Executor(const Executor &) = delete;
  Executor &operator=(const Executor &) = delete;

  int32_t read(const hsp_executor *given);
  // The status of the work that this executor has failed or stopped.
  int32_t status() const { return static_cast<int32_t>(failure()); }

 private:
  static bool run_given(void *context, uint32_t tasks, hsp_task *task, void *data);
  static bool proceed_given(void *context);

  LibraryArithmetic &arithmetic_;
  hsp_executor given_;
};

// Reads a request with an executor in it; null means defaults.
template <class Request>
int32_t read_request(const Request *given, Request &request, Executor &executor) {
  if (const int32_t status = read_request(given, request); status != HSP_OK) return status;
  return request.reserved != 0 ? HSP_E_VERSION : executor.read(request.executor);
}

// The same for a question to the results of a handle.
template <class Handle, class Request>
int32_t read_for_results(const Handle *handle, const Request *given, Request &request, Executor &executor) {
  if (const int32_t status = check_handle(handle); status != HSP_OK) return status;
  return first_failure(read_request(given, request, executor), check_results(handle));
}

}  // namespace hsp::capi
