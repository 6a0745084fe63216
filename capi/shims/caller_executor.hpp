// Work that threads of the caller's share.
#pragma once

#include <type_traits>

#include "core/executor.hpp"
#include "versioned_struct.hpp"

namespace hsp::capi {

static_assert(std::is_same_v<hsp_task, hsp::Executor::Task>);
static_assert(max_tasks == HSP_MAX_WORKERS);

// An executor of the caller's, or null for none.
class Executor : public hsp::Executor {
 public:
  int32_t read(const hsp_executor *given) {
    if (given == nullptr) return HSP_OK;
    hsp_executor complete;
    if (const int32_t status = read_struct(given, {}, complete); status != HSP_OK) return status;
    if (complete.workers > 1 && complete.run == nullptr) return HSP_E_ARGUMENT;
    static_cast<hsp::Executor &>(*this) = {complete.workers, complete.run, complete.context};
    return HSP_OK;
  }
};

// A request, or null for defaults, with an executor in it.
template <class Request>
int32_t read_request(const Request *given, Request &request, Executor &executor) {
  if (const int32_t status = read_request(given, request); status != HSP_OK) return status;
  return request.reserved != 0 ? HSP_E_VERSION : executor.read(request.executor);
}

}  // namespace hsp::capi
