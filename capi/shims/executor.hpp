// Work that threads of the caller's share.
#pragma once

#include "core/small_code.hpp"
#include "versioned_struct.hpp"

namespace hsp::capi {

// An executor of the caller's, or null for none.
class Executor {
 public:
  int32_t read(const hsp_executor *given) {
    if (given == nullptr) return HSP_OK;
    if (const int32_t status = read_struct(given, given_, given_); status != HSP_OK) return status;
    return given_.workers > 1 && given_.run == nullptr ? HSP_E_ARGUMENT : HSP_OK;
  }
  // Code for size works in the caller's thread.
  bool is_parallel() const { return !small_code && given_.workers > 1; }
  uint32_t workers() const { return given_.workers; }
  // Calls task(t) for all t below `tasks`.
  template <class Task>
  void operator()(uint32_t tasks, const Task &task) const {
    const auto call = [](void *data, uint32_t t) { (*static_cast<const Task *>(data))(t); };
    given_.run(given_.context, tasks, call, const_cast<Task *>(&task));
  }

 private:
  hsp_executor given_{sizeof(hsp_executor), 1, nullptr, nullptr};
};

}  // namespace hsp::capi
