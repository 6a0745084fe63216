// Where stems end on a contour, in the order in which they cut its arcs.
#pragma once

#include "maps/hidden_intervals.hpp"

namespace hsp {

// A parameter by which a T may miss an arc: an angle, or a part of the length of a stick. Where two balls have centres
// of equal height, the T of the one and the tangency of the other are the same point, and where a half circle is seen
// edge on, a T is where an arc ends.
inline constexpr double landing_tolerance = 0x1p-24;

struct Landing {
  double t;         // parameter on the contour
  uint32_t vertex;  // the T
};

// Sorts landings on one contour, of which these arcs are seen, in ascending order, each at the turn that fits the arcs.
// What lies in a gap between arcs belongs to the nearer side of it, also in the gap where the contour begins and ends.
void sort_landings(Span<const MapArc> contour, Span<Landing> landings);

}  // namespace hsp
