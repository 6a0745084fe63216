// The terms of a sum in ranges, for tasks of which each adds one. All but the last are the leaves of a complete subtree
// of TreeSum, so that the sum over their sums is that over all terms, bit for bit.
//
// As an example 300 terms for two workers: ranges of 64, of which four are complete, 0 to 63, 64 to 127, 128 to 191 and
// 192 to 255, and a last one of 44 terms.
#pragma once

#include "core/id_range.hpp"

namespace hsp {

class TermRanges {
 public:
  static constexpr uint32_t most = 61;         // sums of all lie on the stack together
  static constexpr uint32_t least_terms = 64;  // in fewer a task is not worth its start

  // A few for each worker, of whom some are slower.
  TermRanges(uint32_t terms, uint32_t workers) : terms_(terms) {
    const uint32_t wanted = workers < most / 4 ? 4 * workers : most;
    while (count() > wanted) length_ *= 2;
  }
  uint32_t count() const { return complete() + (terms_ % length_ == 0 ? 0 : 1); }
  // So many of them come before the last, which has fewer terms and may be missing.
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
