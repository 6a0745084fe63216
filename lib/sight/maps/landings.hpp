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
// All that lies in a gap between arcs belongs to the nearer side of it, also in the gap where the contour begins and
// ends.
inline void sort_landings(Span<const MapArc> contour, Span<Landing> landings) {
  const MapArc &first = contour[0];
  const MapArc &last = contour[contour.size() - 1];
  const double begin = first.closed ? first.from - landing_tolerance : 0.5 * (last.to - 2 * pi + first.from);
  for (Landing &landing : landings) {
    while (landing.t >= begin + 2 * pi) landing.t -= 2 * pi;
    while (landing.t < begin) landing.t += 2 * pi;
  }
  sort_in_place(landings,
                [](const Landing &a, const Landing &b) { return a.t != b.t ? a.t < b.t : a.vertex < b.vertex; });
}

}  // namespace hsp
