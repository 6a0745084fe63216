// What the results of a handle were computed from, and whether that is still as it was.
#pragma once

#include <cstdint>

#include "handle_tag.hpp"

namespace hsp::capi {

// The source has version(), which changes with its results, and has_results().
template <class Handle>
class Source {
 public:
  void set(const Handle *handle) {
    handle_ = handle;
    version_ = handle->version();
  }
  // Whether it lives, has results, and they are the ones of then.
  bool is_unchanged() const { return is_live(handle_) && version_ == handle_->version() && handle_->has_results(); }
  bool is(const Handle *handle) const { return handle_ == handle; }
  const Handle *operator->() const { return handle_; }
  const Handle &operator*() const { return *handle_; }

 private:
  const Handle *handle_ = nullptr;
  uint64_t version_ = 0;
};

}  // namespace hsp::capi
