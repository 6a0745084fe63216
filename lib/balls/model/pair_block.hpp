// The balls that may meet those of one cube, side by side as floats relative to the cube's centre, for lists of all
// pairs, which tests as many at a time as a register holds. Doubtful pairs are left to integers, so that the
// pairs are exact.
//
// With s the side of the cubes and e = 2^-24, coordinates are at most 1.5 s, those of the cube's own balls at most s/2,
// and both are rounded once. Let d be the distance of two balls and t <= s the sum of their radii. If d <= 1.1 s, each
// difference has an error of at most 1.5 s e + 0.5 s e + 1.1 s e, the square of the distance one of 2 d sqrt(3) 3.1 s e
// < 11.9 s^2 e. Radii and their sum are rounded: the square of t has an error of 4 s^2 e. Partial sums of dz^2 - t^2 +
// dy^2 + dx^2 lie between - s^2 and 1.3 s^2, and there are four roundings: 5.2 s^2 e, and 2.3 s^2 e more where products
// are rounded, too. Terms in e^2 are far below the rest of 32 s^2 e = 2^-19 s^2: where the computed d^2 - t^2 is
// further from 0, its sign is certain. If d > 1.1 s it is above 0.2 s^2 by the same errors relative to d. Lengths are
// below 2^33 and, unless they are 0, at least 1/2: no square over- or underflows.
#pragma once

#include <cstdint>

#include "model/query_hits.hpp"

namespace hsp {

struct PairBlock {
  static constexpr uint32_t room = 256;
  static constexpr uint32_t lanes = 8;
  static constexpr double margin_of_squared_side = 0x1p-19;

  float x[room + lanes], y[room + lanes], z[room + lanes], r[room + lanes];
  uint32_t caller[room + lanes], rank[room + lanes];
  uint32_t count;
  float margin;
  double centre[3];
};

// Appends balls of the range, no more than there is room for. Returns the first one that has not been appended.
HSP_KERNEL(uint32_t, add_to_block, (PairBlock & block, const QueryArrays &balls, const BallRange &range),
           (block, balls, range))

// The caller's indices of those of the block, from number `from` on, that meet ball i of its cube. Returns how many.
// Room for all of the block and eight more.
HSP_KERNEL(uint32_t, met_in_block,
           (const PairBlock &block, const QueryArrays &balls, uint32_t i, uint32_t from, uint32_t *met),
           (block, balls, i, from, met))

}  // namespace hsp
