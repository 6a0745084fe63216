// Pores of periodic boxes: closed forms of packings, Euler's sum over a box with gaps counted in integers, directions
// between bounds of a grid, and the same bits for any cell of a crystal.
#include <gtest/gtest.h>

#include <algorithm>

#include "box_flood.hpp"
#include "built_crystal_pores.hpp"
#include "pockets/class_tree.hpp"
#include "pore_sets.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::BoxRows;

constexpr int64_t unit = 100000000;

std::string to_text(const BoxRows &box) {
  std::string text;
  for (const auto &row : box) {
    for (const int64_t side : row) text += std::to_string(side) + " ";
  }
  return text;
}

struct Crystal {
  Balls balls;
  BoxRows box;
};

Crystal random_crystal(oracle::RandomSource &random, int kind) {
  Crystal crystal;
  const auto n = static_cast<size_t>(random.in(1, 7));
  const bool tied = kind % 3 == 2;
  const int64_t grain = tied ? unit / 2 : 1;
  const auto length = [&](int64_t least, int64_t most) { return random.in(least, most) / grain * grain; };
  const auto side = [&] { return length(unit, 3 * unit); };
  crystal.box = {{{side(), 0, 0}, {0, side(), 0}, {0, 0, side()}}};
  if (kind % 2 == 1) {
    crystal.box[1][0] = length(-unit, unit);
    crystal.box[2][0] = length(-unit, unit);
    crystal.box[2][1] = length(-unit, unit);
  }
  for (size_t k = 0; k < n; ++k) {
    const int64_t radius = tied ? random.in(1, 3) * unit / 4 : random.in(unit / 8, unit * 3 / 4);
    crystal.balls.push_back({length(-unit, 3 * unit), length(-unit, 3 * unit), length(-unit, 3 * unit), radius});
  }
  return crystal;
}

// Without balls in images of others.
Balls outer_in_box(const Crystal &crystal) {
  Balls all = crystal.balls;
  for (int a = -4; a <= 4; ++a) {
    for (int b = -4; b <= 4; ++b) {
      for (int c = -4; c <= 4; ++c) {
        if (a == 0 && b == 0 && c == 0) continue;
        for (const auto &ball : crystal.balls) all.push_back(oracle::moved_by(ball, crystal.box, {a, b, c}));
      }
    }
  }
  const Balls outer = oracle::outer_balls(all);
  Balls own;
  for (const auto &ball : crystal.balls) {
    if (std::find(outer.begin(), outer.end(), ball) == outer.end()) continue;
    // Of balls in one place, images of one another, the first stays.
    bool again = false;
    for (const auto &kept : own) {
      for (int c = 0; c < 9 * 9 * 9; ++c) {
        again = again || oracle::moved_by(kept, crystal.box, {c % 9 - 4, c / 9 % 9 - 4, c / 81 - 4}) == ball;
      }
    }
    if (!again) own.push_back(ball);
  }
  return own;
}

// Each level so often, in ascending order.
std::vector<double> levels_of(const BuiltCrystalPores &pores, int times) {
  std::vector<double> levels;
  for (int k = 0; k < times; ++k) {
    for (const auto &maximum : pores.maxima()) levels.push_back(maximum.point.level);
    for (const auto &gate : pores.gates()) levels.push_back(gate.point.level);
  }
  std::sort(levels.begin(), levels.end());
  return levels;
}

void expect_same(const BuiltCrystalPores &one, const BuiltCrystalPores &other, int times) {
  ASSERT_EQ(other.status(), hsp::Status::ok);
  ASSERT_EQ(one.maxima().size() * static_cast<uint32_t>(times), other.maxima().size());
  ASSERT_EQ(levels_of(one, times), levels_of(other, 1));
  for (const uint32_t d : {1U, 2U, 3U}) {
    ASSERT_TRUE(one.passage(d) == other.passage(d) || (std::isnan(one.passage(d)) && std::isnan(other.passage(d))));
  }
}

TEST(CrystalPores, Packings) {
  struct Packing {
    const char *name;
    std::vector<std::array<int, 3>> quarters;  // of the edge
    double largest, passage;                   // plus the radius, of an edge of 1
    uint32_t maxima, gates;
  };
  const Packing packings[] = {
      {"simple", {{0, 0, 0}}, std::sqrt(3.0) / 2, std::sqrt(2.0) / 2, 1, 3},
      {"body-centred", {{0, 0, 0}, {2, 2, 2}}, std::sqrt(5.0) / 4, 3 / (4 * std::sqrt(2.0)), 12, 24},
      {"face-centred", {{0, 0, 0}, {0, 2, 2}, {2, 0, 2}, {2, 2, 0}}, 0.5, 1 / std::sqrt(6.0), 12, 32},
      {"diamond",
       {{0, 0, 0}, {0, 2, 2}, {2, 0, 2}, {2, 2, 0}, {1, 1, 1}, {1, 3, 3}, {3, 1, 3}, {3, 3, 1}},
       std::sqrt(3.0) / 4,
       1 / std::sqrt(6.0),
       24,
       32}};
  constexpr int64_t edge = 8 * unit, radius = unit;
  for (const Packing &packing : packings) {
    for (const int64_t origin : {INT64_C(0), unit / 3, -5 * edge}) {
      for (const int cells : {1, 2}) {
        Balls balls;
        for (int c = 0; c < cells * cells * cells; ++c) {
          for (const auto &q : packing.quarters) {
            balls.push_back({origin + q[0] * edge / 4 + c % cells * edge,
                             origin + q[1] * edge / 4 + c / cells % cells * edge,
                             origin + q[2] * edge / 4 + c / cells / cells * edge, radius});
          }
        }
        const int64_t side = cells * edge;
        const BuiltCrystalPores pores(balls, {{{side, 0, 0}, {0, side, 0}, {0, 0, side}}}, 0);
        ASSERT_EQ(pores.status(), hsp::Status::ok) << packing.name;
        const auto copies = static_cast<uint32_t>(cells * cells * cells);
        EXPECT_EQ(pores.maxima().size(), copies * packing.maxima) << packing.name;
        EXPECT_EQ(pores.gates().size(), copies * packing.gates) << packing.name;
        EXPECT_NEAR(pores.maxima()[0].point.level,
                    packing.largest * static_cast<double>(edge) - static_cast<double>(radius), 1e-3);
        for (const uint32_t d : {1U, 2U, 3U}) {
          EXPECT_NEAR(pores.passage(d), packing.passage * static_cast<double>(edge) - static_cast<double>(radius), 1e-3)
              << packing.name;
        }
      }
    }
  }
}

// The torus has no outside: maxima - gates + gaps - balls is 0 if nothing is missing.
TEST(CrystalPores, EulerSums) {
  oracle::RandomSource random(1);
  int points = 0, tied = 0;
  for (int turn = 0; turn < oracle::sets(36); ++turn) {
    const Crystal crystal = random_crystal(random, turn);
    const Balls outer = outer_in_box(crystal);
    const BuiltCrystalPores pores(crystal.balls, crystal.box);
    ASSERT_EQ(pores.status(), hsp::Status::ok) << oracle::to_text(crystal.balls) << " in " << to_text(crystal.box);
    ASSERT_EQ(pores.builder().outer_balls(), outer.size());
    const auto maxima = static_cast<int>(pores.maxima().size()), gates = static_cast<int>(pores.gates().size());
    ASSERT_EQ(maxima - gates + oracle::count_gaps(outer, crystal.box, 3) - static_cast<int>(outer.size()), 0)
        << oracle::to_text(crystal.balls);
    points += maxima + gates;
    for (const auto &gate : pores.gates()) tied += gate.point.tied > 3 ? 1 : 0;
    // Down to -r_max everything is one class.
    for (uint32_t k = 0; k < pores.maxima().size(); ++k) {
      ASSERT_EQ(pores.maxima()[k].gate == hsp::no_id, k == 0);
      ASSERT_TRUE(k == 0 || pores.maxima()[k].into < k);
    }
  }
  EXPECT_GT(points, 300);
  EXPECT_GT(tied, 10);
}

// A half of the diagonal takes each ball to an equal one in the second crystal, to another one in the first. In the
// third it takes the first ball to an equal one, the others to others.
TEST(CrystalPores, BallsOfMovedPointsTouchThem) {
  const BoxRows box{{{2 * unit, 0, 0}, {0, 2 * unit, 0}, {0, 0, 2 * unit}}};
  for (int kind = 0; kind < 3; ++kind) {
    Balls balls{{0, 0, 0, unit * 7 / 10}, {unit, unit, unit, kind == 0 ? unit / 2 : unit * 7 / 10}};
    if (kind == 2) balls.insert(balls.end(), {{unit, 0, 0, unit * 3 / 10}, {0, unit, unit, unit / 5}});
    const BuiltCrystalPores pores(balls, box);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    const auto check = [&](const hsp::CriticalPoint &point) {
      for (size_t k = 0; k < 4 && point.ball[k] != hsp::no_id; ++k) {
        const hsp::BoxShift shift = point.shift[k].shift();
        const oracle::LatticeBall ball =
            oracle::moved_by(balls[point.ball[k]], box, {shift.k[0], shift.k[1], shift.k[2]});
        const double x = point.position.x - static_cast<double>(ball.x),
                     y = point.position.y - static_cast<double>(ball.y),
                     z = point.position.z - static_cast<double>(ball.z);
        ASSERT_NEAR(std::hypot(x, y, z) - static_cast<double>(ball.radius), point.level, 1e-3);
      }
    };
    for (const auto &maximum : pores.maxima()) check(maximum.point);
    for (const auto &gate : pores.gates()) check(gate.point);
    if (kind < 2) {
      ASSERT_EQ(pores.maxima().size(), 12U);
    }
  }
}

// Between maxima so few steps apart that no way up leaves the gate: the place is that of an end of it.
TEST(CrystalPores, PlacesAtGates) {
  const BoxRows box{{{80, 0, 0}, {0, 100, 0}, {0, 0, 60}}};
  for (int corner = 0; corner < 4; ++corner) {
    const int64_t x = corner % 2 * 40 + 10, z = corner / 2 * 15 + 5;
    const Balls balls{{x, 10, z, 16}, {x, 10, z + 30, 16}};
    const BuiltCrystalPores pores(balls, box, 0);
    const BuiltPeriodic periodic(BuiltPores::listed(balls), {80, 0, 0, 0, 100, 0, 0, 0, 60});
    ASSERT_EQ(pores.gates().size(), 6U);
    for (const auto &gate : pores.gates()) {
      const hsp::Vec3 &at = gate.point.position;
      const hsp::exact::Vector point{std::llround(at.x), std::llround(at.y), std::llround(at.z)};
      hsp::PoreLocation place{};
      ASSERT_EQ(locate(pores.builder(), hsp::BallsAround(periodic.get()), point, 0, place), hsp::Status::ok);
      const auto is_end = [&](uint32_t side) {
        return place.maximum == gate.end[side] && place.maximum_shift == gate.end_shift[side].shift();
      };
      ASSERT_TRUE(is_end(0) || is_end(1));
    }
  }
}

TEST(CrystalPores, DirectionsBetweenBoundsOfAGrid) {
  oracle::RandomSource random(2);
  int decided[4] = {0, 0, 0, 0};
  for (int turn = 0; turn < oracle::sets(12); ++turn) {
    // Rods, and walls: short in one direction and in two.
    Crystal crystal;
    for (size_t k = 0; k < 3; ++k) {
      const bool is_short =
          turn % 2 == 0 ? k == static_cast<size_t>(turn / 2 % 3) : k != static_cast<size_t>(turn / 2 % 3);
      crystal.box[k] = {0, 0, 0};
      crystal.box[k][k] = is_short ? random.in(unit, unit * 6 / 5) : random.in(3 * unit, 7 * unit / 2);
    }
    crystal.box[1][0] = random.in(-unit / 5, unit / 5);
    crystal.box[2][0] = random.in(-unit / 5, unit / 5);
    crystal.box[2][1] = random.in(-unit / 5, unit / 5);
    for (int64_t n = random.in(1, 2); n > 0; --n) {
      crystal.balls.push_back(
          {random.in(0, unit / 3), random.in(0, unit / 3), random.in(0, unit / 3), random.in(unit / 3, unit / 2)});
    }
    const BuiltCrystalPores pores(crystal.balls, crystal.box);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    for (const uint32_t d : {1U, 2U, 3U}) {
      for (const int64_t aside : {-unit / 5, unit / 5}) {
        const double level = pores.passage(d) + static_cast<double>(aside);
        const oracle::DirectionBounds bounds = oracle::free_directions(crystal.balls, crystal.box, level, 20);
        const uint32_t directions = pores.directions(level);
        ASSERT_LE(bounds.least, directions)
            << level << " of " << oracle::to_text(crystal.balls) << to_text(crystal.box);
        ASSERT_GE(bounds.most, directions) << level << " of " << oracle::to_text(crystal.balls) << to_text(crystal.box);
        if (bounds.least == bounds.most) ++decided[directions];
      }
    }
  }
  for (const int count : decided) EXPECT_GT(count, 2);
}

TEST(CrystalPores, AnyCellOfACrystal) {
  oracle::RandomSource random(3);
  for (int turn = 0; turn < oracle::sets(12); ++turn) {
    const Crystal crystal = random_crystal(random, turn);
    const auto &[a, b, c] = crystal.box;
    const BuiltCrystalPores pores(crystal.balls, crystal.box);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    Balls moved = crystal.balls;
    const int64_t x = random.in(-unit, unit), y = random.in(-unit, unit), z = random.in(-unit, unit);
    for (auto &ball : moved) {
      ball = oracle::moved_by(
          {ball.x + x, ball.y + y, ball.z + z, ball.radius}, crystal.box,
          {static_cast<int>(random.in(-3, 3)), static_cast<int>(random.in(-3, 3)), static_cast<int>(random.in(-3, 3))});
    }
    std::reverse(moved.begin(), moved.end());
    ASSERT_NO_FATAL_FAILURE(expect_same(pores, BuiltCrystalPores(moved, crystal.box), 1));
    const BoxRows other{a, {b[0] + a[0], b[1], b[2]}, {c[0] - b[0] - 2 * a[0], c[1] - b[1], c[2]}};
    ASSERT_NO_FATAL_FAILURE(expect_same(pores, BuiltCrystalPores(crystal.balls, other), 1));
    for (size_t axis = 0; axis < 3; ++axis) {
      Balls twice = crystal.balls;
      std::array<int, 3> times{0, 0, 0};
      times[axis] = 1;
      for (const auto &ball : crystal.balls) twice.push_back(oracle::moved_by(ball, crystal.box, times));
      BoxRows larger = crystal.box;
      for (int64_t &v : larger[axis]) v *= 2;
      ASSERT_NO_FATAL_FAILURE(expect_same(pores, BuiltCrystalPores(twice, larger), 2)) << axis;
    }
  }
}

TEST(CrystalPores, FortyEightSymmetries) {
  oracle::RandomSource random(4);
  for (int turn = 0; turn < oracle::sets(4); ++turn) {
    Crystal crystal = random_crystal(random, 2 * turn);
    const BuiltCrystalPores pores(crystal.balls, crystal.box);
    for (int symmetry = 1; symmetry < 48; ++symmetry) {
      std::array<size_t, 3> axis{0, 1, 2};
      for (int k = 0; k < symmetry / 8; ++k) std::next_permutation(axis.begin(), axis.end());
      const auto turned = [&](size_t k, const std::array<int64_t, 3> &p) {
        return (symmetry >> k & 1) != 0 ? -p[axis[k]] : p[axis[k]];
      };
      Balls balls;
      for (const auto &ball : crystal.balls) {
        const std::array<int64_t, 3> p{ball.x, ball.y, ball.z};
        balls.push_back({turned(0, p), turned(1, p), turned(2, p), ball.radius});
      }
      const std::array<int64_t, 3> sides{crystal.box[0][0], crystal.box[1][1], crystal.box[2][2]};
      const BoxRows box{{{sides[axis[0]], 0, 0}, {0, sides[axis[1]], 0}, {0, 0, sides[axis[2]]}}};
      ASSERT_NO_FATAL_FAILURE(expect_same(pores, BuiltCrystalPores(balls, box), 1)) << symmetry;
    }
  }
}

TEST(CrystalPores, WhatWasNeededIsNoMoreThanThat) {
  oracle::RandomSource random(5);
  const Crystal crystal = random_crystal(random, 5);
  BuiltCrystalPores whole(crystal.balls, crystal.box);
  ASSERT_EQ(whole.status(), hsp::Status::ok);
  const hsp::PoreLimits needed = whole.builder().needed();
  ASSERT_EQ(whole.build(needed), hsp::Status::ok);
  for (uint32_t hsp::PoreLimits::*limit : {&hsp::PoreLimits::balls, &hsp::PoreLimits::maxima, &hsp::PoreLimits::gates,
                                           &hsp::PoreLimits::candidates, &hsp::PoreLimits::near}) {
    hsp::PoreLimits less = needed;
    --(less.*limit);
    ASSERT_EQ(whole.build(less), hsp::Status::capacity);
    ASSERT_GT(whole.builder().retry_limits().*limit, less.*limit);
  }
}

TEST(CrystalPores, BoxesThatAreTooLongAndEmptyOnes) {
  const BuiltCrystalPores thin({{0, 0, 0, 100}}, {{{100000, 0, 0}, {0, 400, 0}, {0, 0, 400}}});
  EXPECT_EQ(thin.status(), hsp::Status::range);
  const BuiltCrystalPores empty({}, {{{400, 0, 0}, {0, 400, 0}, {0, 0, 400}}}, 0);
  EXPECT_EQ(empty.status(), hsp::Status::ok);
  EXPECT_EQ(empty.maxima().size() + empty.gates().size(), 0U);
}

}  // namespace
