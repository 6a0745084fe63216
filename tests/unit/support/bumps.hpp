// Small balls all over a large one.
#pragma once

#include <cmath>
#include <numbers>

#include "random_balls.hpp"

// Radii grow geometrically from `least` to `most`, as parts of the large ball's radius.
inline oracle::Balls bumps(oracle::RandomSource &random, uint32_t n, double least, double most) {
  oracle::Balls balls = {{0, 0, 0, 1000000}};
  while (balls.size() < n) {
    const double z = static_cast<double>(random.in(-1000000, 1000000)) / 1e6;
    const double angle = static_cast<double>(random.in(0, 1000000)) / 1e6 * 2 * std::numbers::pi;
    const double across = std::sqrt(1 - z * z);
    const double radius = least * std::pow(most / least, static_cast<double>(random.in(0, 1000)) / 1000);
    balls.push_back({std::llround(1e6 * across * std::cos(angle)), std::llround(1e6 * across * std::sin(angle)),
                     std::llround(1e6 * z), std::llround(1e6 * radius)});
  }
  return balls;
}
