// How near an edge of a map comes to a point of the view plane.
#pragma once

#include <limits>

#include "maps/edge_geometry.hpp"

namespace hsp {

// The nearest point of all edges that have been looked at, and the square of its distance.
struct NearestPoint {
  double x = 0.0, y = 0.0;
  double squared = std::numeric_limits<double>::infinity();
};

void look_at_point(double to_x, double to_y, double x, double y, NearestPoint &nearest);
// All of a curve but its ends. silhouette: of a ball, a circle.
void look_along(const EdgeCurve &curve, bool silhouette, double x, double y, NearestPoint &nearest);

// The nearest point of an edge is an end of it, or one where the distance has an extremum along its curve: of a circle
// the point in the direction from its centre, of an ellipse at most four, the roots of a trigonometric polynomial, of a
// line the foot.
template <class Map>
void look_at_edge(const Map &map, uint32_t e, double x, double y, NearestPoint &nearest) {
  const MapEdge &edge = map.edges[e];
  const double least = map.scene.least_distance(edge.ball, x, y);
  if (least > 0.0 && least * least > nearest.squared) return;
  for (const uint32_t v : edge.vertex) look_at_point(map.vertices[v].x, map.vertices[v].y, x, y, nearest);
  look_along(curve_of(map, e), edge.is_silhouette(), x, y, nearest);
}

}  // namespace hsp
