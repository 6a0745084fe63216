// The two oracles for the complement of a union of balls, the dual complex and the flood fill, against each other,
// against the Betti numbers of the nerve, and against sets whose voids are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "dual_complex.hpp"
#include "flood_fill.hpp"
#include "named_balls.hpp"
#include "nerve.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"

namespace {

using oracle::Balls;
using oracle::Box;
using oracle::cage_of_26;
using oracle::DualComplex;
using oracle::FloodFill;
using oracle::LatticeBall;

TEST(DualComplex, CellsOfSmallSets) {
  EXPECT_EQ(DualComplex({}).cells(), 1U);
  EXPECT_EQ(DualComplex({{0, 0, 0, 5}}).cells(), 1U);
  EXPECT_EQ(DualComplex({{0, 0, 0, 5}}).cell_of(0, 0, 6), 0U);
  EXPECT_THROW((void)DualComplex({{0, 0, 0, 5}}).cell_of(0, 3, 4), std::domain_error);
  EXPECT_THROW(DualComplex({{0, 0, 0, 5}, {1 << 20, 0, 0, 5}}), std::out_of_range);
  const DualComplex cage(cage_of_26(10, 8));
  EXPECT_EQ(cage.cells(), 2U);
  EXPECT_EQ(cage.cell_of(0, 0, 0), 1U);
  EXPECT_EQ(cage.cell_of(0, 0, 40), 0U);
  EXPECT_EQ(cage.cell_of(19, 0, 0), 0U);
  // Half a diagonal of a square is 7.07: windows.
  EXPECT_EQ(DualComplex(cage_of_26(10, 7)).cells(), 1U);
}

TEST(DualComplex, VoidsAreThoseOfTheNerve) {
  oracle::RandomSource random(31);
  int voids = 0;
  for (int k = 0; k < 3000; ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(1, 10)));
    const int64_t expected = oracle::nerve_betti_numbers(balls)[2];
    ASSERT_EQ(DualComplex(balls).cells(), 1 + expected) << oracle::to_text(balls);
    voids += expected > 0 ? 1 : 0;
  }
  // Eight balls at the corners of boxes close a void or just do not.
  for (int k = 0; k < 300; ++k) {
    Balls balls;
    for (int64_t corner = 0; corner < 8; ++corner)
      balls.push_back({4 * (corner & 1), 6 * (corner >> 1 & 1), 12 * (corner >> 2), random.in(6, 7)});
    const int64_t expected = oracle::nerve_betti_numbers(balls)[2];
    ASSERT_EQ(DualComplex(balls).cells(), 1 + expected) << oracle::to_text(balls);
    voids += expected > 0 ? 1 : 0;
  }
  EXPECT_GT(voids, 5);
  for (const oracle::KnownBalls &set : oracle::known_balls()) {
    if (set.balls.size() > 60 || set.name.starts_with("benzene")) continue;  // too many, or beyond the digits
    EXPECT_EQ(DualComplex(set.balls).cells(), 1 + set.voids) << set.name;
  }
}

TEST(DualComplex, DoesNotDependOnTheOrder) {
  oracle::RandomSource random(32);
  for (int k = 0; k < 60; ++k) {
    Balls balls = cage_of_26(10, 8);
    const Balls more = oracle::degenerate_balls(random, 6);
    balls.insert(balls.end(), more.begin(), more.end());
    const DualComplex one(balls);
    const DualComplex other(oracle::permuted(balls, random.permutation(balls.size())));
    ASSERT_EQ(one.cells(), other.cells()) << oracle::to_text(balls);
    for (int p = 0; p < 20; ++p) {
      const LatticeBall point = {random.in(-25, 25), random.in(-25, 25), random.in(-25, 25), 0};
      if (std::any_of(balls.begin(), balls.end(), [&](const LatticeBall &b) {
            const oracle::Vector v = oracle::centre_difference(b, point);
            return oracle::dot(v, v) <= oracle::Int128{b.radius} * b.radius;
          }))
        continue;
      ASSERT_EQ(one.cell_of(point.x, point.y, point.z) == 0, other.cell_of(point.x, point.y, point.z) == 0)
          << oracle::to_text(balls);
    }
  }
}

TEST(FloodFill, OneBall) {
  const int64_t radius = 1000;
  const FloodFill fill({{0, 0, 0, radius}}, {{-1100, -1100, -1100}, {1100, 1100, 1100}}, 20);
  ASSERT_EQ(fill.certain().size(), 1U);
  ASSERT_EQ(fill.perhaps().size(), 1U);
  EXPECT_TRUE(fill.certain()[0].reaches_border);
  const long double free = 2200.0L * 2200 * 2200 - 4 * std::numbers::pi_v<long double> / 3 * radius * radius * radius;
  EXPECT_LT(fill.certain()[0].volume, free);
  EXPECT_GT(fill.perhaps()[0].volume, free);
  // At most the columns' width times the surface apart.
  EXPECT_LT(fill.perhaps()[0].volume - fill.certain()[0].volume,
            4 * std::numbers::pi_v<long double> * radius * radius * 30);
  EXPECT_FALSE(fill.perhaps_at({0, 0, 0}).has_value());
  EXPECT_FALSE(fill.certain_at({0, 0, 999}).has_value());
  EXPECT_TRUE(fill.certain_at({0, 0, 1001}).has_value());
  EXPECT_FALSE(fill.certain_at({0, 0, 1101}).has_value());
}

// The volume of the void in a cage lies between bounds that approach each other, and a window is found to be one.
TEST(FloodFill, Cages) {
  const Balls closed = scaled(cage_of_26(10, 8), 100);
  long double difference = 1e30L;
  long double least = 0;
  long double most = 1e30L;
  for (const int64_t side : {80, 40, 20, 10}) {
    const Box box = oracle::box_around(closed, 2 * side);
    const FloodFill fill(closed, box, side);
    const auto inner = fill.certain_at({0, 0, 0});
    ASSERT_TRUE(inner.has_value());
    const FloodFill::Region &void_region = fill.certain()[*inner];
    EXPECT_FALSE(fill.perhaps()[void_region.perhaps].reaches_border);
    const auto around = fill.perhaps_at({0, 0, box.high[2] - 1});
    ASSERT_TRUE(around.has_value());
    EXPECT_NE(*around, void_region.perhaps);
    const long double now = fill.perhaps()[void_region.perhaps].volume - void_region.volume;
    EXPECT_LT(now, 0.6L * difference);
    difference = now;
    EXPECT_GE(void_region.volume, least);
    EXPECT_LE(fill.perhaps()[void_region.perhaps].volume, most);
    least = void_region.volume;
    most = fill.perhaps()[void_region.perhaps].volume;
  }
  const Balls open = scaled(cage_of_26(10, 6), 100);
  const FloodFill fill(open, oracle::box_around(open, 20), 10);
  ASSERT_EQ(fill.perhaps().size(), 1U);
  ASSERT_TRUE(fill.certain_at({0, 0, 0}).has_value());
  EXPECT_TRUE(fill.certain()[*fill.certain_at({0, 0, 0})].reaches_border);
}

// Flood fill, where it is certain, agrees with the dual complex.
TEST(FloodFill, AgreesWithTheDualComplex) {
  oracle::RandomSource random(33);
  std::map<bool, int> same;
  for (int k = 0; k < 150; ++k) {
    const Balls cage = cage_of_26(100, random.in(65, 90));
    const Balls balls = oracle::joined(cage, oracle::balls_in_box(random, 4, 60, 1, 40));
    const DualComplex complex(balls);
    const FloodFill fill(balls, oracle::box_around(balls, 20), 4);
    for (const FloodFill::Region &a : fill.certain())
      for (const FloodFill::Region &b : fill.certain()) {
        const uint32_t cell_a = complex.cell_of(a.point[0], a.point[1], a.point[2]);
        const uint32_t cell_b = complex.cell_of(b.point[0], b.point[1], b.point[2]);
        if (&a == &b || a.perhaps != b.perhaps) {
          ASSERT_EQ(&a == &b, cell_a == cell_b) << oracle::to_text(balls);
          ++same[cell_a == cell_b];
        }
      }
    for (int p = 0; p < 100; ++p) {
      const oracle::LatticePoint point = {random.in(-150, 150), random.in(-150, 150), random.in(-150, 150)};
      const auto region = fill.certain_at(point);
      if (!region) continue;
      const oracle::LatticePoint &known = fill.certain()[*region].point;
      ASSERT_EQ(complex.cell_of(point[0], point[1], point[2]), complex.cell_of(known[0], known[1], known[2]));
    }
  }
  EXPECT_GT(same[false], 50);
}

}  // namespace
