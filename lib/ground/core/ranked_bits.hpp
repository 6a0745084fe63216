// A set of numbers below a limit, as bits. It finds how many members are smaller than a number, and the k-th member. So
// the members have consecutive ids, without a table from numbers to ids or back.
#pragma once

#include "core/first_index.hpp"
#include "core/workspace.hpp"

namespace hsp {

class RankedBits {
 public:
  void carve(Workspace &workspace, uint64_t most) {
    words_ = workspace.take<uint64_t>(most / 64 + 1);
    before_ = workspace.take<uint32_t>(most / 64 + 2);
  }

  // Empties it for numbers below n.
  void clear(uint32_t n) {
    used_ = n / 64 + 1;
    for (uint32_t w = 0; w < used_; ++w) words_[w] = 0;
  }
  void set(uint32_t k) { words_[k / 64] |= uint64_t{1} << k % 64; }
  // Sets k if it is a member, without a branch, which could not be predicted.
  void set_if(uint32_t k, bool is_member) { words_[k / 64] |= uint64_t{is_member} << k % 64; }
  // To be called once all members are set.
  void count() {
    uint32_t sum = 0;
    for (uint32_t w = 0; w < used_; ++w) {
      before_[w] = sum;
      sum += ones(words_[w]);
    }
    before_[used_] = sum;
  }

  bool has(uint32_t k) const { return (words_[k / 64] >> k % 64 & 1) != 0; }
  uint32_t size() const { return used_ == 0 ? 0 : before_[used_]; }
  // Members below k.
  uint32_t rank(uint32_t k) const { return before_[k / 64] + ones(words_[k / 64] & ((uint64_t{1} << k % 64) - 1)); }
  // The member of rank r; there must be one.
  uint32_t member(uint32_t r) const {
    const uint32_t at = first_index(1, used_, [this, r](uint32_t w) { return before_[w] > r; }) - 1;
    uint64_t word = words_[at];
    for (uint32_t left = r - before_[at]; left > 0; --left) word &= word - 1;
    return 64 * at + ones((word & (~word + 1)) - 1);
  }

 private:
  // The number of set bits, without an instruction for it, which the library may not assume.
  static constexpr uint32_t ones(uint64_t w) {
    w -= w >> 1 & UINT64_C(0x5555555555555555);
    w = (w & UINT64_C(0x3333333333333333)) + (w >> 2 & UINT64_C(0x3333333333333333));
    w = (w + (w >> 4)) & UINT64_C(0x0F0F0F0F0F0F0F0F);
    return static_cast<uint32_t>(w * UINT64_C(0x0101010101010101) >> 56);
  }

  Span<uint64_t> words_;
  Span<uint32_t> before_;
  uint32_t used_ = 0;
};

}  // namespace hsp
