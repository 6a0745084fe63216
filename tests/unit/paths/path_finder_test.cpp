// Paths where they are few and simple, and samples of what paths_slow_test.cpp tries.
#include "paths/path_finder.hpp"

#include <gtest/gtest.h>

#include "checked_paths.hpp"
#include "point_lattices.hpp"
#include "sweep_length.hpp"

namespace {

using namespace checked_paths;

// The path between two points that are connected.
void check_one(const Balls &balls, const Vector &from, const Vector &to, hsp::PathSummary &summary, Seen &seen) {
  BuiltPaths paths(balls);
  ASSERT_EQ(paths.status(), hsp::Status::ok);
  ASSERT_EQ(paths.finder().find(paths.balls(), from, to, summary), hsp::Status::ok);
  ASSERT_NO_FATAL_FAILURE(check_path(balls, paths.finder(), summary, from, to, true, seen));
}

TEST(PathFinder, AroundNoBallsOneAndTwo) {
  oracle::RandomSource random(1);
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check({}, random, 10, seen));
  ASSERT_NO_FATAL_FAILURE(check({{0, 0, 0, 1000}}, random, 50, seen));
  ASSERT_NO_FATAL_FAILURE(check({{0, 0, 0, 1000}, {1500, 0, 0, 1000}}, random, 50, seen));
  ASSERT_NO_FATAL_FAILURE(check({{0, 0, 0, 1000}, {0, 0, 0, 1000}}, random, 50, seen));
  ASSERT_NO_FATAL_FAILURE(check({{3, 4, 5, 0}}, random, 10, seen));
  EXPECT_EQ(seen.certified, seen.found);
  EXPECT_GT(seen.bent, 30U);
}

TEST(PathFinder, AroundSetsOfAllKinds) {
  oracle::RandomSource random(2);
  Seen seen;
  for (int k = 0; k < oracle::sets(12); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 20)));
    ASSERT_NO_FATAL_FAILURE(check(balls, random, 8, seen)) << k;
  }
  if (oracle::sets_for_one == 1) {
    EXPECT_GT(seen.found, 10U);
  }
  EXPECT_GT(100 * seen.certified, 90 * seen.found);
}

TEST(PathFinder, ThroughLattices) {
  oracle::RandomSource random(3);
  Seen seen;
  for (const int64_t radius : {7071, 7072, 8661}) {
    ASSERT_NO_FATAL_FAILURE(check_lattice(radius, 12, random, seen));
  }
  EXPECT_EQ(seen.certified, seen.found);
  EXPECT_GT(seen.apart, 3U);
  EXPECT_GT(seen.covered, 3U);
}

TEST(PathFinder, AmongTheLargestNumbers) {
  oracle::RandomSource random(4);
  Seen seen;
  for (int k = 0; k < oracle::sets(4); ++k) ASSERT_NO_FATAL_FAILURE(check_large_numbers(6, random, seen)) << k;
  EXPECT_EQ(seen.certified, seen.found);
}

TEST(PathFinder, ThroughAMolecule) {
  oracle::RandomSource random(5);
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check(molecule("caffeine.pdb", 0), random, 60, seen));
  EXPECT_EQ(seen.certified, seen.found);
  EXPECT_EQ(seen.found, 60U);
  EXPECT_GT(seen.bent, 15U);
}

// One step beside a tangent of a large ball, and along it: doubles do not tell these apart. In all directions, since
// integers go by signs.
TEST(PathFinder, PastABallByOneStep) {
  const int64_t r = 100000000;
  const Balls balls{{0, 0, 0, r}};
  BuiltPaths paths(balls);
  ASSERT_EQ(paths.status(), hsp::Status::ok);
  for (uint32_t turn = 0; turn < 48; ++turn) {
    const auto turned = [&](int64_t touching, int64_t beside, int64_t along) {
      const int64_t value[3] = {turn & 1 ? -touching : touching, turn & 2 ? -beside : beside,
                                turn & 4 ? -along : along};
      const uint32_t first = turn / 8 % 3, second = turn < 24 ? 1 : 2;
      return Vector{value[first], value[(first + second) % 3], value[(first + 2 * second) % 3]};
    };
    for (const int64_t beside : {1, 0}) {
      const Vector from = turned(r, beside, -2 * r), to = turned(r, beside, 2 * r);
      hsp::PathSummary summary{};
      Seen seen;
      ASSERT_EQ(paths.finder().find(paths.balls(), from, to, summary), hsp::Status::ok);
      ASSERT_NO_FATAL_FAILURE(check_path(balls, paths.finder(), summary, from, to, true, seen)) << turn;
      EXPECT_EQ(seen.certified, 1U) << turn;
      EXPECT_EQ(seen.bent, beside == 0 ? 1U : 0U) << turn;
    }
  }
}

// Portals that touch two balls: no segment from there is outside them, and yet none goes through a ball.
TEST(PathFinder, APointOnTwoSpheresLeadsAroundThem) {
  const int64_t unit = 100000000;
  const auto scaled = [](const Vector &v) { return Vector{v.x * unit / 2, v.y * unit / 2, v.z * unit / 2}; };
  struct Case {
    Balls balls;  // of half units
    Vector from, to;
  };
  const Case cases[] = {
      {{{0, 0, 4, 2}, {4, 0, 2, 4}}, {0, 2, 2}, {0, -2, 3}},
      {{{2, 2, 2, 2}, {-2, 2, 0, 2}, {2, -2, -2, 4}, {2, 0, 0, 2}, {0, 0, 0, 2}}, {0, -1, 3}, {3, 4, -3}}};
  for (const Case &one : cases) {
    Balls balls = one.balls;
    for (auto &ball : balls) {
      const Vector centre = scaled({ball.x, ball.y, ball.z});
      ball = {centre.x, centre.y, centre.z, ball.radius * unit / 2};
    }
    if (balls.size() > 2) balls[1].z += 100;
    const Vector from = scaled(one.from), to = scaled(one.to);
    hsp::PathSummary summary{};
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(check_one(balls, from, to, summary, seen));
    EXPECT_GT(summary.clearance, -4.0);
  }
}

// Corners of a power cell beside a side of the cube that a plane between two balls leaves by nothing but one step.
TEST(PathFinder, RoundsCornersThatDoublesDoNotKnow) {
  const int64_t unit = 100000000;
  const Balls balls{
      {unit, -unit, -unit, unit}, {-unit, -10000, 0, unit}, {unit, 1, unit, unit}, {unit, 0, -2 * unit, 2 * unit}};
  const Vector from{unit / 2, 2 * unit, -3 * unit}, to{3 * unit / 2, -unit / 2, 0};
  hsp::PathSummary summary{};
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check_one(balls, from, to, summary, seen));
  EXPECT_GT(summary.clearance, -4.0);
}

// The same at portals: between cells of one cube, between a cell and a run of cubes without balls, and between cells of
// two cubes.
TEST(PathFinder, PortalsAreAtCornersThatDoublesDoNotKnow) {
  const int64_t u = 100000000;
  struct Case {
    Balls balls;
    Vector from, to;
  };
  const Case cases[] = {{{{0, -3 * u, -2 * u, 2 * u},
                          {2 * u, -u, -2 * u, u},
                          {-3 * u, -u, -3 * u, 0},
                          {3 * u, 2 * u, 2 * u, 2 * u + 10000},
                          {-2 * u, -u, u, 2 * u},
                          {3 * u, 0, -2 * u, u},
                          {-u, 2 * u, 0, 2 * u},
                          {0, 0, -2 * u + 2, 2 * u},
                          {-2 * u, -2 * u, -u, 2 * u},
                          {2 * u, 2 * u, 0, 2 * u}},
                         {-2 * u, 10000, -75000000},
                         {3 * u, -u / 2, -u}},
                        {{{0, -u, -u, u}, {u, u - 2, -u, 2 * u}, {-u, u, u, 2 * u}, {-u, u, -u, 2 * u}},
                         {-2 * u, -u, -2 * u},
                         {u, 2 * u, u}},
                        {{{u, -2 * u, u, u},
                          {3 * u - 200000, -2 * u, 0, 2 * u},
                          {u, -u, -2 * u, u},
                          {3 * u, -2 * u, -u, 2 * u},
                          {0, -u - 2, u, 0},
                          {0, u, 2 * u, 2 * u},
                          {0, -u, -u, 0},
                          {0, 2 * u, 0, 2 * u},
                          {2 * u, -2 * u, -2 * u, 2 * u},
                          {2 * u, 0, u, 2 * u + 100000}},
                         {0, -u, 6 * u / 5},
                         {3 * u, 2 * u, u}}};
  for (const Case &one : cases) {
    hsp::PathSummary summary{};
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(check_one(one.balls, one.from, one.to, summary, seen));
    EXPECT_GT(summary.clearance, -4.0);
  }
}

// A ball without a power cell in the cube has a plane that cuts that of another ball on the way to what it is: so its
// vertices, and its parts, come in another order than where the cells were found.
TEST(PathFinder, CrossesThePartThatTheCellIs) {
  const int64_t u = 100000000;
  const Balls balls{{0, u, 2 * u, u},      {-2 * u, -2 * u, 0, 2 * u}, {0, 0, 0, 2 * u},  {-u, 2 * u, 0, u},
                    {-2 * u, u, u, u},     {0, -2 * u, u, 2 * u},      {-2 * u, 0, u, u}, {-u, u, -2 * u, 2 * u},
                    {2 * u, -u, 2 * u, 0}, {u, 2 * u, 0, 2 * u}};
  const Vector from{-u, 3 * u, u}, to{3 * u, -u, 3 * u};
  hsp::PathSummary summary{};
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check_one(balls, from, to, summary, seen));
  EXPECT_EQ(seen.certified, 1U);
}

// A small ball that touches a large one: a segment in the plane of equal power, which rounding takes past the large
// ball by nothing, goes through the middle of the small one.
TEST(PathFinder, GoesAroundASmallBallOnALargeOne) {
  const int64_t u = 100000000;
  const Balls balls{{0, u, u, 1000}, {0, u - 2000, 0, u}, {u, -u, u, u}};
  const Vector from{-u, 9 * u / 5, 0}, to{u, -2 * u, -u};
  hsp::PathSummary summary{};
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check_one(balls, from, to, summary, seen));
  EXPECT_EQ(seen.certified, 1U);
}

TEST(PathFinder, AsksForRoomForPoints) {
  const Balls balls = molecule("crambin.pdb", 0);
  BuiltPaths large(balls);
  const Vector from{-5000000, -5000000, -5000000}, to{25000000, 25000000, 20000000};
  hsp::PathSummary summary{}, other{};
  ASSERT_EQ(large.finder().find(large.balls(), from, to, summary), hsp::Status::ok);
  const uint32_t needed = large.finder().needed_points();
  ASSERT_GT(needed, 5U);
  BuiltPaths small(balls, needed - 1), enough(balls, needed);
  ASSERT_EQ(small.finder().find(small.balls(), from, to, other), hsp::Status::capacity);
  EXPECT_EQ(small.finder().needed_points(), needed);
  EXPECT_EQ(small.finder().retry_limits().points, needed);
  EXPECT_EQ(small.finder().points().size(), 0U);
  ASSERT_EQ(enough.finder().find(enough.balls(), from, to, other), hsp::Status::ok);
  EXPECT_EQ(summary.length, other.length);
  EXPECT_EQ(large.finder().points().size(), enough.finder().points().size());
}

}  // namespace
