// Sums whose order is fixed by the number of terms alone: a binary tree over the terms in the order they are added. The
// error grows with log2(n) instead of n (Higham, Accuracy and Stability of Numerical Algorithms, section 4.2).
#pragma once

#include <cstdint>

#include "core/floating_point.hpp"

namespace hsp {

class TreeSum {
 public:
  void add(double term) {
    // Level k holds the sum of a complete subtree of 2^k terms whenever bit k of count_ is set.
    int level = 0;
    for (uint32_t carry = count_; carry & 1U; carry >>= 1, ++level) term = partial_[level] + term;
    partial_[level] = term;
    ++count_;
  }
  double total() const {
    double sum = 0.0;
    for (int level = 0; level < 32; ++level) {
      if (count_ >> level & 1U) sum = partial_[level] + sum;
    }
    return sum;
  }

 private:
  double partial_[32] = {};
  uint32_t count_ = 0;
};

}  // namespace hsp
