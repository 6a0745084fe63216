// The balls that are found hidden are hidden: every point of a front above which another ball was to be is looked at,
// by samples. And they are nearly all that are.
#include "view/occlusion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_boundary.hpp"
#include "random_balls.hpp"

namespace {

std::vector<uint8_t> found_visible(const hsp::CubeGrid &grid, const hsp::ViewFrame &frame) {
  const hsp::BallSet &balls = grid.balls();
  hsp::OcclusionCuller hidden;
  hsp::Workspace measured;
  hidden.carve(measured, balls.n);
  std::vector<unsigned char> memory(measured.bytes());
  hsp::Workspace workspace(memory.data(), memory.size());
  hidden.carve(workspace, balls.n);
  std::vector<uint8_t> visible(balls.n, 1);
  hidden.hide(grid, frame, {visible.data(), balls.n});
  return visible;
}

// Whether another ball's front lies above a point of ball i's front disc, in view coordinates.
bool is_covered(const hsp::BallSet &balls, const hsp::ViewFrame &frame, uint32_t i, double x, double y) {
  const auto front = [&](uint32_t k) {
    const hsp::Vec3 centre = frame.centre_of(balls, k);
    const double left = balls.r[k] * balls.r[k] - (x - centre.x) * (x - centre.x) - (y - centre.y) * (y - centre.y);
    return left < 0.0 ? -INFINITY : centre.z + std::sqrt(left);
  };
  const double own = front(i);
  for (uint32_t k = 0; k < balls.n; ++k) {
    if (k != i && front(k) > own) return true;
  }
  return false;
}

hsp::ViewFrame frame_for(const hsp::BallSet &balls, double x, double y, double z) {
  hsp::ViewFrame frame;
  EXPECT_EQ(hsp::look_from({{x, y, z}, {0, 1, 0}}, frame), hsp::Status::ok);
  hsp::centre_on(balls, frame);
  return frame;
}

// How many of the balls are found hidden; each of these is looked at in 400 points up to its rim.
uint32_t count_hidden(const oracle::Balls &set, double x, double y, double z) {
  const BuiltBoundary built(set);
  const hsp::BallSet &balls = built.balls();
  const hsp::ViewFrame frame = frame_for(balls, x, y, z);
  const std::vector<uint8_t> visible = found_visible(built.grid(), frame);
  uint32_t hidden = 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (visible[i] != 0) continue;
    ++hidden;
    const hsp::Vec3 centre = frame.centre_of(balls, i);
    for (int k = 0; k < 400; ++k) {
      const double distance = balls.r[i] * std::sqrt((k + 0.5) / 400.0);
      const double angle = 2.399963 * k;
      EXPECT_TRUE(
          is_covered(balls, frame, i, centre.x + distance * std::cos(angle), centre.y + distance * std::sin(angle)))
          << "ball " << i << " of " << balls.n;
    }
  }
  return hidden;
}

oracle::Balls random_set(oracle::RandomSource &random, uint32_t n, int side, int smallest, int largest) {
  oracle::Balls set;
  for (uint32_t k = 0; k < n; ++k)
    set.push_back({random.in(0, side), random.in(0, side), random.in(0, side), random.in(smallest, largest)});
  return set;
}

TEST(OcclusionCuller, HidesOnlyWhatIsHidden) {
  oracle::RandomSource random(17);
  uint32_t hidden = 0;
  for (int round = 0; round < 60; ++round) {
    const int smallest = round % 3 == 0 ? 100 : 20;
    hidden += count_hidden(random_set(random, 60, 600, smallest, 150), 0, 0, 1);
    hidden += count_hidden(random_set(random, 60, 500, smallest, 150), 1, 1, 1);
    hidden += count_hidden(random_set(random, 80, 700, smallest, 200), 0.3, -0.8, 0.1 * round);
  }
  EXPECT_GT(hidden, 2000U);
}

TEST(OcclusionCuller, BallsOnTheRimOfOthersStay) {
  // Of equal balls one behind the other the second one looks out by a single step.
  const BuiltBoundary built({{0, 0, 0, 1000000}, {1, 0, -5000000, 1000000}});
  const std::vector<uint8_t> visible = found_visible(built.grid(), frame_for(built.balls(), 0, 0, 1));
  EXPECT_NE(visible[built.grid_index(0)], 0);
  EXPECT_NE(visible[built.grid_index(1)], 0);
}

TEST(OcclusionCuller, NothingIsAboveTheHighest) {
  for (const int64_t r : {0, 1, 500}) {
    EXPECT_EQ(count_hidden({{0, 0, 0, r}}, 0, 0, 1), 0U);
    EXPECT_EQ(count_hidden({{0, 0, 0, r}, {0, 0, 0, r}}, 0, 0, 1), 0U);
  }
  EXPECT_EQ(count_hidden({}, 0, 0, 1), 0U);
}

// Behind a large ball all small ones are found, in front of it none.
TEST(OcclusionCuller, FindsWhatLiesDeep) {
  oracle::Balls set{{0, 0, 0, 100000}};
  for (int k = -3; k <= 3; ++k) {
    for (int l = -3; l <= 3; ++l) set.push_back({10000 * k, 10000 * l, -200000, 9000});
  }
  EXPECT_EQ(count_hidden(set, 0, 0, 1), 49U);
  EXPECT_EQ(count_hidden(set, 0, 0, -1), 0U);
}

// Far from the origin of the lattice, and in sets so wide that the cells are larger than the balls.
TEST(OcclusionCuller, LargeExtents) {
  oracle::RandomSource random(23);
  constexpr int64_t far = int64_t{1} << 49;
  oracle::Balls set = random_set(random, 60, 600, 100, 150);
  for (oracle::LatticeBall &ball : set) ball.x += far;
  EXPECT_GT(count_hidden(set, 0, 0, 1), 5U);
  set.push_back({-far, far, 0, 10});
  count_hidden(set, 0, 0, 1);
}

}  // namespace
