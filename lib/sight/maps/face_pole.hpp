// The pole of inaccessibility of a face: the point of it that is farthest from its edges, where a label has most room.
//
// A branch and bound over squares (as in the program polylabel for polygons): no point of a square is deeper in the
// face than its middle by more than half a diagonal, nor farther from the edges than from those points of them that are
// next to the middle. The square that may hold the deepest point is cut in four, until none may hold a point that is
// deeper by more than 1/64 than the deepest one found. At first circles are laid into the face that touch some of its
// edges in the middle and shrink until they fit, so that also in a thin sickle a point is known that lies inside.
#pragma once

#include <limits>

#include "maps/edge_geometry.hpp"
#include "maps/stick_scene.hpp"

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
  const double least = map.scene.least_distance(edge.body, x, y);
  if (least > 0.0 && least * least > nearest.squared) return;
  for (const uint32_t v : edge.vertex) look_at_point(map.vertices[v].x, map.vertices[v].y, x, y, nearest);
  look_along(curve_of(map, e), edge.is_silhouette(), x, y, nearest);
}

// In view coordinates.
struct FacePole {
  double x, y;
  double radius;  // from there to the nearest edge
  double bound;   // nowhere in the face it is more
};

// By how much less than the bound the radius may be, of itself, unless there is too much to look at.
inline constexpr double pole_tolerance = 0x1p-6;
// So many points are looked at, at most; for each all edges around the face.
inline constexpr uint32_t most_pole_looks = 4096;

// Of any face but the unbounded one.
FacePole find_pole(const VisibilityMap &map, uint32_t face);
FacePole find_pole(const StickMap &map, uint32_t face);

}  // namespace hsp
