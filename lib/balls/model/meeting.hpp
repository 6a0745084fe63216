// Whether two balls meet: they do if d^2 <= t^2, with d the distance of their centres and t the sum of their radii. All
// rooms that ask it, of numbers or in lanes, have their bounds from here; exact/PROOFS.md, section 5, proves them.
//
// As an example balls of radius 2 and 3 with centres (3, 4, 0) apart: d^2 = 25 = t^2. They touch, and so meet; doubles
// say that the numbers are nearly equal, and integers that they are equal.
#pragma once

#include <cmath>

#include "lanes/floating_point.hpp"

namespace hsp {

// In doubles, of balls on the lattice: what is computed tells which of d^2 and t^2 is larger if they differ by more
// than this part of t^2.
inline constexpr double meeting_doubt = 8 * unit_roundoff;
// Factors of t^2, and of the squared difference of the radii: above and below these d^2 is certainly larger, smaller.
inline constexpr double certainly_above = 1.0 + meeting_doubt, certainly_below = 1.0 - meeting_doubt;

// In floats, of balls relative to a point, one of which is within 1.5 sides of it along each axis: where d^2 - t^2 is
// further from 0 than this its sign is certain. No t is larger than the side.
static inline double doubt_nearby(double side) {
  return 0x1p-19 * (side * side);
}
// The same for centres within an extent along each axis, all but one, which is no further than a reach beyond. No t is
// larger than the reach, and no extent larger than most_extent_of_reach times that.
inline constexpr double most_extent_of_reach = 0x1p18;
static inline double doubt_within(double extent, double reach) {
  return 0x1p-24 * (16.0 * extent + 64.0 * reach) * reach;
}

// From centre to centre, and the sum of the radii; by integers alone.
bool meet_exactly(double dx, double dy, double dz, double sum);

inline bool meet(double dx, double dy, double dz, double sum) {
  const double within = sum * sum;
  const double excess = (dx * dx + dy * dy + dz * dz) - within;
  // This branch is nearly always taken. The sign itself cannot be predicted, so there must be no branch on it.
  if (std::fabs(excess) > meeting_doubt * within) [[likely]]
    return excess < 0.0;
  return meet_exactly(dx, dy, dz, sum);
}

}  // namespace hsp
