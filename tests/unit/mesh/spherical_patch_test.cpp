#include "mesh/spherical_patch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "carved_memory.hpp"
#include "mesh/mesh_curve.hpp"
#include "mesh/ring_points.hpp"

namespace {

const auto everywhere = [](double, double) { return true; };

using hsp::PatchState;
using hsp::SphericalPatch;
using hsp::Vec3;

struct Triangles {
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> corners;
  std::vector<uint32_t> faces;

  double area() const {
    double sum = 0.0;
    for (const auto &c : corners) {
      const Vec3 normal = cross(vertices[c[1]] - vertices[c[0]], vertices[c[2]] - vertices[c[0]]);
      sum += 0.5 * std::sqrt(dot(normal, normal)) * (dot(normal, vertices[c[0]]) >= 0.0 ? 1.0 : -1.0);
    }
    return sum;
  }
};

// A circle of so many points about the z axis, of a cap with this cosine that the patch lies outside of (south: below).
void add_circle(SphericalPatch &patch, Triangles &triangles, double cosine, uint32_t points, bool south,
                uint32_t face) {
  const double sine = std::sqrt(1.0 - cosine * cosine);
  patch.begin_loop(face);
  for (uint32_t k = 0; k < points; ++k) {
    // The patch lies to the left: clockwise about the cap's axis.
    const double angle = (south ? 1 : -1) * 2 * hsp::pi * k / points;
    const Vec3 place{sine * std::cos(angle), sine * std::sin(angle), south ? -cosine : cosine};
    patch.add({place, static_cast<uint32_t>(triangles.vertices.size()), south ? 1U : 0U, {hsp::no_id, hsp::no_id}});
    triangles.vertices.push_back(place);
  }
}

void emit(SphericalPatch &patch, Triangles &triangles) {
  patch.emit(
      [&](const Vec3 &direction) {
        triangles.vertices.push_back(1.0 / std::sqrt(dot(direction, direction)) * direction);
        return static_cast<uint32_t>(triangles.vertices.size() - 1);
      },
      [&](uint32_t face, const uint32_t *c) {
        triangles.corners.push_back({c[0], c[1], c[2]});
        triangles.faces.push_back(face);
      });
}

TEST(SphericalPatch, AWholeSphere) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 3000U);
  for (const double spacing : {10.0, 0.5, 0.1}) {
    Triangles triangles;
    patch.begin(spacing);
    ASSERT_EQ(patch.triangulate(), PatchState::complete);
    emit(patch, triangles);
    EXPECT_EQ(triangles.corners.size(), 2 * triangles.vertices.size() - 4);
    if (spacing < 1.0) {
      EXPECT_NEAR(triangles.area(), 4 * hsp::pi, 4 * spacing * spacing);
    }
  }
}

TEST(SphericalPatch, ABeltBetweenTwoCircles) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 3000U);
  Triangles triangles;
  patch.begin(0.1);
  patch.keep_off({0, 0, 1}, 0.5);
  patch.keep_off({0, 0, -1}, 0.8);
  add_circle(patch, triangles, 0.5, 54, false, 0);
  add_circle(patch, triangles, 0.8, 38, true, 0);
  ASSERT_EQ(patch.triangulate(), PatchState::complete);
  emit(patch, triangles);
  EXPECT_NEAR(triangles.area(), 2 * hsp::pi * 1.3, 0.05);
  // V - E + T = 0 with E = (3 T + B) / 2.
  EXPECT_EQ(2 * triangles.vertices.size(), triangles.corners.size() + 92);
}

TEST(SphericalPatch, TwoFacesOfOneSphere) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 3000U);
  Triangles triangles;
  patch.begin(0.2);
  // Small faces around the poles.
  add_circle(patch, triangles, -0.6, 26, false, 0);
  add_circle(patch, triangles, -0.7, 24, true, 1);
  ASSERT_EQ(patch.triangulate(), PatchState::complete);
  emit(patch, triangles);
  EXPECT_NEAR(triangles.area(), 2 * hsp::pi * 0.7, 0.1);
  for (size_t t = 0; t < triangles.corners.size(); ++t) {
    EXPECT_EQ(triangles.vertices[triangles.corners[t][0]].z < 0 ? 0U : 1U, triangles.faces[t]);
  }
}

// Two circles so near each other that their chords cross: both are named, and with more points all is well.
TEST(SphericalPatch, NamesCurvesThatAreTooCoarse) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 3000U);
  for (const uint32_t points : {6U, 400U}) {
    Triangles triangles;
    patch.begin(0.5);
    add_circle(patch, triangles, 0.30, points, false, 0);
    add_circle(patch, triangles, -0.29, points + 1, true, 0);
    const PatchState state = patch.triangulate();
    if (points == 400) {
      EXPECT_EQ(state, PatchState::complete);
      continue;
    }
    ASSERT_EQ(state, PatchState::too_coarse);
    bool named[2] = {false, false};
    patch.for_each_coarse_curve([&](uint32_t curve) { named[curve] = true; });
    EXPECT_TRUE(named[0] || named[1]);
  }
}

// Chords of half circles that lie the wrong way around leave all of the sphere on their left, most of it covered. The
// longest ones are named.
TEST(SphericalPatch, NamesTheLongestBorders) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 100U);
  patch.begin(2.0);
  patch.keep_off({-2 / std::sqrt(5.0), 1 / std::sqrt(5.0), 0}, -1 / std::sqrt(5.0));
  patch.keep_off({3 / std::sqrt(26.0), -1 / std::sqrt(26.0), 4 / std::sqrt(26.0)}, 1 / std::sqrt(26.0));
  patch.keep_off({1 / std::sqrt(6.0), -2 / std::sqrt(6.0), 1 / std::sqrt(6.0)}, 2 / std::sqrt(6.0));
  patch.begin_loop(0);
  const Vec3 place[] = {{0, -1, 0}, {64.0 / 81, 47.0 / 81, -16.0 / 81}, {14.0 / 75, -73.0 / 75, -10.0 / 75}};
  for (uint32_t p = 0; p < 3; ++p) patch.add({place[p], p, p, {hsp::no_id, hsp::no_id}});
  ASSERT_EQ(patch.triangulate(), PatchState::too_coarse);
  std::vector<uint32_t> named;
  patch.for_each_coarse_curve([&](uint32_t curve) { named.push_back(curve); });
  EXPECT_EQ(named, (std::vector<uint32_t>{0, 1}));
}

TEST(SphericalPatch, SaysHowManyPointsItNeeds) {
  for (uint32_t room = 6;; ++room) {
    CarvedMemory memory;
    SphericalPatch patch;
    memory.carve(patch, room);
    Triangles triangles;
    patch.begin(0.6);
    add_circle(patch, triangles, 0.5, 9, false, 0);
    const PatchState state = patch.triangulate();
    EXPECT_EQ(state == PatchState::capacity, patch.needed_points() > room) << room;
    if (state == PatchState::capacity) continue;
    EXPECT_EQ(patch.needed_points(), room);
    break;
  }
}

// Polygons around any direction, between great circles or near them: no point of theirs is left out with the circles of
// latitude that meet none.
TEST(SphericalPatch, HasAllPointsOfAPatchFarSmallerThanItsSphere) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 20000U);
  const double spacing = 0.01;
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    const double height = k % 6 == 0 ? 1.0 : std::cos(1.0 + 7.0 * k), angle = 2.4 * k;
    const double across = std::sqrt(1.0 - height * height), size = 0.02 * (1 + k % 8);
    const Vec3 centre{across * std::cos(angle), across * std::sin(angle), height};
    const Vec3 east{-std::sin(angle), std::cos(angle), 0.0}, north = cross(centre, east);
    std::vector<std::pair<Vec3, double>> caps{{-centre, 0.2}};
    const int sides = 3 + k % 5;
    for (int side = 0; side < sides; ++side) {
      const double turn = 2 * hsp::pi * (side + 0.3) / sides;
      caps.push_back({std::cos(turn) * east + std::sin(turn) * north, std::sin(size)});
    }
    patch.begin(spacing);
    for (const auto &[axis, cosine] : caps) patch.keep_off(axis, cosine);
    static_cast<void>(patch.triangulate());
    uint64_t points = 0;
    hsp::for_each_ring_point(spacing, everywhere, [&](const Vec3 &p) {
      bool near = false;
      for (const auto &[axis, cosine] : caps) near = near || dot(p, axis) > std::cos(std::acos(cosine) + 0.6 * spacing);
      points += near ? 0 : 1;
    });
    const uint64_t corners = 6;  // of the octahedron, of which one in the patch keeps some points away
    EXPECT_LE(patch.needed_points(), points + corners);
    EXPECT_GE(patch.needed_points() + 8, points + corners);
    EXPECT_GT(points, 4U);
  }
}

// Around a cap of any direction and size, with a border of few points: no point lies between a chord and its arc, such
// as those that the triangulation begins with.
TEST(SphericalPatch, KeepsNoPointInACap) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 300U);
  for (int k = 0; k < 300; ++k) {
    const double cosine = 0.2 + 0.002 * k, sine = std::sqrt(1.0 - cosine * cosine);
    const Vec3 axis = hsp::unit({std::cos(k), std::sin(3.0 * k), std::cos(7.0 * k)}, {0, 0, 1});
    const Vec3 u = hsp::perpendicular_to(axis), v = cross(axis, u);
    patch.begin(1.0);
    patch.keep_off(axis, cosine);
    patch.begin_loop(0);
    for (uint32_t p = 0; p < 4; ++p) {
      const double angle = -2 * hsp::pi * p / 4;
      patch.add({cosine * axis + sine * hsp::combine(std::cos(angle), u, std::sin(angle), v), p, 0, {7, hsp::no_id}});
    }
    ASSERT_EQ(patch.triangulate(), PatchState::complete);
    uint32_t added = 0, triangles = 0;
    patch.emit(
        [&](const Vec3 &direction) {
          EXPECT_LE(dot(direction, axis), (cosine + 1e-15) * std::sqrt(dot(direction, direction))) << k;
          return 4 + added++;
        },
        [&](uint32_t, const uint32_t *) { ++triangles; });
    EXPECT_EQ(triangles, 2 * added + 2);
  }
}

// Such an edge is divided in its middle, or nearer to an end if a further cap covers that; at the end if all of it is
// covered.
TEST(SphericalPatch, DividesEdgesWhereTheyAreFree) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 100U);
  const double half = 0.1;  // of the edge, as an angle from its middle
  const double covered[] = {0.0, 0.1, 0.6, 1.1}, from_middle[] = {0.0, 0.5, 0.75, 1.0};
  for (int k = 0; k < 4; ++k) {
    patch.begin(2.0);
    patch.keep_off({0, 0, 1}, -0.98);
    if (k > 0) patch.keep_off({0, 0, -1}, std::cos(covered[k] * half));
    patch.begin_loop(0);
    const double x[] = {0.2, 0, -0.2, 0}, y[] = {0, -1, 0, 1};
    for (uint32_t p = 0; p < 4; ++p) {
      patch.add({{x[p], y[p] * std::sin(half), -std::cos(half)}, p, 0, {7, hsp::no_id}});
    }
    ASSERT_EQ(patch.triangulate(), PatchState::complete);
    uint32_t added = 0;
    patch.emit(
        [&](const Vec3 &direction) {
          EXPECT_NEAR(std::atan2(std::hypot(direction.x, direction.y), -direction.z), from_middle[k] * half, 1e-3);
          return 4 + added++;
        },
        [&](uint32_t, const uint32_t *) {});
    EXPECT_EQ(added, 1U);
  }
}

// An edge between border points that another patch may join as well is divided.
TEST(SphericalPatch, DividesEdgesThatMayBeElsewhere) {
  CarvedMemory memory;
  SphericalPatch patch;
  memory.carve(patch, 100U);
  for (const bool elsewhere : {false, true}) {
    patch.begin(2.0);
    patch.keep_off({0, 0, 1}, -0.98);
    patch.begin_loop(0);
    const uint32_t other = elsewhere ? 7U : hsp::no_id;
    for (uint32_t k = 0; k < 5; ++k) {
      const double angle = -2 * hsp::pi * k / 5;
      patch.add({{0.2 * std::cos(angle), 0.2 * std::sin(angle), -0.98}, k, 0, {other, hsp::no_id}});
    }
    ASSERT_EQ(patch.triangulate(), PatchState::complete);
    uint32_t added = 0, triangles = 0, across = 0;
    patch.emit([&](const Vec3 &) { return 5 + added++; },
               [&](uint32_t, const uint32_t *c) {
                 ++triangles;
                 for (int k = 0; k < 3; ++k) {
                   const uint32_t a = c[k], b = c[(k + 1) % 3];
                   if (a < 5 && b < 5 && (a + 1) % 5 != b) ++across;
                 }
               });
    EXPECT_EQ(triangles, 3 + 2 * added);
    EXPECT_EQ(across, elsewhere ? 0U : 4U);
  }
}

}  // namespace
