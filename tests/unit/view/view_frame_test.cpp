// The axes of a view: directions rounded to integers, what is up, and the middle of the balls.
#include "view/view_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "built_boundary.hpp"

namespace {

using hsp::Vec3;

constexpr double largest = std::numeric_limits<double>::max();
constexpr int64_t unit = int64_t{1} << 28;

hsp::ViewFrame frame_of(const hsp::ViewDirection &direction) {
  hsp::ViewFrame frame;
  EXPECT_EQ(hsp::look_from(direction, frame), hsp::Status::ok);
  return frame;
}

void expect_vector(const Vec3 &v, double x, double y, double z) {
  EXPECT_EQ(v.x, x);
  EXPECT_EQ(v.y, y);
  EXPECT_EQ(v.z, z);
}

void expect_direction(const hsp::ViewFrame &frame, int64_t x, int64_t y, int64_t z) {
  EXPECT_EQ(frame.direction.x, x);
  EXPECT_EQ(frame.direction.y, y);
  EXPECT_EQ(frame.direction.z, z);
}

TEST(ViewFrame, AxesAreExact) {
  const hsp::ViewFrame front = frame_of({{0, 0, 3}, {0, 2, 0}});
  expect_direction(front, 0, 0, unit);
  expect_vector(front.right, 1, 0, 0);
  expect_vector(front.up, 0, 1, 0);
  expect_vector(front.towards, 0, 0, 1);
  const hsp::ViewFrame side = frame_of({{-1e-300, 0, 0}, {0, 0, 1e300}});
  expect_direction(side, -unit, 0, 0);
  expect_vector(side.right, 0, -1, 0);
  expect_vector(side.up, 0, 0, 1);
}

TEST(ViewFrame, DirectionsOfAnyLength) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  expect_direction(frame_of({{tiny, tiny, tiny}, {0, 1, 0}}), unit, unit, unit);
  expect_direction(frame_of({{largest, -largest, 0}, {0, 0, largest}}), unit, -unit, 0);
  expect_direction(frame_of({{largest, largest / 2, 1e-300}, {0, 1, 0}}), unit, unit / 2, 0);
}

TEST(ViewFrame, ZeroMeansDefault) {
  const hsp::ViewFrame frame = frame_of({{0, 0, 0}, {0, 0, 0}});
  expect_direction(frame, 0, 0, unit);
  expect_vector(frame.up, 0, 1, 0);
}

TEST(ViewFrame, UpParallelToTheViewIsReplaced) {
  expect_vector(frame_of({{0, 5, 0}, {0, 1, 0}}).up, 0, 0, 1);
  expect_vector(frame_of({{0, -5, 0}, {0, 0, 0}}).up, 0, 0, 1);
  expect_vector(frame_of({{1, 0, 0}, {-2, 0, 0}}).up, 0, 1, 0);
}

TEST(ViewFrame, RefusesWhatIsNotFinite) {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};
  for (const double value : bad) {
    for (int k = 0; k < 6; ++k) {
      hsp::ViewDirection direction{{0, 0, 1}, {0, 1, 0}};
      (k < 3 ? direction.towards[k] : direction.up[k - 3]) = value;
      hsp::ViewFrame frame;
      EXPECT_EQ(hsp::look_from(direction, frame), hsp::Status::not_finite);
    }
  }
}

TEST(ViewFrame, IsOrthonormalAndRightHanded) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> component(-1.0, 1.0);
  const double rounding = 8 * hsp::unit_roundoff;
  for (int k = 0; k < 20000; ++k) {
    const hsp::ViewDirection direction{{component(random), component(random), component(random)},
                                       {component(random), component(random), component(random)}};
    const hsp::ViewFrame frame = frame_of(direction);
    ASSERT_NEAR(dot(frame.right, frame.right), 1.0, rounding);
    ASSERT_NEAR(dot(frame.up, frame.up), 1.0, rounding);
    ASSERT_NEAR(dot(frame.towards, frame.towards), 1.0, rounding);
    ASSERT_NEAR(dot(frame.right, frame.up), 0.0, rounding);
    ASSERT_NEAR(dot(frame.up, frame.towards), 0.0, rounding);
    ASSERT_NEAR(dot(frame.towards, frame.right), 0.0, rounding);
    const Vec3 third = hsp::cross(frame.right, frame.up);
    ASSERT_NEAR(dot(third, frame.towards), 1.0, rounding);
    // Each component within half a step of 2^-28 of the largest.
    const Vec3 asked{direction.towards[0], direction.towards[1], direction.towards[2]};
    const Vec3 off = hsp::cross(asked, frame.towards);
    ASSERT_LT(std::sqrt(dot(off, off) / dot(asked, asked)), 0x1p-28);
    ASSERT_GT(dot(asked, frame.towards), 0.0);
    ASSERT_GT(frame.up.x * direction.up[0] + frame.up.y * direction.up[1] + frame.up.z * direction.up[2], 0.0);
  }
}

TEST(ViewFrame, OriginIsTheMiddleOfTheCentres) {
  hsp::ViewFrame frame;
  const BuiltBoundary one({{7, -8, 9, 1}});
  hsp::centre_on(one.balls(), frame);
  expect_vector(frame.origin, 7, -8, 9);
  const BuiltBoundary three({{-10, 0, 5, 1}, {30, 2, 5, 3}, {0, -100, 5, 1}});
  hsp::centre_on(three.balls(), frame);
  expect_vector(frame.origin, 10, -49, 5);
  const BuiltBoundary none({});
  hsp::centre_on(none.balls(), frame);
  expect_vector(frame.origin, 0, 0, 0);
}

}  // namespace
