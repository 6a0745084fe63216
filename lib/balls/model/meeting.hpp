// Whether two balls meet: they do if d^2 <= t^2, with d the distance of their centres and t the sum of their radii. All
// code that asks this, in doubles or floats, in lanes or not, uses the error bounds of this file; exact/PROOFS.md,
// section 5, proves them.
//
// As an example balls of radius 2 and 3 whose centres differ by (3, 4, 0): d^2 = 25 = t^2. They touch, and so meet.
// Doubles only say that both numbers are nearly equal; integers say that they are equal.
#pragma once

#include <cmath>

#include "lanes/floating_point.hpp"

namespace hsp {

// In doubles, for balls on the lattice: if the computed d^2 - t^2 is larger in size than this part of t^2, its sign is
// certain.
inline constexpr double meeting_doubt = 8 * unit_roundoff;
// Factors of t^2, or of the squared difference of the radii: a computed d^2 above the one product is certainly larger,
// a computed d^2 below the other product is certainly smaller.
inline constexpr double certainly_above = 1.0 + meeting_doubt, certainly_below = 1.0 - meeting_doubt;

// In floats, for balls relative to a point, of which one of the two is within 1.5 `side` of it along each axis: if
// d^2 - t^2 is larger in size than this, its sign is certain. No t is larger than `side`.
static inline double doubt_nearby(double side) {
  return 0x1p-19 * (side * side);
}
// The same for balls relative to a point, with centres at most `extent` from it along each axis; one of the two may be
// farther by `reach`. No t is larger than `reach`, and `extent` is at most most_extent_of_reach times `reach`.
inline constexpr double most_extent_of_reach = 0x1p18;
static inline double doubt_within(double extent, double reach) {
  return 0x1p-24 * (16.0 * extent + 64.0 * reach) * reach;
}

// Whether two balls meet, by integers alone. (dx, dy, dz): from centre to centre; sum: of the radii.
bool meet_exactly(double dx, double dy, double dz, double sum);

// The same, by doubles if these are certain.
inline bool meet(double dx, double dy, double dz, double sum) {
  const double within = sum * sum;
  const double excess = (dx * dx + dy * dy + dz * dz) - within;
  // This branch is nearly always taken. The sign itself cannot be predicted, so there must be no branch on it.
  if (std::fabs(excess) > meeting_doubt * within) [[likely]]
    return excess < 0.0;
  return meet_exactly(dx, dy, dz, sum);
}

}  // namespace hsp
