// Limits of structures: records of numbers that say for how many items of each kind there is room.
//
// As an example limits of 100 vertices and 3 circles suffice for one set, and 80 and 5 for another one. Then 100 and 5
// suffice for either set.
#pragma once

#include <bit>

#include "core/status.hpp"

namespace hsp {

// The limits with the number choose(x, y) for each number x of `limits` and the same number y of `others`.
template <class Limits, class Choose>
constexpr Limits each_limit(const Limits &limits, const Limits &others, Choose choose) {
  struct Numbers {
    uint32_t of[sizeof(Limits) / sizeof(uint32_t)];
  };
  Numbers x = std::bit_cast<Numbers>(limits);
  const Numbers y = std::bit_cast<Numbers>(others);
  for (size_t k = 0; k < sizeof(Limits) / sizeof(uint32_t); ++k) x.of[k] = choose(x.of[k], y.of[k]);
  return std::bit_cast<Limits>(x);
}

// The smallest limits that suffice where `limits` or `others` do: the larger of each two numbers.
template <class Limits>
constexpr Limits covering(const Limits &limits, const Limits &others) {
  return each_limit(limits, others, larger_count);
}

// A base of builders: the limits for which memory was carved, and those that are needed.
template <class Limits>
class Limited {
 public:
  // The limits that suffice, as far as the last build has found out.
  const Limits &needed() const { return needed_; }
  // The limits to try again with after Status::capacity.
  Limits retry_limits() const { return covering(limits_, needed_); }

 protected:
  void limit(const Limits &limits) {
    limits_ = limits;
    needed_ = {};
  }

  Limits limits_, needed_;
};

}  // namespace hsp
