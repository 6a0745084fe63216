#include "mesh/mesh_builder.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "built_boundary.hpp"
#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

struct BuiltMesh {
  BuiltMesh(const BuiltBoundary &built, double edge) {
    hsp::MeshLimits limits;
    EXPECT_EQ(hsp::expected_mesh_limits(built.balls(), built.boundary(), edge, limits), hsp::Status::ok);
    memory.carve(builder, limits);
    status = builder.build(built.balls(), built.boundary(), edge);
  }

  CarvedMemory memory;
  hsp::MeshBuilder builder;
  hsp::Status status;
};

// Every edge in two triangles that run through it in opposite directions.
bool is_closed(const hsp::Mesh &mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const uint32_t *const v = mesh.triangle(t).vertex;
      ++edges[{v[k], v[(k + 1) % 3]}];
    }
  }
  for (const auto &[edge, times] : edges) {
    if (times != 1 || edges.count({edge.second, edge.first}) == 0) return false;
  }
  return true;
}

TEST(MeshBuilder, ExpectedLimitsSufficeForRandomSets) {
  int closed = 0, refined = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    oracle::RandomSource random(seed);
    const BuiltBoundary built(seed % 2 == 0 ? oracle::loose_balls(random, 30) : oracle::dense_balls(random, 20));
    const double edge = 0.4 * static_cast<double>(built.balls().largest_radius);
    const BuiltMesh mesh(built, edge);
    if (mesh.status != hsp::Status::ok) continue;
    const hsp::Mesh &found = mesh.builder.mesh();
    if (is_closed(found)) ++closed;
    if (found.refined_count() > 0) ++refined;
    EXPECT_EQ(int64_t{found.vertex_count()} - found.triangle_count() / 2, built.boundary().euler());
  }
  EXPECT_EQ(closed, 60);
  EXPECT_GT(refined, 0);
}

TEST(MeshBuilder, NamesWhatSuffices) {
  oracle::RandomSource random(3);
  const BuiltBoundary built(oracle::loose_balls(random, 10));
  const double edge = 0.5 * static_cast<double>(built.balls().largest_radius);
  const BuiltMesh reference(built, edge);
  ASSERT_EQ(reference.status, hsp::Status::ok);
  const hsp::MeshLimits exact = reference.builder.needed();
  uint32_t hsp::MeshLimits::*const all[] = {&hsp::MeshLimits::balls, &hsp::MeshLimits::curves,
                                            &hsp::MeshLimits::vertices, &hsp::MeshLimits::triangles,
                                            &hsp::MeshLimits::points};
  for (const auto limit : all) {
    hsp::MeshLimits limits = exact;
    --(limits.*limit);
    CarvedMemory memory;
    hsp::MeshBuilder builder;
    memory.carve(builder, limits);
    EXPECT_EQ(builder.build(built.balls(), built.boundary(), edge), hsp::Status::capacity);
    EXPECT_GT(builder.retry_limits().*limit, limits.*limit);
  }
}

// Balls that touch in a point: the circle between them has no length, and still there is one surface.
TEST(MeshBuilder, BallsThatTouch) {
  const BuiltBoundary built(oracle::Balls{{0, 0, 0, 1000}, {1500, 0, 2000, 1500}});
  const BuiltMesh mesh(built, 300.0);
  ASSERT_EQ(mesh.status, hsp::Status::ok);
  EXPECT_TRUE(is_closed(mesh.builder.mesh()));
  EXPECT_EQ(int64_t{mesh.builder.mesh().vertex_count()} - mesh.builder.mesh().triangle_count() / 2, 2);
}

TEST(MeshBuilder, EdgesTooShortForAnyLimit) {
  const BuiltBoundary built(oracle::Balls{{0, 0, 0, 1000}, {1500, 0, 1000, 1500}});
  hsp::MeshLimits limits;
  EXPECT_EQ(hsp::expected_mesh_limits(built.balls(), built.boundary(), 1e-3, limits), hsp::Status::range);
}

}  // namespace
