// A ball with many caps: which pairs of later caps may have a free point, found in floats. Pairs whose circles
// certainly do not cross and points that are certainly covered are left out several at a time; what is not certain is
// left to doubles. Most points of most circles are covered by a large cap, so the large ones come first.
#pragma once

#include "sphere/float_caps.hpp"

namespace hsp {

// A pair of caps with a point that is not certainly covered.
struct OpenPair {
  uint32_t j, k;  // j < k
  bool certain;   // then the points named here are free, and no other one is
  bool minus, plus;
};

struct PairSweep {
  static constexpr uint32_t most_caps = 1U << 16;
  static constexpr uint32_t batch = 64;  // pairs that are tested together
  static constexpr uint32_t size_classes = 2;
  FloatCaps caps;
  uint32_t count = 0, first_later = 0;
  FloatCaps by_size;             // the larger caps again, by classes of size
  FloatCaps large;               // the same as fractions (covered_circles.hpp)
  FloatCaps exposed;             // later caps whose circles are not certainly covered by large caps
  float *exposed_cap = nullptr;  // their numbers
  float *crossed = nullptr;      // for each something negative if it certainly crosses the circle of a large cap
  uint32_t class_end[size_classes] = {};
  uint32_t exposed_count = 0;
  // Where to go on.
  uint32_t row = 0, column = 0;
  uint32_t crossing = 0;  // pairs so far whose circles may cross
};

// After caps, count and first_later, and memory for the rest.
HSP_KERNEL(void, start_sweep, (PairSweep & sweep), (sweep))
// The next open pairs, in the order of j and k, at most PairSweep::batch. Returns their number, 0 after the last.
HSP_KERNEL(uint32_t, next_open_pairs, (PairSweep & sweep, OpenPair *pairs), (sweep, pairs))
// After the last pair: the caps whose circles may be free as a whole, ascending. Room for count caps.
HSP_KERNEL(uint32_t, uncrossed_caps, (const PairSweep &sweep, uint32_t *caps), (sweep, caps))

}  // namespace hsp
