// Faces of a sphere with several clusters of caps and a ring, in all 48 positions to the poles of the walks: a large
// cap that leaves a disc free, and in the disc a ring of caps. The free disc falls into the hole of the ring and the
// band around it, whatever way the walks run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "boundary/boundary_check.hpp"
#include "built_boundary.hpp"
#include "measure/boundary_metric_check.hpp"
#include "point_lattices.hpp"
#include "set_arrangements.hpp"

namespace {

// The sphere has radius 1000. The ring's caps, 17 degrees wide, are centred 30 degrees from the axis y.
oracle::Balls ring() {
  return oracle::along_axes(oracle::ring_around_z(6, 500, 866, 296, 0.2), {0, 2, 1});
}

// The numbers of loops of the first ball's faces, ascending.
std::vector<uint32_t> loops_of_faces(const oracle::Balls &balls) {
  BuiltBoundary boundary(balls);
  EXPECT_EQ(boundary.status(), hsp::Status::ok);
  EXPECT_EQ(hsp::check_boundary(boundary.balls(), boundary.boundary(), boundary.scratch()).invariant,
            hsp::BoundaryInvariant::none);
  EXPECT_EQ(hsp::check_boundary_metric(boundary.balls(), boundary.boundary()).invariant, hsp::BoundaryInvariant::none);
  const uint32_t own = boundary.grid_index(0);
  std::vector<uint32_t> loops;
  for (const uint32_t face : boundary.boundary().faces(own)) {
    loops.push_back(boundary.boundary().loops_of_face(face).size());
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

// The ball that leaves the disc of 60 degrees about y free.
constexpr oracle::LatticeBall large{0, -1000, 0, 1732};

TEST(MeridianWalks, HoleAndBandInEveryPosition) {
  for (const oracle::Balls &balls : oracle::axis_symmetries(oracle::joined({{0, 0, 0, 1000}, large}, ring()))) {
    EXPECT_EQ(loops_of_faces(balls), (std::vector<uint32_t>{1, 2}));
  }
}

// A walk that starts at a small cap inside the large one may stay inside it all the way: its circle meets no free
// point. The small cap stands for the cluster if its ball comes first.
TEST(MeridianWalks, WalksThatStayCovered) {
  for (const oracle::LatticeBall &small : {oracle::LatticeBall{1000, 0, 0, 100}, oracle::LatticeBall{0, 0, 1000, 100},
                                           oracle::LatticeBall{0, -1000, 0, 100}}) {
    for (const oracle::Balls &balls :
         oracle::axis_symmetries(oracle::joined({{0, 0, 0, 1000}, small, large}, ring()))) {
      EXPECT_EQ(loops_of_faces(balls), (std::vector<uint32_t>{1, 2}));
    }
  }
}

// Rings of sixteen caps, 17 degrees wide, around the axis z: more caps than are counted at once. Of a belt of three
// rings the middle one has no free arc, and without it the caps of the two loops do not hang together.
oracle::Balls ring_of_sixteen(double degrees) {
  const double latitude = degrees * std::acos(-1.0) / 180;
  return oracle::ring_around_z(16, 1000 * std::cos(latitude), std::lround(1000 * std::sin(latitude)), 296, 0.1);
}

TEST(ClustersOfManyCaps, BeltWhoseMiddleIsCovered) {
  const oracle::Balls belt =
      oracle::joined(ring_of_sixteen(20), oracle::joined(ring_of_sixteen(0), ring_of_sixteen(-20)));
  for (const oracle::Balls &balls : oracle::axis_symmetries(oracle::joined({{0, 0, 0, 1000}}, belt))) {
    EXPECT_EQ(loops_of_faces(balls), (std::vector<uint32_t>{1, 1}));
  }
}

TEST(ClustersOfManyCaps, TwoRings) {
  const oracle::Balls rings = oracle::joined(ring_of_sixteen(45), ring_of_sixteen(-45));
  for (const oracle::Balls &balls : oracle::axis_symmetries(oracle::joined({{0, 0, 0, 1000}}, rings))) {
    EXPECT_EQ(loops_of_faces(balls), (std::vector<uint32_t>{1, 1, 2}));
  }
}

// Loops are numbered face by face, though they are found in the order of their half-edges. Outside a ring and around
// two studs on the far side the sphere has one face with two loops; in some positions the ring's inner loop is found
// between them.
TEST(LoopsOfFaces, AreConsecutive) {
  uint32_t found_between = 0;
  const oracle::Balls ball_and_studs = {{0, 0, 0, 1000}, {60, -1000, 0, 150}, {-60, -1000, 0, 150}};
  for (const oracle::Balls &balls : oracle::axis_symmetries(oracle::joined(ball_and_studs, ring()))) {
    BuiltBoundary built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::Boundary &boundary = built.boundary();
    ASSERT_EQ(boundary.loops(built.grid_index(0)).size(), 3U);
    uint32_t last_start = 0;
    bool ascending = true;
    for (const uint32_t face : boundary.faces(built.grid_index(0))) {
      for (const uint32_t loop : boundary.loops_of_face(face)) {
        EXPECT_EQ(boundary.face_of_loop(loop), face);
        const hsp::LoopElement start = boundary.loop_start(loop);
        ASSERT_FALSE(start.is_circle());
        EXPECT_EQ(boundary.loop_of(start), loop);
        ascending = ascending && start.half_edge() >= last_start;
        last_start = start.half_edge();
      }
    }
    found_between += ascending ? 0 : 1;
    EXPECT_EQ(hsp::check_boundary(built.balls(), boundary, built.scratch()).invariant, hsp::BoundaryInvariant::none);
    EXPECT_EQ(hsp::check_boundary_metric(built.balls(), boundary).invariant, hsp::BoundaryInvariant::none);
  }
  EXPECT_GT(found_between, 0U);
  EXPECT_LT(found_between, 48U);
}

// Two rings around one direction, and within the inner one hundreds of studs: a face with all of these, a band with two
// loops that no stud borders, and the rest.
TEST(LoopsOfFaces, BandBehindHundredsOfStuds) {
  const auto ring_of = [](int balls, double degrees, int64_t radius) {
    const double from_pole = degrees * std::acos(-1.0) / 180;
    return oracle::ring_around_z(balls, 1000000 * std::sin(from_pole), std::lround(1000000 * std::cos(from_pole)),
                                 radius, 0.3);
  };
  oracle::Balls balls =
      oracle::joined({{0, 0, 0, 1000000}}, oracle::joined(ring_of(24, 25, 70000), ring_of(24, 40, 100000)));
  for (int k = 0; k < 280; ++k) {
    const double from_pole = 0.005 + 0.0011 * k, angle = 2.4 * k;
    balls.push_back({std::lround(1e6 * std::sin(from_pole) * std::cos(angle)),
                     std::lround(1e6 * std::sin(from_pole) * std::sin(angle)), std::lround(1e6 * std::cos(from_pole)),
                     500});
  }
  for (const oracle::Balls &turned : oracle::axis_symmetries(balls)) {
    EXPECT_EQ(loops_of_faces(turned), (std::vector<uint32_t>{1, 2, 281}));
  }
}

}  // namespace
