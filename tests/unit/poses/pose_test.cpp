#include "poses/pose.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "random_poses.hpp"

namespace {

using hsp::Pose;
using hsp::Status;

constexpr double infinity = std::numeric_limits<double>::infinity();

Status made(const std::array<double, 4> &quaternion, const std::array<double, 3> &translation) {
  Pose pose;
  return Pose::make(quaternion.data(), translation.data(), hsp::exact::Lattice::with_step(0.5), pose);
}

// R x + t by the product of quaternions q x q*, in extended precision: not the formula of the library.
std::array<long double, 3> ideal_image(const PoseNumbers &pose, const hsp::Vec3 &p) {
  using Quaternion = std::array<long double, 4>;
  const auto product = [](const Quaternion &a, const Quaternion &b) {
    return Quaternion{
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
  };
  const Quaternion q{pose.quaternion[0], pose.quaternion[1], pose.quaternion[2], pose.quaternion[3]};
  const Quaternion turned = product(product(q, {0, p.x, p.y, p.z}), {q[0], -q[1], -q[2], -q[3]});
  const long double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  return {turned[1] / square + pose.translation[0], turned[2] / square + pose.translation[1],
          turned[3] / square + pose.translation[2]};
}

TEST(Pose, IsAtRestFirst) {
  const hsp::Vec3 image = Pose().image({1, -2, 3});
  EXPECT_EQ(image.x, 1);
  EXPECT_EQ(image.y, -2);
  EXPECT_EQ(image.z, 3);
}

TEST(Pose, SnapsToThePointsNearestToIdealImages) {
  oracle::RandomSource random(1);
  for (int k = 0; k < 5000; ++k) {
    const int64_t most = int64_t{1} << random.in(1, 40);
    const PoseNumbers numbers = random_pose(random, most);
    const hsp::Vec3 p{static_cast<double>(random.in(-most, most)), static_cast<double>(random.in(-most, most)),
                      static_cast<double>(random.in(-most, most))};
    const hsp::Vec3 snapped = pose_of(numbers).snapped(p);
    const std::array<long double, 3> ideal = ideal_image(numbers, p);
    const long double x = snapped.x - ideal[0], y = snapped.y - ideal[1], z = snapped.z - ideal[2];
    EXPECT_LT(x * x + y * y + z * z, 0.87L * 0.87L);
    EXPECT_EQ(snapped.x, std::floor(snapped.x));
  }
}

// Quaternions of any length are the same rotation where powers of two are between them.
TEST(Pose, DoesNotDependOnTheLengthOfTheQuaternion) {
  const std::array<double, 3> translation{1, 2, 3};
  PoseNumbers numbers{{0.3, -0.7, 0.2, 0.6}, translation};
  const hsp::Vec3 image = pose_of(numbers).image({10, 20, 30});
  for (const double scale : {0x1p-299, 0x1p-40, -1.0, 0x1p10, 0x1p300}) {
    PoseNumbers scaled = numbers;
    for (double &component : scaled.quaternion) component *= scale;
    const hsp::Vec3 other = pose_of(scaled).image({10, 20, 30});
    EXPECT_EQ(other.x, image.x) << scale;
    EXPECT_EQ(other.y, image.y) << scale;
    EXPECT_EQ(other.z, image.z) << scale;
  }
}

// From the matrix of a pose back to its quaternion, up to its sign: quarter and half turns about all axes among them.
TEST(Pose, FindsTheQuaternionOfAMatrix) {
  oracle::RandomSource random(9);
  for (int k = 0; k < 3000; ++k) {
    const PoseNumbers numbers = random_pose(random, 0);
    const hsp::Pose pose = pose_of(numbers);
    const hsp::Vec3 x = pose.image({1, 0, 0}), y = pose.image({0, 1, 0}), z = pose.image({0, 0, 1});
    const double matrix[9] = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
    PoseNumbers found;
    ASSERT_EQ(hsp::quaternion_of_rotation(matrix, found.quaternion.data()), Status::ok);
    double square = 0, product = 0, unit = 0;
    for (size_t c = 0; c < 4; ++c) {
      square += numbers.quaternion[c] * numbers.quaternion[c];
      product += numbers.quaternion[c] * found.quaternion[c];
      unit += found.quaternion[c] * found.quaternion[c];
    }
    EXPECT_NEAR(std::fabs(product), std::sqrt(square), 1e-14 * std::sqrt(square));
    EXPECT_NEAR(unit, 1, 1e-14);
  }
}

// A rotation times a symmetric matrix with positive eigenvalues is nearest to that rotation, as each matrix is to the
// rotation of its polar decomposition.
TEST(Pose, FindsTheRotationNearestToAMatrix) {
  oracle::RandomSource random(10);
  for (int k = 0; k < 3000; ++k) {
    const PoseNumbers numbers = random_pose(random, 0);
    const hsp::Pose pose = pose_of(numbers);
    double stretch[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        stretch[i][j] = stretch[j][i] = (i == j ? 1.0 : 0.0) + 1e-9 * static_cast<double>(random.in(-200, 200));
    double matrix[9];
    for (size_t j = 0; j < 3; ++j) {
      const hsp::Vec3 column = pose.image({stretch[0][j], stretch[1][j], stretch[2][j]});
      matrix[j] = column.x, matrix[3 + j] = column.y, matrix[6 + j] = column.z;
    }
    double found[4];
    ASSERT_EQ(hsp::quaternion_of_rotation(matrix, found), Status::ok);
    double of_found = 0, of_given = 0, product = 0;
    for (size_t c = 0; c < 4; ++c) {
      of_found += found[c] * found[c];
      of_given += numbers.quaternion[c] * numbers.quaternion[c];
      product += numbers.quaternion[c] * found[c];
    }
    EXPECT_NEAR(of_found, 1, 1e-6);
    const double scale = product / of_given;
    for (size_t c = 0; c < 4; ++c) EXPECT_NEAR(found[c], scale * numbers.quaternion[c], 1e-14);
  }
}

TEST(Pose, RefusesMatricesThatAreNoRotations) {
  double quaternion[4] = {7, 7, 7, 7};
  const double reflection[9] = {1, 0, 0, 0, 1, 0, 0, 0, -1}, scaled[9] = {1.00001, 0, 0, 0, 1, 0, 0, 0, 1};
  const double sheared[9] = {1, 1e-5, 0, 0, 1, 0, 0, 0, 1}, none[9] = {};
  const double turned[9] = {0, -1, 0, 1, 4e-7, 0, 0, 0, 1};
  double bad[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  bad[5] = std::numeric_limits<double>::quiet_NaN();
  for (const double *matrix : {reflection, scaled, sheared, none})
    EXPECT_EQ(hsp::quaternion_of_rotation(matrix, quaternion), Status::range);
  EXPECT_EQ(hsp::quaternion_of_rotation(bad, quaternion), Status::not_finite);
  EXPECT_EQ(quaternion[0], 7);
  EXPECT_EQ(hsp::quaternion_of_rotation(turned, quaternion), Status::ok);
  EXPECT_NEAR(quaternion[0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(quaternion[3], std::sqrt(0.5), 1e-6);
}

TEST(Pose, RefusesWhatIsNone) {
  EXPECT_EQ(made({1, 0, 0, 0}, {0, 0, 0}), Status::ok);
  EXPECT_EQ(made({0, 0, 0, 0}, {0, 0, 0}), Status::range);
  EXPECT_EQ(made({0x1p-301, 0, 0, 0}, {0, 0, 0}), Status::range);
  EXPECT_EQ(made({0, 0x1p301, 0, 0}, {0, 0, 0}), Status::range);
  EXPECT_EQ(made({1, 0, 0, 0}, {0x1p49, 0, -0x1p49}), Status::ok);
  EXPECT_EQ(made({1, 0, 0, 0}, {0, 0x1.8p49, 0}), Status::range);
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    for (size_t k = 0; k < 4; ++k) {
      std::array<double, 4> quaternion{1, 0, 0, 0};
      quaternion[k] = bad;
      EXPECT_EQ(made(quaternion, {0, 0, 0}), Status::not_finite);
    }
    for (size_t k = 0; k < 3; ++k) {
      std::array<double, 3> translation{};
      translation[k] = bad;
      EXPECT_EQ(made({1, 0, 0, 0}, translation), Status::not_finite);
    }
  }
}

TEST(Pose, HasRoomAsFarAsDifferencesAreExact) {
  PoseNumbers numbers;
  numbers.translation = {0x1p50, 0, 0};
  EXPECT_TRUE(pose_of(numbers).has_room_for(0x1p50));
  EXPECT_FALSE(pose_of(numbers).has_room_for(0x1.000002p50));
}

}  // namespace
