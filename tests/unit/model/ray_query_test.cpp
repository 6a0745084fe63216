// The first ball on a ray against a look at every ball, in integers.
#include "model/ray_query.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brute_queries.hpp"
#include "grids_of_sets.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using oracle::LatticePoint;

struct Seen {
  int nothing = 0, something = 0, inside = 0, tied = 0;
};

std::array<double, 3> in_doubles(const LatticePoint &point) {
  return {static_cast<double>(point[0]), static_cast<double>(point[1]), static_cast<double>(point[2])};
}

// How far from the origin the ray enters the ball: by integers up to the line's distance from the centre.
long double entry(const LatticeBall &ball, const LatticePoint &origin, const LatticePoint &direction) {
  const oracle::Vector u = centre_difference(oracle::ball_around(origin, 0), ball);
  const oracle::Vector d = {direction[0], direction[1], direction[2]};
  const auto length = [](const oracle::Vector &v) {
    long double squared = 0;
    for (const oracle::Int128 component : v)
      squared += static_cast<long double>(component) * static_cast<long double>(component);
    return std::sqrt(squared);
  };
  const long double beside = length(oracle::cross(u, d)) / length(d);
  const auto r = static_cast<long double>(ball.radius);
  return static_cast<long double>(oracle::dot(u, d)) / length(d) -
         std::sqrt(std::max(0.0L, (r - beside) * (r + beside)));
}

bool is_tied(const Balls &balls, uint32_t first, const LatticePoint &origin, const LatticePoint &direction) {
  for (uint32_t j = first + 1; j < balls.size(); ++j) {
    if (oracle::first_on_ray({balls[j]}, origin, direction) == 0 &&
        oracle::compare_entries(balls[first], balls[j], origin, direction) == 0)
      return true;
  }
  return false;
}

void check(const Balls &balls, const BuiltGrid &built, const LatticePoint &origin, const LatticePoint &direction,
           Seen &seen) {
  ASSERT_EQ(built.status(), hsp::Status::ok);
  hsp::exact::LatticeRay ray{};
  const std::array<double, 3> from = in_doubles(origin), along = in_doubles(direction);
  ASSERT_EQ(hsp::round_ray(built.grid().balls(), from.data(), along.data(), ray), hsp::Status::ok);
  const hsp::RayHit found = hsp::first_ball_on_ray(built.grid(), ray);
  const uint32_t expected = oracle::first_on_ray(balls, origin, direction);
  const std::string scene = oracle::to_text({oracle::ball_around(origin, 0), oracle::ball_around(direction, 0)}) +
                            " and " + oracle::to_text(balls);
  if (expected == oracle::no_ball) {
    ASSERT_EQ(found.ball, hsp::no_id) << scene;
    EXPECT_TRUE(std::isinf(found.distance));
    ++seen.nothing;
    return;
  }
  ASSERT_NE(found.ball, hsp::no_id) << scene;
  ASSERT_EQ(built.grid().balls().caller[found.ball], expected) << scene;
  if (oracle::balls_meeting({balls[expected]}, oracle::ball_around(origin, 0)).size() == 1) {
    EXPECT_EQ(found.distance, 0.0);
    EXPECT_EQ(found.point.x, from[0]);
    EXPECT_EQ(found.point.y, from[1]);
    EXPECT_EQ(found.point.z, from[2]);
    ++seen.inside;
    return;
  }
  // Where a ray grazes a ball, the root of a small difference is what the oracle rounds.
  const auto distance = static_cast<double>(entry(balls[expected], origin, direction));
  const double coarse = 1e-7 * static_cast<double>(balls[expected].radius);
  EXPECT_NEAR(distance, found.distance, coarse + 2e-15 * found.distance) << scene;
  const double length = std::hypot(along[0], along[1], along[2]);
  const double size = found.distance + std::hypot(from[0], from[1], from[2]);
  EXPECT_NEAR(found.point.x, from[0] + found.distance * (along[0] / length), 1e-15 * size) << scene;
  EXPECT_NEAR(found.point.y, from[1] + found.distance * (along[1] / length), 1e-15 * size) << scene;
  EXPECT_NEAR(found.point.z, from[2] + found.distance * (along[2] / length), 1e-15 * size) << scene;
  ++seen.something;
  if (is_tied(balls, expected, origin, direction)) ++seen.tied;
}

LatticePoint random_point(oracle::RandomSource &random, int64_t most) {
  const int64_t x = random.in(-most, most);
  const int64_t y = random.in(-most, most);
  return {x, y, random.in(-most, most)};
}

// Along an axis, a diagonal, or any way; and towards a ball or not.
void check_rays(const Balls &balls, const BuiltGrid &built, oracle::RandomSource &random, int rays, Seen &seen) {
  int64_t extent = 1;
  for (const LatticeBall &ball : balls)
    extent = std::max({extent, std::abs(ball.x), std::abs(ball.y), std::abs(ball.z), ball.radius});
  for (int asked = 0; asked < rays; ++asked) {
    const auto chosen = static_cast<size_t>(random.in(0, static_cast<int64_t>(balls.size()) - 1));
    const LatticePoint towards = centre_of(balls[chosen]);
    LatticePoint direction = random_point(random, random.one_in(2) ? 1 : 1 + extent);
    if (direction == LatticePoint{}) direction[static_cast<size_t>(random.in(0, 2))] = random.one_in(2) ? 1 : -1;
    LatticePoint origin = random_point(random, 2 * extent);
    if (!random.one_in(4)) {
      const int64_t aside = random.one_in(2) ? 0 : balls[chosen].radius;
      const int64_t back = random.in(0, 4);
      for (size_t axis = 0; axis < 3; ++axis) {
        // Whole multiples of the direction, so that there are rays through centres.
        origin[axis] = towards[axis] - back * direction[axis];
      }
      origin[static_cast<size_t>(random.in(0, 2))] += random.one_in(2) ? aside : -aside;
    }
    check(balls, built, origin, direction, seen);
  }
}

void check_sets(uint64_t seed, int sets, Balls (*make)(oracle::RandomSource &, std::size_t), std::size_t most,
                Seen &seen) {
  for_random_sets(seed, sets, make, most,
                  [&](const Balls &balls, const BuiltGrid &built, oracle::RandomSource &random) {
                    check_rays(balls, built, random, 20, seen);
                  });
}

TEST(RayQuery, InSetsOfAllKinds) {
  Seen seen;
  check_sets(1, 60, oracle::any_balls, 30, seen);
  check_sets(2, 100, oracle::degenerate_balls, 20, seen);
  check_sets(3, 30, oracle::loose_balls, 80, seen);
  EXPECT_GT(seen.nothing, 300);
  EXPECT_GT(seen.something, 800);
  EXPECT_GT(seen.inside, 100);
  EXPECT_GT(seen.tied, 30);
}

// Small balls far apart from each other, in many layers: the ray is lost if a cube beside it is left out.
TEST(RayQuery, ThroughManyLayers) {
  oracle::RandomSource random(4);
  Seen seen;
  for (int k = 0; k < 6; ++k) {
    Balls balls = oracle::balls_in_box(random, 120, 400, 10, 40);
    if (k % 2 == 0) balls.push_back({0, 0, 0, 41});
    const BuiltGrid built(oracle::in_lengths(balls, 1));
    for (int asked = 0; asked < 60; ++asked) {
      const LatticePoint origin = random_point(random, asked % 2 == 0 ? 1200 : 300);
      const LatticePoint aim = random_point(random, 300);
      const LatticePoint direction = {aim[0] - origin[0], aim[1] - origin[1], aim[2] - origin[2]};
      check(balls, built, origin, direction == LatticePoint{} ? LatticePoint{0, 1, 0} : direction, seen);
    }
  }
  EXPECT_GT(seen.nothing, 30);
  EXPECT_GT(seen.something, 100);
}

TEST(RayQuery, BreaksTiesByTheLowestNumber) {
  Seen seen;
  for_balls_entered_in_one_point(60, [&](int k, const Balls &balls, const BuiltGrid &built, int64_t z) {
    check(balls, built, {0, 0, z}, {0, 0, 1 + k}, seen);
  });
  EXPECT_EQ(seen.nothing, 0);
  EXPECT_EQ(seen.tied, 300);
}

// Two balls side by side, so far off that doubles do not tell which one is entered first.
TEST(RayQuery, TellsEntriesThatDoublesDoNot) {
  Seen seen;
  for (const int64_t side : {-1, 1}) {
    const Balls balls = {{30 * side, 0, int64_t{1} << 49, 1000}, {-33 * side, 0, int64_t{1} << 49, 1000}};
    check(balls, BuiltGrid(oracle::in_lengths(balls, 1)), {0, 0, 0}, {0, 0, 1}, seen);
  }
  EXPECT_EQ(seen.something, 2);
  EXPECT_EQ(seen.tied, 0);
}

// The ends of the lattice, where a ray crosses far more layers than there are cubes.
TEST(RayQuery, AtTheEndsOfTheLattice) {
  constexpr int64_t far = int64_t{1} << 50;
  constexpr int64_t largest = (int64_t{1} << 30) - 1;
  Seen seen;
  for (const int64_t radius : {int64_t{0}, int64_t{1}, int64_t{1000}, largest}) {
    const Balls balls = {{far, far, far, radius},
                         {-far, -far, -far, radius},
                         {0, 0, 0, radius},
                         {-far, far, far, radius / 2},
                         {far, -far / 2, far, radius / 3}};
    const BuiltGrid built(oracle::in_lengths(balls, 1));
    for (const LatticeBall &from : balls) {
      for (const LatticeBall &to : balls) {
        for (const int64_t off : {int64_t{0}, int64_t{1}, radius, radius + 1}) {
          const LatticePoint direction = {to.x - from.x, to.y - from.y, to.z - from.z};
          if (direction == LatticePoint{}) continue;
          const int64_t inwards = from.x > 0 ? -1 : 1;
          check(balls, built, {from.x + inwards * (radius + off), from.y, from.z}, direction, seen);
          check(balls, built, {from.x, from.y, from.z}, direction, seen);
        }
      }
    }
  }
  EXPECT_GT(seen.nothing + seen.something, 100);
  EXPECT_GT(seen.inside, 100);
}

// As many layers as cubes, one more and one less: both ways to look must give one answer.
TEST(RayQuery, WithAsManyLayersAsCubes) {
  Seen seen;
  for (int64_t cubes = 1; cubes <= 6; ++cubes) {
    for (int64_t gap = 0; gap <= 3; ++gap) {
      Balls balls;
      for (int64_t k = 0; k < cubes; ++k) balls.push_back({4, 4, 20 * k + 10, 10});
      balls.push_back({4, 4, 20 * (cubes - 1 + gap) + 10, 3});
      const BuiltGrid built(oracle::in_lengths(balls, 1));
      for (int64_t z = -40; z <= 20 * (cubes + gap) + 10; z += 5) {
        for (const int64_t x : {4, 13, 14, 15}) {
          check(balls, built, {x, 4, z}, {0, 0, 1}, seen);
          check(balls, built, {x, 4, z}, {0, 0, -1}, seen);
          check(balls, built, {x + z + 40, 4, z}, {-1, 0, -1}, seen);
        }
      }
    }
  }
  EXPECT_GT(seen.nothing, 50);
  EXPECT_GT(seen.something, 200);
}

// Directions are rounded relative to their largest component, whatever their size.
TEST(RayQuery, RoundsDirectionsOfAnySize) {
  const BuiltGrid built(oracle::in_lengths({{0, 0, 0, 5}}, 1));
  const double origin[3] = {1, 2, 3};
  hsp::exact::LatticeRay one{}, other{};
  const auto round = [&](double x, double y, double z, hsp::exact::LatticeRay &ray) {
    const double direction[3] = {x, y, z};
    return hsp::round_ray(built.grid().balls(), origin, direction, ray);
  };
  ASSERT_EQ(round(3, -4, 0.1, one), hsp::Status::ok);
  EXPECT_EQ(one.direction.x, int64_t{3} << 50);
  EXPECT_EQ(one.direction.y, -(int64_t{4} << 50));
  EXPECT_EQ(one.direction.z, std::llround(std::ldexp(0.1, 50)));
  for (const int power : {-1073, -1022, -1000, -901, -900, -899, -700, -50, 1, 52, 900, 1021}) {
    ASSERT_EQ(round(std::ldexp(3.0, power), std::ldexp(-4.0, power), 0.0, other), hsp::Status::ok) << power;
    EXPECT_EQ(other.direction.x, one.direction.x) << power;
    EXPECT_EQ(other.direction.y, one.direction.y) << power;
    EXPECT_EQ(other.direction.z, 0) << power;
  }
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  ASSERT_EQ(round(most, least, -most / 2, other), hsp::Status::ok);
  EXPECT_EQ(other.direction.x, (int64_t{1} << 53) - 1);
  EXPECT_EQ(other.direction.y, 0);
  ASSERT_EQ(round(0, -least, 0, other), hsp::Status::ok);
  EXPECT_EQ(other.direction.y, -(int64_t{1} << 52));
  EXPECT_EQ(round(0, -0.0, 0, other), hsp::Status::range);
  EXPECT_EQ(round(0, std::nan(""), 0, other), hsp::Status::not_finite);
  const double far[3] = {1e300, 0, 0}, nowhere[3] = {1e300, -INFINITY, 0}, along[3] = {1, 0, 0};
  EXPECT_EQ(hsp::round_ray(built.grid().balls(), far, along, other), hsp::Status::range);
  EXPECT_EQ(hsp::round_ray(built.grid().balls(), nowhere, along, other), hsp::Status::not_finite);
}

TEST(RayQuery, AmongNoBalls) {
  const BuiltGrid built(oracle::in_lengths({}, 1));
  EXPECT_EQ(hsp::first_ball_on_ray(built.grid(), {{0, 0, 0}, {1, 0, 0}}).ball, hsp::no_id);
}

}  // namespace
