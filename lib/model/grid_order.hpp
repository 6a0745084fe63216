// The order of the balls in the grid: by the z, the y and then the x of their cubes, and in one cube by rank. So the
// cubes of one row, with equal y and z, follow each other, and so do the balls of neighbouring cubes of a row: one
// search in the hash table finds all of them. The order depends on the balls alone, not on that of the input (but for
// balls that are equal), so that neither does anything that runs in the order of ids.
#pragma once

#include "model/ball_set.hpp"
#include "model/cube_table.hpp"

namespace hsp {

// The cubes of side `side`, along one axis.
class CubeAxis {
 public:
  explicit CubeAxis(int64_t side) : side_(side), reciprocal_(1.0 / static_cast<double>(side)) {}

  // floor(value / side) for |value| < 2^52. The estimate has an error below |value| 2^-52 / side < 1 / side, while a
  // quotient that is no integer is at least 1 / side away from the next one: so truncation is off by at most one, and
  // the sign and size of the remainder show it.
  int64_t cube_at(int64_t value) const {
    const int64_t quotient = static_cast<int64_t>(static_cast<double>(value) * reciprocal_);
    const int64_t rest = value - quotient * side_;
    return quotient - static_cast<int64_t>(rest < 0) + static_cast<int64_t>(rest >= side_);
  }
  int64_t side() const { return side_; }
  CubeCoordinates cube_at(const exact::Vector &point) const {
    return {cube_at(point.x), cube_at(point.y), cube_at(point.z)};
  }

 private:
  int64_t side_;
  double reciprocal_;
};

// Scratch memory: an entry per ball in each but the last, and at least 2 counters, of which up to 2048 are used.
struct GridOrderScratch {
  Span<uint32_t> order, other_order, keys, other_keys, counters;
};

// Returns the numbers of the balls in grid order, in scratch.order or scratch.other_order. O(n) if no more than a
// bounded number of balls lie in one cube.
Span<uint32_t> grid_order(const BallSet &balls, const CubeAxis &axis, const GridOrderScratch &scratch);
// The same in less code: O(n log n). order [n].
Span<uint32_t> grid_order_by_comparing(const BallSet &balls, const CubeAxis &axis, Span<uint32_t> order);

}  // namespace hsp
