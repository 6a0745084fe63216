// The blocks of a search, cubes and parts of cubes, and the balls that are near a block.
#pragma once

#include "core/extremes.hpp"
#include "pores/critical_points.hpp"

namespace hsp {

inline Vec3 centre_of(const BallSet &balls, uint32_t ball) {
  return {balls.x[ball], balls.y[ball], balls.z[ball]};
}
inline double distance(const BallSet &balls, uint32_t ball, const exact::Vector &from) {
  const double x = balls.x[ball] - static_cast<double>(from.x), y = balls.y[ball] - static_cast<double>(from.y),
               z = balls.z[ball] - static_cast<double>(from.z);
  return std::sqrt(x * x + y * y + z * z);
}

// Whether a point is in a cube, its sides included, by doubles: +1 it certainly is, -1 it certainly is not, 0 else.
inline int may_be_in(const TangentPoint &point, const CriticalPoints::Block &block) {
  const Vec3 off = point.position_estimate() - to_double(block.centre) - block.off;
  const double most = longest_part(off), error = point.position_error();
  return most > block.half + error ? -1 : most < block.half - error ? 1 : 0;
}
inline bool is_in(const TangentPoint &point, const CriticalPoints::Block &block) {
  const int certain = may_be_in(point, block);
  if (certain != 0) return certain > 0;
  const int64_t middle[3] = {block.centre.x, block.centre.y, block.centre.z};
  const double off[3] = {block.off.x, block.off.y, block.off.z};
  for (uint32_t axis = 0; axis < 3; ++axis) {
    if (point.against(axis, middle[axis], off[axis] - block.half) < 0 ||
        point.against(axis, middle[axis], off[axis] + block.half) > 0) {
      return false;
    }
  }
  return true;
}
inline bool meet(const CriticalPoints::Block &a, const CriticalPoints::Block &b) {
  return longest_part(to_double(a.centre) + a.off - to_double(b.centre) - b.off) <= a.half + b.half;
}

}  // namespace hsp
