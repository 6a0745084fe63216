// The candidates of all balls of one cube: the balls of the cubes around it, copied side by side, as floats relative to
// the cube's centre. Candidates that are certainly too far from a ball are left out several at a time.
#pragma once

#include "lanes/target.hpp"
#include "model/ball_range.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

struct CandidateBlock {
  static constexpr uint32_t spare = 8;  // entries behind the last one that may be written

  float *x = nullptr, *y = nullptr, *z = nullptr, *r = nullptr;
  uint32_t *ball = nullptr;
  uint32_t room = 0;
  uint32_t count = 0;
  float doubt = 0.0F;  // doubt_nearby(side) of model/meeting.hpp
};

// Copies the balls of these ranges, one range after the other, and behind them balls that meet nothing. There is room.
HSP_KERNEL(void, set_candidates,
           (CandidateBlock & block, const BallArrays &balls, const BallRange *range, uint32_t ranges,
            const double (&centre)[3]),
           (block, balls, range, ranges, centre))

// Writes to `near` the ids of the other candidates that are not certainly disjoint from candidate `own`, in the order
// of the block; `earlier` of them stand before `own`. Returns how many these are, or some number above `most` if they
// are more than `most`. `near` has room for most + spare_ids.
HSP_KERNEL(uint32_t, near_candidates,
           (const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most, uint32_t &earlier),
           (block, own, near, most, earlier))
// How many candidates are not certainly disjoint from candidate `own`, itself included.
HSP_KERNEL(uint32_t, count_candidates, (const CandidateBlock &block, uint32_t own), (block, own))
// The same as near_candidates() for the candidates behind `own` alone.
HSP_KERNEL(uint32_t, later_candidates, (const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most),
           (block, own, near, most))

}  // namespace hsp
