#include "random_balls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace oracle {
namespace {

// Integer vectors of integer length: the ties that lattice balls with integer radii can have come from these.
constexpr std::array<std::array<int64_t, 4>, kinds_of_integer_length> integer_lengths = {{{0, 0, 1, 1},
                                                                                          {0, 3, 4, 5},
                                                                                          {1, 2, 2, 3},
                                                                                          {2, 3, 6, 7},
                                                                                          {1, 4, 8, 9},
                                                                                          {4, 4, 7, 9},
                                                                                          {2, 6, 9, 11},
                                                                                          {6, 6, 7, 11},
                                                                                          {0, 5, 12, 13}}};

}  // namespace

LatticeBall integer_length_vector(RandomSource &random, size_t kinds) {
  const auto &choice = integer_lengths[static_cast<size_t>(random.in(0, static_cast<int64_t>(kinds) - 1))];
  std::array<int64_t, 3> v = {choice[0], choice[1], choice[2]};
  for (size_t k = 2; k > 0; --k) std::swap(v[k], v[static_cast<size_t>(random.in(0, static_cast<int64_t>(k)))]);
  for (int64_t &component : v)
    if (random.one_in(2)) component = -component;
  return {v[0], v[1], v[2], choice[3]};
}

LatticeBall ball_in_box(RandomSource &random, int64_t half_side, int64_t least, int64_t largest) {
  const int64_t x = random.in(-half_side, half_side);
  const int64_t y = random.in(-half_side, half_side);
  const int64_t z = random.in(-half_side, half_side);
  return {x, y, z, random.in(least, largest)};
}

Balls balls_in_box(RandomSource &random, size_t n, int64_t half_side, int64_t least, int64_t largest) {
  Balls balls;
  while (balls.size() < n) balls.push_back(ball_in_box(random, half_side, least, largest));
  return balls;
}

std::vector<uint32_t> RandomSource::permutation(size_t n) {
  std::vector<uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  for (size_t k = n; k > 1; --k)
    std::swap(order[k - 1], order[static_cast<size_t>(in(0, static_cast<int64_t>(k) - 1))]);
  return order;
}

Balls permuted(const Balls &balls, const std::vector<uint32_t> &order) {
  Balls result;
  for (const uint32_t i : order) result.push_back(balls[i]);
  return result;
}

Balls loose_balls(RandomSource &random, size_t n) {
  // Six to eight balls of mean radius 70 in each cube of side 200.
  const auto half_side = static_cast<int64_t>(50 * std::cbrt(static_cast<double>(n)));
  return balls_in_box(random, n, half_side, 50, 90);
}

Balls dense_balls(RandomSource &random, size_t n) {
  return balls_in_box(random, n, 60, 60, 100);
}

Balls largest_balls(RandomSource &random, size_t n) {
  constexpr int64_t unit = (INT64_C(1) << 30) - 1;
  const int64_t away = random.one_in(2) ? 0 : (INT64_C(1) << 50) - 4 * unit;
  Balls balls;
  for (size_t i = 0; i < n; ++i) {
    const int64_t x = random.in(-2 * unit, 2 * unit), y = random.in(-2 * unit, 2 * unit);
    const int64_t z = random.in(-2 * unit, 2 * unit);
    balls.push_back({away + x, y - away, z, random.one_in(2) ? unit : random.in(0, unit)});
  }
  return balls;
}

Balls clustered_balls(RandomSource &random, size_t n) {
  Balls balls;
  LatticeBall group;
  int64_t size = 0;
  while (balls.size() < n) {
    if (balls.empty() || random.one_in(4)) {
      group = ball_in_box(random, 130, 0, 0);
      size = random.in(0, 2) == 0 ? 8 : 40;
    }
    const LatticeBall offset = ball_in_box(random, size, size / 3 + 1, size);
    balls.push_back({group.x + offset.x, group.y + offset.y, group.z + offset.z, offset.radius});
  }
  return balls;
}

Balls studded_ball(RandomSource &random, size_t studs, const LatticePoint &centre, int64_t large, int64_t least,
                   int64_t largest) {
  Balls balls = {ball_around(centre, large)};
  while (balls.size() <= studs) {
    const double z = static_cast<double>(random.in(-1000000, 1000000)) / 1000000, across = std::sqrt(1 - z * z);
    const double angle = static_cast<double>(random.in(0, 999999)) / 1000000 * 2 * std::numbers::pi;
    const auto on_sphere = [&](size_t axis, double unit) {
      return centre[axis] + std::llround(static_cast<double>(large) * unit);
    };
    balls.push_back(
        ball_around({on_sphere(0, across * std::cos(angle)), on_sphere(1, across * std::sin(angle)), on_sphere(2, z)},
                    random.in(least, largest)));
  }
  return balls;
}

Balls balls_of_near_planes(RandomSource &random, size_t n, int64_t radius, double height, double width) {
  Balls balls = {{0, 0, 0, radius}};
  const auto size = static_cast<double>(radius);
  const auto part = [&random] { return 2 * random.fraction() - 1; };
  while (balls.size() < n) {
    const double x = width * part(), y = width * part(), distance = size * (0.85 + 0.65 * part());
    const double along = distance / std::sqrt(1 + x * x + y * y);
    balls.push_back({std::llround(along * x), std::llround(along * y), std::llround(along),
                     std::llround(std::sqrt(size * size + distance * distance - 2 * size * height * along))});
  }
  return balls;
}

Balls belted_balls(RandomSource &random, size_t n) {
  constexpr double large = 100;
  Balls balls = {{0, 0, 0, static_cast<int64_t>(large)}};
  const int64_t axis = random.in(0, 2);
  const auto push = [&](double along, double across, double angle, int64_t radius) {
    const auto a = static_cast<int64_t>(std::floor(along));
    const auto b = static_cast<int64_t>(std::floor(across * std::cos(angle)));
    const auto c = static_cast<int64_t>(std::floor(across * std::sin(angle)));
    balls.push_back(axis == 0   ? LatticeBall{a, b, c, radius}
                    : axis == 1 ? LatticeBall{b, a, c, radius}
                                : LatticeBall{b, c, a, radius});
  };
  while (balls.size() < n) {
    const double latitude = static_cast<double>(random.in(-60, 60)) * std::numbers::pi / 180;
    const size_t members = static_cast<size_t>(random.in(5, 9));
    if (balls.size() + members <= n && !random.one_in(3)) {
      const double ring = large * std::cos(latitude);
      const double spacing = 2 * std::numbers::pi * ring / static_cast<double>(members);
      for (size_t k = 0; k < members; ++k)
        push(large * std::sin(latitude), ring,
             2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(members),
             static_cast<int64_t>(0.56 * spacing) + 1);
    } else {
      const double longitude = static_cast<double>(random.in(0, 359)) * std::numbers::pi / 180;
      const double bump = static_cast<double>(random.in(-80, 80)) * std::numbers::pi / 180;
      push(large * std::sin(bump), large * std::cos(bump), longitude, random.in(5, 14));
    }
  }
  return balls;
}

Balls grid_balls(RandomSource &random, size_t n) {
  constexpr std::array<int64_t, 6> sides = {1, 2, 2, 3, 4, 20};
  const int64_t side = sides[static_cast<size_t>(random.in(0, 5))];
  const int64_t least = random.in(0, 1);
  const int64_t largest = std::max<int64_t>(2, 2 * side / 3);
  Balls balls;
  while (balls.size() < n) {
    const int64_t x = random.in(0, side);
    const int64_t y = random.in(0, side);
    const int64_t z = random.in(0, side);
    balls.push_back({x, y, z, random.in(least, largest)});
  }
  return balls;
}

Balls coplanar_balls(RandomSource &random, size_t n) {
  Balls balls = grid_balls(random, n);
  const bool slanted = random.one_in(2);
  for (LatticeBall &ball : balls) ball.z = slanted ? ball.x + ball.y : 0;
  return balls;
}

Balls collinear_balls(RandomSource &random, size_t n) {
  Balls balls = grid_balls(random, n);
  const bool slanted = random.one_in(2);  // along (1, 2, 2), of length 3: tangencies occur
  for (LatticeBall &ball : balls) {
    ball.y = slanted ? 2 * ball.x : 0;
    ball.z = ball.y;
  }
  return balls;
}

Balls balls_through_point(RandomSource &random, size_t n) {
  const LatticeBall point = ball_in_box(random, 3, 0, 0);
  const int64_t scale = random.in(1, 2);
  Balls balls;
  while (balls.size() < n) {
    const LatticeBall v = integer_length_vector(random, 6);
    balls.push_back({point.x + scale * v.x, point.y + scale * v.y, point.z + scale * v.z, scale * v.radius});
  }
  return balls;
}

Balls balls_through_circle(RandomSource &random, size_t n) {
  // Centres h above the circle of radius 12, h^2 + 12^2 a square.
  constexpr std::array<std::array<int64_t, 2>, 5> heights = {{{0, 12}, {5, 13}, {9, 15}, {16, 20}, {35, 37}}};
  const int64_t axis = random.in(0, 2);
  Balls balls;
  while (balls.size() < n) {
    const auto &[height, radius] = heights[static_cast<size_t>(random.in(0, 4))];
    const int64_t h = random.one_in(2) ? height : -height;
    LatticeBall ball = {axis == 0 ? h : 0, axis == 1 ? h : 0, axis == 2 ? h : 0, radius};
    if (random.one_in(5)) ball = ball_in_box(random, 20, 3, 14);
    balls.push_back(ball);
  }
  return balls;
}

Balls balls_around_circle(RandomSource &random, size_t n) {
  // Of the 36 points with x^2 + y^2 = 5^2 13^2 17, in a plane across any axis.
  constexpr int64_t squared = 71825;
  std::vector<std::array<int64_t, 2>> points;
  for (int64_t x = -267; x <= 267; ++x) {
    for (int64_t y = -267; y <= 267; ++y) {
      if (x * x + y * y == squared) points.push_back({x, y});
    }
  }
  const int64_t axis = random.in(0, 2), radius = random.in(100, 900), height = random.in(-9, 9);
  const int64_t other = random.in(3, 12);
  Balls balls;
  while (balls.size() < n) {
    const auto &[x, y] = points[static_cast<size_t>(random.in(0, static_cast<int64_t>(points.size()) - 1))];
    LatticeBall ball = {x, y, height, radius};
    if (random.one_in(other)) {
      ball.radius += random.in(-50, 9);
      if (random.one_in(2)) ball = ball_in_box(random, 300, 1, 600);
    }
    for (int64_t turn = 0; turn < axis; ++turn) ball = {ball.y, ball.z, ball.x, ball.radius};
    balls.push_back(ball);
  }
  return balls;
}

Balls balls_around_sphere(RandomSource &random, size_t n) {
  // Of the points with x^2 + y^2 + z^2 = 21^2, of which many lie on common circles.
  constexpr int64_t squared = 441;
  std::vector<LatticeBall> points;
  for (int64_t x = -21; x <= 21; ++x) {
    for (int64_t y = -21; y <= 21; ++y) {
      for (int64_t z = -21; z <= 21; ++z) {
        if (x * x + y * y + z * z == squared) points.push_back({x, y, z, 0});
      }
    }
  }
  const int64_t radius = random.one_in(4) ? 21 : random.in(12, 40);
  Balls balls;
  while (balls.size() < n) {
    LatticeBall ball = points[static_cast<size_t>(random.in(0, static_cast<int64_t>(points.size()) - 1))];
    ball.radius = radius;
    balls.push_back(ball);
  }
  return balls;
}

Balls tangent_balls(RandomSource &random, size_t n) {
  Balls balls = {{0, 0, 0, random.in(1, 6)}};
  while (balls.size() < n) {
    const LatticeBall &other = balls[static_cast<size_t>(random.in(0, static_cast<int64_t>(balls.size()) - 1))];
    const LatticeBall v = integer_length_vector(random);
    const int64_t radius = random.one_in(3) ? other.radius + v.radius : std::abs(v.radius - other.radius);
    const LatticeBall ball = {other.x + v.x, other.y + v.y, other.z + v.z, radius};
    if (std::max({std::abs(ball.x), std::abs(ball.y), std::abs(ball.z)}) <= 45 && radius <= 45) balls.push_back(ball);
  }
  return balls;
}

Balls lattice_balls(RandomSource &random, size_t n) {
  // Boxes of 4 x 6 x 12 have a half diagonal of 7; the other radii touch neighbours in one direction each.
  constexpr std::array<int64_t, 5> radii = {2, 3, 5, 6, 7};
  const bool all_equal = random.one_in(2);
  const int64_t common = radii[static_cast<size_t>(random.in(0, 4))];
  Balls balls;
  while (balls.size() < n) {
    const int64_t i = random.in(0, 2);
    const int64_t j = random.in(0, 2);
    const int64_t k = random.in(0, 1);
    balls.push_back({4 * i, 6 * j, 12 * k, all_equal ? common : radii[static_cast<size_t>(random.in(0, 4))]});
  }
  return balls;
}

Balls repeated_balls(RandomSource &random, size_t n) {
  Balls balls;
  while (balls.size() < n) {
    if (balls.empty() || random.one_in(2)) {
      balls.push_back(ball_in_box(random, 4, 1, 5));
      continue;
    }
    LatticeBall ball = balls[static_cast<size_t>(random.in(0, static_cast<int64_t>(balls.size()) - 1))];
    if (random.one_in(2)) ball.radius = random.in(0, ball.radius);
    if (random.one_in(4)) ball.x += 1;
    balls.push_back(ball);
  }
  return balls;
}

Balls crowned_balls(RandomSource &random, size_t n) {
  // Circles of latitude on the sphere of radius 25 that hold 4, 12 or 20 integer points.
  constexpr std::array<int64_t, 5> latitudes = {0, 7, 15, 20, 24};
  constexpr std::array<int64_t, 5> central_radii = {15, 20, 24, 25, 26};
  const int64_t axis = random.in(0, 2);
  Balls balls = {{0, 0, 0, central_radii[static_cast<size_t>(random.in(0, 4))]}};
  const auto push = [&](int64_t along, int64_t b, int64_t c, int64_t radius) {
    if (balls.size() < n)
      balls.push_back(axis == 0   ? LatticeBall{along, b, c, radius}
                      : axis == 1 ? LatticeBall{b, along, c, radius}
                                  : LatticeBall{b, c, along, radius});
  };
  while (balls.size() < n) {
    const int64_t sign = random.one_in(2) ? 1 : -1;
    if (random.one_in(3)) {
      push(sign * random.in(20, 25), 0, 0, random.in(1, 7));  // a bump at a pole
      continue;
    }
    const int64_t latitude = sign * latitudes[static_cast<size_t>(random.in(0, 4))];
    const int64_t radius = random.in(3, 9);
    for (int64_t b = -25; b <= 25; ++b)
      for (int64_t c = -25; c <= 25; ++c)
        if (b * b + c * c + latitude * latitude == 625) push(latitude, b, c, radius);
  }
  return balls;
}

Balls colliding_balls(RandomSource &random, size_t n) {
  const LatticePoint &step = colliding_steps[static_cast<size_t>(random.in(0, 1))];
  const int64_t radius = random.in(1, 30);
  const int64_t side = 2 * radius;
  const int64_t most = random.in(1, 4);
  Balls balls;
  for (int64_t group = 0; balls.size() < n; ++group) {
    const LatticePoint corner = {4 * side * group * step[0], 4 * side * group * step[1], 4 * side * group * step[2]};
    for (int64_t k = random.in(1, most); k > 0 && balls.size() < n; --k) {
      const bool nearby = random.one_in(2);
      const auto place = [&] { return !nearby ? random.in(0, side - 1) : random.in(-side, 2 * side); };
      const int64_t x = place(), y = place(), z = place();
      balls.push_back({corner[0] + x, corner[1] + y, corner[2] + z, balls.empty() ? radius : random.in(1, radius)});
    }
  }
  return permuted(balls, random.permutation(n));
}

Balls degenerate_balls(RandomSource &random, size_t n) {
  using Maker = Balls (*)(RandomSource &, size_t);
  constexpr std::array<Maker, 8> makers = {grid_balls,           coplanar_balls, collinear_balls, balls_through_point,
                                           balls_through_circle, tangent_balls,  lattice_balls,   repeated_balls};
  const auto make = [&](size_t count) {
    return makers[static_cast<size_t>(random.in(0, 9)) % makers.size()](random, count);
  };
  if (n < 4 || !random.one_in(4)) return make(n);
  Balls balls = make(n / 2);
  const Balls more = make(n - n / 2);
  balls.insert(balls.end(), more.begin(), more.end());
  return balls;
}

Balls any_balls(RandomSource &random, size_t n) {
  switch (random.in(0, 7)) {
    case 0:
      return loose_balls(random, n);
    case 1:
      return dense_balls(random, n);
    case 2:
      return clustered_balls(random, n);
    case 3:
      return belted_balls(random, n);
    default:
      return degenerate_balls(random, n);
  }
}

}  // namespace oracle
