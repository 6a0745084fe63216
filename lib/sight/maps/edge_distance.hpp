// How near an edge of a map comes to a point of the view plane.
#pragma once

#include <limits>

#include "maps/visibility_map.hpp"

namespace hsp {

// The nearest point of all edges that have been looked at, and the square of its distance.
struct NearestPoint {
  double x = 0.0, y = 0.0;
  double squared = std::numeric_limits<double>::infinity();
};

// The nearest point of an edge is an end of it, or one where the distance has an extremum along its curve: of a circle
// the point in the direction from its centre, of an ellipse at most four, the roots of a trigonometric polynomial.
void look_at_edge(const VisibilityMap &map, uint32_t edge, double x, double y, NearestPoint &nearest);

}  // namespace hsp
