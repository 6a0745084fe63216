// One ball of the set is the origin, and its neighbours are half-spaces: the form in which all predicates of the
// boundary are evaluated.
//
// With c the centre and w = r^2 the weight of the origin ball, put y = 2 (x - c). Its sphere is |y|^2 = W = 4 w, and
// ball j with v = c_j - c and h = |v|^2 + w - w_j is the half-space v.y >= h: a point of the sphere lies in ball j iff
// it lies in the half-space.
//
// Contract, in lattice steps: radii are below 2^30, |v| < 2^31, and planes are made only of spheres that meet in a
// proper circle or touch, so that |h| <= 2 r |v| < 2^62. Then, with L = 2^31, by Cauchy-Schwarz:
//   h, v.v, u.v, n = u x v, W  <= L^2          64 bits        B = n.z                <= L^3       128 bits
//   q = h_P v - h_Q u          <= 2 L^3       128 bits        H = q x z + h_R n      <= 3 L^4     128 bits
//   D = W n.n - q.q            <= 4 L^6       192 bits        A = -H.n               <= 3 L^6     192 bits
//   F = W B^2 - H.H            <= 9 L^8       256 bits        G = h_S B - s.H            <= 4 L^5     192 bits
// Only differences of centres enter, so the extent of the set does not matter.
#pragma once

#include <cstdint>

#include "core/small_code.hpp"
#include "core/vec3.hpp"
#include "exact/rank.hpp"

namespace hsp::exact {

struct Vector {
  int64_t x, y, z;

  HSP_APART_IF_SMALL friend constexpr Vector operator-(const Vector &a, const Vector &b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
};

constexpr int64_t dot(const Vector &a, const Vector &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vector cross(const Vector &a, const Vector &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr bool is_zero(const Vector &a) {
  return (a.x | a.y | a.z) == 0;
}

inline Vec3 to_double(const Vector &a) {
  return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}

// The sphere of the origin ball.
struct Sphere {
  int64_t W;       // 4 r^2
  uint32_t index;  // the caller's index, for the rank
};

struct Plane {
  Vector v;
  int64_t h;
  // 1 for a ball, whose plane moves when the origin ball is inflated; 0 for a virtual plane (meridian, ray,
  // silhouette), which does not move.
  int32_t perturbed;
  uint32_t index;
};

constexpr Plane virtual_plane(const Vector &v, int64_t h) {
  return {v, h, 0, 0};
}

// Whether the ball of plane a has a lower rank than that of plane b (rank.hpp). For one origin the order of the centres
// is that of the vectors v, and of two balls with one centre the smaller has the larger h. Virtual planes come after
// all balls.
constexpr bool ranks_before(const Plane &a, const Plane &b) {
  if (a.perturbed != b.perturbed) return a.perturbed > b.perturbed;
  return ranks_before(RankKey<int64_t>{a.v.x, a.v.y, a.v.z, -a.h, a.index},
                      RankKey<int64_t>{b.v.x, b.v.y, b.v.z, -b.h, b.index});
}

// The origin ball itself in the form of a plane, for comparing ranks.
constexpr Plane origin_plane(const Sphere &sphere) {
  return {{0, 0, 0}, 0, 1, sphere.index};
}

}  // namespace hsp::exact
