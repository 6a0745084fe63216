// Points of the unit sphere, rounded to integers of 30 bits, and the two questions that a triangulation of them asks.
// Both are the sign of a determinant of at most 94 bits: in doubles where their error bound leaves no doubt, else in
// integers.
#pragma once

#include "core/vec3.hpp"
#include "exact/wide_integer.hpp"
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

// The sign of (u x v).w for integers: u x v has components below 2^63 where |u| and |v| are at most 2^31 + 2.
inline int exact_triple_product_sign(const int64_t u[3], const int64_t v[3], const int64_t w[3]) {
  using Term = exact::WideInteger<exact::FastLimb, 64>;
  constexpr int bits = 128;
  exact::WideInteger<exact::FastLimb, bits> sum{};
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    const int m = (k + 2) % 3;
    sum = sum + exact::product<bits>(Term::from(u[l] * v[m] - u[m] * v[l]), Term::from(w[k]));
  }
  return sum.sign();
}

// The sign of det(a, b, c): positive if the triangle runs counter-clockwise, seen from outside. In doubles every one of
// the products of three coordinates has a relative error below 4 roundings, and their absolute sum is below 6 times
// 2^90.
inline int orientation(const RoundedDirection &a, const RoundedDirection &b, const RoundedDirection &c) {
  const double determinant = dot(cross(to_double(a), to_double(b)), to_double(c));
  constexpr double doubt = 0x1p90 * 32 * unit_roundoff;
  if (determinant > doubt) return 1;
  if (determinant < -doubt) return -1;
  const int64_t u[3] = {a.x, a.y, a.z};
  const int64_t v[3] = {b.x, b.y, b.z};
  const int64_t w[3] = {c.x, c.y, c.z};
  return exact_triple_product_sign(u, v, w);
}

// The sign of d's height above the plane of the counter-clockwise triangle a, b, c: positive if d is inside its circle.
// Differences are exact; they are at most 2^31 + 2 long.
inline int height_above(const RoundedDirection &a, const RoundedDirection &b, const RoundedDirection &c,
                        const RoundedDirection &d) {
  const Vec3 from = to_double(a);
  const double determinant = dot(cross(to_double(b) - from, to_double(c) - from), to_double(d) - from);
  constexpr double doubt = 0x1p94 * 32 * unit_roundoff;
  if (determinant > doubt) return 1;
  if (determinant < -doubt) return -1;
  const auto less_a = [&a](const RoundedDirection &p, int64_t difference[3]) {
    difference[0] = static_cast<int64_t>(p.x) - a.x;
    difference[1] = static_cast<int64_t>(p.y) - a.y;
    difference[2] = static_cast<int64_t>(p.z) - a.z;
  };
  int64_t u[3];
  int64_t v[3];
  int64_t w[3];
  less_a(b, u);
  less_a(c, v);
  less_a(d, w);
  return exact_triple_product_sign(u, v, w);
}

}  // namespace hsp
