// How long to work without asking the caller whether to go on.
#pragma once

#include "core/executor.hpp"

namespace hsp {

class Patience {
 public:
  // Null, or one that may stop: the work of one thread.
  explicit Patience(const Executor *executor = nullptr)
      : executor_(executor != nullptr && executor->may_stop() ? executor : nullptr) {}

  // Whether to go on after work of about so many instructions. Once not, never again.
  bool allows(uint64_t instructions) {
    if (small_code || executor_ == nullptr) return true;
    spent_ += instructions;
    return spent_ < without_asking ? !executor_->is_stopped() : ask();
  }

 private:
  // Far less than the interface promises, as estimates may be far off.
  static constexpr uint64_t without_asking = 300000;

  bool ask() {
    spent_ = 0;
    return executor_->goes_on();
  }

  const Executor *executor_;
  uint64_t spent_ = 0;
};

}  // namespace hsp
