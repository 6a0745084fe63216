// Computations that the caller stops at one of their questions whether to go on.
#pragma once

#include <hardsphere.h>

#include "fuzz_input.hpp"

namespace fuzz {

// Answers no to a question that the input chooses, and to all questions after it.
class RandomStop {
 public:
  explicit RandomStop(Bytes &bytes) : left_(bytes.below(bytes.one_in(2) ? 4 : 64)) {}
  RandomStop(const RandomStop &) = delete;
  RandomStop &operator=(const RandomStop &) = delete;

  const hsp_executor *executor() const { return &executor_; }
  bool stopped() const { return stopped_; }

 private:
  static int32_t proceed(void *context) {
    RandomStop &own = *static_cast<RandomStop *>(context);
    if (own.left_ > 0) {
      --own.left_;
      return 0;
    }
    own.stopped_ = true;
    return 1;
  }

  uint32_t left_;
  bool stopped_ = false;
  const hsp_executor executor_{sizeof(hsp_executor), 1, this, nullptr, proceed};
};

}  // namespace fuzz
