// Balls on the lattice, and the relation of two of them: disjoint, nested, or meeting in a circle. The symbolic
// perturbation decides ties.
//
// As an example balls of radius 5 and 3, whose sum is 8 and whose difference is 2, by the distance d of their centres:
//   d = 9      disjoint
//   d = 8      they touch: a circle by the perturbation, which inflates both
//   d = 4      circle
//   d = 1      second_in_first
#pragma once

#include "exact/plane.hpp"

namespace hsp::exact {

struct LatticeBall {
  Vector centre;
  int64_t radius;
  uint32_t index;
};

constexpr bool ranks_before(const LatticeBall &a, const LatticeBall &b) {
  return ranks_before(RankKey<int64_t>{a.centre.x, a.centre.y, a.centre.z, a.radius, a.index},
                      RankKey<int64_t>{b.centre.x, b.centre.y, b.centre.z, b.radius, b.index});
}

// Whether no component of v is larger than s in size.
constexpr bool within(const Vector &v, int64_t s) {
  return v.x <= s && v.y <= s && v.z <= s && -v.x <= s && -v.y <= s && -v.z <= s;
}
// |v|^2 of a vector within the sum of two radii.
constexpr uint64_t squared_within(const Vector &v) {
  return static_cast<uint64_t>(v.x * v.x) + static_cast<uint64_t>(v.y * v.y) + static_cast<uint64_t>(v.z * v.z);
}

enum class PairRelation { disjoint, circle, first_in_second, second_in_first };

// By 64-bit arithmetic alone: radii are below 2^30, coordinates at most 2^50 in size.
constexpr PairRelation pair_relation(const LatticeBall &a, const LatticeBall &b) {
  const int64_t sum = a.radius + b.radius;
  const int64_t difference = a.radius - b.radius;
  const Vector u = b.centre - a.centre;
  if (!within(u, sum)) return PairRelation::disjoint;
  const uint64_t U = squared_within(u);
  const uint64_t sum_squared = static_cast<uint64_t>(sum * sum);
  const uint64_t difference_squared = static_cast<uint64_t>(difference * difference);
  if (U > sum_squared) return PairRelation::disjoint;
  if (U > difference_squared) return PairRelation::circle;
  // One is inside the other, also if they touch from inside, as the larger one grows by more. So a point on a sphere is
  // inside its ball, though the distance is also the sum of the radii.
  if (difference != 0) return difference < 0 ? PairRelation::first_in_second : PairRelation::second_in_first;
  return ranks_before(a, b) ? PairRelation::second_in_first : PairRelation::first_in_second;
}

// Ball b as a plane seen from ball a, for two balls that meet in a circle.
constexpr Plane plane_of(const LatticeBall &a, const LatticeBall &b) {
  const Vector v = b.centre - a.centre;
  // As a product of sum and difference, so that no term exceeds 2^62.
  return {v, dot(v, v) + (a.radius - b.radius) * (a.radius + b.radius), 1, b.index};
}

constexpr Sphere sphere_of(const LatticeBall &a) {
  return {4 * a.radius * a.radius, a.index};
}

}  // namespace hsp::exact
