#include "mesh/mesh_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_boundary.hpp"
#include "built_mesh.hpp"
#include "built_surface.hpp"
#include "lattice_lengths.hpp"
#include "mesh/mesh_sizes.hpp"
#include "random_balls.hpp"
#include "sweep_length.hpp"
#include "tied_families.hpp"

namespace {

TEST(MeshBuilder, ExpectedLimitsSufficeForRandomSets) {
  int closed = 0, refined = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    oracle::RandomSource random(seed);
    const BuiltBoundary built(seed % 2 == 0 ? oracle::loose_balls(random, 30) : oracle::dense_balls(random, 20));
    const double edge = 0.4 * static_cast<double>(built.balls().largest_radius);
    const BuiltMesh mesh(edge, built.balls(), built.boundary());
    if (mesh.status() != hsp::Status::ok) continue;
    if (mesh.is_closed()) ++closed;
    if (mesh.mesh().refined_count() > 0) ++refined;
    EXPECT_EQ(mesh.euler(), built.boundary().euler());
  }
  EXPECT_EQ(closed, 60);
  EXPECT_GT(refined, 0);
}

// Balls that touch, spheres through common points and circles, balls that are points: there is a mesh of every one.
TEST(MeshBuilder, BoundariesOfDegenerateSets) {
  int more_room = 0;
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    oracle::RandomSource random(seed);
    const BuiltBoundary built(oracle::degenerate_balls(random, 3 + seed % 14));
    const double largest = static_cast<double>(built.balls().largest_radius);
    const BuiltMesh mesh(0.5 * std::max(largest, 1.0), built.balls(), built.boundary());
    ASSERT_EQ(mesh.status(), hsp::Status::ok) << seed;
    EXPECT_TRUE(mesh.is_closed()) << seed;
    EXPECT_EQ(mesh.euler(), built.boundary().euler()) << seed;
    more_room += mesh.retries() > 0 ? 1 : 0;
  }
  EXPECT_LE(more_room, 20);
}

// Two balls that are points, and one that both lie on: their circles have no length on either side.
TEST(MeshBuilder, PointsOnABall) {
  const BuiltBoundary built(oracle::Balls{{1, 0, 0, 0}, {0, 2, 0, 2}, {0, 0, 0, 0}, {2, 2, 0, 0}, {4, 2, 0, 2}});
  const BuiltMesh mesh(1.0, built.balls(), built.boundary());
  ASSERT_EQ(mesh.status(), hsp::Status::ok);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.euler(), built.boundary().euler());
}

// Spheres through one point: where a curve has too many points, others that wanted more of them do not get them later.
TEST(MeshBuilder, SpheresThroughOnePoint) {
  support::BallList points;
  points.add(0, -3, 0, 0);
  points.add(-2, 2, 1, 0);
  points.add(-3, 0, 0, 0);
  points.add(0, 3, 0, 0);
  points.add(2, -2, 1, 0);
  const BuiltSurface built(points, 3, 0);
  const double edge = 0.7 * static_cast<double>(built.balls().largest_radius);
  const BuiltMesh boundary(edge, built.balls(), built.boundary());
  const BuiltMesh smooth(edge, built.balls(), built.boundary(), &built.surface());
  EXPECT_EQ(boundary.status(), hsp::Status::ok);
  EXPECT_EQ(smooth.status(), hsp::Status::ok);
  EXPECT_TRUE(boundary.is_closed());
  EXPECT_TRUE(smooth.is_closed());
}

TEST(MeshBuilder, NamesWhatSuffices) {
  oracle::RandomSource random(3);
  const BuiltBoundary built(oracle::loose_balls(random, 10));
  const double edge = 0.5 * static_cast<double>(built.balls().largest_radius);
  const BuiltMesh reference(edge, built.balls(), built.boundary());
  ASSERT_EQ(reference.status(), hsp::Status::ok);
  const hsp::MeshLimits exact = reference.builder().needed();
  uint32_t hsp::MeshLimits::*const all[] = {&hsp::MeshLimits::balls, &hsp::MeshLimits::curves,
                                            &hsp::MeshLimits::vertices, &hsp::MeshLimits::triangles,
                                            &hsp::MeshLimits::points};
  for (const auto limit : all) {
    hsp::MeshLimits limits = exact;
    --(limits.*limit);
    CarvedMemory memory;
    hsp::MeshBuilder builder;
    memory.carve(builder, limits);
    EXPECT_EQ(builder.build({built.balls(), built.boundary()}, edge), hsp::Status::capacity);
    EXPECT_GT(builder.retry_limits().*limit, limits.*limit);
  }
}

// Balls that touch in a point: the circle between them has no length, and still there is one surface.
TEST(MeshBuilder, BallsThatTouch) {
  const BuiltBoundary built(oracle::Balls{{0, 0, 0, 1000}, {1500, 0, 2000, 1500}});
  const BuiltMesh mesh(300.0, built.balls(), built.boundary());
  ASSERT_EQ(mesh.status(), hsp::Status::ok);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.euler(), 2);
}

TEST(MeshBuilder, EdgesTooShortForAnyLimit) {
  const BuiltBoundary built(oracle::Balls{{0, 0, 0, 1000}, {1500, 0, 1000, 1500}});
  hsp::MeshLimits limits;
  EXPECT_EQ(hsp::expected_mesh_limits({built.balls(), built.boundary()}, 1e-3, limits), hsp::Status::range);
}

// The points of a few hundred spheres would take minutes to count one by one, and those of the saddles of a row.
TEST(MeshBuilder, TooManyPointsAreSeenBeforeAnyIsMade) {
  const hsp::MeshLimits few = {1000, 20000, 100, 100, 100};
  CarvedMemory memory;
  hsp::MeshBuilder builder;
  memory.carve(builder, few);
  oracle::RandomSource random(5);
  const oracle::Balls loose = oracle::loose_balls(random, 300);
  const BuiltBoundary built(loose);
  const double edge = 3e-4 * static_cast<double>(built.balls().largest_radius);
  EXPECT_EQ(builder.build({built.balls(), built.boundary()}, edge), hsp::Status::range);
  const BuiltSurface smooth(oracle::in_lengths(loose, 1), 2.0);
  ASSERT_EQ(smooth.status(), hsp::Status::ok);
  memory.carve(builder, hsp::MeshLimits{100000, 100000, 100, 100, 100});
  EXPECT_EQ(builder.build({smooth.balls(), smooth.boundary(), &smooth.surface()}, edge), hsp::Status::range);
  support::BallList row;
  for (int k = 0; k < 40; ++k) row.add(280.0 * k, 0, 0, 10);
  const BuiltSurface saddles(row, 1000.0);
  ASSERT_EQ(saddles.status(), hsp::Status::ok);
  EXPECT_EQ(builder.build({saddles.balls(), saddles.boundary(), &saddles.surface()}, 0.06), hsp::Status::range);
}

// Spheres with few points do not count, however many there are, nor does what is covered.
TEST(MeshBuilder, PointsInsidePatches) {
  const double spacing = std::sqrt(14.6 / hsp::max_count);
  hsp::PointsInside points;
  points.add(4 * hsp::pi, 1.01 * spacing);
  EXPECT_FALSE(points.are_too_many());
  points.add(0.1 * 4 * hsp::pi, spacing);
  EXPECT_TRUE(points.are_too_many());
  hsp::PointsInside others;
  for (int k = 0; k < 4; ++k) others.add(hsp::pi / 4.04, spacing);
  for (const double s : {2.0, 0.2}) others.add(1e12, s);
  others.add(0.0, 0.0);
  EXPECT_FALSE(others.are_too_many());
}

// Of the surface as a map: corners less edges, and every patch as a sphere with holes.
int64_t euler_of(const BuiltSurface &built) {
  const hsp::SurfaceMap map(built.balls(), built.boundary(), built.surface());
  int64_t faces_and_holes = 0;
  for (uint32_t p = 0; p < map.patch_count(); ++p) {
    int64_t loops = 0;
    map.for_each_loop(p, [&](uint32_t) { ++loops; });
    faces_and_holes += 2 - loops;
  }
  int64_t edges = 0;
  for (uint32_t e = 0; e < map.edge_count(); ++e) edges += map.origin(2 * e) != hsp::no_id ? 1 : 0;
  int64_t corners = 0;
  for (uint32_t c = 0; c < map.corner_count(); ++c) corners += map.shell_of_corner(c) != hsp::no_id ? 1 : 0;
  return corners - edges + faces_and_holes;
}

// Sets of all families with ties: nearly all have a mesh, which is closed, has one ring around a vertex, and the
// Euler number of the surface.
TEST(MeshBuilder, SmoothSurfacesOfTiedFamilies) {
  uint32_t sets = 0, refused = 0;
  for (const support::TiedFamily &family : support::tied_families) {
    SCOPED_TRACE(family.name);
    for (int k = 0; k < oracle::rounds(6, 1000); ++k) {
      SCOPED_TRACE(k);
      const support::TiedSet set = family.member(static_cast<uint64_t>(k));
      const BuiltSurface built(set.balls, set.probe, 0.0);
      ASSERT_EQ(built.status(), hsp::Status::ok);
      const BuiltMesh mesh(0.3 * static_cast<double>(built.balls().probe_steps), built.balls(), built.boundary(),
                           &built.surface());
      ++sets;
      if (mesh.status() != hsp::Status::ok) {
        ASSERT_EQ(mesh.status(), hsp::Status::degenerate);
        ++refused;
        continue;
      }
      EXPECT_TRUE(mesh.is_closed());
      EXPECT_EQ(mesh.euler(), euler_of(built));
    }
  }
  EXPECT_LE(refused, sets / 100);
}

TEST(MeshBuilder, SmoothSurfacesOfRandomSets) {
  int closed = 0, refined = 0, more_room = 0, cusped = 0, cut = 0;
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    oracle::RandomSource random(seed);
    const oracle::Balls set = seed % 4 == 0   ? oracle::degenerate_balls(random, 12)
                              : seed % 4 == 1 ? oracle::dense_balls(random, 10)
                              : seed % 4 == 2 ? oracle::loose_balls(random, 30)
                                              : oracle::clustered_balls(random, 16);
    const support::BallList lengths = oracle::in_lengths(set, 1);
    const double largest = *std::max_element(lengths.radius.begin(), lengths.radius.end());
    const BuiltSurface built(lengths, std::floor(0.3 * largest * static_cast<double>(1 + seed % 5)));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const BuiltMesh mesh(0.3 * largest, built.balls(), built.boundary(), &built.surface());
    if (mesh.retries() > 0) ++more_room;
    ASSERT_EQ(mesh.status(), hsp::Status::ok) << seed;
    if (mesh.is_closed()) ++closed;
    if (mesh.mesh().refined_count() > 0) ++refined;
    EXPECT_EQ(mesh.euler(), euler_of(built)) << seed;
    const hsp::SurfaceMeasure exact = built.total();
    EXPECT_NEAR(mesh.area(), exact.area(), 0.06 * exact.area()) << seed;
    EXPECT_NEAR(mesh.volume(), exact.volume, 0.06 * exact.volume) << seed;
    cusped += built.surface().counts().cusped_arcs > 0 ? 1 : 0;
    cut += built.surface().counts().cut_patches > 0 ? 1 : 0;
  }
  EXPECT_GE(closed, 190);
  EXPECT_LE(more_room, 2);
  EXPECT_GT(refined, 0);
  EXPECT_GT(cusped, 40);
  EXPECT_GT(cut, 40);
}

// Half the edge, a quarter of the error: of a torus with a crease that is a whole circle, of three spindles, and of
// cusps with cut patches between them.
TEST(MeshBuilder, SmoothSurfacesConverge) {
  for (const double circumradius : {2.9, 3.09, 3.2}) {
    support::BallList three;
    for (int k = 0; k < 3; ++k) {
      const double x[] = {1.0, -0.5, -0.5};
      const double y[] = {0.0, 0.8660254037844386, -0.8660254037844386};
      three.add(circumradius * x[k], circumradius * y[k], 0.0, 1.7);
    }
    const BuiltSurface built(three, 1.4, 0.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::SurfaceMeasure exact = built.total();
    double area[3], volume[3];
    for (int k = 0; k < 3; ++k) {
      const double edge = built.balls().lattice.steps(0.4 / (1 << k));
      const BuiltMesh mesh(edge, built.balls(), built.boundary(), &built.surface());
      ASSERT_EQ(mesh.status(), hsp::Status::ok);
      area[k] = exact.area() - mesh.area();
      volume[k] = exact.volume - mesh.volume();
    }
    for (int k = 0; k < 2; ++k) {
      EXPECT_GT(area[k], 3.0 * area[k + 1]) << circumradius;
      EXPECT_LT(area[k], 6.0 * area[k + 1]) << circumradius;
      EXPECT_GT(volume[k], 3.0 * volume[k + 1]) << circumradius;
      EXPECT_LT(volume[k], 6.0 * volume[k + 1]) << circumradius;
    }
  }
}

// Patches in order, each with its own kind, and balls of which a probe touches one there.
TEST(MeshBuilder, TrianglesOfEachPatch) {
  oracle::RandomSource random(2);
  const support::BallList lengths = oracle::in_lengths(oracle::loose_balls(random, 30), 1);
  const BuiltSurface built(lengths, 300.0);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const BuiltMesh mesh(200.0, built.balls(), built.boundary(), &built.surface());
  ASSERT_EQ(mesh.status(), hsp::Status::ok);
  const hsp::SurfaceMap map(built.balls(), built.boundary(), built.surface());
  uint32_t next = 0;
  for (uint32_t p = 0; p < map.patch_count(); ++p) {
    const hsp::IdRange triangles = mesh.mesh().triangles_of(p);
    EXPECT_EQ(triangles.first, next);
    EXPECT_FALSE(triangles.empty());
    next = triangles.last;
    const hsp::SurfacePatch patch = map.patch(p);
    for (const uint32_t t : triangles) {
      const hsp::MeshTriangle &triangle = mesh.mesh().triangle(t);
      EXPECT_EQ(triangle.kind, patch.kind);
      if (patch.kind == hsp::PatchKind::convex) {
        EXPECT_EQ(triangle.ball, built.boundary().face(patch.source).ball);
      }
      if (patch.kind == hsp::PatchKind::concave) {
        EXPECT_LT(built.boundary().vertex(patch.source).slot_of(triangle.ball), 3U);
      }
    }
  }
  EXPECT_EQ(next, mesh.mesh().triangle_count());
}

// A vertex in the plane of three of its balls' centres that lies on two more spheres: a mesh of its surface is refused,
// or closed.
TEST(MeshBuilder, TiedSurfacesAreRefusedOrClosed) {
  const oracle::Balls balls = {{4, 12, 0, 3},  {8, 6, 0, 3},  {8, 12, 0, 7}, {4, 6, 12, 3},
                               {4, 12, 12, 3}, {8, 0, 12, 3}, {0, 0, 12, 5}, {4, 6, 12, 3}};
  const BuiltSurface built(oracle::in_lengths(balls, 1), 4.0);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const BuiltMesh mesh(5.0, built.balls(), built.boundary(), &built.surface());
  if (mesh.status() == hsp::Status::ok) {
    EXPECT_TRUE(mesh.is_closed());
  } else {
    EXPECT_EQ(mesh.status(), hsp::Status::degenerate);
  }
}

// A void in an octahedron: probes outside and inside overlap, and cusps are corners of both surfaces. With the shells
// chosen one by one each is a sphere, also without a probe.
TEST(MeshBuilder, ChosenShells) {
  for (const double probe : {0.0, 2200.0}) {
    support::BallList six;
    for (const double at : {-3400.0, 3400.0}) {
      six.add(at, 0.0, 0.0, 3100.0 - probe);
      six.add(0.0, at, 0.0, 3100.0 - probe);
      six.add(0.0, 0.0, at, 3100.0 - probe);
    }
    BuiltSurface built(six, probe);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    ASSERT_EQ(built.boundary().shell_count(), 2U);
    for (uint32_t shell = 0; shell < 2; ++shell) {
      ASSERT_EQ(built.choose({shell}), hsp::Status::ok);
      ASSERT_EQ(built.status(), hsp::Status::ok);
      EXPECT_EQ(built.surface().cusped_circles().count() > 0, probe > 0.0);
      const BuiltMesh mesh(100.0, built.balls(), built.boundary(), &built.surface());
      ASSERT_EQ(mesh.status(), hsp::Status::ok);
      EXPECT_TRUE(mesh.is_closed());
      EXPECT_EQ(mesh.euler(), 2);
      EXPECT_EQ(mesh.wrong_normals(), 0U);
      EXPECT_NEAR(mesh.area(), built.total().area(), 0.02 * built.total().area());
    }
  }
}

// Without a probe the smooth surface is the boundary.
TEST(MeshBuilder, WithoutAProbe) {
  oracle::RandomSource random(5);
  const BuiltSurface built(oracle::in_lengths(oracle::loose_balls(random, 12), 1), 0.0);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const BuiltMesh mesh(300.0, built.balls(), built.boundary(), &built.surface());
  ASSERT_EQ(mesh.status(), hsp::Status::ok);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.euler(), built.boundary().euler());
}

}  // namespace
