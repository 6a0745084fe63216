#include "mesh/sphere_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "carved_memory.hpp"
#include "core/elementary.hpp"
#include "random_balls.hpp"

namespace {

using hsp::SphereTriangulation;

hsp::Vec3 random_vector(oracle::RandomSource &random) {
  const auto part = [&] { return static_cast<double>(random.in(-1000, 1000)) + 0.25; };
  return {part(), part(), part()};
}

// Neighbours know each other, all triangles run counter-clockwise, and there are 2 n - 4.
void expect_sound(const SphereTriangulation &sphere, uint32_t removed = 0) {
  ASSERT_EQ(sphere.triangle_count(), 2 * (sphere.point_count() - removed) - 4);
  for (uint32_t t = 0; t < sphere.triangle_count(); ++t) {
    const hsp::SphereTriangle &one = sphere.triangle(t);
    EXPECT_GT(hsp::orientation(sphere.point(one.point[0]), sphere.point(one.point[1]), sphere.point(one.point[2])), 0);
    for (uint32_t e = 0; e < 3; ++e) {
      const hsp::SphereTriangle &other = sphere.triangle(one.neighbour[e]);
      const uint32_t back = other.edge_towards(t);
      ASSERT_EQ(other.neighbour[back], t);
      EXPECT_EQ(other.point[hsp::next_corner(back)], one.point[hsp::previous_corner(e)]);
      EXPECT_EQ(other.point[hsp::previous_corner(back)], one.point[hsp::next_corner(e)]);
      EXPECT_EQ(other.fixed[back], one.fixed[e]);
    }
  }
}

// No point from this one on lies in a triangle's circle, unless points are so near each other that rounding decides.
void expect_delaunay(const SphereTriangulation &sphere, uint32_t first = 0) {
  for (uint32_t t = 0; t < sphere.triangle_count(); ++t) {
    const uint32_t *const c = sphere.triangle(t).point;
    for (uint32_t p = first; p < sphere.point_count(); ++p) {
      EXPECT_LE(hsp::height_above(sphere.point(c[0]), sphere.point(c[1]), sphere.point(c[2]), sphere.point(p)), 0);
    }
  }
}

TEST(SphereTriangulation, StartsAsAnOctahedronInEveryTurn) {
  CarvedMemory memory;
  SphereTriangulation sphere;
  memory.carve(sphere, 6U);
  for (uint32_t turn = 0; turn < SphereTriangulation::octahedron_turns; ++turn) {
    sphere.start(turn);
    EXPECT_EQ(sphere.point_count(), 6U);
    expect_sound(sphere);
    expect_delaunay(sphere);
  }
}

TEST(SphereTriangulation, IsDelaunaysForAnyPoints) {
  CarvedMemory memory;
  SphereTriangulation sphere;
  memory.carve(sphere, 206U);
  for (int turn = 0; turn < 10; ++turn) {
    oracle::RandomSource random(static_cast<uint64_t>(turn) + 1);
    sphere.start(0);
    for (int k = 0; k < 200; ++k) sphere.insert(hsp::rounded(random_vector(random)));
    EXPECT_GT(sphere.point_count(), 190U);
    expect_sound(sphere);
    expect_delaunay(sphere);
  }
}

// Points on edges and on other points: of a grid of small integers.
TEST(SphereTriangulation, TakesPointsThatCoincideOrLieOnEdges) {
  CarvedMemory memory;
  SphereTriangulation sphere;
  memory.carve(sphere, 200U);
  sphere.start(0);
  std::map<std::pair<int, std::pair<int, int>>, uint32_t> known;
  for (int round = 0; round < 2; ++round) {
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != 2) continue;
          const hsp::Vec3 place{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          const uint32_t p = sphere.insert(hsp::rounded(place));
          const auto [at, fresh] = known.insert({{x, {y, z}}, p});
          EXPECT_EQ(at->second, p);
          EXPECT_EQ(fresh, round == 0);
        }
      }
    }
  }
  expect_sound(sphere);
}

// The sides of a triangle of far points become edges among any points, and stay when edges are restored.
TEST(SphereTriangulation, FixesEdges) {
  CarvedMemory memory;
  SphereTriangulation sphere;
  memory.carve(sphere, 400U);
  int fixed = 0;
  for (int turn = 0; turn < 50; ++turn) {
    oracle::RandomSource random(static_cast<uint64_t>(turn) + 100);
    sphere.start(0);
    uint32_t corner[3];
    const hsp::Vec3 corners[3] = {{1, 0.1, 0.2}, {0.3, 1, 0.1}, {0.2, 0.3, 1}};
    for (int k = 0; k < 150; ++k) sphere.insert(hsp::rounded(random_vector(random)));
    for (int k = 0; k < 3; ++k) corner[k] = sphere.insert(hsp::rounded(corners[k]));
    for (int k = 0; k < 3; ++k) {
      uint32_t obstacle = hsp::no_id;
      if (sphere.fix_edge(corner[k], corner[(k + 1) % 3], obstacle)) ++fixed;
      expect_sound(sphere);
    }
    sphere.restore_all();
    expect_sound(sphere);
    for (int k = 0; k < 3; ++k) {
      hsp::TriangleEdge found{};
      EXPECT_TRUE(sphere.find_edge(corner[k], corner[(k + 1) % 3], found));
      EXPECT_TRUE(sphere.triangle(found.triangle).fixed[found.edge]);
    }
  }
  EXPECT_EQ(fixed, 150);
}

// The corners that it begins with, and more, among any points and beside a fixed edge.
TEST(SphereTriangulation, TakesPointsAway) {
  CarvedMemory memory;
  SphereTriangulation sphere;
  memory.carve(sphere, 100U);
  for (int turn = 0; turn < 50; ++turn) {
    oracle::RandomSource random(static_cast<uint64_t>(turn) + 200);
    sphere.start(static_cast<uint32_t>(turn) % SphereTriangulation::octahedron_turns);
    for (int k = 0; k < 60; ++k) sphere.insert(hsp::rounded(random_vector(random)));
    uint32_t obstacle = hsp::no_id;
    ASSERT_TRUE(sphere.fix_edge(40, 50, obstacle));
    for (uint32_t p = 0; p < 30; ++p) {
      ASSERT_TRUE(sphere.remove(p));
      expect_sound(sphere, p + 1);
    }
    hsp::TriangleEdge found{};
    ASSERT_TRUE(sphere.find_edge(40, 50, found));
    EXPECT_TRUE(sphere.triangle(found.triangle).fixed[found.edge]);
    for (uint32_t p = 30; p < sphere.point_count(); ++p) {
      const hsp::SphereTriangle &one = sphere.triangle(sphere.triangle_at(p));
      EXPECT_EQ(one.point[one.corner_of(p)], p);
    }
    EXPECT_EQ(sphere.insert(sphere.point(45)), 45U);
  }
  sphere.start(0);
  for (int k = 0; k < 60; ++k) sphere.insert(hsp::rounded({std::cos(k), std::sin(k), std::sin(7.0 * k)}));
  for (uint32_t p = 0; p < 6; ++p) ASSERT_TRUE(sphere.remove(p));
  sphere.restore_all();
  expect_sound(sphere, 6);
  expect_delaunay(sphere, 6);
}

// Without one of its corners an octahedron's triangles would have a diameter as an edge, and without the only point of
// its half of the sphere there would be a triangle larger than that.
TEST(SphereTriangulation, KeepsPointsThatAreNeeded) {
  CarvedMemory memory;
  SphereTriangulation sphere;
  memory.carve(sphere, 9U);
  sphere.start(3);
  EXPECT_FALSE(sphere.remove(2));
  expect_sound(sphere);
  const auto corner = [](uint32_t k) { return SphereTriangulation::octahedron_corner(3, k); };
  for (int k = 0; k < 3; ++k) {
    const double angle = 0.3 + 2 * hsp::pi * k / 3;
    const hsp::Vec3 level = hsp::combine(std::cos(angle), corner(2), std::sin(angle), corner(4));
    sphere.insert(hsp::rounded(hsp::combine(1.0, level, -0.3, corner(0))));
  }
  for (uint32_t p = 2; p < 6; ++p) EXPECT_TRUE(sphere.remove(p));
  EXPECT_FALSE(sphere.remove(0));
  expect_sound(sphere, 4);
}

// An edge that would cross a fixed one, or run through a point, names what is in its way.
TEST(SphereTriangulation, NamesObstacles) {
  CarvedMemory memory;
  SphereTriangulation sphere;
  memory.carve(sphere, 20U);
  sphere.start(0);
  const uint32_t west = sphere.insert(hsp::rounded({-0.2, 0, 1}));
  const uint32_t east = sphere.insert(hsp::rounded({0.2, 0, 1}));
  const uint32_t south = sphere.insert(hsp::rounded({0, -0.2, 1}));
  const uint32_t north = sphere.insert(hsp::rounded({0, 0.2, 1}));
  uint32_t obstacle = hsp::no_id;
  EXPECT_TRUE(sphere.fix_edge(west, east, obstacle));
  EXPECT_FALSE(sphere.fix_edge(south, north, obstacle));
  EXPECT_TRUE(obstacle == west || obstacle == east);
  const uint32_t middle = sphere.insert(hsp::rounded({0, 0.4, 1}));
  const uint32_t beyond = sphere.insert(hsp::rounded({0, 0.6, 1}));
  EXPECT_FALSE(sphere.fix_edge(north, beyond, obstacle));
  EXPECT_EQ(obstacle, middle);
}

}  // namespace
