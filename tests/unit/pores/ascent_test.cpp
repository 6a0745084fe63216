// Ways up: f, from all balls, never falls on them, and they end at a maximum or outside. The point of a hull that is
// nearest to 0 is held against mixtures of its corners.
#include "pores/ascent.hpp"

#include <gtest/gtest.h>

#include "built_crystal_pores.hpp"
#include "built_periodic.hpp"
#include "built_pores.hpp"
#include "pockets/class_tree.hpp"
#include "pore_sets.hpp"
#include "sweep_length.hpp"

namespace {

double nearest_distance(const oracle::Balls &balls, const hsp::Vec3 &x) {
  double least = INFINITY;
  for (const auto &ball : balls) {
    const double dx = x.x - static_cast<double>(ball.x), dy = x.y - static_cast<double>(ball.y),
                 dz = x.z - static_cast<double>(ball.z);
    least = std::min(least, std::sqrt(dx * dx + dy * dy + dz * dz) - static_cast<double>(ball.radius));
  }
  return least;
}

TEST(Ascent, TheDistanceNeverFalls) {
  oracle::RandomSource random(1);
  int steps = 0, outside = 0, tops = 0;
  for (int turn = 0; turn < oracle::sets(60); ++turn) {
    const oracle::Balls balls = turn % 2 == 0 ? pore_sets::general_set(random, 40, turn / 2 % pore_sets::general_kinds)
                                              : pore_sets::tied_set(random, 20, turn / 2 % pore_sets::tied_kinds);
    const BuiltPores pores(balls);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    for (int k = 0; k < 10; ++k) {
      const auto along = [&] {  // of the others some are full of ties
        return turn % 2 == 0 ? random.in(-130000000, 130000000) : random.in(0, 6) * 50000000;
      };
      const hsp::exact::Vector start{along(), along(), along()};
      hsp::Ascent way(pores.grid(), start);
      const auto at = [&](double part, const hsp::Vec3 &from) {
        const hsp::Vec3 o = hsp::combine(1.0 - part, from, part, way.offset());
        return nearest_distance(balls, {static_cast<double>(start.x) + o.x, static_cast<double>(start.y) + o.y,
                                        static_cast<double>(start.z) + o.z});
      };
      hsp::Vec3 before = way.offset();
      double level = way.level();
      ASSERT_NEAR(level, at(1.0, before), 1e-6);
      while (way.step()) {
        for (const double part : {0.25, 0.5, 0.75}) ASSERT_GE(at(part, before), level - 2.0) << oracle::to_text(balls);
        ASSERT_NEAR(way.level(), at(1.0, before), 1e-4);
        ASSERT_GE(way.level(), level - 2.0);
        before = way.offset();
        level = way.level();
        ++steps;
      }
      ASSERT_FALSE(way.is_lost());
      ++(way.is_outside() ? outside : tops);
      if (way.is_outside()) continue;
      // There is a maximum, or nearly.
      double nearest = INFINITY;
      for (const auto &maximum : pores.maxima()) {
        const hsp::Vec3 p = maximum.point.position, o = way.offset();
        const hsp::Vec3 d{p.x - o.x - static_cast<double>(start.x), p.y - o.y - static_cast<double>(start.y),
                          p.z - o.z - static_cast<double>(start.z)};
        nearest = std::min(nearest, std::sqrt(dot(d, d)));
      }
      ASSERT_LT(nearest, 1e4) << oracle::to_text(balls) << start.x << ' ' << start.y << ' ' << start.z;
    }
  }
  EXPECT_GT(steps, 3 * (outside + tops));
  EXPECT_GT(outside, tops / 20);
  EXPECT_GT(tops, outside / 20);
}

// A gap of two balls beside a third one that touches the same probe, and a square of four with two more on one side of
// it: on the other side f rises from there. At any scale; the way is to end outside, or where f is highest.
TEST(Ascent, TiesThatAreClosedOnOneSideAreLeftOnTheOther) {
  const oracle::Balls gap{{-10, -10, -10, 40}, {-10, 70, -10, 40}, {0, -10, 40, 40}};
  oracle::Balls square;
  for (int64_t y = 0; y <= 16; y += 8) {
    for (int64_t z = 0; z <= 16; z += 8) {
      square.push_back({0, y, z, 6});
      if (y == 0) square.push_back({8, y, z, 6});
    }
  }
  for (int64_t scale = 1; scale <= 10000000; scale *= 10) {
    const auto scaled = [&](oracle::Balls balls) {
      for (auto &ball : balls) ball = {ball.x * scale, ball.y * scale, ball.z * scale, ball.radius * scale};
      return balls;
    };
    const oracle::Balls sets[] = {scaled(gap), scaled(square)};
    const hsp::exact::Vector starts[] = {{-5 * scale, 21 * scale, 15 * scale}, {3 * scale, 4 * scale, 4 * scale}};
    for (const int which : {0, 1}) {
      const BuiltPores pores(sets[which], 0);
      ASSERT_EQ(pores.status(), hsp::Status::ok);
      hsp::PoreLocation place{};
      EXPECT_EQ(hsp::locate(pores.builder(), pores.grid(), starts[which], 0, place), hsp::Status::ok) << scale;
      EXPECT_EQ(place.maximum, hsp::pore_outside) << scale << ' ' << which;
      EXPECT_EQ(pores.maxima().size(), 0U);
    }
  }
}

// A packing of three balls to a cube, one of them 300 steps beside its place. Beside the point between the four balls
// around the side of a cube f rises by a few millionths of a step, which is as much as rounding takes from it.
TEST(Ascent, EndsWhereRoundingTakesWhatIsGained) {
  oracle::Balls balls;
  for (int64_t x = -2; x <= 2; ++x) {
    for (int64_t y = -2; y <= 2; ++y) {
      for (int64_t z = -2; z <= 2; ++z) {
        const int64_t i = 100000000 * x, j = 100000000 * y, k = 100000000 * z;
        balls.push_back({i, j + 50000000, k + 50000000, 50000000});
        balls.push_back({i + 50000000, j, k + 49999700, 50000000});
        balls.push_back({i, j + 50000000, k, 50000000});
      }
    }
  }
  const BuiltPores pores(balls, 0);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  for (const int64_t x : {-150, 150}) {
    const hsp::exact::Vector start{x, 0, 75000000};
    hsp::Ascent way(pores.grid(), start);
    uint32_t steps = 0;
    while (way.step()) ++steps;
    EXPECT_FALSE(way.step());
    EXPECT_FALSE(way.is_lost());
    EXPECT_LT(steps, 20000U);
    hsp::PoreLocation place{};
    ASSERT_EQ(hsp::locate(pores.builder(), pores.grid(), start, 0, place), hsp::Status::ok);
    ASSERT_LT(place.maximum, pores.maxima().size());
    EXPECT_NEAR(pores.maxima()[place.maximum].point.level, place.level, 1.0);
  }
}

// Ways from there, and the ball that they begin at.
void check_begin(const BuiltPores &pores, const oracle::Balls &balls, const hsp::exact::Vector &start) {
  const hsp::Vec3 at{static_cast<double>(start.x), static_cast<double>(start.y), static_cast<double>(start.z)};
  const double level = nearest_distance(balls, at);
  hsp::Ascent way(pores.grid(), start);
  ASSERT_NEAR(way.level(), level, 1e-6);
  ASSERT_LT(way.nearest_ball().ball, balls.size());
  ASSERT_NEAR(nearest_distance({balls[way.nearest_ball().ball]}, at), level, 1e-6);
  double before = level;
  while (way.step()) {
    ASSERT_NEAR(way.level(), nearest_distance(balls, at + way.offset()), 1e-4);
    ASSERT_GE(way.level(), before - 2.0);
    before = way.level();
  }
  ASSERT_FALSE(way.is_lost());
  hsp::PoreLocation place{};
  ASSERT_EQ(hsp::locate(pores.builder(), pores.grid(), start, BuiltPores::lowest(balls), place), hsp::Status::ok);
  ASSERT_NEAR(place.level, level, 1e-6);
  if (place.maximum == hsp::pore_outside) return;
  ASSERT_LT(place.maximum, pores.maxima().size());
  ASSERT_GE(pores.maxima()[place.maximum].point.level, level - 2.0);
}

// In more balls than there is room for it is deep in most of them.
TEST(Ascent, BeginsInManyBalls) {
  constexpr int64_t unit = 100000000;
  oracle::RandomSource random(4);
  oracle::Balls balls;
  const auto along = [&] { return random.in(-unit, unit); };
  for (int k = 0; k < 300; ++k) balls.push_back({along(), along(), along(), 3 * unit});
  const BuiltPores pores(balls);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  for (int k = 0; k < 30; ++k) ASSERT_NO_FATAL_FAILURE(check_begin(pores, balls, {along(), along(), along()}));
}

// Of 672 balls around one point, from there and from a step beside it.
TEST(Ascent, BeginsWhereManyBallsTie) {
  constexpr int64_t unit = 1000000, most = 44;
  for (const int64_t radius : {INT64_C(0), unit / 2, 200 * unit}) {
    oracle::Balls balls;
    for (int64_t x = -most; x <= most; ++x) {
      for (int64_t y = -most; y <= most; ++y) {
        for (int64_t z = -most; z <= most; ++z) {
          if (x * x + y * y + z * z == 2009) balls.push_back({x * unit, y * unit, z * unit, radius});
        }
      }
    }
    ASSERT_EQ(balls.size(), 672U);
    const BuiltPores pores(balls);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    for (const hsp::exact::Vector &start : {hsp::exact::Vector{0, 0, 0}, {1, 0, 0}, {0, -1, 2}, {3, 5, -2}}) {
      ASSERT_NO_FATAL_FAILURE(check_begin(pores, balls, start));
    }
  }
}

// Along the axis of a ring all of its balls nearly tie, up to the rounding of their centres, or more than there is room
// for. Others are far above.
oracle::Balls ring_of(int count) {
  constexpr double unit = 1e8, turn = 6.283185307179586;
  oracle::Balls balls;
  for (int k = 0; k < count; ++k) {
    const double angle = turn * (k + 0.1234) / count;
    balls.push_back({std::llround(8.779 * unit * std::cos(angle)), std::llround(8.779 * unit * std::sin(angle)), 0,
                     INT64_C(300000000)});
  }
  for (const int64_t x : {-6000000000, 6000000000}) {
    for (const int64_t y : {-6000000000, 6000000000}) balls.push_back({x, y, 6000000000, 100000000});
  }
  return balls;
}

TEST(Ascent, FollowsTheAxisOfARing) {
  for (const int count : {60, 90, 96, 97, 100, 193, 250, 1000}) {
    const oracle::Balls balls = ring_of(count);
    const BuiltGrid grid(BuiltPores::listed(balls));
    for (const int64_t z : {0, 10000000, 100000000, 300000000}) {
      for (const int64_t x : {0, 10, 100000}) {
        const hsp::exact::Vector start{x, 0, z};
        hsp::Ascent way(grid.grid(), start);
        double level = way.level();
        while (way.step()) {
          const hsp::Vec3 &o = way.offset();
          ASSERT_NEAR(way.level(),
                      nearest_distance(balls, {static_cast<double>(x) + o.x, o.y, static_cast<double>(z) + o.z}), 1e-4);
          ASSERT_GE(way.level(), level - 2.0);
          level = way.level();
        }
        ASSERT_FALSE(way.is_lost());
        ASSERT_TRUE(way.is_outside()) << count << " " << z << " " << x;
      }
    }
  }
}

TEST(Ascent, OfARingEndsOnItsSide) {
  for (const int count : {60, 96, 100}) {
    const BuiltPores pores(ring_of(count), 0);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    for (const int64_t z : {10000000, 100000000, 300000000}) {
      for (const int64_t x : {0, 10, 100000}) {
        hsp::PoreLocation place{};
        ASSERT_EQ(hsp::locate(pores.builder(), pores.grid(), {x, 0, z}, 0, place), hsp::Status::ok);
        ASSERT_EQ(place.maximum, hsp::pore_outside);
      }
    }
  }
}

// So many in one place of a box, whose copies meet; the widest probe is in its middle, from where all are as far.
TEST(Ascent, BeginsInManyBallsOfABox) {
  constexpr int64_t unit = 1000000;
  const oracle::Balls balls(250, {0, 0, 0, 11 * unit / 20});
  const BuiltCrystalPores pores(balls, {{{unit, 0, 0}, {0, unit, 0}, {0, 0, unit}}}, -3 * unit / 10);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  ASSERT_EQ(pores.maxima().size(), 1U);
  const auto side = static_cast<double>(unit);
  const BuiltPeriodic periodic(BuiltPores::listed(balls), {side, 0, 0, 0, side, 0, 0, 0, side});
  const auto check = [&](const hsp::exact::Vector &start, double distance, bool there) {
    hsp::PoreLocation place{};
    ASSERT_EQ(hsp::locate(pores.builder(), hsp::BallsAround(periodic.get()), start, -3 * unit / 10, place),
              hsp::Status::ok);
    EXPECT_NEAR(place.level, distance - 0.55 * side, 1e-6);
    EXPECT_LT(place.ball, balls.size());
    EXPECT_EQ(place.maximum, there ? 0U : hsp::no_id);
  };
  for (const int64_t x : {INT64_C(0), unit / 10, unit / 3}) {
    const auto distance = static_cast<double>(x);
    ASSERT_NO_FATAL_FAILURE(check({x, 0, 0}, distance, distance > 0.25 * side));
    ASSERT_NO_FATAL_FAILURE(check({unit, x - unit, 0}, distance, distance > 0.25 * side));
  }
  ASSERT_NO_FATAL_FAILURE(check({unit / 2, unit / 2, unit / 2}, std::sqrt(0.75) * side, true));
}

TEST(Ascent, NoMixtureOfPointsIsNearerToZero) {
  oracle::RandomSource random(2);
  const auto number = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random.in(0, 1000000)) * 1e-6;
  };
  int inside = 0;
  for (int turn = 0; turn < 2000; ++turn) {
    const auto given = static_cast<uint32_t>(random.in(1, 8));
    const bool shifted = random.one_in(2);
    hsp::Vec3 points[4], found{};
    uint32_t count = 0;
    // Each added to those that have stayed.
    for (uint32_t step = 0; step < given && count < 4; ++step) {
      const hsp::Vec3 v{number(-1, 1), number(-1, 1), number(shifted ? 0.1 : -1, 1)};
      hsp::Vec3 all[4];
      points[count++] = (1.0 / std::sqrt(dot(v, v))) * v;
      const uint32_t before = count;
      for (uint32_t k = 0; k < count; ++k) all[k] = points[k];
      found = step == 0 ? points[0] : hsp::nearest_to_zero(points, count, found);
      ASSERT_LE(count, before);
      ASSERT_GE(count, 1U);
      // Nearest: no point of the hull is on the near side of the plane across it.
      for (uint32_t k = 0; k < before; ++k) ASSERT_GE(dot(all[k], found), dot(found, found) - 1e-9);
      for (uint32_t k = 0; k < count; ++k) ASSERT_NEAR(dot(points[k], found), dot(found, found), 1e-9);
    }
    inside += dot(found, found) == 0.0 ? 1 : 0;
  }
  EXPECT_GT(inside, 20);
}

}  // namespace
