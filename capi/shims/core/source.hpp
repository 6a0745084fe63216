// The source of a handle's results, and whether that is still as it was: the same handle at the same
// place, which holds the same.
//
// A count of computations would not tell, as a handle that is made anew in the same memory begins to count anew. So a
// version stands for what a handle holds: that of a model is a digest of 64 bits (model/set_digest.hpp, which says why
// these are enough), that of a boundary the one of its model, from which all of a boundary follows, whatever its limits
// and workers. Results computed again from the same balls are therefore as they were.
#pragma once

#include <cstdint>

#include "handle_tag.hpp"

namespace hsp::capi {

// The source has has_results() and, where these are there, version().
template <class Handle>
class Source {
 public:
  void set(const Handle *handle) {
    handle_ = handle;
    version_ = handle->version();
  }
  // Whether it lives, has results, and they are the ones of then.
  bool is_unchanged() const { return is_live(handle_) && handle_->has_results() && version_ == handle_->version(); }
  uint64_t version() const { return version_; }
  bool is(const Handle *handle) const { return handle_ == handle; }
  const Handle *operator->() const { return handle_; }
  const Handle &operator*() const { return *handle_; }

 private:
  const Handle *handle_ = nullptr;
  uint64_t version_ = 0;
};

}  // namespace hsp::capi
