// The grid exactly as the paper's Section 3 has it: each ball is stored in every cube that the box around the ball
// meets, and a query looks only at the cubes that it meets itself, at most 8. So it finds balls more than once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "section_3/cubes.hpp"
#include "section_3/double_hashing.hpp"
#include "section_3/grouped_balls.hpp"

namespace bench {

class PaperGrid {
 public:
  void build(const support::BallList &balls) {
    cubes_ = Cubes(balls, 1);
    cube_.clear();
    ball_.clear();
    for (uint32_t i = 0; i < balls.size(); ++i) {
      visit_cubes(cubes_.within(&balls.xyz[3 * size_t{i}], balls.radius[i]), [&](const Cube &cube) {
        cube_.push_back(cube);
        ball_.push_back(i);
      });
    }
    directory_.build(cubes_, cube_, number_);
    balls_.build(balls, ball_, number_, directory_.count());
  }

  // The balls that meet a ball, ascending. There must be room for those that are found more than once.
  void meeting(const double *centre, double radius, Hits &hits) const {
    const uint32_t before = hits.count;
    const CubeRange range = cubes_.within(centre, radius);
    visit_cubes(range, [&](const Cube &cube) {
      directory_.visit_row(cube.x, cube.x, cube.y, cube.z, [&](uint32_t begin, uint32_t end) {
        balls_.meeting(centre, radius, balls_.first(begin), balls_.first(end), hits);
      });
    });
    if (hits.count > hits.capacity) return;
    std::sort(hits.ids + before, hits.ids + hits.count);
    hits.count = static_cast<uint32_t>(std::unique(hits.ids + before, hits.ids + hits.count) - hits.ids);
  }

  // In how many cubes a ball is stored, on average.
  double cubes_per_ball(const support::BallList &balls) const { return double{1} * balls_.size() / balls.size(); }

  size_t bytes() const { return directory_.bytes() + balls_.bytes(); }

 private:
  template <class Visit>
  static void visit_cubes(const CubeRange &range, Visit visit) {
    if (range.empty) return;
    for (uint32_t z = range.low.z; z <= range.high.z; ++z) {
      for (uint32_t y = range.low.y; y <= range.high.y; ++y) {
        for (uint32_t x = range.low.x; x <= range.high.x; ++x) visit(Cube{x, y, z});
      }
    }
  }

  Cubes cubes_;
  DoubleHashing directory_;
  GroupedBalls balls_;
  std::vector<Cube> cube_;  // while building: of each entry, its cube's number, its ball
  std::vector<uint32_t> number_;
  std::vector<uint32_t> ball_;
};

}  // namespace bench
