// The grid of the paper's Section 3 with each ball stored once, in the cube of its centre. The directory finds the
// balls of a cube. It is a parameter, so that directories can be compared with all else equal: dense_cubes.hpp,
// sorted_cubes.hpp, double_hashing.hpp, perfect_hashing.hpp. Each has
//
//   void build(const Cubes &, const std::vector<Cube> &, std::vector<uint32_t> &numbers);  // a number for each cube
//   uint32_t count() const;                                                                 // all numbers are below
//   void visit_row(uint32_t x_low, uint32_t x_high, uint32_t y, uint32_t z, visit) const;
//       calls visit(first, last), once at most: first .. last - 1 are the cubes x_low .. x_high of a row with balls
//   size_t bytes() const;
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "section_3/cubes.hpp"
#include "section_3/grouped_balls.hpp"

namespace bench {

template <class Directory>
class CentreGrid {
 public:
  // May be called again, and then uses its memory again.
  void build(const support::BallList &balls) {
    cubes_ = Cubes(balls);
    cube_.clear();
    for (size_t i = 0; i < balls.size(); ++i) cube_.push_back(cubes_.of(&balls.xyz[3 * i]));
    directory_.build(cubes_, cube_, number_);
    ball_.resize(balls.size());
    std::iota(ball_.begin(), ball_.end(), 0U);
    balls_.build(balls, ball_, number_, directory_.count());
  }

  // The balls that meet a ball, in no particular order.
  void meeting(const double *centre, double radius, Hits &hits) const {
    visit_places(cubes_.within(centre, radius + cubes_.largest_radius()),
                 [&](uint32_t first, uint32_t last) { balls_.meeting(centre, radius, first, last, hits); });
  }

  // The number of ordered pairs of different balls that meet. The rows around a cube are looked up once for all its
  // balls.
  uint64_t count_pairs() const {
    std::array<uint32_t, 9> first;
    std::array<uint32_t, 9> last;
    uint64_t pairs = 0;
    for (uint32_t number = 0; number < directory_.count(); ++number) {
      const uint32_t begin = balls_.first(number);
      const uint32_t end = balls_.first(number + 1);
      if (begin == end) continue;
      size_t ranges = 0;
      visit_places(around(begin), [&](uint32_t from, uint32_t to) {
        first[ranges] = from;
        last[ranges++] = to;
      });
      for (uint32_t place = begin; place < end; ++place) {
        for (size_t k = 0; k < ranges; ++k) pairs += balls_.count_meeting(place, first[k], last[k]);
      }
    }
    return pairs - balls_.size();
  }

  size_t bytes() const { return directory_.bytes() + balls_.bytes(); }
  const Directory &directory() const { return directory_; }

 private:
  template <class Visit>
  void visit_places(const CubeRange &range, Visit visit) const {
    if (range.empty) return;
    for (uint32_t z = range.low.z; z <= range.high.z; ++z) {
      for (uint32_t y = range.low.y; y <= range.high.y; ++y) {
        directory_.visit_row(range.low.x, range.high.x, y, z,
                             [&](uint32_t begin, uint32_t end) { visit(balls_.first(begin), balls_.first(end)); });
      }
    }
  }

  // The cube of a ball and its up to 26 neighbours.
  CubeRange around(uint32_t place) const {
    std::array<double, 3> centre{};
    balls_.centre_of(place, centre.data());
    const Cube cube = cubes_.of(centre.data());
    const auto below = [](uint32_t value) { return value - (value > 0 ? 1 : 0); };
    const auto above = [this](uint32_t value, size_t axis) { return value + (value + 1 < cubes_.along(axis) ? 1 : 0); };
    return {
        {below(cube.x), below(cube.y), below(cube.z)}, {above(cube.x, 0), above(cube.y, 1), above(cube.z, 2)}, false};
  }

  Cubes cubes_;
  Directory directory_;
  GroupedBalls balls_;
  std::vector<Cube> cube_;  // while building: of each ball, its cube's number, itself
  std::vector<uint32_t> number_;
  std::vector<uint32_t> ball_;
};

}  // namespace bench
