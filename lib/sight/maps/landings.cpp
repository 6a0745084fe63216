#include "maps/landings.hpp"

#include "lanes/floating_point.hpp"

namespace hsp {

void sort_landings(Span<const MapArc> contour, Span<Landing> landings) {
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
