// The points of two segments that are closest to each other.
#pragma once

#include "core/vec3.hpp"

namespace hsp {

// The points from + t (to - from), t in [0, 1].
struct Segment {
  Vec3 from, to;

  Vec3 at(double t) const { return combine(1.0 - t, from, t, to); }
  // Its shadow in the view plane.
  Segment flat() const { return {{from.x, from.y, 0.0}, {to.x, to.y, 0.0}}; }
};

// Parameters of closest points, and the square of their distance.
struct ClosestPoints {
  double first, second;
  double squared;
};

// A point is a segment with equal ends. Of parallel segments one of the closest pairs.
inline ClosestPoints closest_points(const Segment &a, const Segment &b) {
  const auto clamped = [](double t) { return t > 0.0 ? (t < 1.0 ? t : 1.0) : 0.0; };
  const Vec3 u = a.to - a.from;
  const Vec3 v = b.to - b.from;
  const Vec3 r = b.from - a.from;
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const double ur = dot(u, r);
  const double vr = dot(v, r);
  // Closest on the lines: s uu - t uv = ur and s uv - t vv = vr. Then each is moved into its segment, the other one
  // after it; a second time, as the first may have left its own.
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 0.0 ? clamped((ur * vv - uv * vr) / determinant) : 0.0;
  const double t = vv > 0.0 ? clamped((s * uv - vr) / vv) : 0.0;
  s = uu > 0.0 ? clamped((ur + t * uv) / uu) : 0.0;
  const Vec3 gap = b.at(t) - a.at(s);
  return {s, t, dot(gap, gap)};
}

}  // namespace hsp
