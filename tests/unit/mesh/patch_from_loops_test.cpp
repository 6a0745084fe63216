// Meshes of surfaces with patches that have no area: closed, and as large as the surface. And patches of any loops: a
// surface with these as its border.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "built_mesh.hpp"
#include "built_surface.hpp"
#include "lattice_lengths.hpp"
#include "random_numbers.hpp"

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

TEST(PatchFromLoops, CloseTheMesh) {
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
                           &built.surface());
      ASSERT_EQ(mesh.status(), hsp::Status::ok);
      EXPECT_TRUE(mesh.is_closed());
      EXPECT_EQ(mesh.euler(), set.euler);
      missing[k] = 1 - mesh.area() / area;
    }
    EXPECT_LT(std::fabs(missing[0]), 0.1);
    EXPECT_LT(std::fabs(missing[1]), 0.4 * std::fabs(missing[0]));
  }
}

// Loops of points anywhere, in any places, also all in one: as many triangles as Euler's formula demands, every edge in
// two of them in opposite directions, but those of the loops; and no edge between two points of the loops but these.
TEST(PatchFromLoops, OfAnyLoops) {
  support::Random random(5);
  for (int turn = 0; turn < 200; ++turn) {
    SCOPED_TRACE(turn);
    hsp::SphericalPatch patch;
    CarvedMemory memory;
    memory.carve(patch, 2000U);
    patch.begin(0.5);
    const uint32_t faces = 1 + random.below(3);
    uint32_t points = 0;
    std::map<std::pair<uint32_t, uint32_t>, int> open;  // directed edges without another one the other way
    int64_t expected = 0;
    for (uint32_t face = 0; face < faces; ++face) {
      const uint32_t loops = 1 + random.below(3);
      expected += 2 - static_cast<int64_t>(loops);
      for (uint32_t loop = 0; loop < loops; ++loop) {
        patch.begin_loop(face);
        const uint32_t count = 2 + random.below(40), places = 1 + random.below(3) * 10;
        for (uint32_t k = 0; k < count; ++k) {
          const double angle = 0.1 * random.below(places);
          patch.add(
              {{std::cos(angle), std::sin(angle), 0.1 * random.below(2)}, points + k, 0, {hsp::no_id, hsp::no_id}});
          open[{points + (k + 1) % count, points + k}] = 1;
        }
        points += count;
      }
    }
    const std::map<std::pair<uint32_t, uint32_t>, int> border = open;
    ASSERT_EQ(patch.triangulate_from_loops(), hsp::PatchState::complete);
    uint32_t vertices = points;
    int64_t triangles = 0;
    patch.emit([&](const hsp::Vec3 &) { return vertices++; },
               [&](uint32_t face, const uint32_t *c) {
                 ++triangles;
                 EXPECT_LT(face, faces);
                 for (int k = 0; k < 3; ++k) {
                   const std::pair<uint32_t, uint32_t> edge(c[k], c[(k + 1) % 3]), back(edge.second, edge.first);
                   EXPECT_NE(edge.first, edge.second);
                   if (edge.first < points && edge.second < points) {
                     EXPECT_EQ(border.count(back), 1U);
                   }
                   if (open.count(back) > 0) {
                     open.erase(back);
                   } else {
                     EXPECT_EQ(open.count(edge), 0U);
                     open[edge] = 1;
                   }
                 }
               });
    EXPECT_TRUE(open.empty());
    const int64_t edges = (3 * triangles + static_cast<int64_t>(points)) / 2;
    EXPECT_EQ(int64_t{vertices} - edges + triangles, expected);
  }
}

TEST(PatchFromLoops, SaysHowMuchRoomItNeeds) {
  hsp::SphericalPatch patch;
  CarvedMemory memory;
  uint32_t room = 8;
  for (int turn = 0; turn < 3; ++turn) {
    memory.carve(patch, room);
    patch.begin(0.5);
    patch.begin_loop(0);
    for (uint32_t k = 0; k < 50; ++k)
      patch.add({{std::cos(0.1 * k), std::sin(0.1 * k), 0}, k, 0, {hsp::no_id, hsp::no_id}});
    if (patch.triangulate_from_loops() == hsp::PatchState::complete) break;
    EXPECT_GT(patch.needed_points(), room);
    room = static_cast<uint32_t>(patch.needed_points());
  }
  EXPECT_GT(room, 8U);
  EXPECT_EQ(patch.needed_points(), room);
}

}  // namespace
