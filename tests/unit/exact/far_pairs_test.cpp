// Pairs of balls so far apart that the squares of the differences leave 64 bits. The test that stops them before
// anything is squared is asked for each axis and direction on its own.
#include <gtest/gtest.h>

#include <vector>

#include "built_grid.hpp"
#include "exact/lattice_ball.hpp"
#include "model/packing_statistics.hpp"

namespace {

using hsp::exact::LatticeBall;
using hsp::exact::PairRelation;

constexpr int64_t largest_radius = (int64_t{1} << 30) - 1;

void set_axis(hsp::exact::Vector &v, int axis, int64_t value) {
  (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value;
}

TEST(FarPairs, AreDisjointAlongEveryAxis) {
  // 2^32 squared is 0 modulo 2^64, 2^50 squared is as well.
  for (const int64_t distance : {int64_t{1} << 32, int64_t{3} << 32, int64_t{1} << 50}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int64_t direction : {-1, 1}) {
        for (const int64_t radius : {int64_t{0}, int64_t{1}, int64_t{1} << 20, largest_radius}) {
          LatticeBall a{{5, 6, 7}, radius, 0};
          LatticeBall b{{5, 6, 7}, radius, 1};
          set_axis(b.centre, axis, 5 + axis + direction * distance);
          EXPECT_EQ(pair_relation(a, b), PairRelation::disjoint)
              << axis << ' ' << direction * distance << ' ' << radius;
          a.radius = 3;
          EXPECT_EQ(pair_relation(a, b), PairRelation::disjoint)
              << axis << ' ' << direction * distance << ' ' << radius;
        }
      }
    }
  }
}

double mean_overlaps(const support::BallList &balls) {
  BuiltGrid built(balls);
  EXPECT_EQ(built.status(), hsp::Status::ok);
  return packing_statistics(built.grid()).mean_overlaps;
}

// Two largest balls at the far sides of neighbouring cubes: 4 r - 1 apart along one axis, and along another by as much
// as makes the sum of squares a small number modulo 2^64.
TEST(FarPairs, InNeighbouringCubesDoNotOverlap) {
  const double side = 2.0 * static_cast<double>(largest_radius);
  support::BallList pair;
  pair.radius.assign(2, static_cast<double>(largest_radius));
  for (size_t axis = 0; axis < 3; ++axis) {
    for (const bool backwards : {false, true}) {
      std::vector<double> &xyz = pair.xyz;
      xyz.assign(6, 0.0);
      xyz[axis] = backwards ? 2 * side - 1 : 0.0;
      xyz[3 + axis] = backwards ? 0.0 : 2 * side - 1;
      xyz[3 + (axis + 1) % 3] = 0x1p18;
      EXPECT_EQ(mean_overlaps(pair), 0.0) << axis << ' ' << backwards;
      // The same pair close to each other does.
      xyz[axis] = xyz[3 + axis] = 0.0;
      EXPECT_EQ(mean_overlaps(pair), 1.0);
    }
  }
}

}  // namespace
