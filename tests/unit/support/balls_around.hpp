// A large ball with small balls around it, most of which cross the large sphere: many half-edges on one ball.
#pragma once

#include <cmath>

#include "random_balls.hpp"

inline oracle::Balls balls_around(oracle::RandomSource &random, size_t n, int64_t least, int64_t largest) {
  constexpr int64_t radius = 1000;
  oracle::Balls balls{{0, 0, 0, radius}};
  for (const oracle::LatticeBall &ball : oracle::balls_in_box(random, n, radius, least, largest)) {
    const double squared = static_cast<double>(ball.x * ball.x + ball.y * ball.y + ball.z * ball.z + 1);
    const double scale = static_cast<double>(radius) / std::sqrt(squared);
    const auto scaled = [scale](int64_t x) { return static_cast<int64_t>(static_cast<double>(x) * scale); };
    balls.push_back({scaled(ball.x), scaled(ball.y), scaled(ball.z), ball.radius});
  }
  return balls;
}
