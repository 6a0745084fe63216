#include "view/covered_balls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_grid.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"

namespace {

// The depth of the point of a ball's sphere that is least deep inside others, of many points of it.
double least_depth(const hsp::BallSet &balls, uint32_t ball, oracle::RandomSource &random) {
  double least = HUGE_VAL;
  for (int point = 0; point < 60; ++point) {
    double u[3], squared = 0.0;
    for (double &each : u) {
      each = static_cast<double>(random.in(-1000, 1000));
      squared += each * each;
    }
    if (squared == 0.0) continue;
    const double scale = balls.r[ball] / std::sqrt(squared);
    double deepest = -HUGE_VAL;
    for (uint32_t k = 0; k < balls.n; ++k) {
      if (k == ball) continue;
      const double distance =
          std::hypot(balls.x[ball] + scale * u[0] - balls.x[k], balls.y[ball] + scale * u[1] - balls.y[k],
                     balls.z[ball] + scale * u[2] - balls.z[k]);
      deepest = std::max(deepest, balls.r[k] - distance);
    }
    least = std::min(least, deepest);
  }
  return least;
}

struct Found {
  uint32_t covered = 0, uncovered = 0;
};

// Held against points of the spheres.
Found find_with_room_for(uint32_t caps, int64_t most, oracle::RandomSource &random) {
  const oracle::Balls atoms = oracle::grown(oracle::loose_balls(random, 12), 100);
  const BuiltGrid built(oracle::in_lengths(oracle::as_models(atoms, 30, most, random), 1));
  const hsp::BallSet &balls = built.grid().balls();
  CarvedMemory memory;
  hsp::CoveredBalls covered;
  memory.carve(covered, caps);
  covered.start(built.grid());
  Found found;
  for (uint32_t i = 0; i < balls.n; ++i) {
    const bool is_covered = covered.contains(i);
    ++(is_covered ? found.covered : found.uncovered);
    if (is_covered) {
      EXPECT_GT(least_depth(balls, i, random), -1e-6) << i;
    }
  }
  return found;
}

TEST(CoveredBalls, HaveNoFreePoint) {
  oracle::RandomSource random(31);
  for (const int64_t most : {3, 300}) {
    const Found found = find_with_room_for(360, most, random);
    EXPECT_GT(found.covered, 100U);
    EXPECT_GT(found.uncovered, 12U);
  }
}

// Of 360 balls, every second one or every fourth.
TEST(CoveredBalls, AreFoundWithLittleRoom) {
  oracle::RandomSource random(32);
  for (const uint32_t caps : {60U, 161U, 359U}) {
    const Found found = find_with_room_for(caps, 300, random);
    EXPECT_GT(found.covered, 20U) << caps;
  }
}

}  // namespace
