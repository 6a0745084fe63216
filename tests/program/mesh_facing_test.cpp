// The contour of a torus and of two balls, known on paper: after the split the edges between what faces the viewer and
// what turns away are on it, and nothing else of the surface has changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

extern "C" {
#include "draw/mesh_facing.h"
#include "hardsphere.h"
}

namespace {

constexpr double wide = 3;  // of the circle of the tube's middles; the tube's radius is 1

// Freed as the program does it, since a split makes arrays of its own.
struct Mesh {
  Mesh(uint32_t vertices, uint32_t triangles) {
    failure failure{};
    EXPECT_TRUE(triangle_mesh_make(&mesh, vertices, triangles, &failure));
  }
  Mesh(const Mesh &) = delete;
  Mesh &operator=(const Mesh &) = delete;
  ~Mesh() { triangle_mesh_free(&mesh); }

  void split(const mesh_view &view, const molecule &molecule, uint8_t **marks = nullptr) {
    failure failure{};
    EXPECT_TRUE(mesh_facing_split(&mesh, &view, &molecule, marks, &failure));
  }
  // Of each edge how often it is there the one way and the other.
  [[nodiscard]] std::map<std::pair<uint32_t, uint32_t>, int> edges() const {
    std::map<std::pair<uint32_t, uint32_t>, int> found;
    for (size_t k = 0; k < 3 * size_t{mesh.triangles}; ++k) {
      ++found[{mesh.corners[k], mesh.corners[k % 3 == 2 ? k - 2 : k + 1]}];
    }
    return found;
  }

  triangle_mesh mesh{};
};

// A torus of saddles around the third axis, seen along (0, sin, cos) of an angle.
void make_torus(triangle_mesh &mesh, uint32_t around, uint32_t across) {
  for (uint32_t i = 0; i < around; ++i) {
    for (uint32_t k = 0; k < across; ++k) {
      const size_t v = size_t{i} * across + k;
      const double turn = 2 * M_PI * (i + 0.3) / around, lean = 2 * M_PI * (k + 0.4) / across;
      const std::array<double, 3> normal{std::cos(lean) * std::cos(turn), std::cos(lean) * std::sin(turn),
                                         std::sin(lean)};
      const std::array<double, 3> middle{wide * std::cos(turn), wide * std::sin(turn), 0};
      for (size_t axis = 0; axis < 3; ++axis) {
        mesh.normals[3 * v + axis] = normal[axis];
        mesh.xyz[3 * v + axis] = middle[axis] + normal[axis];
      }
      const auto vertex = [&](uint32_t a, uint32_t b) { return a % around * across + b % across; };
      const std::array<uint32_t, 6> corner{vertex(i, k), vertex(i + 1, k),     vertex(i + 1, k + 1),
                                           vertex(i, k), vertex(i + 1, k + 1), vertex(i, k + 1)};
      for (size_t c = 0; c < 6; ++c) mesh.corners[6 * v + c] = corner[c];
      for (size_t t = 2 * v; t < 2 * v + 2; ++t) mesh.kinds[t] = HSP_PATCH_SADDLE;
    }
  }
}

struct Torus {
  double from_surface, along_view;
};
Torus torus_at(const double *at, const mesh_view &view) {
  const double out = std::hypot(at[0], at[1]), tube = std::hypot(out - wide, at[2]);
  const std::array<double, 3> normal{at[0] / out * (out - wide) / tube, at[1] / out * (out - wide) / tube,
                                     at[2] / tube};
  const double *axis = view.axis[2];
  return {tube - 1, normal[0] * axis[0] + normal[1] * axis[1] + normal[2] * axis[2]};
}

TEST(MeshFacing, ContoursOfATorus) {
  constexpr uint32_t around = 180, across = 60;
  for (const double angle : {0.0, 0.4, 1.2}) {
    Mesh torus(around * across, 2 * around * across);
    make_torus(torus.mesh, around, across);
    mesh_view view{};
    view.axis[2][1] = std::sin(angle);
    view.axis[2][2] = std::cos(angle);
    const molecule none{};
    const uint32_t before = torus.mesh.vertices;
    auto *marks = static_cast<uint8_t *>(std::malloc(torus.mesh.triangles));
    for (uint32_t t = 0; t < torus.mesh.triangles; ++t) marks[t] = static_cast<uint8_t>(t % 200);
    const std::vector<uint32_t> corners(torus.mesh.corners, torus.mesh.corners + 3 * size_t{torus.mesh.triangles});
    torus.split(view, none, &marks);
    const triangle_mesh &mesh = torus.mesh;
    EXPECT_GT(mesh.vertices, before + around);
    for (uint32_t v = before; v < mesh.vertices; ++v) {
      const Torus at = torus_at(mesh.xyz + 3 * size_t{v}, view);
      EXPECT_NEAR(at.from_surface, 0, 2e-5) << angle;
      EXPECT_NEAR(at.along_view, 0, 2e-3) << angle;
    }
    const auto edges = torus.edges();
    for (const auto &[edge, times] : edges) {
      EXPECT_EQ(times, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    for (uint32_t t = 2 * before; t < mesh.triangles; ++t) {
      const uint32_t *c = mesh.corners + 3 * size_t{t};
      const uint32_t old = *std::min_element(c, c + 3);  // each part but few has a corner of before
      const auto around_it = [&](uint32_t other) {
        const uint32_t *of = corners.data() + 3 * size_t{other};
        return std::any_of(of, of + 3, [old](uint32_t v) { return v == old; });
      };
      bool any = old >= before;
      for (uint32_t other = marks[t]; other < 2 * before; other += 200) any = any || around_it(other);
      EXPECT_TRUE(any) << t;
    }
    size_t turned = 0;
    for (uint32_t t = 0; t < mesh.triangles; ++t) {
      double least = 1, most = -1;
      for (size_t k = 0; k < 3; ++k) {
        const double own = torus_at(mesh.xyz + 3 * size_t{mesh.corners[3 * size_t{t} + k]}, view).along_view;
        least = std::fmin(least, own);
        most = std::fmax(most, own);
      }
      const bool front = mesh_facing(&mesh, &view, &none, t) > 0;
      EXPECT_LT(front ? -least : most, 0.03) << angle;  // a fifth of what an edge of 0.1 turns by, and more
      if (!front) ++turned;
    }
    EXPECT_NEAR(static_cast<double>(turned), mesh.triangles / 2.0, mesh.triangles * 0.1);
    std::free(marks);
  }
}

// Two tetrahedra about two balls that share an edge, in which the normals of either differ: seen so that the one ball
// faces the viewer along all of it and the other one in no place, it is not split, and both triangles have a side each.
TEST(MeshFacing, CreasesHaveTwoSides) {
  std::array<double, 6> centres{-1, 0, 0, 1, 0, 0};
  molecule pair{};
  pair.xyz = centres.data();
  Mesh crease(4, 2);
  triangle_mesh &mesh = crease.mesh;
  const std::array<double, 12> at{0, -0.1, 1, 0, 0.1, 1, -1, 0, 1.4, 1, 0, 1.4};
  std::copy(at.begin(), at.end(), mesh.xyz);
  const std::array<uint32_t, 6> corners{0, 1, 2, 1, 0, 3};
  std::copy(corners.begin(), corners.end(), mesh.corners);
  mesh.balls[1] = 1;
  for (size_t v = 0; v < 4; ++v) mesh.normals[3 * v + 2] = 1;  // of the middle of both
  mesh_view view{};
  view.axis[2][0] = std::sqrt(0.75);
  view.axis[2][2] = -0.5;
  // The ball on the left has normals (1, y, 1) on the crease, that on the right (-1, y, 1).
  const double left = mesh_facing(&mesh, &view, &pair, 0), right = mesh_facing(&mesh, &view, &pair, 1);
  EXPECT_NEAR(left, 2 * (std::sqrt(0.75) - 0.5) / std::sqrt(2.01) - 0.5, 1e-12);
  EXPECT_NEAR(right, 2 * (-std::sqrt(0.75) - 0.5) / std::sqrt(2.01) - 0.5, 1e-12);
  crease.split(view, pair);
  EXPECT_EQ(crease.mesh.vertices, 6u);  // on the two edges of the left one that lead to its third corner
  EXPECT_EQ(crease.mesh.triangles, 4u);
}

// Where the probe is in its place the surface turns to the probe's centre, whatever its vertices have for normals.
TEST(MeshFacing, PlacesOfTheProbe) {
  Mesh place(3, 1);
  const std::array<double, 9> at{1, 0, 0, 0, 1, 0, -1, -1, 0};
  std::copy(at.begin(), at.end(), place.mesh.xyz);
  for (uint32_t k = 0; k < 3; ++k) {
    place.mesh.corners[k] = k;
    place.mesh.normals[3 * k] = 1;
  }
  place.mesh.kinds[0] = HSP_PATCH_CONCAVE;
  mesh_patch patch{};
  patch.probe[2] = 1;
  mesh_view view{};
  view.patches = &patch;
  view.axis[2][2] = 1;
  const molecule none{};
  EXPECT_NEAR(mesh_facing(&place.mesh, &view, &none, 0), 2 / std::sqrt(2) + 1 / std::sqrt(3), 1e-12);
}

}  // namespace
