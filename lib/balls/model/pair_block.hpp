// The balls that may meet those of one cube, side by side as floats relative to the cube's centre, for lists of all
// pairs, which tests as many at a time as a register holds. Doubtful pairs are left to integers, so that the
// pairs are exact.
#pragma once

#include <cstdint>

#include "model/query_hits.hpp"

namespace hsp {

struct PairBlock {
  static constexpr uint32_t room = 256;
  static constexpr uint32_t lanes = 8;

  float x[room + lanes], y[room + lanes], z[room + lanes], r[room + lanes];
  uint32_t caller[room + lanes], rank[room + lanes];
  uint32_t count;
  float doubt;  // doubt_nearby(side of the cubes)
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
