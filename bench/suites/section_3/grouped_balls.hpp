// Balls in groups, one group after the other in memory, and the test which balls of a group meet a query ball. It uses
// the doubles of the input, so ties are decided rightly only where squares of differences are exact.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ball_list.hpp"

namespace bench {

// The list of hits. If there are more hits than there is room for, only their number is right.
struct Hits {
  uint32_t *ids;
  uint32_t capacity;  // at least 1
  uint32_t count = 0;
};

template <class T>
size_t bytes_of(const std::vector<T> &values) {
  return values.size() * sizeof(T);
}

class GroupedBalls {
 public:
  // A counting sort: entry e is the ball ball[e], in the group group[e] < groups. A ball may be in several groups.
  void build(const support::BallList &balls, const std::vector<uint32_t> &ball, const std::vector<uint32_t> &group,
             uint32_t groups) {
    const size_t entries = ball.size();
    first_.assign(size_t{groups} + 1, 0);
    for (const uint32_t g : group) ++first_[g + 1];
    for (size_t g = 0; g < groups; ++g) first_[g + 1] += first_[g];
    for (std::vector<double> *values : {&x_, &y_, &z_, &radius_}) values->resize(entries);
    id_.resize(entries);
    next_ = first_;
    for (size_t entry = 0; entry < entries; ++entry) {
      const uint32_t place = next_[group[entry]]++;
      const size_t i = ball[entry];
      x_[place] = balls.xyz[3 * i];
      y_[place] = balls.xyz[3 * i + 1];
      z_[place] = balls.xyz[3 * i + 2];
      radius_[place] = balls.radius[i];
      id_[place] = ball[entry];
    }
  }

  uint32_t size() const { return static_cast<uint32_t>(id_.size()); }
  // The places of group g are first(g) .. first(g + 1) - 1.
  uint32_t first(uint32_t group) const { return first_[group]; }

  // Appends the balls of places first .. last - 1 that meet the ball. Each is stored, but stays only if it is a hit: a
  // branch could not be predicted.
  void meeting(const double *centre, double radius, uint32_t first, uint32_t last, Hits &hits) const {
    const double x = centre[0], y = centre[1], z = centre[2];
    uint32_t count = hits.count;
    for (uint32_t place = first; place < last; ++place) {
      const double dx = x_[place] - x, dy = y_[place] - y, dz = z_[place] - z, reach = radius_[place] + radius;
      hits.ids[std::min(count, hits.capacity - 1)] = id_[place];
      count += dx * dx + dy * dy + dz * dz <= reach * reach ? 1 : 0;
    }
    hits.count = count;
  }

  // How many balls of places first .. last - 1 meet the ball of a place.
  uint32_t count_meeting(uint32_t place, uint32_t first, uint32_t last) const {
    const double x = x_[place], y = y_[place], z = z_[place], radius = radius_[place];
    uint32_t count = 0;
    for (uint32_t other = first; other < last; ++other) {
      const double dx = x_[other] - x, dy = y_[other] - y, dz = z_[other] - z, reach = radius_[other] + radius;
      count += dx * dx + dy * dy + dz * dz <= reach * reach ? 1 : 0;
    }
    return count;
  }

  void centre_of(uint32_t place, double *centre) const {
    centre[0] = x_[place];
    centre[1] = y_[place];
    centre[2] = z_[place];
  }

  size_t bytes() const { return bytes_of(first_) + 4 * bytes_of(x_) + bytes_of(id_); }

 private:
  std::vector<uint32_t> first_;
  std::vector<double> x_, y_, z_, radius_;
  std::vector<uint32_t> id_;
  std::vector<uint32_t> next_;  // while building
};

}  // namespace bench
