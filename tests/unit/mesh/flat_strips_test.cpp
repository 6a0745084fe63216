// Meshes of surfaces with patches that have no area: closed, and as large as the surface.
#include "mesh/flat_strips.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_mesh.hpp"
#include "built_surface.hpp"
#include "lattice_lengths.hpp"

namespace {

struct Touching {
  oracle::Balls balls;  // with the probe
  double probe;
  int64_t euler;
};

// Strips with both borders on sides, with creases, and rings.
const Touching sets[] = {{{{0, 0, 0, 50}, {80, 40, 0, 50}, {80, -40, 0, 50}}, 20, 0},
                         {{{0, 0, 0, 50}, {80, 40, 0, 50}, {80, -40, 0, 50}}, 40, 6},
                         {{{0, 0, 0, 50}, {80, 40, 0, 50}, {50, 50, 0, 50}}, 20, 2},
                         {{{-30, 0, 0, 50}, {30, 0, 0, 50}, {0, 90, 0, 50}}, 30, 4},
                         {{{60, 80, 0, 100}, {60, -80, 0, 100}, {-60, 80, 0, 100}, {-60, -80, 0, 100}}, 20, 0},
                         {{{60, 80, 0, 100}, {60, -80, 0, 100}, {-60, 80, 0, 100}, {-60, -80, 0, 100}}, 70, 4}};

TEST(FlatStrips, CloseTheMesh) {
  for (const Touching &set : sets) {
    SCOPED_TRACE(set.probe);
    oracle::Balls balls = set.balls;
    for (oracle::LatticeBall &ball : balls) ball.radius -= static_cast<int64_t>(set.probe);
    const BuiltSurface built(oracle::in_lengths(balls, 1), set.probe);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const double area = built.total().area();
    double missing[2];
    for (int k = 0; k < 2; ++k) {
      const BuiltMesh mesh(0.1 * static_cast<double>(set.balls[0].radius) / (k + 1), built.balls(), built.boundary(),
                           built.surface());
      ASSERT_EQ(mesh.status(), hsp::Status::ok);
      EXPECT_TRUE(mesh.is_closed());
      EXPECT_EQ(mesh.euler(), set.euler);
      missing[k] = 1 - mesh.area() / area;
    }
    EXPECT_LT(std::fabs(missing[0]), 0.1);
    EXPECT_LT(std::fabs(missing[1]), 0.4 * std::fabs(missing[0]));
  }
}

}  // namespace
