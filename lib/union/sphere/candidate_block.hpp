// The balls of the cubes around one cube, copied side by side as floats relative to that cube's centre, for all balls
// of the cube: what is certainly too far from one of them is left out several at a time.
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
  float doubt = 0.0F;  // doubt_nearby(side)
};

// The balls of these ranges, one after the other, for which there is room, and behind them some that meet nothing.
HSP_KERNEL(void, set_candidates,
           (CandidateBlock & block, const BallArrays &balls, const BallRange *range, uint32_t ranges,
            const double (&centre)[3]),
           (block, balls, range, ranges, centre))

// The ids of the other candidates that are not certainly disjoint from candidate `own`, as they stand in the block, of
// which `earlier` stand before it. Returns their number, or a larger one than `most` if they are more. Room for most +
// spare_ids.
HSP_KERNEL(uint32_t, near_candidates,
           (const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most, uint32_t &earlier),
           (block, own, near, most, earlier))
// How many these are, with `own` itself.
HSP_KERNEL(uint32_t, count_candidates, (const CandidateBlock &block, uint32_t own), (block, own))
// The same as near_candidates, of the candidates behind `own` alone.
HSP_KERNEL(uint32_t, later_candidates, (const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most),
           (block, own, near, most))

}  // namespace hsp
