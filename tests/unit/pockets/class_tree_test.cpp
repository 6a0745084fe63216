// Classes at a probe against regions of grown balls, gates between two classes against relaxation over all gates; the
// widest probe between two points where it is known in closed form, and among random balls.
#include "pockets/class_tree.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "cells/cell_location.hpp"
#include "checked_passage.hpp"
#include "checked_pores.hpp"
#include "pore_widths.hpp"
#include "sweep_length.hpp"

namespace {

using checked_passage::Balls;
using checked_passage::BuiltPassage;
using checked_passage::Vector;
using hsp::no_id;
using hsp::pore_outside;

struct Seen {
  int points = 0, levels = 0, regions = 0, inner = 0;
};

// At levels between all that are known, points are in one class if and only if they are in one region.
void compare_places(oracle::RandomSource &random, const oracle::Balls &balls, int64_t spread, int64_t unit,
                    Seen &seen) {
  const BuiltPores pores(balls, 0);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  const hsp::ClassTree tree(pores.builder());
  std::vector<hsp::exact::Vector> points;
  std::vector<hsp::PoreLocation> places;
  for (int k = 0; k < 12; ++k) {
    const auto along = [&] { return random.in(-spread / unit, spread / unit) * unit; };
    points.push_back({along(), along(), along()});
    if (k % 2 == 0 && !pores.maxima().empty()) {
      const auto last = static_cast<int64_t>(pores.maxima().size()) - 1;
      const hsp::Vec3 &at = pores.maxima()[static_cast<uint32_t>(random.in(0, last))].point.position;
      points.back() = {std::llround(at.x), std::llround(at.y), std::llround(at.z)};
    }
    hsp::PoreLocation place{};
    ASSERT_EQ(locate(pores.builder(), pores.grid(), points.back(), 0, place), hsp::Status::ok)
        << oracle::to_text(balls) << points.back().x << ' ' << points.back().y << ' ' << points.back().z;
    ASSERT_EQ(place.maximum == no_id, any_ball_meets(pores.grid(), {points.back(), 0}));
    places.push_back(place);
    ++seen.points;
  }
  for (int turn = 0; turn < 6; ++turn) {
    const hsp::PoreLocation &one = places[static_cast<size_t>(random.in(0, 5)) * 2];
    if (one.level < 10.0 || one.level > 9e8) continue;
    const auto level =
        static_cast<int64_t>(one.level) - (turn % 2 == 0 ? 4 : random.in(4, static_cast<int64_t>(one.level)));
    oracle::Balls grown = balls;
    int64_t largest = 0;
    for (auto &ball : grown) largest = std::max(largest, ball.radius += level);
    if (level < 0 || largest >= INT64_C(1) << 30) continue;
    const BuiltFreeSpace space(grown);
    ASSERT_EQ(space.status(), hsp::Status::ok);
    std::map<uint32_t, uint32_t> region_of;
    for (size_t k = 0; k < points.size(); ++k) {
      if (std::fabs(places[k].level - static_cast<double>(level)) < 3.0) continue;
      const uint32_t cell = hsp::cell_at(space.balls(), space.space(), points[k]);
      const bool fits = places[k].level > static_cast<double>(level);
      ASSERT_EQ(cell != no_id, fits);
      if (!fits) continue;
      const uint32_t region = space.space().cell(cell).region;
      const uint32_t member = tree.class_at(places[k].maximum, static_cast<double>(level));
      ASSERT_NE(member, no_id);
      ASSERT_EQ(member == pore_outside, region == 0) << oracle::to_text(balls) << " at " << level;
      ASSERT_EQ(region_of.insert({member, region}).first->second, region) << oracle::to_text(balls);
      seen.inner += region != 0 ? 1 : 0;
    }
    ++seen.levels;
    seen.regions += static_cast<int>(region_of.size());
  }
}

TEST(ClassTree, PlacesAreInOneClassIfTheyAreInOneRegion) {
  oracle::RandomSource random(1);
  Seen general, tied;
  for (int turn = 0; turn < oracle::sets(48); ++turn) {
    ASSERT_NO_FATAL_FAILURE(compare_places(random, pore_sets::general_set(random, 40, turn % pore_sets::general_kinds),
                                           250000000, 1, general));
    ASSERT_NO_FATAL_FAILURE(compare_places(random, pore_sets::tied_set(random, 24, turn % pore_sets::tied_kinds),
                                           300000000, 25000000, tied));
  }
  EXPECT_GT(general.inner, 10);
  EXPECT_GT(tied.inner, 10);
  EXPECT_GT(general.levels, 30);
}

TEST(ClassTree, GatesBetweenAreTheTightestOfTheWidestPath) {
  oracle::RandomSource random(2);
  int met = 0, apart = 0;
  for (int turn = 0; turn < oracle::sets(24); ++turn) {
    const oracle::Balls balls = pore_sets::general_set(random, 40, turn % pore_sets::general_kinds);
    const BuiltPores pores(balls, turn % 2 == 0 ? 30000000 : BuiltPores::lowest(balls));
    const hsp::ClassTree tree(pores.builder());
    const uint32_t count = pores.maxima().size();
    for (uint32_t a = 0; a <= count; ++a) {
      const uint32_t from = a == count ? pore_outside : a;
      const pore_widths::Widths widths(pores, from);
      for (uint32_t b = 0; b <= count; ++b) {
        const uint32_t to = b == count ? pore_outside : b;
        const uint32_t gate = tree.gate_between(from, to);
        if (gate == no_id) {
          ASSERT_EQ(widths.at(to), a == b ? INFINITY : -INFINITY);
          apart += a == b ? 0 : 1;
          continue;
        }
        ++met;
        const double level = pores.gates()[gate].point.level;
        ASSERT_NEAR(level, widths.at(to), 1e-6);
        // Just below they are one class, and at it they are not.
        ASSERT_EQ(tree.class_at(from, level - 1.0), tree.class_at(to, level - 1.0));
        ASSERT_NE(tree.class_at(from, level), tree.class_at(to, level));
      }
      ASSERT_EQ(tree.class_at(from, INFINITY), a == count ? pore_outside : no_id);
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(apart, 10);
}

TEST(ClassTree, WithoutBallsAllIsOutside) {
  const BuiltPores pores(oracle::Balls{}, 0);
  hsp::PoreLocation place{};
  ASSERT_EQ(locate(pores.builder(), pores.grid(), {5, 6, 7}, 0, place), hsp::Status::ok);
  EXPECT_EQ(place.maximum, pore_outside);
  EXPECT_EQ(place.ball, no_id);
  EXPECT_EQ(place.level, INFINITY);
}

TEST(FindPassage, AmongNoBallsOneAndTwo) {
  const Vector from{2000, 0, 0}, to{-3000, 0, 0}, inside{10, 0, 0};
  const BuiltPassage free({}, from, &to);
  ASSERT_EQ(free.status(), hsp::Status::ok);
  EXPECT_TRUE(free.passes());
  EXPECT_EQ(free.level(), INFINITY);
  EXPECT_EQ(free.ball(), no_id);
  for (const Vector *end : {&to, static_cast<const Vector *>(nullptr), &from}) {
    const BuiltPassage one({{0, 0, 0, 1000}}, from, end);
    ASSERT_EQ(one.status(), hsp::Status::ok);
    EXPECT_TRUE(one.passes());
    EXPECT_EQ(one.level(), 1000.0);
    EXPECT_EQ(one.ball(), 0U);
    EXPECT_FALSE(one.has_gate());
  }
  const BuiltPassage two({{0, 0, 0, 1000}, {-3000, 700, 0, 200}}, from, &to);
  EXPECT_EQ(two.level(), 500.0);
  EXPECT_EQ(two.ball(), 1U);
  const BuiltPassage covered({{0, 0, 0, 1000}}, from, &inside);
  ASSERT_EQ(covered.status(), hsp::Status::ok);
  EXPECT_FALSE(covered.passes());
  EXPECT_EQ(covered.ball(), no_id);
  const BuiltPassage touching({{0, 0, 0, 2000}}, from, nullptr);
  EXPECT_FALSE(touching.passes());
}

// Balls that would not fit a lattice if they grew as wide.
TEST(FindPassage, BesideAndBetweenFarBalls) {
  const int64_t far = INT64_C(1) << 31;
  Balls balls;
  for (const int64_t side : {far, -far}) {
    balls.push_back({side, 0, 0, 1000});
    balls.push_back({0, side, 0, 1000});
    balls.push_back({0, 0, side, 1000});
  }
  const Vector beside{8 * far, 5, 5}, other{7, -far, 9};
  const BuiltPassage away(balls, beside, nullptr);
  ASSERT_EQ(away.status(), hsp::Status::ok);
  EXPECT_TRUE(away.passes());
  EXPECT_NEAR(away.level(), static_cast<double>(7 * far - 1000), 1.0);
  EXPECT_EQ(away.ball(), 0U);
  EXPECT_FALSE(away.has_gate());
  const BuiltPassage covered(balls, beside, &other);
  ASSERT_EQ(covered.status(), hsp::Status::ok);
  EXPECT_EQ(covered.passes(), false);
  const BuiltPassage between(balls, {0, 0, 0}, nullptr);
  ASSERT_EQ(between.status(), hsp::Status::ok);
  EXPECT_TRUE(between.has_gate());
  EXPECT_NEAR(between.level(), static_cast<double>(far) * std::sqrt(2.0 / 3.0) - 1000.0, 1e-6);
}

// The hole of a ring of three, in closed form: the circumradius of the triangle less their radius.
TEST(FindPassage, ThroughARingOfThree) {
  const int64_t unit = 1000000;
  Balls balls{{2 * unit, 0, 0, unit}, {-unit, 1732051, 0, unit}, {-unit, -1732051, 0, unit}};
  // The ring is a hole in a lid; what is below has walls and a floor.
  for (int64_t x = -6; x <= 6; ++x) {
    for (int64_t y = -6; y <= 6; ++y) {
      if (x * x + y * y > 9) balls.push_back({x * unit, y * unit, 0, unit + unit / 2});
      if (x % 2 != 0 || y % 2 != 0) continue;
      const bool at_wall = std::max(std::abs(x), std::abs(y)) == 6;
      for (int64_t z = -6; z < (at_wall ? 0 : -4); z += 2) {
        balls.push_back({x * unit, y * unit, z * unit, unit + unit / 2});
      }
    }
  }
  const BuiltPassage built(balls, {0, 0, -3 * unit}, nullptr);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  ASSERT_TRUE(built.passes());
  // With h = 1732051 the centre is at x = (3 unit^2 - h^2) / (6 unit).
  EXPECT_NEAR(built.level(), static_cast<double>(unit) + 666601 / 6e6, 1e-4);
  ASSERT_TRUE(built.has_gate());
  EXPECT_EQ(std::set<uint32_t>(built.gate().begin(), built.gate().end()), (std::set<uint32_t>{0, 1, 2}));
}

TEST(FindPassage, AmongRandomBalls) {
  oracle::RandomSource random(1);
  checked_passage::Seen seen;
  ASSERT_NO_FATAL_FAILURE(check_among_random_balls(random, oracle::sets(4), seen));
  EXPECT_GT(seen.gates + seen.touches, 0U);
}

}  // namespace
