// Sides of vertices by integers, of spheres that all go through one point.
#include "sphere/cell_ties.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "built_grid.hpp"
#include "model/block_sweep.hpp"
#include "runnable_targets.hpp"

namespace {

using hsp::CellTies;
using hsp::OuterCell;
using hsp::TiedSets;
using hsp::VertexBits;
using hsp::VertexSides;

// Balls of radius 3 whose spheres go through the origin.
support::BallList balls_through_origin() {
  support::BallList balls;
  for (const double x : {1.0, -1.0}) {
    for (const double y : {2.0, -2.0}) {
      balls.add(x, y, 2, 3);
      balls.add(y, x, 2, 3);
      balls.add(y, 2, x, 3);
    }
  }
  return balls;
}

// The same of several radii, and as many farther out: vertices differ from each other at every level.
support::BallList balls_of_several_radii() {
  support::BallList balls;
  constexpr int quadruples[][4] = {{2, 6, 9, 11}, {6, 6, 7, 11}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 3, 6, 7}};
  for (const auto &[x, y, z, radius] : quadruples) {
    for (const int sign : {1, -1}) {
      balls.add(sign * x, y, z, radius);
      balls.add(z, sign * x, y, radius);
      balls.add(2 * y, 2 * z, sign * 2 * x, radius + 2);
    }
  }
  return balls;
}

struct Tally {
  uint32_t inside = 0, outside = 0, untied = 0;
};

// Every vertex of balls is asked about, whether or not doubles are sure of it.
void expect_decided_as_by_one_question(const support::BallList &balls, Tally &tally) {
  const BuiltGrid built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  hsp::Caps caps;
  CarvedMemory memory;
  memory.carve(caps, balls.size());
  hsp::BlockSweep sweep(built.grid());
  for (uint32_t i = 0; i < balls.size(); ++i) {
    caps.target = runnable_targets().front();
    caps.gather(built.grid().balls(), sweep.block_around_ball(i), i, nullptr);
    OuterCell cell;
    cell.start();
    const auto plane = [&](uint32_t k) { return OuterCell::Plane{caps.ux[k], caps.uy[k], caps.uz[k], caps.b[k], k}; };
    CellTies ties(caps);
    for (uint32_t k = 0; k < caps.count; ++k) {
      const VertexSides before = sides_of_vertices(caps.target, cell, plane(k));
      VertexSides sides{{0, 0}, {~UINT64_C(0), ~UINT64_C(0)}};
      VertexBits on_plane;
      ties.decide(cell, {&k, 1}, &sides, &on_plane);
      EXPECT_EQ(sides.unsure[0] | sides.unsure[1], 0U);
      for (uint32_t v = 0; v < cell.vertices; ++v) {
        const auto has = [v](const uint64_t(&bits)[2]) { return bits[v / 64] >> v % 64 & 1U; };
        EXPECT_TRUE(has(before.unsure) != 0 || has(sides.outside) == has(before.outside));
        const uint8_t *const face = cell.face[v];
        const uint32_t cap[3] = {cell.cap[face[0]], cell.cap[face[1]], cell.cap[face[2]]};
        if (std::count(cap, cap + 3, hsp::no_id) > 0) continue;
        const hsp::exact::Sign nearer =
            caps.predicates().near(caps.plane(cap[0]), caps.plane(cap[1]), caps.plane(cap[2]), caps.plane(k));
        EXPECT_EQ(has(on_plane.word), nearer.tied ? 1U : 0U);
        EXPECT_EQ(has(sides.outside), nearer.sign < 0 ? 1U : 0U);
        ++(!nearer.tied ? tally.untied : nearer.sign < 0 ? tally.inside : tally.outside);
      }
      cell.cut(plane(k), sides.outside);
    }
    // Those of the cube are on the sides that doubles tell, where these are certain.
    cell.start();
    for (uint32_t k = 0; k < caps.count; ++k) {
      VertexSides sides{{0, 0}, {0xFF, 0}};
      const VertexSides expected = sides_of_vertices(caps.target, cell, plane(k));
      VertexBits on_plane;
      ties.decide(cell, {&k, 1}, &sides, &on_plane);
      EXPECT_EQ(sides.outside[0] & ~expected.unsure[0], expected.outside[0]);
      EXPECT_EQ(on_plane.word[0] & ~expected.unsure[0], 0U);
    }
  }
}

TEST(CellTies, AreDecidedAsByTheInflatedBalls) {
  Tally alike, several;
  expect_decided_as_by_one_question(balls_through_origin(), alike);
  expect_decided_as_by_one_question(balls_of_several_radii(), several);
  EXPECT_GT(alike.inside, 10U);
  EXPECT_GT(alike.outside, 10U);
  EXPECT_GT(several.inside, 10U);
  EXPECT_GT(several.outside, 10U);
  EXPECT_GT(several.untied, 100U);
}

TEST(TiedSets, OneWithAllOfAnotherServesIt) {
  TiedSets sets;
  const uint32_t small = sets.number_of({{3, 0}}), large = sets.number_of({{7, 1}}), other = sets.number_of({{8, 0}});
  EXPECT_EQ(sets.number_of({{7, 1}}), large);
  sets.keep(small);
  EXPECT_TRUE(sets.is_kept(small));
  EXPECT_FALSE(sets.is_kept(large));
  sets.keep(large);
  EXPECT_TRUE(sets.is_kept(large));
  EXPECT_FALSE(sets.is_kept(other));
  for (uint64_t k = 3; k < TiedSets::most; ++k) EXPECT_EQ(sets.number_of({{16 * k, 0}}), k);
  EXPECT_EQ(sets.number_of({{15, 0}}), TiedSets::most);
  EXPECT_EQ(sets.number_of({{8, 0}}), other);
}

}  // namespace
