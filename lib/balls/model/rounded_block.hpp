// All balls around one cube side by side, as the floats that a set with a directory of rows has them rounded to
// (query_hits.hpp): for the rows of neighbour lists, as many at a time as a register holds. Doubtful pairs are left to
// integers, so that the rows are exact.
#pragma once

#include <cstdint>

#include "model/query_hits.hpp"

namespace hsp {

struct RoundedBlock {
  static constexpr uint32_t room = 608;  // in most proteins enough with a probe, too; and the stack has room for it
  static constexpr uint32_t lanes = 8;
  static constexpr uint32_t most_ranges = 9;

  float x[room + lanes], y[room + lanes], z[room + lanes], r[room + lanes];
  uint32_t caller[room + lanes];
  BallRange range[most_ranges];  // where they come from
  const float *rounded;
  float doubt;  // differences of squares no further from 0 are not certain
  uint32_t count;
};

// The balls of the ranges, and no others. False, and the block is not to be used, if there is no room for them.
HSP_KERNEL(bool, fill_block,
           (RoundedBlock & block, const QueryGrid &grid, const QueryArrays &balls, const BallRange *ranges,
            uint32_t range_count),
           (block, grid, balls, ranges, range_count))

// How many balls of the block meet ball i, which is one of them and meets itself; and the others as hits.
HSP_KERNEL(uint32_t, count_in_block, (const RoundedBlock &block, const QueryArrays &balls, uint32_t i),
           (block, balls, i))
HSP_KERNEL(void, find_others_in_block,
           (const RoundedBlock &block, const QueryArrays &balls, uint32_t i, QueryHits &hits), (block, balls, i, hits))

}  // namespace hsp
