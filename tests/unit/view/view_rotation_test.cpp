// View directions from angles: quarter turns exactly, others as the matrices say.
#include "view/view_rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using hsp::Status;
using hsp::ViewDirection;

ViewDirection rotated(double x, double y, double z) {
  ViewDirection direction{};
  EXPECT_EQ(hsp::direction_of_rotation(x, y, z, direction), Status::ok);
  return direction;
}

void expect_equal(const double a[3], double x, double y, double z) {
  EXPECT_EQ(a[0], x);
  EXPECT_EQ(a[1], y);
  EXPECT_EQ(a[2], z);
}

TEST(DirectionOfDegrees, QuarterTurnsAreExact) {
  const double cosine[4] = {1, 0, -1, 0};
  const double sine[4] = {0, 1, 0, -1};
  for (int quarter = -4000; quarter <= 4000; ++quarter) {
    const auto direction = hsp::direction_of_degrees(90.0 * quarter);
    EXPECT_EQ(direction.cosine, cosine[quarter & 3]) << quarter;
    EXPECT_EQ(direction.sine, sine[quarter & 3]) << quarter;
  }
}

TEST(DirectionOfDegrees, OtherAnglesAreThoseOfTheCLibrary) {
  for (int k = -7000; k <= 7000; ++k) {
    const double degrees = 0.37 * k;
    const double angle = std::remainder(degrees, 360.0) * (std::numbers::pi / 180);
    const auto direction = hsp::direction_of_degrees(degrees);
    EXPECT_NEAR(direction.cosine, std::cos(angle), 1e-14) << degrees;
    EXPECT_NEAR(direction.sine, std::sin(angle), 1e-14) << degrees;
  }
}

TEST(DirectionOfRotation, OneQuarterTurnAboutEachAxis) {
  ViewDirection seen = rotated(0, 0, 0);
  expect_equal(seen.towards, 0, 0, 1);
  expect_equal(seen.up, 0, 1, 0);
  // About x: what was above comes to the front.
  seen = rotated(90, 0, 0);
  expect_equal(seen.towards, 0, 1, 0);
  expect_equal(seen.up, 0, 0, -1);
  // About y: what was on the left comes to the front.
  seen = rotated(0, 90, 0);
  expect_equal(seen.towards, -1, 0, 0);
  expect_equal(seen.up, 0, 1, 0);
  // About z: what was on the right comes to the top.
  seen = rotated(0, 0, 90);
  expect_equal(seen.towards, 0, 0, 1);
  expect_equal(seen.up, 1, 0, 0);
}

// Rows of R_z R_y R_x, multiplied out here from the three matrices.
TEST(DirectionOfRotation, RowsOfTheProduct) {
  const double angles[3] = {20, -50, 110};
  double R[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    const double t = angles[axis] * std::numbers::pi / 180;
    const int p = (axis + 1) % 3, q = (axis + 2) % 3;
    for (int column = 0; column < 3; ++column) {
      const double a = R[p][column], b = R[q][column];
      R[p][column] = std::cos(t) * a - std::sin(t) * b;
      R[q][column] = std::sin(t) * a + std::cos(t) * b;
    }
  }
  const ViewDirection seen = rotated(angles[0], angles[1], angles[2]);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(seen.towards[k], R[2][k], 1e-14);
    EXPECT_NEAR(seen.up[k], R[1][k], 1e-14);
  }
}

TEST(DirectionOfRotation, RefusesAnglesThatAreNoneOrTooLarge) {
  ViewDirection direction{};
  const double infinite = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    double angle[3] = {0, 0, 0};
    const auto refused = [&](double value) {
      angle[axis] = value;
      return hsp::direction_of_rotation(angle[0], angle[1], angle[2], direction);
    };
    EXPECT_EQ(refused(std::numeric_limits<double>::quiet_NaN()), Status::not_finite);
    EXPECT_EQ(refused(-infinite), Status::not_finite);
    EXPECT_EQ(refused(std::nextafter(hsp::largest_rotation, infinite)), Status::range);
    EXPECT_EQ(refused(-std::nextafter(hsp::largest_rotation, infinite)), Status::range);
    EXPECT_EQ(refused(hsp::largest_rotation), Status::ok);
    EXPECT_EQ(refused(-hsp::largest_rotation), Status::ok);
  }
}

}  // namespace
