// Plugs: balls that close the mouths of pockets. All balls are grown by the radius of a narrow probe. In the plane of
// the centres of a mouth's nearest balls these leave a region open: between their discs and, between two neighbouring
// discs that do not meet, up to the line of their centres. Its farthest point from the mouth's point is a corner at
// which two discs meet, or an end of such a gap. The plug is a ball around the mouth's point, rounded to the lattice,
// that contains all these corners and ends.
#pragma once

#include "pores/balls_around.hpp"
#include "pores/pores_builder.hpp"

namespace hsp {

// grown: the length by which balls are grown, in steps; radii that would be negative are 0. The radius of the plug is
// rounded up, by 2^-20 of the largest length that it is computed from: so the plug still closes the mouth if balls and
// plugs are put on a somewhat coarser lattice.
exact::LatticeBall plug_of(const PoresBuilder &pores, const BallsAround &balls, const PoreGate &mouth, int64_t grown);

// The radius of a ball that is grown, in steps.
constexpr int64_t grown_radius(int64_t radius, int64_t grown) {
  return radius + grown > 0 ? radius + grown : 0;
}

}  // namespace hsp
