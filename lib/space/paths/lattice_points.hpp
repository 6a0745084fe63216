// Differences and distances of lattice points.
#pragma once

#include "exact/plane.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {

inline exact::Vector difference(const exact::Vector &to, const exact::Vector &from) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}
inline double distance(const exact::Vector &a, const exact::Vector &b) {
  const Vec3 d = to_double(difference(b, a));
  return std::sqrt(dot(d, d));
}

}  // namespace hsp
