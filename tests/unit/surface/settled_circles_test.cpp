// Where four probes meet in a point, or a probe and a cusp, or several vertices are in one place, all patches there
// agree: the surface is closed.
#include "surface/settled_circles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "built_surface.hpp"
#include "lattice_lengths.hpp"
#include "named_balls.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "surface/surface_check.hpp"

namespace {

// 1: closed, and all invariants hold. 0: open.
int closed(const oracle::Balls &balls, double probe) {
  const BuiltSurface built(oracle::in_lengths(balls, 1), probe);
  EXPECT_EQ(built.status(), hsp::Status::ok);
  if (built.status() != hsp::Status::ok || !built.surface().is_closed()) return 0;
  const hsp::SurfaceViolation violation = hsp::check_surface(built.balls(), built.boundary(), built.surface());
  EXPECT_EQ(violation.invariant, hsp::SurfaceInvariant::none) << violation.id;
  return 1;
}

TEST(SettledCircles, Lattices) {
  int seen = 0, open = 0;
  for (const int64_t radius : {3, 4, 5, 6, 7, 8, 9}) {
    for (const double probe : {1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 9.0}) {
      for (const oracle::Balls &lattice :
           {oracle::box_lattice({2, 2, 2}, {12, 12, 12}, radius), oracle::box_lattice({3, 3, 2}, {12, 12, 12}, radius),
            oracle::box_lattice({2, 3, 2}, {6, 8, 24}, radius), oracle::box_lattice({2, 2, 3}, {4, 6, 12}, radius)}) {
        SCOPED_TRACE(testing::Message() << lattice.size() << " balls of " << radius << ", probe " << probe);
        ++seen;
        if (closed(lattice, probe) == 0) ++open;
      }
    }
  }
  EXPECT_EQ(seen, 196);
  EXPECT_EQ(open, 0);
}

// How many of 600 are open. Balls have at least this radius.
int open_random_sets(int64_t least_radius) {
  int open = 0;
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    oracle::RandomSource random(seed);
    oracle::Balls balls = oracle::degenerate_balls(random, 3 + seed % 12);
    double largest = 1.0;
    for (oracle::LatticeBall &ball : balls) {
      ball.radius = std::max(ball.radius, least_radius);
      largest = std::max(largest, static_cast<double>(ball.radius));
    }
    SCOPED_TRACE(seed);
    if (closed(balls, std::max(1.0, std::floor(0.3 * largest * static_cast<double>(1 + seed % 4)))) == 0) ++open;
  }
  return open;
}

// Four balls through a point, and four probes that meet in it. With balls that are points all probes around one of them
// meet there.
TEST(SettledCircles, RandomSetsFullOfTies) {
  EXPECT_EQ(open_random_sets(1), 0);
  EXPECT_EQ(open_random_sets(0), 0);
}

// Four spheres through (1, 6, 6), so that two vertices are in one place, with a side between them in the plane y = z.
// It is a plane of symmetry of two more probes, which meet both in points of this side: either of them may touch either
// vertex there.
TEST(SettledCircles, TwoProbesOnTheSideBetweenTwoVertices) {
  oracle::Balls balls = {{8, 12, 12, 5}, {4, 0, 0, 5}, {4, 12, 12, 5}, {4, 12, 0, 5}, {4, 0, 12, 5}};
  EXPECT_EQ(closed(balls, 4), 1);
  // Seen from elsewhere, and in other orders of the vertices.
  for (int turn = 0; turn < 6; ++turn) {
    for (oracle::LatticeBall &ball : balls) ball = {ball.z, turn == 2 ? -ball.x : ball.x, ball.y + turn, ball.radius};
    EXPECT_EQ(closed(balls, 4), 1) << turn;
  }
}

// A lattice in which eight spheres meet in a point, so that pairs of vertices are in one place, and sides between them
// in one plane: where their probes meet either of two pairs of patches may touch.
TEST(SettledCircles, SidesOfTwoPairsInOnePlane) {
  EXPECT_EQ(closed(oracle::box_lattice({2, 3, 2}, {6, 8, 24}, 4), 9), 1);
  EXPECT_EQ(closed(oracle::box_lattice({2, 3, 2}, {6, 8, 24}, 6), 7), 1);
  EXPECT_EQ(closed(oracle::box_lattice({3, 2, 2}, {8, 6, 24}, 4), 9), 1);
}

// Probes a few 1e-5 of their radius apart: where the crease between two of them ends is known to 1e-4.
TEST(SettledCircles, CreasesOfProbesCloseToEachOther) {
  const std::vector<oracle::KnownBalls> named = oracle::known_balls();
  const auto found = std::find_if(named.begin(), named.end(), [](const auto &set) { return set.name == "fullerene"; });
  ASSERT_NE(found, named.end());
  for (const int probe : {40, 51, 60, 68, 76, 80}) {
    SCOPED_TRACE(probe);
    oracle::Balls balls = found->balls;
    for (oracle::LatticeBall &ball : balls) ball.radius -= probe;
    EXPECT_EQ(closed(balls, probe), 1);
  }
}

// Balls that are points without the probe, on a sphere of its size: cusps of several circles, and probes, meet in each
// of them.
TEST(SettledCircles, CuspsAndProbesInOnePoint) {
  for (const oracle::Balls &balls :
       {oracle::Balls{{6, 3, 2, 0}, {-6, 3, 2, 0}, {0, -6, 2, 0}, {2, 3, -6, 0}},
        oracle::Balls{{5, 0, 0, 0}, {-5, 0, 0, 0}, {0, 5, 0, 0}, {0, -5, 0, 0}, {0, 0, 5, 0}, {0, 0, -5, 0}},
        oracle::Balls{{3, 4, 0, 0}, {-3, 4, 0, 0}, {0, -4, 3, 0}, {0, -4, -3, 0}}}) {
    EXPECT_EQ(closed(balls, balls[0].x == 6 ? 7.0 : 5.0), 1);
  }
}

}  // namespace
