// Sides of vertices by integers, of spheres that all go through one point.
#include "sphere/cell_ties.hpp"

#include <gtest/gtest.h>

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

TEST(CellTies, AreDecidedAsByTheInflatedBalls) {
  const support::BallList balls = balls_through_origin();
  const BuiltGrid built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  hsp::Caps caps;
  CarvedMemory memory;
  memory.carve(caps, balls.size());
  hsp::BlockSweep sweep(built.grid());
  int inside = 0, outside = 0;
  for (uint32_t i = 0; i < balls.size(); ++i) {
    caps.target = runnable_targets().front();
    caps.gather(built.grid().balls(), sweep.block_around_ball(i), i, nullptr);
    OuterCell cell;
    cell.start();
    const auto plane = [&](uint32_t k) { return OuterCell::Plane{caps.ux[k], caps.uy[k], caps.uz[k], caps.b[k], k}; };
    const CellTies ties(caps, caps.length_squared);
    for (uint32_t k = 0; k < caps.count; ++k) {
      VertexSides sides = sides_of_vertices(caps.target, cell, plane(k));
      const VertexSides before = sides;
      VertexBits on_plane;
      ties.decide(cell, k, sides, on_plane);
      EXPECT_EQ(sides.unsure[0] | sides.unsure[1], 0U);
      for (uint32_t v = 0; v < cell.vertices; ++v) {
        const uint8_t *const face = cell.face[v];
        const bool of_balls =
            cell.cap[face[0]] != hsp::no_id && cell.cap[face[1]] != hsp::no_id && cell.cap[face[2]] != hsp::no_id;
        if ((before.unsure[0] >> v & 1U) == 0 || !of_balls) continue;
        const hsp::exact::Sign nearer = caps.predicates().near(
            caps.plane(cell.cap[face[0]]), caps.plane(cell.cap[face[1]]), caps.plane(cell.cap[face[2]]), caps.plane(k));
        EXPECT_TRUE(nearer.tied);
        EXPECT_EQ(on_plane.word[0] >> v & 1U, 1U);
        EXPECT_EQ(sides.outside[0] >> v & 1U, nearer.sign < 0 ? 1U : 0U);
        ++(nearer.sign < 0 ? inside : outside);
      }
      cell.cut(plane(k), sides.outside);
    }
    // Those of the cube are on the sides that doubles tell, where these are certain.
    cell.start();
    for (uint32_t k = 0; k < caps.count; ++k) {
      VertexSides sides{{0, 0}, {0xFF, 0}};
      const VertexSides expected = sides_of_vertices(caps.target, cell, plane(k));
      VertexBits on_plane;
      ties.decide(cell, k, sides, on_plane);
      EXPECT_EQ(expected.unsure[0], 0U);
      EXPECT_EQ(sides.outside[0], expected.outside[0]);
      EXPECT_TRUE(on_plane.empty());
    }
  }
  EXPECT_GT(inside, 10);
  EXPECT_GT(outside, 10);
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
