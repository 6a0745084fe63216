// The void of symmetric cages, turned and rounded, as fullerenes, zeolites and coordination cages have them: one, of
// the volume that a ball laid into it adds to the union.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Point = std::array<double, 3>;

double length(const Point &p) {
  return std::hypot(p[0], p[1], p[2]);
}

// All points with these coordinates in any order and of any sign, but `few`: in cyclic order alone, or with an even
// number of signs alone.
enum class Few { none, cyclic, even_signs };
void add_corners(const Point &point, Few few, std::vector<Point> &corners) {
  std::array<size_t, 3> order{0, 1, 2};
  do {
    const bool is_cyclic = order[1] == (order[0] + 1) % 3;
    if (few == Few::cyclic && !is_cyclic) continue;
    for (unsigned signs = 0; signs < 8; ++signs) {
      if (few == Few::even_signs && (signs & 1U) + (signs >> 1U & 1U) + (signs >> 2U) != 2 * (signs > 0 ? 1U : 0U))
        continue;
      Point corner{};
      for (size_t axis = 0; axis < 3; ++axis)
        corner[axis] = (signs >> axis & 1U) != 0 ? -point[order[axis]] : point[order[axis]];
      const auto is_same = [&](const Point &other) {
        return length({corner[0] - other[0], corner[1] - other[1], corner[2] - other[2]}) < 1e-9;
      };
      if (std::none_of(corners.begin(), corners.end(), is_same)) corners.push_back(corner);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

// The corners of a solid with edges of 1, and the radius of the circle around its largest face.
struct Cage {
  const char *name;
  std::vector<Point> corners;
  double largest_face;
};

// Around a regular face of so many corners.
double face_of(double corners) {
  return 0.5 / std::sin(std::numbers::pi / corners);
}

Cage cage_of(const char *name, std::vector<Point> corners, double largest_face) {
  double edge = INFINITY;
  for (size_t k = 1; k < corners.size(); ++k) {
    edge = std::min(
        edge, length({corners[k][0] - corners[0][0], corners[k][1] - corners[0][1], corners[k][2] - corners[0][2]}));
  }
  for (Point &corner : corners) {
    for (double &coordinate : corner) coordinate /= edge;
  }
  return {name, corners, largest_face};
}

Cage cage_of(const char *name, const Point &point, Few few, double largest_face) {
  std::vector<Point> corners;
  add_corners(point, few, corners);
  return cage_of(name, corners, largest_face);
}

std::vector<Cage> cages() {
  const double root = std::sqrt(2.0), golden = std::numbers::phi;
  std::vector<Point> c60, prism, dodecahedron;
  for (const Point &point :
       {Point{0, 1, 3 * golden}, Point{1, 2 + golden, 2 * golden}, Point{golden, 2, 2 * golden + 1}}) {
    add_corners(point, Few::cyclic, c60);
  }
  add_corners({1, 1, 1}, Few::none, dodecahedron);
  add_corners({0, 1 / golden, golden}, Few::cyclic, dodecahedron);
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3;
    for (const double z : {0.5, -0.5}) prism.push_back({std::cos(angle), std::sin(angle), z});
  }
  return {cage_of("fullerene", c60, face_of(6)),
          cage_of("hexagonal prism", prism, face_of(6)),
          cage_of("dodecahedron", dodecahedron, face_of(5)),
          cage_of("cube", {1, 1, 1}, Few::none, face_of(4)),
          cage_of("cuboctahedron", {0, 1, 1}, Few::none, face_of(4)),
          cage_of("sodalite", {0, 1, 2}, Few::none, face_of(6)),
          cage_of("zeolite A", {1, 1 + root, 1 + 2 * root}, Few::none, face_of(8)),
          cage_of("truncated cube", {root - 1, 1, 1}, Few::none, face_of(8)),
          cage_of("truncated tetrahedron", {3, 1, 1}, Few::even_signs, face_of(6)),
          cage_of("rhombicuboctahedron", {1, 1, 1 + root}, Few::none, face_of(4))};
}

// A rotation by a quaternion of any direction.
std::array<Point, 3> any_rotation(std::mt19937 &random) {
  std::normal_distribution<double> normal;
  double q[4], sum = 0;
  for (double &part : q) part = normal(random), sum += part * part;
  for (double &part : q) part /= std::sqrt(sum);
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

double volume_of(const std::string &balls) {
  const TemporaryFile file("balls.xyzr", balls);
  return run_json({"measure", file.path()})["volume"].number;
}

TEST(VoidCages, HaveOneVoidHoweverTheyLie) {
  std::mt19937 random(60);
  const int turns = std::getenv("HSP_LONG_TESTS") != nullptr ? 60 : 4;
  for (const Cage &cage : cages()) {
    const double edge = 1.42, size = edge * length(cage.corners[0]), face = edge * cage.largest_face;
    // Balls that close the faces and leave the middle, and one that fills that and does not come out.
    const double radius = face + 0.4 * (size - face), plug = std::sqrt(size * size - face * face);
    for (int turn = 0; turn < turns; ++turn) {
      const std::array<Point, 3> rotation = any_rotation(random);
      std::ostringstream text;
      text << std::fixed;
      text.precision(2 + turn % 4);
      for (const Point &corner : cage.corners) {
        for (const Point &row : rotation)
          text << edge * (row[0] * corner[0] + row[1] * corner[1] + row[2] * corner[2]) << ' ';
        text << radius << '\n';
      }
      SCOPED_TRACE(std::string(cage.name) + ", turn " + std::to_string(turn));
      const TemporaryFile file("cage.xyzr", text.str());
      const std::vector<Json> voids = run_json({"voids", file.path()})["voids"].items;
      ASSERT_EQ(voids.size(), 1U);
      std::ostringstream filled;
      filled << text.str() << "0 0 0 " << plug << '\n';
      EXPECT_NEAR(voids[0]["volume"].number, volume_of(filled.str()) - volume_of(text.str()), 1e-10);
      EXPECT_GT(voids[0]["clearance"].number, 0);
    }
  }
}

}  // namespace
