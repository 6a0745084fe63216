#include "mesh/rounded_direction.hpp"

#include <gtest/gtest.h>

#include "big_integer.hpp"
#include "random_balls.hpp"

namespace {

using hsp::RoundedDirection;

oracle::BigInteger big(int64_t value) {
  return oracle::BigInteger(value);
}

oracle::BigInteger determinant(const int64_t u[3], const int64_t v[3], const int64_t w[3]) {
  oracle::BigInteger sum = big(0);
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    sum = sum + big(u[k]) * (big(v[l]) * big(w[m]) - big(v[m]) * big(w[l]));
  }
  return sum;
}

int slow_orientation(const RoundedDirection &a, const RoundedDirection &b, const RoundedDirection &c) {
  const int64_t u[3] = {a.x, a.y, a.z}, v[3] = {b.x, b.y, b.z}, w[3] = {c.x, c.y, c.z};
  return determinant(u, v, w).sign();
}

int slow_height(const RoundedDirection &a, const RoundedDirection &b, const RoundedDirection &c,
                const RoundedDirection &d) {
  const auto less = [&](const RoundedDirection &p, int64_t out[3]) {
    out[0] = int64_t{p.x} - a.x;
    out[1] = int64_t{p.y} - a.y;
    out[2] = int64_t{p.z} - a.z;
  };
  int64_t u[3], v[3], w[3];
  less(b, u);
  less(c, v);
  less(d, w);
  return determinant(u, v, w).sign();
}

RoundedDirection random_direction(oracle::RandomSource &random) {
  const auto part = [&] { return static_cast<double>(random.in(-1000000, 1000000)) + 0.5; };
  return hsp::rounded({part(), part(), part()});
}

// Points anywhere, and points so close to each other that doubles cannot tell.
TEST(RoundedDirection, BothQuestionsAgreeWithLongIntegers) {
  oracle::RandomSource random(1);
  int undecided = 0;
  for (int turn = 0; turn < 20000; ++turn) {
    RoundedDirection p[4];
    const int spread = turn % 3 == 0 ? 0 : turn % 3 == 1 ? 3 : 40;
    p[0] = random_direction(random);
    for (int k = 1; k < 4; ++k) {
      p[k] = random_direction(random);
      if (spread == 0) continue;
      const auto near = [&](int32_t x) { return x + static_cast<int32_t>(random.in(-spread, spread)); };
      p[k] = {near(p[0].x), near(p[0].y), near(p[0].z)};
    }
    EXPECT_EQ(hsp::orientation(p[0], p[1], p[2]), slow_orientation(p[0], p[1], p[2]));
    EXPECT_EQ(hsp::height_above(p[0], p[1], p[2], p[3]), slow_height(p[0], p[1], p[2], p[3]));
    if (slow_orientation(p[0], p[1], p[2]) == 0) ++undecided;
  }
  EXPECT_GT(undecided, 0);
}

TEST(RoundedDirection, LargestValues) {
  constexpr int32_t most = 1 << 30;
  const RoundedDirection x{most, 0, 0}, y{0, most, 0}, z{0, 0, most};
  const RoundedDirection minus_x{-most, 0, 0}, minus_y{0, -most, 0};
  EXPECT_EQ(hsp::orientation(x, y, z), 1);
  EXPECT_EQ(hsp::orientation(y, x, z), -1);
  EXPECT_EQ(hsp::orientation(x, y, minus_x), 0);
  EXPECT_EQ(hsp::height_above(x, y, z, minus_x), -1);
  EXPECT_EQ(hsp::height_above(x, y, minus_x, z), 1);
  EXPECT_EQ(hsp::height_above(x, y, minus_x, minus_y), 0);
}

TEST(RoundedDirection, RoundsToTheNearest) {
  EXPECT_EQ(hsp::rounded({0, 0, -5}), (RoundedDirection{0, 0, -(1 << 30)}));
  EXPECT_EQ(hsp::rounded({3, 0, 4}), (RoundedDirection{644245094, 0, 858993459}));
  EXPECT_EQ(hsp::rounded({-3, 0, 4}), (RoundedDirection{-644245094, 0, 858993459}));
}

}  // namespace
