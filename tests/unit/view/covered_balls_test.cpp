#include "view/covered_balls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <set>

#include "built_grid.hpp"
#include "core/vec3.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"

namespace {

using hsp::Vec3;

class CoveredBalls : public testing::Test {
 protected:
  CoveredBalls() : random_(31) {}

  // Models of one molecule, each ball moved by at most so much, and memory for so many caps.
  void take_models(size_t models, int64_t most, uint32_t caps) {
    const oracle::Balls atoms = oracle::grown(oracle::loose_balls(random_, 12), 100);
    grid_.emplace(oracle::in_lengths(oracle::as_models(atoms, models, most, random_), 1));
    memory_.carve(covered, caps);
    covered.start(grid_->grid());
  }
  const hsp::BallSet &balls() const { return grid_->grid().balls(); }

  Vec3 random_direction() {
    for (;;) {
      const auto component = [this] { return static_cast<double>(random_.in(-1000, 1000)); };
      const double x = component(), y = component(), z = component(), squared = x * x + y * y + z * z;
      if (squared > 0.0) return combine(1.0 / std::sqrt(squared), Vec3{x, y, z}, 0.0, Vec3{0.0, 0.0, 0.0});
    }
  }
  Vec3 centre(uint32_t i) const { return {balls().x[i], balls().y[i], balls().z[i]}; }
  // Whether a point is so far outside all balls but these.
  bool is_outside(const Vec3 &point, double by, uint32_t a, uint32_t b) const {
    for (uint32_t k = 0; k < balls().n; ++k) {
      if (k == a || k == b) continue;
      const Vec3 c = centre(k), d{point.x - c.x, point.y - c.y, point.z - c.z};
      const double reach = balls().r[k] + by;
      if (dot(d, d) <= reach * reach) return false;
    }
    return true;
  }
  // Of many points of the sphere.
  bool has_free_point(uint32_t i) {
    for (int point = 0; point < 60; ++point)
      if (is_outside(combine(1.0, centre(i), balls().r[i], random_direction()), 1e-6, i, i)) return true;
    return false;
  }
  // Of many points of the circle of two balls, if they have one.
  bool has_free_point(uint32_t i, uint32_t j) {
    const Vec3 c = centre(i), other = centre(j), d{other.x - c.x, other.y - c.y, other.z - c.z};
    const double squared = dot(d, d), r = balls().r[i], s = balls().r[j];
    const double along = 0.5 * (squared + r * r - s * s), rho_squared = r * r - along * along / squared;
    for (int point = 0; point < 40 && rho_squared > 0.0; ++point) {
      const Vec3 u = random_direction(), across = combine(1.0, u, -dot(u, d) / squared, d);
      const double rho = std::sqrt(rho_squared / dot(across, across));
      if (is_outside(combine(1.0, combine(1.0, c, along / squared, d), rho, across), 1e-3, i, j)) return true;
    }
    return false;
  }

  uint32_t count_covered() {
    uint32_t count = 0;
    for (uint32_t i = 0; i < balls().n; ++i) {
      if (!covered.contains(i)) continue;
      EXPECT_FALSE(has_free_point(i)) << i;
      ++count;
    }
    return count;
  }

  hsp::CoveredBalls covered;

 private:
  oracle::RandomSource random_;
  std::optional<BuiltGrid> grid_;
  CarvedMemory memory_;
};

TEST_F(CoveredBalls, HaveNoFreePoint) {
  for (const int64_t most : {3, 300}) {
    take_models(30, most, 360);
    const uint32_t count = count_covered();
    EXPECT_GT(count, 100U);
    EXPECT_LT(count, 348U);
  }
}

// Of 360 balls: those that matter are kept, and others come.
TEST_F(CoveredBalls, AreTheSameWithLittleRoom) {
  for (const uint32_t caps : {80U, 161U}) {
    take_models(30, 300, caps);
    EXPECT_GT(count_covered(), 100U) << caps;
  }
}

TEST_F(CoveredBalls, AreNotCertainWithoutRoom) {
  for (const uint32_t caps : {0U, 2U}) {
    take_models(30, 300, caps);
    EXPECT_EQ(count_covered(), 0U);
  }
  EXPECT_FALSE(covered.visit_neighbours([](uint32_t) { FAIL(); }));
}

// Others may be named, too, but few.
TEST_F(CoveredBalls, TellTheCirclesOfTheOthersThatMayBeFree) {
  for (const uint32_t caps : {100U, 360U}) {
    take_models(20, 300, caps);
    uint32_t free = 0, named = 0;
    for (uint32_t i = 0; i < balls().n; ++i) {
      if (covered.contains(i)) continue;
      std::set<uint32_t> others;
      ASSERT_TRUE(covered.visit_neighbours([&others](uint32_t other) { others.insert(other); }));
      named += static_cast<uint32_t>(others.size());
      for (uint32_t j = 0; j < balls().n; ++j) {
        if (j == i || !has_free_point(i, j)) continue;
        EXPECT_EQ(others.count(j), 1U) << i << " " << j;
        ++free;
      }
    }
    EXPECT_GT(free, 100U);
    EXPECT_LT(named, 4 * free);
  }
}

}  // namespace
