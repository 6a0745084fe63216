#include "exact_depth.hpp"

#include <algorithm>
#include <cmath>

std::array<int64_t, 3> integer_direction(const Direction &towards) {
  const double largest = std::max({std::abs(towards[0]), std::abs(towards[1]), std::abs(towards[2])});
  if (largest == 0) return {0, 0, 1};
  std::array<int64_t, 3> result{};
  for (size_t k = 0; k < 3; ++k)
    result[k] = std::llround(static_cast<long double>(towards[k]) / static_cast<long double>(largest) * 0x1p28L);
  return result;
}

bool is_farther(const oracle::LatticeBall &a, const oracle::LatticeBall &b, const std::array<int64_t, 3> &direction) {
  using oracle::BigInteger;
  const auto times = [](int64_t coordinate, int64_t component) {
    return BigInteger(coordinate) * BigInteger(component);
  };
  const BigInteger depth_a = times(a.x, direction[0]) + times(a.y, direction[1]) + times(a.z, direction[2]);
  const BigInteger depth_b = times(b.x, direction[0]) + times(b.y, direction[1]) + times(b.z, direction[2]);
  const int sign = (depth_a - depth_b).sign();
  return sign != 0 ? sign < 0 : a < b;
}
