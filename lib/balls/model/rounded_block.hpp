// All balls around one cube side by side, in the floats of a set with a directory of rows (QueryGrid::rounded). For the
// rows of neighbour lists: as many balls are tested at a time as a register holds. Integers decide doubtful pairs, so
// that the rows are exact.
#pragma once

#include <cstdint>

#include "model/query_hits.hpp"

namespace hsp {

struct RoundedBlock {
  static constexpr uint32_t room = 608;  // enough in most proteins, even with a probe; the stack has room for it
  static constexpr uint32_t lanes = 8;
  static constexpr uint32_t most_ranges = 9;

  float x[room + lanes], y[room + lanes], z[room + lanes], r[room + lanes];
  uint32_t caller[room + lanes];
  BallRange range[most_ranges];  // the ranges of balls of which it is made
  const float *rounded;          // QueryGrid::rounded
  float doubt;                   // the sign of a d^2 - t^2 that is not larger in size is not certain
  uint32_t count;
};

// Fills the block with the balls of the ranges. If there is no room for them, returns false, and the block is not to be
// used.
HSP_KERNEL(bool, fill_block,
           (RoundedBlock & block, const QueryGrid &grid, const QueryArrays &balls, const BallRange *ranges,
            uint32_t range_count),
           (block, grid, balls, ranges, range_count))

// How many balls of the block meet ball i, which is one of them and meets itself.
HSP_KERNEL(uint32_t, count_in_block, (const RoundedBlock &block, const QueryArrays &balls, uint32_t i),
           (block, balls, i))
// Finds the others as hits.
HSP_KERNEL(void, find_others_in_block,
           (const RoundedBlock &block, const QueryArrays &balls, uint32_t i, QueryHits &hits), (block, balls, i, hits))

}  // namespace hsp
