// The cubes of Section 3: side 2 r_max, counted from the low corner of the box around all centres or around all balls.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "ball_list.hpp"

namespace bench {

struct Cube {
  uint32_t x, y, z;
};

// One number for a cube; they are ordered by z, then y, then x.
constexpr uint64_t packed(const Cube &cube) {
  return (uint64_t{cube.z} << 42) | (uint64_t{cube.y} << 21) | uint64_t{cube.x};
}

// Sorts the keys of different cubes, and returns the new place of each key. In this order the cubes of a row follow
// each other in memory, and neighbouring rows are near.
inline std::vector<uint32_t> sort_cubes(std::vector<uint64_t> &keys) {
  std::vector<uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return keys[a] < keys[b]; });
  std::vector<uint32_t> place(keys.size());
  for (size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<uint32_t>(k);
  std::sort(keys.begin(), keys.end());
  return place;
}

// Visits the cubes x_low .. x_high of a row as one range of places in the sorted keys: find(key) is the place of a key,
// or at least keys.size(). One search finds the first cube that is there; the others follow it.
template <class Find, class Visit>
void visit_row_of(const std::vector<uint64_t> &keys, uint32_t x_low, uint32_t x_high, uint32_t y, uint32_t z, Find find,
                  Visit visit) {
  for (uint32_t x = x_low; x <= x_high; ++x) {
    const uint32_t first = find(packed({x, y, z}));
    if (first >= keys.size()) continue;
    const uint64_t highest = packed({x_high, y, z});
    uint32_t last = first + 1;
    while (last < keys.size() && keys[last] <= highest) ++last;
    visit(first, last);
    return;
  }
}

// The cubes low .. high along every axis; empty if none of the box is reached.
struct CubeRange {
  Cube low{}, high{};
  bool empty = true;
};

// The cube of a point is found by one monotone function of each coordinate, for balls and queries alike, and the reach
// of a query is enlarged by more than rounding can lose. So no ball is missed, as long as coordinates are below 10^6
// r_max.
class Cubes {
 public:
  static constexpr double most_along_axis = 1 << 21;  // so that packed() has room

  Cubes() = default;

  // The cubes of the box around all centres, grown by a margin in units of r_max. Throws std::length_error if the set
  // is too wide for packed().
  explicit Cubes(const support::BallList &balls, double margin = 0) {
    for (const double radius : balls.radius) largest_radius_ = std::max(largest_radius_, radius);
    per_length_ = 1 / (largest_radius_ > 0 ? 2 * largest_radius_ : 1);
    std::array<double, 3> high{};
    for (size_t i = 0; i < balls.xyz.size(); ++i) {
      const size_t axis = i % 3;
      low_[axis] = i < 3 ? balls.xyz[i] : std::min(low_[axis], balls.xyz[i]);
      high[axis] = i < 3 ? balls.xyz[i] : std::max(high[axis], balls.xyz[i]);
    }
    for (size_t axis = 0; axis < 3; ++axis) {
      low_[axis] -= margin * largest_radius_;
      high[axis] += margin * largest_radius_;
      const double last = (high[axis] - low_[axis]) * per_length_;
      if (!(last < most_along_axis - 1)) throw std::length_error("too many cubes along an axis");
      last_[axis] = static_cast<double>(static_cast<uint32_t>(last));
    }
  }

  double largest_radius() const { return largest_radius_; }
  // How many cubes there are along an axis.
  uint32_t along(size_t axis) const { return static_cast<uint32_t>(last_[axis]) + 1; }

  // The cube of a point of the box.
  Cube of(const double *centre) const {
    return {along_axis(centre[0], 0), along_axis(centre[1], 1), along_axis(centre[2], 2)};
  }

  // The cubes that hold all points of the box within `reach` of a point.
  CubeRange within(const double *point, double reach) const {
    const double padded = reach * (1 + 1e-9) + 1e-9 * largest_radius_;
    CubeRange range;
    range.empty = false;
    uint32_t *const lows[] = {&range.low.x, &range.low.y, &range.low.z};
    uint32_t *const highs[] = {&range.high.x, &range.high.y, &range.high.z};
    for (size_t axis = 0; axis < 3; ++axis) {
      const double first = place(point[axis] - padded, axis);
      const double last = place(point[axis] + padded, axis);
      range.empty = range.empty || last < 0 || first >= last_[axis] + 1;
      *lows[axis] = static_cast<uint32_t>(std::min(std::max(first, 0.0), last_[axis]));
      *highs[axis] = static_cast<uint32_t>(std::min(std::max(last, 0.0), last_[axis]));
    }
    return range;
  }

 private:
  double place(double coordinate, size_t axis) const { return (coordinate - low_[axis]) * per_length_; }
  uint32_t along_axis(double coordinate, size_t axis) const { return static_cast<uint32_t>(place(coordinate, axis)); }

  std::array<double, 3> low_{};
  std::array<double, 3> last_{};  // the largest coordinate of a cube
  double per_length_ = 1;
  double largest_radius_ = 0;
};

}  // namespace bench
