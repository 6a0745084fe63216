// Points of the unit sphere, rounded to integers of 30 bits, and the two questions that a triangulation of them asks.
// Both are the sign of a determinant of at most 94 bits: in doubles where their error bound leaves no doubt, else in
// integers.
#pragma once

#include "exact/exact_predicates.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {

struct RoundedDirection {
  int32_t x, y, z;

  constexpr bool operator==(const RoundedDirection &other) const = default;
};

inline constexpr double rounded_radius = 0x1p30;

// A vector without length becomes the direction upwards, as at a ball without radius: there all points coincide.
inline RoundedDirection rounded(const Vec3 &v) {
  const double square = dot(v, v);
  if (!(square > 0.0)) return {0, 0, static_cast<int32_t>(rounded_radius)};
  const double scale = rounded_radius / std::sqrt(square);
  const auto nearest = [scale](double x) {
    const double scaled = x * scale;
    return static_cast<int32_t>(scaled < 0.0 ? scaled - 0.5 : scaled + 0.5);
  };
  return {nearest(v.x), nearest(v.y), nearest(v.z)};
}
inline Vec3 to_double(const RoundedDirection &p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

inline exact::Vector to_integers(const RoundedDirection &p) {
  return {p.x, p.y, p.z};
}

// The sign of det(a, b, c): positive if the triangle runs counter-clockwise, seen from outside. In doubles every one of
// the products of three coordinates has a relative error below 4 roundings, and their absolute sum is below 6 times
// 2^90.
inline int orientation(const RoundedDirection &a, const RoundedDirection &b, const RoundedDirection &c) {
  const double determinant = dot(cross(to_double(a), to_double(b)), to_double(c));
  constexpr double doubt = 0x1p90 * 32 * unit_roundoff;
  if (determinant > doubt) return 1;
  if (determinant < -doubt) return -1;
  return exact::Exact::triple_product_sign(to_integers(a), to_integers(b), to_integers(c));
}

// The sign of d's height above the plane of the counter-clockwise triangle a, b, c: positive if d is inside its circle.
// Differences are exact; they are at most 2^31 + 2 long, so that their vector products have components below 2^63.
inline int height_above(const RoundedDirection &a, const RoundedDirection &b, const RoundedDirection &c,
                        const RoundedDirection &d) {
  const Vec3 from = to_double(a);
  const double determinant = dot(cross(to_double(b) - from, to_double(c) - from), to_double(d) - from);
  constexpr double doubt = 0x1p94 * 32 * unit_roundoff;
  if (determinant > doubt) return 1;
  if (determinant < -doubt) return -1;
  const exact::Vector origin = to_integers(a);
  return exact::Exact::triple_product_sign(to_integers(b) - origin, to_integers(c) - origin, to_integers(d) - origin);
}

}  // namespace hsp
