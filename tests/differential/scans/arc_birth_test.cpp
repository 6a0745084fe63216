// A ball that sinks into the crease between two others. First its sphere meets each of them in a whole circle; then
// these reach the circle of the two, and arcs are born: gradients have an unbounded slope there, but no jump.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "library_derivatives.hpp"

namespace {

constexpr int64_t unit = int64_t{1} << 22;

// Radii of about 100 units; the third ball is above the crease at the given height.
oracle::Balls balls_at(int64_t height) {
  return {{0, 0, 0, 100 * unit},
          {120 * unit + 7, 3 * unit, -unit, 90 * unit},
          {40 * unit, height, 30 * unit + 11, 80 * unit}};
}

uint32_t vertices_at(int64_t height) {
  return LibraryBoundary(balls_at(height)).counts().vertices;
}

// All derivatives of the area, relative to the unit.
std::vector<double> gradient_at(int64_t height) {
  std::vector<double> result;
  for (const FourDerivatives &ball : gradient(LibraryBoundary(balls_at(height)), EnergyTerms{}).by_ball)
    for (const double derivative : ball) result.push_back(derivative / static_cast<double>(unit));
  return result;
}

double largest_difference(const std::vector<double> &a, const std::vector<double> &b) {
  double largest = 0;
  for (size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

class ArcBirth : public testing::Test {
 protected:
  // The lowest height without vertices, at which each two of the balls meet in a whole free circle.
  void SetUp() override {
    int64_t with = 100 * unit;
    int64_t without = 190 * unit;
    ASSERT_EQ(vertices_at(with), 2U);
    ASSERT_EQ(vertices_at(without), 0U);
    while (without - with > 1) {
      const int64_t middle = (with + without) / 2;
      (vertices_at(middle) > 0 ? with : without) = middle;
    }
    birth_ = without;
    ASSERT_EQ(LibraryBoundary(balls_at(birth_)).counts().circles, 3U);
  }

  int64_t birth_ = 0;
};

TEST_F(ArcBirth, TheGradientDoesNotJump) {
  const std::vector<double> one_side = gradient_at(birth_);
  const std::vector<double> other_side = gradient_at(birth_ - 1);
  // A jump would be as large as the derivatives themselves, hundreds; a root of one step out of 1e8 is not.
  EXPECT_LT(largest_difference(one_side, other_side), 0.5);
  double largest = 0;
  for (const double derivative : one_side) largest = std::max(largest, std::abs(derivative));
  EXPECT_GT(largest, 100);
}

// With vertices the derivatives move away from their value at the birth like the root of the depth: four times the
// depth makes twice the change.
TEST_F(ArcBirth, TheGradientLeavesLikeARoot) {
  const std::vector<double> at_birth = gradient_at(birth_);
  double shallow = largest_difference(gradient_at(birth_ - 256), at_birth);
  for (int64_t depth = 1024; depth <= 1024 * 1024; depth *= 4) {
    const double deep = largest_difference(gradient_at(birth_ - depth), at_birth);
    EXPECT_NEAR(deep / shallow, 2, 0.1) << depth;
    shallow = deep;
  }
}

// Without vertices they are smooth up to the birth: the change is as the step.
TEST_F(ArcBirth, TheGradientArrivesSmoothly) {
  const std::vector<double> at_birth = gradient_at(birth_);
  double small = largest_difference(gradient_at(birth_ + 4096), at_birth);
  for (int64_t distance = 4 * 4096; distance <= 256 * 4096; distance *= 4) {
    const double large = largest_difference(gradient_at(birth_ + distance), at_birth);
    EXPECT_NEAR(large / small, 4, 0.1) << distance;
    small = large;
  }
}

}  // namespace
