// The balls of the cubes around one cube, copied side by side as floats relative to that cube's centre, for all balls
// of the cube: what is certainly too far from one of them is left out several at a time.
//
// No ball that meets another one is left out. With s the side of the cubes and e = 2^-24, let ball j meet ball i: their
// distance d and the sum t of their radii satisfy d <= t <= s. Coordinates are those of the cube's own balls, at most
// s / 2, or of any balls, at most 1.5 s from a common centre; and those of balls that they meet, at most s more. Both
// are rounded once, so that each difference has an error of at most 2.5 s e + 1.5 s e + s e = 5 s e, and the square of
// the distance one of 2 d sqrt(3) 5 s e < 17.4 s^2 e. Both radii and their sum are rounded: t has a relative error of
// 2e, its square one of 4 s^2 e. Partial sums of dz^2 - t^2 + dy^2 + dx^2 lie between - s^2 and s^2, and there are
// seven roundings at most, four where sums are fused: 7 s^2 e. Terms in e^2 are far below the rest of 32 s^2 e = 2^-19
// s^2, the margin below which d^2 - t^2 is taken for negative. All numbers are below 2^36 in size, so nothing over- or
// underflows.
#pragma once

#include "lanes/target.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

struct CandidateBlock {
  static constexpr uint32_t spare = 8;  // entries behind the last one that may be written
  static constexpr double margin_of_squared_side = 0x1p-19;

  float *x = nullptr, *y = nullptr, *z = nullptr, *r = nullptr;
  uint32_t *ball = nullptr;
  uint32_t room = 0;
  uint32_t count = 0;
  float margin = 0.0F;
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
// The same of the candidates behind `own` alone.
HSP_KERNEL(uint32_t, later_candidates, (const CandidateBlock &block, uint32_t own, uint32_t *near, uint32_t most),
           (block, own, near, most))

}  // namespace hsp
