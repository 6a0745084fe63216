// Positions of vertices, arcs and circles: on their spheres, the same for every order of the balls, and the same from
// either side.
#include "measure/boundary_positions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "built_boundary.hpp"

namespace {

// Three balls that meet in two points, and a fourth that cuts a whole circle out of the first.
const oracle::Balls scene = {{0, 0, 0, 1000}, {1000, 0, 0, 900}, {500, 800, 0, 800}, {-1500, 0, 0, 600}};

double distance(const double a[3], const oracle::LatticeBall &b) {
  const oracle::LatticePoint centre = centre_of(b);
  return std::hypot(a[0] - static_cast<double>(centre[0]), a[1] - static_cast<double>(centre[1]),
                    a[2] - static_cast<double>(centre[2]));
}

std::array<double, 3> coordinates(const BuiltBoundary &built, uint32_t vertex) {
  std::array<double, 3> xyz{};
  hsp::to_coordinates(built.balls(), hsp::position_of_vertex(built.balls(), built.boundary(), vertex), xyz.data());
  return xyz;
}

TEST(BoundaryPositions, VerticesLieOnTheirSpheres) {
  BuiltBoundary built(scene);
  ASSERT_EQ(built.boundary().vertex_count(), 2U);
  for (uint32_t v = 0; v < 2; ++v) {
    const std::array<double, 3> xyz = coordinates(built, v);
    for (const uint32_t ball : built.boundary().vertex(v).ball) {
      const oracle::LatticeBall &own = scene[built.balls().caller[ball]];
      EXPECT_NEAR(distance(xyz.data(), own), static_cast<double>(own.radius), 1e-9);
    }
  }
  EXPECT_EQ(coordinates(built, 0)[2], -coordinates(built, 1)[2]);
}

// What does not depend on ids: the same bits for all orders of the input, and angles that are those of the twins.
TEST(BoundaryPositions, SameBitsInEveryOrder) {
  const auto results_of = [](const oracle::Balls &balls) {
    BuiltBoundary built(balls);
    const hsp::Boundary &boundary = built.boundary();
    std::multiset<double> results;
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      for (const double coordinate : coordinates(built, v)) results.insert(coordinate);
    }
    for (uint32_t e = 0; e < boundary.half_edge_count(); ++e) {
      const double angle = hsp::angle_of_arc(built.balls(), boundary, e);
      EXPECT_EQ(angle, hsp::angle_of_arc(built.balls(), boundary, boundary.twin(e)));
      results.insert(angle);
    }
    for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
      const hsp::CirclePosition from[2] = {hsp::position_of_circle(built.balls(), boundary.circle(c), 0),
                                           hsp::position_of_circle(built.balls(), boundary.circle(c), 1)};
      double centre[2][3];
      for (int side = 0; side < 2; ++side) hsp::to_coordinates(built.balls(), from[side].centre, centre[side]);
      EXPECT_EQ(from[0].radius, from[1].radius);
      results.insert(from[0].radius);
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(centre[0][k], centre[1][k]);
        results.insert(centre[0][k]);
      }
    }
    return results;
  };
  oracle::Balls balls = scene;
  const auto by_place = [](const oracle::LatticeBall &a, const oracle::LatticeBall &b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  };
  std::sort(balls.begin(), balls.end(), by_place);
  const std::multiset<double> results = results_of(balls);
  EXPECT_EQ(results.size(), 2U * 3 + 6 + 4);
  while (std::next_permutation(balls.begin(), balls.end(), by_place)) EXPECT_EQ(results_of(balls), results);
}

TEST(BoundaryPositions, ACircleFromEitherSide) {
  // A lens whose circle has radius 400 about (300, 0, 0).
  BuiltBoundary built({{0, 0, 0, 500}, {600, 0, 0, 500}});
  ASSERT_EQ(built.boundary().circle_count(), 1U);
  const hsp::CircleRecord &circle = built.boundary().circle(0);
  for (uint32_t side = 0; side < 2; ++side) {
    const hsp::CirclePosition position = hsp::position_of_circle(built.balls(), circle, side);
    double centre[3];
    hsp::to_coordinates(built.balls(), position.centre, centre);
    EXPECT_EQ(centre[0], 300);
    EXPECT_EQ(centre[1], 0);
    EXPECT_EQ(centre[2], 0);
    EXPECT_EQ(position.radius, 400);
    const double towards_other = built.balls().x[circle.ball[1 - side]] > 0 ? 1 : -1;
    EXPECT_EQ(position.axis.x, towards_other);
    EXPECT_EQ(position.axis.y, 0);
    EXPECT_EQ(position.axis.z, 0);
  }
}

}  // namespace
