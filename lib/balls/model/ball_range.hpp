// A run of consecutive balls in grid order.
#pragma once

#include <cstdint>

namespace hsp {

// Balls first .. last - 1.
struct BallRange {
  uint32_t first, last;
  bool empty() const { return first == last; }
};

}  // namespace hsp
