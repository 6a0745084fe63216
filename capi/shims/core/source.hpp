// The source of a handle's results, and whether it is unchanged: the same handle at the same address with the same
// contents.
//
// A count of computations would not suffice, as a handle made again in the same memory begins to count again. So a
// version stands for the contents of a handle. The version of a model is a digest of 64 bits (model/set_digest.hpp says
// why that is enough). A boundary has the version of its model, since all of it follows from the model, whatever its
// limits and workers. So a source is unchanged if it was computed again from the same balls.
#pragma once

#include <cstdint>

#include "handle_tag.hpp"

namespace hsp::capi {

// The source has has_results(), and version() if it has results.
template <class Handle>
class Source {
 public:
  void set(const Handle *handle) {
    handle_ = handle;
    version_ = handle->version();
  }
  // Whether the source is a live handle with the same results as when it was noted.
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
