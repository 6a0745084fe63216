// Borders of patches of any surface. A curve has its points once, so that all patches beside it share them.
#pragma once

#include "core/elementary.hpp"
#include "surface/surface_positions.hpp"

namespace hsp {

struct MeshCurve {
  LoopElement element;    // of the boundary, on the ball of lower rank; not used for edges of the smooth surface
  uint32_t segments;      // between its points
  uint32_t first_sample;  // number in the mesh of the points between its ends, of a closed one of all of them
  bool refine;            // wants twice as many segments
  bool refined;           // has more segments than its length demands
};

// Points at equal angles on a circle, from one of them on.
struct CirclePoints {
  Position centre;
  double angle;  // from the first point to the last one
  Vec3 x, y;     // from the centre to the first point, and to that a quarter turn on

  // Point k of 0 .. segments.
  Position at(uint32_t k, uint32_t segments) const {
    const SinCos turn = sin_cos(angle * k / segments);
    return {centre.ball, centre.offset + combine(turn.cosine, x, turn.sine, y)};
  }
};

// Calls visit(k, vertex) for the points of a curve between its ends, or all of a closed one, along it or against it,
// with their numbers in the mesh.
template <class Visit>
void for_each_point(const MeshCurve &curve, bool is_closed, bool forwards, Visit visit) {
  const uint32_t first = is_closed ? 0 : 1;
  for (uint32_t k = first; k < curve.segments; ++k) {
    const uint32_t at = forwards ? k : curve.segments - 1 - k + first;
    visit(at, curve.first_sample + (at - first));
  }
}

// A circle smaller than this, as a share of the sphere's radius, is triangulated as if it were so large: where balls
// touch in a point it has no length at all.
inline constexpr double least_circle = 0x1p-18;

// How near each other points of a curve may be, as a share of the radius of the ball or probe.
inline constexpr double least_segment = 0x1p-24;

// Closed curves have no fewer segments.
inline constexpr double fewest_of_circle = 6.0;

// Segments of at most the given length, at least `fewest`; in doubles, which may be more than fits.
inline double segments_of(double length_of_curve, double length, double fewest) {
  const double wanted = length_of_curve / length;
  const double floor = wanted < 0x1p30 ? static_cast<double>(static_cast<int64_t>(wanted)) : wanted;
  const double segments = floor < wanted ? floor + 1.0 : floor;
  return segments < fewest ? fewest : segments;
}

// The fewest segments of an arc or a circle. If both ends of an arc are of the same three balls, another arc may have
// the same ends, and the two must not both be a single segment.
inline double fewest_segments(const Boundary &boundary, LoopElement e) {
  if (e.is_circle()) return fewest_of_circle;
  const HalfEdge &start = boundary.half_edge(e.half_edge());
  const uint32_t third = boundary.previous_circle(boundary.ball_of(e.half_edge()), start);
  return boundary.half_edge(start.next).circle == third ? 2.0 : 1.0;
}

// The direction to take if no other is known.
inline constexpr Vec3 upwards{0.0, 0.0, 1.0};

inline Vec3 direction_from(const BallSet &balls, uint32_t ball, const Position &position) {
  return balls.difference(ball, position.ball) + position.offset;
}

}  // namespace hsp
