// The balls of the cubes around one cube, copied side by side as floats relative to that cube's centre, for all balls
// of the cube: what is certainly too far from one of them is left out several at a time.
#pragma once

#include "lanes/target.hpp"
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

// Appends balls first .. last - 1, for which there is room.
HSP_KERNEL(void, add_candidates,
           (CandidateBlock & block, const BallArrays &balls, uint32_t first, uint32_t last, const double (&centre)[3]),
           (block, balls, first, last, centre))
// Puts candidates that meet nothing behind the last one.
HSP_KERNEL(void, end_candidates, (CandidateBlock & block), (block))

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
