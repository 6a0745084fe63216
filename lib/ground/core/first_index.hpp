// Binary search for the first index at which a predicate holds.
#pragma once

#include <cstdint>

namespace hsp {

// The first k in first .. last - 1 with holds(k), which must hold from there on; `last` if there is none. There must be
// first <= last and last - first < 2^32 - 1.
template <class Holds>
constexpr uint32_t first_index(uint32_t first, uint32_t last, Holds holds) {
  // The predicate does not hold at `before`, which wraps around below 0, and holds at `last`. Compilers make
  // conditional moves of this form of the loop, and no branch, which could not be predicted.
  uint32_t before = first - 1;
  while (last - before > 1) {
    const uint32_t middle = before + (last - before) / 2;
    if (holds(middle)) {
      last = middle;
    } else {
      before = middle;
    }
  }
  return last;
}

}  // namespace hsp
