// The pole of inaccessibility of a face: its point that is farthest from its edges, where a label has most room.
//
// A branch and bound over squares (as in the program polylabel for polygons). The depth of a point is its distance from
// the edges. A point of a square is at most half a diagonal deeper than the middle of the square; and it is no farther
// from the edges than from their points next to the middle. The square with the largest bound is cut in four, until no
// square may hold a point that is deeper by more than 1/64 than the deepest one found. At first circles are laid into
// the face that touch some of its edges in the middle, and shrink until they fit: so a point inside is known even in a
// thin sickle.
#pragma once

#include <limits>

#include "maps/edge_geometry.hpp"
#include "maps/stick_scene.hpp"

namespace hsp {

// The nearest point of all edges looked at so far, and the square of its distance.
struct NearestPoint {
  double x = 0.0, y = 0.0;
  double squared = std::numeric_limits<double>::infinity();
};

void look_at_point(double to_x, double to_y, double x, double y, NearestPoint &nearest);
// Looks at all of a curve but its ends. silhouette: the curve is a circle, or a line of a stick's contour.
void look_along(const EdgeCurve &curve, bool silhouette, double x, double y, NearestPoint &nearest);

// The nearest point of an edge is an end, or a point at which the distance has an extremum along the curve. On a circle
// that is the point in the direction from the centre; on an ellipse there are at most four, the roots of a
// trigonometric polynomial; on a line it is the foot of the perpendicular.
template <class Map>
void look_at_edge(const Map &map, uint32_t e, double x, double y, NearestPoint &nearest) {
  const MapEdge &edge = map.edges[e];
  const double least = map.scene.least_distance(edge.body, x, y);
  if (least > 0.0 && least * least > nearest.squared) return;
  for (const uint32_t v : edge.vertex) look_at_point(map.vertices[v].x, map.vertices[v].y, x, y, nearest);
  look_along(curve_of(map, e), edge.is_silhouette(), x, y, nearest);
}

// A pole in view coordinates.
struct FacePole {
  double x, y;
  double radius;  // its distance from the nearest edge
  double bound;   // no point of the face is farther from its edges
};

// The bound may be larger than the radius by this fraction of the radius; by more only if there is too much to look at.
inline constexpr double pole_tolerance = 0x1p-6;
// At most so many points are looked at, each with all edges around the face.
inline constexpr uint32_t most_pole_looks = 4096;

// The pole of any face but the unbounded one.
FacePole find_pole(const VisibilityMap &map, uint32_t face);
FacePole find_pole(const StickMap &map, uint32_t face);

}  // namespace hsp
