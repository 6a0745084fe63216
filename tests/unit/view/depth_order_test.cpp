// The painter's order against depths worked out in big integers.
#include "view/depth_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "big_integer.hpp"
#include "gridless_balls.hpp"
#include "random_balls.hpp"

namespace {

using Set = GridlessBalls<128>;

oracle::BigInteger depth(const hsp::BallSet &balls, const hsp::exact::Vector &v, uint32_t i) {
  const auto term = [](int64_t a, double b) {
    return oracle::BigInteger(a) * oracle::BigInteger(static_cast<int64_t>(b));
  };
  return term(v.x, balls.x[i]) + term(v.y, balls.y[i]) + term(v.z, balls.z[i]);
}

bool comes_before(const hsp::BallSet &balls, const hsp::exact::Vector &v, uint32_t a, uint32_t b) {
  const int sign = (depth(balls, v, a) - depth(balls, v, b)).sign();
  if (sign != 0) return sign < 0;
  const auto key = [&](uint32_t i) {
    return std::array<double, 5>{balls.x[i], balls.y[i], balls.z[i], balls.r[i], static_cast<double>(balls.caller[i])};
  };
  return key(a) < key(b);
}

void expect_order(const Set &set, const hsp::ViewDirection &direction) {
  const hsp::BallSet &balls = set.set();
  hsp::ViewFrame frame;
  ASSERT_EQ(hsp::look_from(direction, frame), hsp::Status::ok);
  hsp::centre_on(balls, frame);
  std::vector<hsp::DepthKey> keys;
  std::vector<uint32_t> expected;
  for (uint32_t i = 0; i < balls.n; ++i) {
    keys.push_back({0.0, i, 1000 + i});
    expected.push_back(i);
  }
  std::vector<uint32_t> scratch(balls.n);
  hsp::Patience endless;
  hsp::sort_by_depth(balls, frame, {keys.data(), balls.n}, {scratch.data(), balls.n}, endless);
  std::sort(expected.begin(), expected.end(),
            [&](uint32_t a, uint32_t b) { return comes_before(balls, frame.direction, a, b); });
  for (uint32_t k = 0; k < balls.n; ++k) {
    ASSERT_EQ(keys[k].ball, expected[k]) << "place " << k;
    ASSERT_EQ(keys[k].item, 1000 + expected[k]);
    for (uint32_t l = 0; l < balls.n && l < 40; ++l) {
      ASSERT_EQ(hsp::is_farther(balls, frame.direction, k, l), comes_before(balls, frame.direction, k, l));
    }
  }
}

hsp::ViewDirection towards(double x, double y, double z) {
  return {{x, y, z}, {0, 1, 0}};
}

TEST(DepthOrder, OfRandomSets) {
  oracle::RandomSource random(5);
  for (const int bits : {3, 20, 31, 50}) {
    for (int round = 0; round < 30; ++round) {
      Set set;
      const auto coordinate = [&] {
        return static_cast<int64_t>(random.next() >> (64 - bits)) - (int64_t{1} << (bits - 1));
      };
      for (int k = 0; k < 100; ++k) {
        set.add(coordinate(), coordinate(), coordinate(), static_cast<int64_t>(random.next() % 3));
      }
      expect_order(set, towards(0, 0, 1));
      expect_order(set, towards(1, -1, 1));
      expect_order(set, towards(0.3, -0.1 * round, 0.7));
    }
  }
}

// The largest coordinates and depths that differ by one unit, far below what doubles can tell.
TEST(DepthOrder, OfDepthsThatDifferByOneUnit) {
  Set set;
  const int64_t far = (int64_t{1} << 50) - 1;
  for (int64_t k = -20; k <= 20; ++k) {
    set.add(far - k, -far + k, k % 3, 1);
    set.add(-far + k, far - k, k % 3, 1);
    set.add(far, far - 3 * k, -far, 1);
  }
  expect_order(set, towards(1, 1, 1));
  expect_order(set, towards(1, 1, 0x1p-28));
  expect_order(set, towards(1 - 0x1p-27, 1, 0x1p-28));
}

// Far vectors a depth of one unit long: the products with the first two components are rounded differently, the third
// is exact, so that the sum in doubles has any sign. The last ball lies in the middle.
TEST(DepthOrder, OfDepthsThatRoundingWouldExchange) {
  constexpr int64_t modulus = int64_t{1} << 28;
  constexpr int64_t a = modulus - 3;
  constexpr int64_t b = modulus - 5;
  uint64_t inverse = 1;  // of b, modulo the modulus
  for (int k = 0; k < 6; ++k) inverse *= 2 - static_cast<uint64_t>(b) * inverse;
  oracle::RandomSource random(7);
  Set set;
  for (int k = 0; k < 40; ++k) {
    const int64_t depth = k % 2 == 0 ? 1 : -1;
    const int64_t x = (int64_t{1} << 47) + static_cast<int64_t>(random.next() >> 17);
    const int64_t remainder =
        static_cast<int64_t>(static_cast<uint64_t>(depth - a * (x % modulus)) * inverse % modulus);
    const int64_t y = remainder - ((int64_t{1} << 18) + static_cast<int64_t>(random.next() >> 46)) * modulus;
    const oracle::BigInteger rest =
        oracle::BigInteger(a) * oracle::BigInteger(x) + oracle::BigInteger(b) * oracle::BigInteger(y);
    const int64_t low = a * (x % modulus) + b * (y % modulus) - depth;
    const int64_t z = -(a * (x / modulus) + b * (y / modulus) + low / modulus);
    ASSERT_EQ((rest + oracle::BigInteger(modulus) * oracle::BigInteger(z) - oracle::BigInteger(depth)).sign(), 0);
    set.add(x, y, z, 1);
    set.add(-x, -y, -z, 1);
    set.add(k, k, -2 * k, 1);
  }
  set.add(0, 0, 0, 1);
  expect_order(set, towards(a * 0x1p-28, b * 0x1p-28, 1));
}

TEST(DepthOrder, EqualDepthsGoByPlaceRadiusAndIndex) {
  Set set;
  for (int k = 0; k < 60; ++k) set.add(k % 4, (k / 4) % 3, 7, k % 2);
  expect_order(set, towards(0, 0, 1));
  expect_order(set, towards(0, 0, -1));
}

}  // namespace
