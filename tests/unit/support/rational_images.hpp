// Whether a ball moved by a rational pose meets another ball: by products of quaternions, in integers of any size.
#pragma once

#include <array>
#include <cstdint>

#include "big_integer.hpp"
#include "lattice_ball.hpp"
#include "random_balls.hpp"

struct RationalNumbers {
  std::array<int32_t, 4> quaternion{1, 0, 0, 0};
  std::array<int64_t, 3> shift{};
};

// The sign of distance - (r + s) of a fixed ball (centre c, radius r) and a moved one (centre p before the move, radius
// s), as the sign of |N (c - t) - q p q*|^2 - N^2 (r + s)^2 with the quaternion q, N = |q|^2 and the shift t.
inline int exact_relation(const oracle::LatticeBall &fixed, const oracle::LatticeBall &moving,
                          const RationalNumbers &pose) {
  using oracle::BigInteger;
  using Quaternion = std::array<BigInteger, 4>;
  const auto big = [](oracle::Int128 value) { return BigInteger(value); };
  const auto times = [](const Quaternion &a, const Quaternion &b) {
    return Quaternion{
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
  };
  const auto &n = pose.quaternion;
  const Quaternion q{big(n[0]), big(n[1]), big(n[2]), big(n[3])}, conjugate{q[0], -q[1], -q[2], -q[3]};
  const Quaternion turned = times(times(q, {big(0), big(moving.x), big(moving.y), big(moving.z)}), conjugate);
  const BigInteger scale = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  const std::array<int64_t, 3> centre{fixed.x, fixed.y, fixed.z};
  BigInteger square;
  for (size_t k = 0; k < 3; ++k) {
    const BigInteger component = scale * big(oracle::Int128{centre[k]} - pose.shift[k]) - turned[k + 1];
    square = square + component * component;
  }
  const BigInteger within = scale * big(oracle::Int128{fixed.radius} + moving.radius);
  return (square - within * within).sign();
}

// Quaternions of any length, and those that map the axes onto each other, or turn about one by an angle whose sine and
// cosine are fractions: lattice points come to lie on lattice points.
inline RationalNumbers random_rational(oracle::RandomSource &random, int64_t largest_shift) {
  RationalNumbers pose;
  const int64_t kind = random.in(0, 4);
  const int64_t most = kind == 4 ? INT32_MAX : kind == 3 ? 1000 : kind == 2 ? 3 : 1;
  for (int32_t &component : pose.quaternion) component = static_cast<int32_t>(random.in(-most, most));
  if (kind == 4 && random.one_in(8)) pose.quaternion[0] = INT32_MIN;
  if (kind == 0 || pose.quaternion == std::array<int32_t, 4>{}) pose.quaternion = {1, 0, 0, 0};
  for (int64_t &component : pose.shift) component = random.in(-largest_shift, largest_shift);
  return pose;
}
