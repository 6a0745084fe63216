// The first ball above a point against a look at every ball.
#include "model/vertical_ray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "big_integer.hpp"
#include "grids_of_sets.hpp"
#include "root_sums.hpp"

namespace {

using oracle::Balls;
using oracle::BigInteger;
using oracle::LatticeBall;

struct Point {
  int64_t x, y, z;
};

// The power of a vertical line with respect to a ball, without overflow: r^2 - distance^2, or less than 0.
int64_t line_power(const LatticeBall &ball, const Point &point) {
  const oracle::Int128 dx = oracle::Int128{ball.x} - point.x;
  const oracle::Int128 dy = oracle::Int128{ball.y} - point.y;
  const oracle::Int128 power = oracle::Int128{ball.radius} * ball.radius - dx * dx - dy * dy;
  return power < 0 ? -1 : static_cast<int64_t>(power);
}
bool contains(const LatticeBall &ball, const Point &point) {
  const oracle::Int128 dx = oracle::Int128{ball.x} - point.x;
  const oracle::Int128 dy = oracle::Int128{ball.y} - point.y;
  const oracle::Int128 dz = oracle::Int128{ball.z} - point.z;
  return dx * dx + dy * dy + dz * dz <= oracle::Int128{ball.radius} * ball.radius;
}

// Sign of z + sqrt(b) - sqrt(a).
int sign_of_roots(const BigInteger &z, const BigInteger &b, const BigInteger &a) {
  if (z.sign() < 0) return -sign_of_roots(-z, a, b);
  const BigInteger rest = z * z + b - a;
  const BigInteger mixed = BigInteger(4) * z * z * b;  // the square of what is missing
  if (rest.sign() >= 0) return rest.sign() + mixed.sign() > 0 ? 1 : 0;
  return (mixed - rest * rest).sign();
}

// Whether ball a is entered before ball b, in one point as given, if both really grow by tiny amounts, as in
// exact/PROOFS.md, section 3: in proportion by 2^-400, and so on by powers of that.
bool grows_to_be_first(const Balls &balls, uint32_t a, uint32_t b, const Point &point) {
  constexpr unsigned step = 400, places = 4 * step;
  const std::vector<uint32_t> rank = oracle::tie_ranks(balls);
  const auto power = [&](uint32_t k, bool lower) {
    const LatticeBall &ball = balls[k];
    const oracle::Int128 x = ball.x - point.x, y = ball.y - point.y, z = ball.z - point.z, r = ball.radius;
    const oracle::Int128 form = 1009 * x * x + 757 * x * y + 499 * x * z + 331 * y * y + 211 * y * z + 113 * z * z;
    BigInteger sum = BigInteger(line_power(ball, point)).times_power_of_two(2 * places);
    const auto grow = [&](const oracle::Int128 &amount, unsigned level) {
      sum = sum + BigInteger(amount).times_power_of_two(2 * places - step * level);
    };
    grow(r * r, 1);
    grow(1, 3);
    grow(x, 4);
    grow(y, 5);
    grow(z, 6);
    grow(form, 7);
    grow(lower ? 1 : 0, 8);
    return sum;
  };
  const bool a_lower = rank[a] < rank[b];
  const BigInteger z = BigInteger(balls[a].z - balls[b].z).times_power_of_two(places);
  return sign_of_roots(z, power(b, !a_lower), power(a, a_lower)) < 0;
}

// By the definition: of all balls that the line meets above the point, the one that is entered lowest, and of several
// in one place the one that is if they grow.
std::optional<uint32_t> first_above(const Balls &balls, const Point &point) {
  std::optional<uint32_t> first;
  for (uint32_t j = 0; j < balls.size(); ++j) {
    const int64_t power = line_power(balls[j], point);
    if (power < 0 || balls[j].z <= point.z) continue;
    if (first) {
      const int order = sign_of_root_difference(balls[j].z - balls[*first].z, line_power(balls[*first], point), power);
      if (order > 0 || (order == 0 && !grows_to_be_first(balls, j, *first, point))) continue;
    }
    first = j;
  }
  return first;
}

struct Seen {
  int nothing = 0, something = 0, tied = 0;
};

bool is_tied(const Balls &balls, const Point &point, uint32_t first) {
  for (uint32_t j = 0; j < balls.size(); ++j) {
    const int64_t power = line_power(balls[j], point);
    if (j == first || power < 0 || balls[j].z <= point.z) continue;
    if (sign_of_root_difference(balls[j].z - balls[first].z, line_power(balls[first], point), power) == 0) return true;
  }
  return false;
}

// Nothing is asked of points in a ball.
void check(const Balls &balls, const BuiltGrid &built, const Point &point, Seen &seen) {
  ASSERT_EQ(built.status(), hsp::Status::ok);
  if (std::any_of(balls.begin(), balls.end(), [&](const LatticeBall &ball) { return contains(ball, point); })) return;
  int64_t highest = balls[0].z;
  for (const LatticeBall &ball : balls) highest = std::max(highest, ball.z);
  const uint32_t found = hsp::first_ball_above(built.grid(), {point.x, point.y, point.z}, highest);
  const std::optional<uint32_t> expected = first_above(balls, point);
  if (!expected) {
    ASSERT_EQ(found, hsp::no_id) << oracle::to_text(balls);
    ++seen.nothing;
    return;
  }
  ASSERT_NE(found, hsp::no_id) << point.x << ' ' << point.y << ' ' << point.z << ": " << oracle::to_text(balls);
  ASSERT_EQ(built.grid().balls().caller[found], *expected)
      << point.x << ' ' << point.y << ' ' << point.z << ": " << oracle::to_text(balls);
  ++seen.something;
  if (is_tied(balls, point, *expected)) ++seen.tied;
}

Point point_near(oracle::RandomSource &random, const Balls &balls) {
  const LatticeBall &ball = balls[static_cast<std::size_t>(random.in(0, static_cast<std::int64_t>(balls.size()) - 1))];
  const int64_t reach = ball.radius + 1;
  // Through the centre, at the rim, and anywhere.
  switch (random.in(0, 3)) {
    case 0:
      return {ball.x, ball.y, ball.z - random.in(0, 8 * reach)};
    case 1:
      return {ball.x + (random.one_in(2) ? ball.radius : -ball.radius), ball.y, ball.z - random.in(0, 8 * reach)};
    case 2:
      return {ball.x, ball.y + (random.one_in(2) ? ball.radius : -ball.radius), ball.z - random.in(-2, 8) * reach};
    default:
      return {ball.x + random.in(-reach, reach), ball.y + random.in(-reach, reach), ball.z - random.in(-2, 8) * reach};
  }
}

void check_sets(uint64_t seed, int sets, Balls (*make)(oracle::RandomSource &, std::size_t), std::size_t most,
                Seen &seen) {
  for_random_sets(seed, sets, make, most,
                  [&](const Balls &balls, const BuiltGrid &built, oracle::RandomSource &random) {
                    for (int asked = 0; asked < 20; ++asked) check(balls, built, point_near(random, balls), seen);
                  });
}

TEST(FirstBallAbove, InSetsOfAllKinds) {
  Seen seen;
  check_sets(1, 150, oracle::any_balls, 40, seen);
  check_sets(2, 150, oracle::degenerate_balls, 20, seen);
  check_sets(3, 100, oracle::loose_balls, 100, seen);
  EXPECT_GT(seen.nothing, 500);
  EXPECT_GT(seen.something, 2000);
  EXPECT_GT(seen.tied, 100);
}

// Centres of one height in one cube, or a whole column of balls in cubes above each other.
TEST(FirstBallAbove, InColumns) {
  Seen seen;
  oracle::RandomSource random(4);
  for (int k = 0; k < 200; ++k) {
    Balls balls;
    const std::int64_t n = random.in(1, 30);
    for (std::int64_t j = 0; j < n; ++j) {
      balls.push_back({random.in(-3, 3), random.in(-3, 3), random.in(0, 400), random.in(0, 6)});
    }
    const BuiltGrid built(oracle::in_lengths(balls, 1));
    for (int asked = 0; asked < 20; ++asked) {
      check(balls, built, {random.in(-8, 8), random.in(-8, 8), random.in(-100, 420)}, seen);
    }
  }
  EXPECT_GT(seen.nothing, 200);
  EXPECT_GT(seen.something, 1000);
}

TEST(FirstBallAbove, BreaksTiesAsBallsGrow) {
  Seen seen;
  for_balls_entered_in_one_point(100, [&](int, const Balls &balls, const BuiltGrid &built, int64_t z) {
    check(balls, built, {0, 0, z}, seen);
  });
  EXPECT_EQ(seen.nothing, 0);
  EXPECT_EQ(seen.tied, 500);
}

// The ends of the lattice, where squares of differences leave 64 bits and a column has far more layers than cubes.
TEST(FirstBallAbove, AtTheEndsOfTheLattice) {
  constexpr int64_t far = int64_t{1} << 50;
  constexpr int64_t largest = (int64_t{1} << 30) - 1;
  Seen seen;
  for (const int64_t radius : {int64_t{0}, int64_t{1}, int64_t{1000}, largest}) {
    for (const int64_t x : {-far, int64_t{0}, far}) {
      for (const int64_t y : {-far, int64_t{0}, far}) {
        const Balls balls = {{x, y, far, radius},
                             {x, y, -far, radius},
                             {x, y, 0, radius},
                             {-x, y, far, radius / 2},
                             {x, -y, far / 2, radius / 3}};
        const BuiltGrid built(oracle::in_lengths(balls, 1));
        for (const int64_t dx : {-radius - 1, -radius, int64_t{0}, radius, radius + 1}) {
          for (const int64_t z : {-far, -far + radius, -far + radius + 1, -radius - 1, radius, radius + 1,
                                  far - radius - 1, far + radius, far + radius + 1}) {
            check(balls, built, {x + dx, y, z}, seen);
            check(balls, built, {x, y + dx, z}, seen);
          }
        }
      }
    }
  }
  EXPECT_GT(seen.nothing, 500);
  EXPECT_GT(seen.something, 1000);
}

// As many layers as cubes, one more and one less: both ways to look must give one answer.
TEST(FirstBallAbove, WithAsManyLayersAsCubes) {
  Seen seen;
  for (int64_t cubes = 1; cubes <= 6; ++cubes) {
    for (int64_t gap = 0; gap <= 3; ++gap) {
      Balls balls;
      for (int64_t k = 0; k < cubes; ++k) balls.push_back({4, 4, 20 * k + 10, 10});
      balls.push_back({4, 4, 20 * (cubes - 1 + gap) + 10, 3});
      const BuiltGrid built(oracle::in_lengths(balls, 1));
      for (int64_t z = -40; z <= 20 * (cubes + gap) + 10; z += 5) {
        for (const int64_t x : {4, 13, 14, 15}) check(balls, built, {x, 4, z}, seen);
      }
    }
  }
  EXPECT_GT(seen.nothing, 50);
  EXPECT_GT(seen.something, 200);
}

}  // namespace
