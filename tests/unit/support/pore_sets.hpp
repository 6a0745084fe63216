// Sets of balls for pores: in general position of several kinds, and full of ties.
#pragma once

#include <algorithm>
#include <cmath>

#include "random_balls.hpp"

namespace pore_sets {

inline constexpr int general_kinds = 6;

// 0 overlapping, 1 apart, 2 very unequal, 3 nearly equal, 4 a shell, 5 flat.
inline oracle::Balls general_set(oracle::RandomSource &random, size_t n, int kind) {
  const int64_t unit = 100000000;
  const auto side = static_cast<int64_t>(std::cbrt(static_cast<double>(n)) * static_cast<double>(unit));
  const int64_t half = kind == 1 ? side * 5 / 4 : side * 7 / 10;
  oracle::Balls balls = oracle::balls_in_box(random, n, half, unit / 2, unit);
  for (auto &ball : balls) {
    if (kind == 2) ball.radius >>= random.in(0, 5);
    if (kind == 3) ball.radius = unit * 7 / 10 + random.in(0, 10000);
    if (kind == 4) {
      const double length = std::max(
          1.0, std::hypot(static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)));
      const double scale = static_cast<double>(random.in(2 * unit, 23 * unit / 10)) / length;
      for (int64_t *value : {&ball.x, &ball.y, &ball.z})
        *value = static_cast<int64_t>(scale * static_cast<double>(*value));
    }
    if (kind == 5) ball.z /= 50;
  }
  return balls;
}

inline constexpr int tied_kinds = 5;

// 0 a lattice, 1 one plane of it, 2 one line, 3 a lattice that is shaken by a step, 4 any of the oracles' degenerate
// sets.
inline oracle::Balls tied_set(oracle::RandomSource &random, size_t n, int kind) {
  if (kind == 4) {
    oracle::Balls balls = oracle::degenerate_balls(random, n);
    int64_t largest = 1;
    for (const auto &ball : balls) {
      largest = std::max({largest, std::abs(ball.x), std::abs(ball.y), std::abs(ball.z), ball.radius});
    }
    const int64_t scale = std::max(INT64_C(1), 100000000 / largest);  // so that levels are many steps apart
    for (auto &ball : balls) ball = {ball.x * scale, ball.y * scale, ball.z * scale, ball.radius * scale};
    return balls;
  }
  const int64_t unit = 100000000, shake = kind == 3 ? 1 : 0;
  oracle::Balls balls;
  for (size_t k = 0; k < n; ++k) {
    const auto place = [&](bool free) {
      return free ? random.in(0, kind == 2 ? 6 : 3) * unit + random.in(-shake, shake) : 0;
    };
    balls.push_back(
        {place(true), place(kind != 2), place(kind == 0 || kind == 3), unit / 2 + random.in(0, 2) * unit / 4});
  }
  return balls;
}

// Balls at all integer points with x^2 + y^2 + z^2 = square, times step: all tie in the middle, at the level
// sqrt(square) step - radius. There are 72 for 26, and 168 for 101.
inline oracle::Balls shell(int64_t step, int64_t radius, int64_t square = 26) {
  oracle::Balls balls;
  const auto most = static_cast<int64_t>(std::sqrt(static_cast<double>(square)));
  for (int64_t x = -most; x <= most; ++x) {
    for (int64_t y = -most; y <= most; ++y) {
      for (int64_t z = -most; z <= most; ++z) {
        if (x * x + y * y + z * z == square) balls.push_back({step * x, step * y, step * z, radius});
      }
    }
  }
  return balls;
}

// Part of a shell, each ball moved by up to so many steps along each axis. Kinds: 0 any balls, 1 those on one side of
// the middle or level with it, 2 those in one plane with the middle and few others.
inline constexpr int shell_kinds = 3;
inline oracle::Balls part_of_shell(oracle::RandomSource &random, int kind, size_t most, int64_t square, int64_t shake) {
  const int64_t unit = 100000000;
  oracle::Balls balls, all = shell(unit, unit / 3, square);
  for (size_t k = all.size(); k > 1; --k) {
    std::swap(all[k - 1], all[static_cast<size_t>(random.in(0, static_cast<int64_t>(k) - 1))]);
  }
  for (auto ball : all) {
    if (balls.size() == most || (kind == 1 && ball.z < 0) || (kind == 2 && ball.z != 0 && !random.one_in(8))) continue;
    for (int64_t *value : {&ball.x, &ball.y, &ball.z}) *value += random.in(-shake, shake);
    balls.push_back(ball);
  }
  return balls;
}

// Corners of regular bodies, turned and rounded to a lattice of `radius` steps: 0 cube, 1 icosahedron, 2 dodecahedron,
// 3 cuboctahedron, 4 rhombic dodecahedron, 5 truncated icosahedron.
inline constexpr int cage_kinds = 6;
inline oracle::Balls cage(oracle::RandomSource &random, int kind, double unit) {
  using Point = std::array<double, 3>;
  const double p = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Point> corners;
  const auto add = [&](double a, double b, double c) {
    for (int signs = 0; signs < 8; ++signs) {
      const double u = (signs & 1) != 0 ? -a : a, v = (signs & 2) != 0 ? -b : b, w = (signs & 4) != 0 ? -c : c;
      for (const Point &corner : {Point{u, v, w}, Point{v, w, u}, Point{w, u, v}}) {
        bool known = false;
        for (const Point &other : corners) {
          known = known || std::hypot(other[0] - corner[0], other[1] - corner[1], other[2] - corner[2]) < 1e-9;
        }
        if (!known) corners.push_back(corner);
      }
    }
  };
  if (kind == 1) add(0, 1, p);
  if (kind == 3) add(0, 1, 1);
  if (kind == 0 || kind == 2 || kind == 4) add(1, 1, 1);
  if (kind == 2) add(0, p, 1 / p);
  if (kind == 4) add(0, 0, 2);
  if (kind == 5) {
    add(0, 1, 3 * p);
    add(1, 2 + p, 2 * p);
    add(p, 2, 2 * p + 1);
  }
  const auto unit_vector = [&] { return static_cast<double>(random.in(-1000000, 1000000)) / 1e6; };
  Point a{unit_vector(), unit_vector(), unit_vector() + 1e-3}, b{unit_vector(), unit_vector(), unit_vector()}, c{};
  const auto cross = [](const Point &u, const Point &v) {
    return Point{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const auto normalise = [](Point &v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double &x : v) x /= length;
  };
  normalise(a);
  c = cross(a, b);
  normalise(c);
  b = cross(c, a);
  const auto radius = static_cast<int64_t>(unit * (0.2 + 0.1 * static_cast<double>(random.in(0, 7))));
  oracle::Balls balls;
  for (const Point &y : corners) {
    const auto at = [&](size_t k) { return std::llround(unit * (y[0] * a[k] + y[1] * b[k] + y[2] * c[k])); };
    balls.push_back({at(0), at(1), at(2), radius});
  }
  return balls;
}

// Balls on a circle of radius 2.5 units, rounded to so many decimals of a unit. Kinds: 0 the ring alone, 1 with a small
// ball in the middle, 2 with a ball on the axis at the ring's distance from the middle, 3 with two such balls, 4 with
// every other ball of the ring higher, 5 with another ring above, 6 with that ring turned by half the angle between
// neighbours, 7 the ring turned out of the plane of two axes, 8 with another ring beside.
inline constexpr int ring_kinds = 9;
inline oracle::Balls ring_set(int kind, size_t n, int decimals) {
  const double unit = 1e8, size = 2.5, pi = std::acos(-1.0);
  double grain = unit;
  for (int k = 0; k < decimals; ++k) grain /= 10.0;
  oracle::Balls balls;
  const auto add = [&](double x, double y, double z, double radius) {
    const auto rounded = [&](double length) { return static_cast<int64_t>(grain * std::round(length * unit / grain)); };
    balls.push_back({rounded(x), rounded(y), rounded(z), rounded(radius)});
  };
  const size_t rings = kind == 5 || kind == 6 || kind == 8 ? 2 : 1;
  for (size_t ring = 0; ring < rings; ++ring) {
    for (size_t k = 0; k < n; ++k) {
      const double turn = static_cast<double>(k) + (kind == 6 && ring == 1 ? 0.5 : 0.0);
      const double angle = 2.0 * pi * turn / static_cast<double>(n), x = size * std::cos(angle),
                   y = size * std::sin(angle);
      const double other = static_cast<double>(ring);
      if (kind == 4) add(x, y, k % 2 == 0 ? 0.2 : -0.2, 0.7);
      if (kind == 7) add(0.96 * x - 0.28 * 0.6 * y, 0.8 * y, 0.28 * x + 0.96 * 0.6 * y, 0.7);
      if (kind == 8) add(x + 2.0 * size * other, y, 0.0, 0.7);
      if (kind != 4 && kind < 7) add(x, y, kind < 5 ? 0.0 : other, 0.7);
    }
  }
  if (kind == 1) add(0.0, 0.0, 0.0, 0.3);
  if (kind == 2 || kind == 3) add(0.0, 0.0, size, 0.7);
  if (kind == 3) add(0.0, 0.0, -size, 0.7);
  return balls;
}

// Balls of one radius at all lattice points of a circle around 0 in one plane, whose radius is the integer `root`.
// `poles` more balls, one or two, are at the same distance from 0 on the axis. There are 36 points on the circle of
// radius 65, and 108 on that of radius 1105.
inline oracle::Balls exact_circle(int64_t root, int64_t step, int64_t radius, int poles) {
  oracle::Balls balls;
  for (int64_t x = -root; x <= root; ++x) {
    for (int64_t y = -root; y <= root; ++y) {
      if (x * x + y * y == root * root) balls.push_back({step * x, step * y, 0, radius});
    }
  }
  if (poles > 0) balls.push_back({0, 0, step * root, radius});
  if (poles > 1) balls.push_back({0, 0, -step * root, radius});
  return balls;
}

}  // namespace pore_sets
