// Balls that close the mouths of pockets. The balls are grown by a narrow probe: in the plane of a mouth's nearest ones
// they leave a part open, between their discs and, where two neighbouring discs do not meet, up to the line of their
// centres. Its farthest point from that of the mouth is a corner where two discs meet, or an end of such a gap. A plug
// is a ball around the mouth's point, as it is on the lattice, that holds all of these.
#pragma once

#include "pores/balls_around.hpp"
#include "pores/pores_builder.hpp"

namespace hsp {

// grown: by what balls are, in steps; a ball that would have less than none has the radius 0. The radius of the plug is
// rounded up, by a part in 2^20 of the largest length that it comes from: so it still closes the mouth where balls and
// plugs are put on a somewhat coarser lattice.
exact::LatticeBall plug_of(const PoresBuilder &pores, const BallsAround &balls, const PoreGate &mouth, int64_t grown);

// The radius of a ball that is grown, in steps.
constexpr int64_t grown_radius(int64_t radius, int64_t grown) {
  return radius + grown > 0 ? radius + grown : 0;
}

}  // namespace hsp
