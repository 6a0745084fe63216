// The search of a ball with many caps: finds in floats which pairs of later caps may have a free point. Pairs whose
// circles certainly do not cross, and points that are certainly covered, are left out several at a time; uncertain
// pairs are left to doubles. Most points of most circles are covered by a large cap, so points are tested against large
// caps first.
#pragma once

#include "sphere/float_caps.hpp"

namespace hsp {

// A pair of caps with a point that is not certainly covered.
struct OpenPair {
  uint32_t j, k;     // j < k
  bool certain;      // the points named by minus and plus are free, and no other one is
  bool minus, plus;  // p-, p+
};

struct PairSweep {
  static constexpr uint32_t most_caps = 1U << 16;
  static constexpr uint32_t batch = 64;  // pairs that are tested together
  static constexpr uint32_t size_classes = 2;
  FloatCaps caps;
  uint32_t count = 0, first_later = 0;
  FloatCaps by_size;             // the larger caps again, by classes of size
  FloatCaps large;               // by_size as fractions (covered_circles.hpp)
  FloatCaps exposed;             // later caps whose circles are not certainly covered by large caps
  float *exposed_cap = nullptr;  // the numbers of the exposed caps
  float *crossed = nullptr;      // for each exposed cap: negative if its circle certainly crosses that of a large cap
  uint32_t class_end[size_classes] = {};  // of the classes in by_size
  uint32_t exposed_count = 0;
  // The pair of exposed caps at which next_open_pairs goes on.
  uint32_t row = 0, column = 0;
  uint32_t crossing = 0;  // number of pairs so far whose circles may cross
};

// The caller has set caps, count and first_later, and has let the other arrays point to memory.
HSP_KERNEL(void, start_sweep, (PairSweep & sweep), (sweep))
// Writes the next open pairs, in the order of j and k, at most PairSweep::batch. Returns how many; 0 after the last.
HSP_KERNEL(uint32_t, next_open_pairs, (PairSweep & sweep, OpenPair *pairs), (sweep, pairs))
// After the last pair: writes the caps whose circles may be free as a whole, ascending. There is room for count caps.
HSP_KERNEL(uint32_t, uncrossed_caps, (const PairSweep &sweep, uint32_t *caps), (sweep, caps))

}  // namespace hsp
