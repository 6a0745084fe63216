// The balls that may meet the balls of one cube, copied side by side as floats relative to the cube's centre. For lists
// of all pairs: as many are tested at a time as a register holds. Integers decide doubtful pairs, so that the pairs are
// exact.
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

// Appends balls of the range, as many as there is room for. Returns the first ball that has not been appended.
HSP_KERNEL(uint32_t, add_to_block, (PairBlock & block, const QueryArrays &balls, const BallRange &range),
           (block, balls, range))

// Writes the caller's indices of the balls of the block, from number `from` on, that meet ball i of the cube. Returns
// how many. `met` has room for all balls of the block and eight more.
HSP_KERNEL(uint32_t, met_in_block,
           (const PairBlock &block, const QueryArrays &balls, uint32_t i, uint32_t from, uint32_t *met),
           (block, balls, i, from, met))

}  // namespace hsp
