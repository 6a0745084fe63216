// Axes of boxes: at right angles to the last bits, however flat the box; and exact where a turn exchanges axes.
#include "periodic/box_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_balls.hpp"

namespace {

using Row = std::array<long double, 3>;

Row axis_of(const hsp::BoxFrame &frame, int k) {
  return {frame.axis(k).x, frame.axis(k).y, frame.axis(k).z};
}
long double dot(const Row &a, const Row &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void expect_axes(const double (&vector)[9]) {
  hsp::BoxFrame frame;
  ASSERT_TRUE(frame.set(vector));
  ASSERT_TRUE(frame.turns());
  constexpr long double error = 0x1p-50L;
  const Row x = axis_of(frame, 0), y = axis_of(frame, 1), z = axis_of(frame, 2);
  for (const auto &[p, q] : {std::pair{x, y}, {y, z}, {z, x}}) EXPECT_LE(std::fabs(dot(p, q)), error);
  for (const Row &p : {x, y, z}) EXPECT_LE(std::fabs(dot(p, p) - 1), error);
  const Row turn{y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0]};
  EXPECT_LE(std::fabs(dot(x, turn) - 1), error);
  const Row a{vector[0], vector[1], vector[2]}, b{vector[3], vector[4], vector[5]};
  const long double length_a = std::sqrt(dot(a, a)), length_b = std::sqrt(dot(b, b));
  EXPECT_LE(std::fabs(dot(a, x) / length_a - 1), error);
  EXPECT_LE(std::fabs(dot(a, y) / length_a), error);
  EXPECT_LE(std::fabs(dot(a, z) / length_a), error);
  EXPECT_LE(std::fabs(dot(b, z) / length_b), error);
  EXPECT_GE(dot(b, y), 0);
  // By powers of two everything is scaled without a rounding.
  double scaled[9];
  for (const double factor : {0x1p-900, 0x1p800}) {
    hsp::BoxFrame same;
    for (int k = 0; k < 9; ++k) scaled[k] = factor * vector[k];
    ASSERT_TRUE(same.set(scaled));
    EXPECT_TRUE(same == frame);
  }
}

TEST(BoxFrame, HasRightAngles) {
  oracle::RandomSource random(361);
  for (int set = 0; set < 500; ++set) {
    double vector[9];
    for (double &x : vector) x = 20 * random.fraction() - 10;
    expect_axes(vector);
    // b nearly along a, and c nearly in their plane.
    for (int k = 0; k < 3; ++k) vector[3 + k] = vector[k] * 3 + vector[3 + k] * (set % 2 == 0 ? 1e-6 : 1e-12);
    for (int k = 0; k < 3; ++k) vector[6 + k] = vector[k] - vector[3 + k];
    expect_axes(vector);
  }
}

TEST(BoxFrame, DoesNotTurnWhatIsUpright) {
  const double vector[9] = {-3, 0, 0, 1, 0.1, 0, 7, 5, -1e-9};
  hsp::BoxFrame frame;
  ASSERT_TRUE(frame.set(vector));
  EXPECT_FALSE(frame.turns());
  const double v[3] = {-0.0, 0.1, 1e300};
  const hsp::Vec3 same = frame.turned_in(v), back = frame.turned_back(same);
  EXPECT_TRUE(std::signbit(same.x) && same.y == 0.1 && same.z == 1e300);
  EXPECT_TRUE(std::signbit(back.x) && back.y == 0.1 && back.z == 1e300);
}

TEST(BoxFrame, ExchangesAxesExactly) {
  std::array<size_t, 3> axis{0, 1, 2};
  do {
    for (uint32_t signs = 0; signs < 8; ++signs) {
      double vector[9] = {};
      const double length[3] = {5.1, 0.3, 7e5};
      for (size_t k = 0; k < 3; ++k) vector[3 * k + axis[k]] = (signs >> k & 1) != 0 ? -length[k] : length[k];
      hsp::BoxFrame frame;
      ASSERT_TRUE(frame.set(vector));
      for (int k = 0; k < 3; ++k) {
        const hsp::Vec3 turned = frame.turned_in(vector + 3 * k);
        const double along[3] = {turned.x, turned.y, turned.z};
        for (int other = 0; other < 3; ++other) EXPECT_EQ(std::fabs(along[other]), other == k ? length[k] : 0.0);
      }
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
}

TEST(BoxFrame, NeedsAPlane) {
  const double vectors[][9] = {
      {0, 0, 0, 1, 2, 3, 4, 5, 6},
      {1, 0, 0, 0, 0, 0, 4, 5, 6.5},  // upright but for c, of which nothing is asked
      {0, 1, 0, 0, -7, 0, 4, 5, 6},
      {5e-324, 5e-324, 0, 0, 5e-324, 0, 0, 0, 5e-324},
  };
  const bool has_axes[] = {false, true, false, false};
  for (size_t k = 0; k < 4; ++k) {
    hsp::BoxFrame frame;
    EXPECT_EQ(frame.set(vectors[k]), has_axes[k]);
  }
}

}  // namespace
