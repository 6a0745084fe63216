// Sums whose order depends only on the number of terms: pairwise summation, a binary tree over the terms in the order
// in which they are added. The error grows with log2(n) instead of n (Higham, Accuracy and Stability of Numerical
// Algorithms, section 4.2).
//
// As an example five terms a to e: ((a + b) + (c + d)) + e. With `rest`, the sum of further terms that another task has
// added: ((a + b) + (c + d)) + (e + rest).
#pragma once

#include <cstdint>

#include "core/id_range.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {

class TreeSum {
 public:
  void add(double term) {
    waiting_[count_ % block] = term;
    if (++count_ % block == 0) add_block(sum_of(waiting_, block));
  }
  // The same as adding n terms one by one.
  [[gnu::noinline]] void add(const double *terms, uint32_t n) {
    add_many(
        n, [terms](uint32_t k) { return terms[k]; }, [terms](uint32_t k) { return sum_of(terms + k, block); });
  }
  // The same as add(zero) so many times, for a zero of either sign: a sum of equal zeros is the zero itself.
  void add_zeros(double zero, uint32_t times) {
    const auto always = [zero](uint32_t) { return zero; };
    add_many(times, always, always);
  }
  // The sum. If each term is itself the sum of a range of terms, `rest` is the sum of the last range, which has fewer
  // terms than the others; it is added to the last of the terms first.
  [[gnu::noinline]] double total(double rest = 0.0) const {
    double sum = rest;
    uint32_t left = count_ % block;  // terms that wait; their complete subtrees come last
    for (uint32_t size = 1; size < block; size *= 2) {
      if ((count_ & size) == 0) continue;
      left -= size;
      sum = sum_of(waiting_ + left, size) + sum;
    }
    for (int level = 0; level < 32 - block_level; ++level) {
      if (count_ / block >> level & 1U) sum = partial_[level] + sum;
    }
    return sum;
  }

 private:
  static constexpr int block_level = 4;
  static constexpr uint32_t block = 1U << block_level;

  // Adds n terms. term(k) is term k, and block_at(k) the sum of the block of terms from k on.
  template <class Term, class BlockAt>
  void add_many(uint32_t n, Term term, BlockAt block_at) {
    for (uint32_t k = 0; k < n;) {
      if (n - k < block || count_ % block != 0) {
        add(term(k++));
      } else {
        count_ += block;
        add_block(block_at(k));
        k += block;
      }
    }
  }
  // The sum of a complete subtree of `size` terms. Out of line, as it is called once for each block.
  [[gnu::noinline]] static double sum_of(const double *terms, uint32_t size) {
    double sum[block];
    for (uint32_t k = 0; k < size; ++k) sum[k] = terms[k];
    for (; size > 1; size /= 2) {
      for (uint32_t k = 0; k < size / 2; ++k) sum[k] = sum[2 * k] + sum[2 * k + 1];
    }
    return sum[0];
  }
  // Adds a complete block; `term` is its sum.
  [[gnu::noinline]] void add_block(double term) {
    // Level k holds the sum of a complete subtree of 2^k blocks whenever bit k of their number is set.
    int level = 0;
    for (uint32_t carry = count_ / block - 1; carry & 1U; carry >>= 1, ++level) term = partial_[level] + term;
    partial_[level] = term;
  }

  double waiting_[block] = {};
  double partial_[32 - block_level] = {};
  uint32_t count_ = 0;
};

// Divides the terms of a sum into ranges, for tasks of which each adds one range. All ranges but the last are the
// leaves of complete subtrees of TreeSum, so that the sum over the ranges' sums has the same bits as the sum over all
// terms.
//
// As an example 300 terms for two workers: ranges of 64, of which four are complete, 0 to 63, 64 to 127, 128 to 191 and
// 192 to 255, and a last one of 44 terms.
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
