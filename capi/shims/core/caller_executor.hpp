// Work that threads of the caller's share.
#pragma once

#include "conversion.hpp"
#include "core/executor.hpp"
#include "library_arithmetic.hpp"
#include "versioned_struct.hpp"

namespace hsp::capi {

// An executor of the caller's, or null for none. Its loop runs in the caller's floating-point environment, each task in
// the library's: a thread has registers of its own. So has that which asks whether to go on.
class Executor : public hsp::Executor {
 public:
  explicit Executor(LibraryArithmetic &arithmetic) : arithmetic_(arithmetic) {}
  // A loop has its address.
  Executor(const Executor &) = delete;
  Executor &operator=(const Executor &) = delete;

  int32_t read(const hsp_executor *given);
  // The status of what this has failed or stopped.
  int32_t status() const { return static_cast<int32_t>(failure()); }

 private:
  static bool run_given(void *context, uint32_t tasks, hsp_task *task, void *data);
  static bool proceed_given(void *context);

  LibraryArithmetic &arithmetic_;
  hsp_executor given_;
};

// A request, or null for defaults, with an executor in it.
template <class Request>
int32_t read_request(const Request *given, Request &request, Executor &executor) {
  if (const int32_t status = read_request(given, request); status != HSP_OK) return status;
  return request.reserved != 0 ? HSP_E_VERSION : executor.read(request.executor);
}

// The same of a question to the results of a handle.
template <class Handle, class Request>
int32_t read_for_results(const Handle *handle, const Request *given, Request &request, Executor &executor) {
  if (const int32_t status = check_handle(handle); status != HSP_OK) return status;
  return first_failure(read_request(given, request, executor), check_results(handle));
}

}  // namespace hsp::capi
