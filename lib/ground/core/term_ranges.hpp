// Divides the terms of a sum into ranges, for tasks of which each adds one range. All ranges but the last are the
// leaves of complete subtrees of TreeSum, so that the sum over the ranges' sums has the same bits as the sum over all
// terms.
//
// As an example 300 terms for two workers: ranges of 64, of which four are complete, 0 to 63, 64 to 127, 128 to 191 and
// 192 to 255, and a last one of 44 terms.
#pragma once

#include "core/id_range.hpp"

namespace hsp {

class TermRanges {
 public:
  static constexpr uint32_t most = 61;         // the sums of all ranges are on the stack together
  static constexpr uint32_t least_terms = 64;  // a task with fewer terms is not worth its start

  // A few ranges for each worker, as some workers are slower.
  TermRanges(uint32_t terms, uint32_t workers) : terms_(terms) {
    const uint32_t wanted = workers < most / 4 ? 4 * workers : most;
    while (count() > wanted) length_ *= 2;
  }
  uint32_t count() const { return complete() + (terms_ % length_ == 0 ? 0 : 1); }
  // The number of ranges before the last, which has fewer terms and may be missing.
  uint32_t complete() const { return terms_ / length_; }
  IdRange operator[](uint32_t range) const {
    const uint32_t first = range * length_;
    return {first, terms_ - first < length_ ? terms_ : first + length_};
  }

 private:
  uint32_t terms_;
  uint32_t length_ = least_terms;
};

}  // namespace hsp
