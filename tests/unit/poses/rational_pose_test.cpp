#include "poses/rational_pose.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rational_images.hpp"

namespace {

using hsp::RationalPose;
using hsp::Status;
using hsp::Vec3;

RationalPose pose_of(const RationalNumbers &numbers) {
  RationalPose pose;
  const double translation[3] = {static_cast<double>(numbers.shift[0]), static_cast<double>(numbers.shift[1]),
                                 static_cast<double>(numbers.shift[2])};
  EXPECT_EQ(RationalPose::make(numbers.quaternion.data(), translation, hsp::exact::Lattice::with_step(1.0), pose),
            Status::ok);
  return pose;
}

Vec3 vector_of(const oracle::LatticeBall &ball) {
  return {static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)};
}

int sign_by_library(const RationalPose &pose, const oracle::LatticeBall &fixed, const oracle::LatticeBall &moving) {
  return pose.meet_exactly(vector_of(fixed), vector_of(moving), static_cast<double>(fixed.radius + moving.radius)) ? 0
                                                                                                                   : 1;
}

// Balls at rest near the image of another ball, up to the largest coordinates.
TEST(RationalPose, DecidesAsLargeIntegersDo) {
  oracle::RandomSource random(3);
  int touching = 0;
  for (int k = 0; k < 4000; ++k) {
    const int64_t most = int64_t{1} << random.in(3, 48);
    const RationalNumbers numbers = random_rational(random, most);
    const RationalPose pose = pose_of(numbers);
    const oracle::LatticeBall moving{random.in(-most, most), random.in(-most, most), random.in(-most, most),
                                     random.in(0, std::min<int64_t>(most, (1 << 30) - 1))};
    const Vec3 image = pose.image(vector_of(moving));
    oracle::LatticeBall fixed{std::llround(image.x), std::llround(image.y), std::llround(image.z), random.in(0, 2000)};
    const double slack = pose.slack(2 * static_cast<double>(most + fixed.radius + moving.radius));
    int64_t &coordinate = random.one_in(2) ? fixed.x : fixed.y;
    const int64_t off = random.one_in(2) ? random.in(-1, 1) : 0;
    coordinate += off + (random.one_in(2) ? 1 : -1) * (fixed.radius + moving.radius);
    const int expected = exact_relation(fixed, moving, numbers);
    touching += expected == 0 ? 1 : 0;
    ASSERT_EQ(sign_by_library(pose, fixed, moving), expected > 0 ? 1 : 0) << k;
    // Doubles are right up to the slack, and the rounded distance much nearer.
    const auto sum = static_cast<double>(fixed.radius + moving.radius);
    const Vec3 between = image - vector_of(fixed);
    const double exact = pose.distance(vector_of(fixed), vector_of(moving));
    ASSERT_NEAR(std::sqrt(dot(between, between)), exact, slack) << k;
    if (expected > 0) {
      ASSERT_GE(exact, sum * (1 - 0x1p-51));
    } else {
      ASSERT_LE(exact, sum * (1 + 0x1p-51));
    }
  }
  EXPECT_GT(touching, 100);
}

// 3, 4, 5: half an angle whose sine and cosine are fractions.
TEST(RationalPose, PutsLatticePointsOntoLatticePoints) {
  const RationalPose pose = pose_of({{2, 0, 0, 1}, {100, 0, 7}});  // cos 3/5, sin 4/5
  EXPECT_EQ(pose.distance({103, 4, 7}, {5, 0, 0}), 0);
  EXPECT_EQ(pose.distance({103, 4, 19}, {5, 0, 0}), 12);
  EXPECT_TRUE(pose.meet_exactly({103, 4, 19}, {5, 0, 0}, 12));
  EXPECT_FALSE(pose.meet_exactly({103, 4, 19}, {5, 0, 0}, 11));
  EXPECT_EQ(RationalPose().distance({1, 2, 2}, {0, 0, 0}), 3);
}

// The same rotation, in other lengths.
TEST(RationalPose, DoesNotDependOnTheLengthOfTheQuaternion) {
  oracle::RandomSource random(4);
  for (int k = 0; k < 300; ++k) {
    RationalNumbers numbers = random_rational(random, 100);
    for (int32_t &component : numbers.quaternion) component /= 1 << 10;
    if (numbers.quaternion == std::array<int32_t, 4>{}) numbers.quaternion[3] = 1;
    RationalNumbers scaled = numbers;
    for (int32_t &component : scaled.quaternion) component *= -1023;
    const oracle::LatticeBall moving{random.in(-99, 99), random.in(-99, 99), random.in(-99, 99), 9};
    for (int time = 0; time < 20; ++time) {
      const oracle::LatticeBall fixed{random.in(-99, 99), random.in(-99, 99), random.in(-99, 99), random.in(0, 200)};
      EXPECT_EQ(sign_by_library(pose_of(numbers), fixed, moving), sign_by_library(pose_of(scaled), fixed, moving));
    }
  }
}

TEST(RationalPose, RoundsItsTranslationToTheLattice) {
  RationalPose pose;
  const int32_t none[4] = {0, 0, 0, 0}, at_rest[4] = {INT32_MIN, 0, 0, 0};
  const double shift[3] = {0.75, -0.76, 10.3};
  const hsp::exact::Lattice halves = hsp::exact::Lattice::with_step(0.5);
  ASSERT_EQ(RationalPose::make(at_rest, shift, halves, pose), Status::ok);
  EXPECT_EQ(pose.distance({2, -2, 21}, {0, 0, 0}), 0);
  EXPECT_EQ(RationalPose::make(none, shift, halves, pose), Status::range);
  const double far[3] = {0, 0x1.8p49, 0}, bad[3] = {0, 0, std::nan("")};
  EXPECT_EQ(RationalPose::make(at_rest, far, halves, pose), Status::range);
  EXPECT_EQ(RationalPose::make(at_rest, bad, halves, pose), Status::not_finite);
}

}  // namespace
