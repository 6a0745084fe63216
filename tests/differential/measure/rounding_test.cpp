// How far rounding moves areas, volumes and derivatives of molecules: against the same formulas in a longer
// floating-point format, from the vertices, arcs and circles of the boundary.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "library_run.hpp"
#include "molecule_balls.hpp"

namespace {

using Real = long double;
constexpr Real pi = 3.141592653589793238462643383279502884L;

struct Vector {
  Real x, y, z;
  friend Vector operator+(const Vector &a, const Vector &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector &a, const Vector &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(Real s, const Vector &a) { return {s * a.x, s * a.y, s * a.z}; }
};
Real dot(const Vector &a, const Vector &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector cross(const Vector &a, const Vector &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The circle of two spheres as the first sees it: u and h as in lib/union/measure/gradients.hpp.
struct Circle {
  Vector u;
  Real d, h;
};

// The sums of Gauss-Bonnet and Stokes on each sphere.
struct Sums {
  Real steradians = 0, by_radius = 0;
  Vector vector_area{0, 0, 0}, by_centre{0, 0, 0};
};

class LongMeasures {
 public:
  LongMeasures(const oracle::Balls &balls, int64_t probe, const LibraryBoundary &library)
      : balls_(balls), probe_(probe), sums_(balls.size()) {
    const std::vector<hsp_vertex> vertices = library.vertices();
    for (const hsp_vertex &v : vertices) {
      for (size_t k = 0; k < 3; ++k) add_turn(v.ball[k], v.ball[(k + 1) % 3], v.ball[(k + 2) % 3]);
    }
    for (const hsp_arc &arc : library.arcs()) {
      const auto [a, b] = arc.ball;
      const Circle circle = circle_of(a, b);
      const Vector p = vertex(vertices[arc.vertex[0]], a);
      const Vector q = vertex(vertices[arc.vertex[1]], a);
      const Vector p_seen = p - circle.h * circle.u;
      const Vector q_seen = q - circle.h * circle.u;
      Real angle = std::atan2(dot(circle.u, cross(p_seen, q_seen)), dot(p_seen, q_seen));
      if (angle < 0) angle += 2 * pi;
      add_arc(a, b, angle, q - p);
      add_arc(b, a, angle, p - q);
    }
    for (const hsp_circle &circle : library.circles()) {
      add_arc(circle.ball[0], circle.ball[1], 2 * pi, {0, 0, 0});
      add_arc(circle.ball[1], circle.ball[0], 2 * pi, {0, 0, 0});
    }
    for (const hsp_face &face : library.faces()) {
      sums_[face.ball].steradians += 2 * pi * (2 - static_cast<Real>(face.loops));
    }
    for (uint32_t i = 0; i < balls.size(); ++i) sums_[i].by_radius += 2 * radius(i) * sums_[i].steradians;
  }
  [[nodiscard]] const Sums &of(uint32_t i) const { return sums_[i]; }
  [[nodiscard]] Real radius(uint32_t i) const { return static_cast<Real>(balls_[i].radius + probe_); }
  [[nodiscard]] Vector centre(uint32_t i) const {
    return {static_cast<Real>(balls_[i].x), static_cast<Real>(balls_[i].y), static_cast<Real>(balls_[i].z)};
  }

 private:
  [[nodiscard]] Circle circle_of(uint32_t i, uint32_t j) const {
    const Vector v = centre(j) - centre(i);
    const Real d = std::sqrt(dot(v, v));
    return {(1 / d) * v, d, (d * d + (radius(i) - radius(j)) * (radius(i) + radius(j))) / (2 * d)};
  }

  // The circles of j and k on ball i cross in (q x n + sign root n)/n.n, from its centre.
  struct Crossing {
    Vector n, q;
    Real root;
  };
  [[nodiscard]] Crossing crossing(uint32_t i, uint32_t j, uint32_t k) const {
    const Circle a = circle_of(i, j);
    const Circle b = circle_of(i, k);
    const Vector n = cross(a.u, b.u);
    const Vector q = a.h * b.u - b.h * a.u;
    const Real D = radius(i) * radius(i) * dot(n, n) - dot(q, q);
    return {n, q, D > 0 ? std::sqrt(D) : 0};
  }
  [[nodiscard]] Vector vertex(const hsp_vertex &v, uint32_t i) const {
    const size_t k = v.ball[0] == i ? 0 : v.ball[1] == i ? 1 : 2;
    const auto [n, q, root] = crossing(i, v.ball[(k + 1) % 3], v.ball[(k + 2) % 3]);
    return (1 / dot(n, n)) * (cross(q, n) + (static_cast<Real>(v.sign) * root) * n);
  }

  void add_turn(uint32_t i, uint32_t j, uint32_t k) {
    const Circle a = circle_of(i, j);
    const Circle b = circle_of(i, k);
    const Real r = radius(i);
    sums_[i].steradians -= std::atan2(crossing(i, j, k).root / r, dot(a.u, b.u) - a.h * b.h / (r * r));
  }

  // An arc on ball i, counter-clockwise about the axis to ball j.
  void add_arc(uint32_t i, uint32_t j, Real angle, const Vector &chord) {
    const Circle c = circle_of(i, j);
    const Vector X = cross(chord, c.u);
    const Real r = radius(i);
    Sums &sums = sums_[i];
    sums.steradians += c.h / r * angle;
    sums.vector_area = sums.vector_area + 0.5L * (c.h * X - ((r - c.h) * (r + c.h) * angle) * c.u);
    sums.by_centre =
        sums.by_centre + ((-r * (1 - c.h / c.d) - radius(j) * c.h / c.d) * angle) * c.u + ((r - radius(j)) / c.d) * X;
    sums.by_radius += angle * (r * r / c.d - c.h) - radius(j) * r * angle / c.d;
  }

  const oracle::Balls &balls_;
  const int64_t probe_;
  std::vector<Sums> sums_;
};

// In units of 2^-53 of the natural scale.
struct Error {
  double largest = 0, mean = 0;

  void add(Real error, size_t terms) {
    const double units = static_cast<double>(std::fabs(error) * 0x1p53L);
    if (units > largest) largest = units;
    mean += units / static_cast<double>(terms);
  }
};

struct Errors {
  Error area, vector_area, by_centre, by_radius;
};

Errors errors_of(const char *file, int64_t probe) {
  const oracle::Balls balls = read_molecule(support::own_molecule(file));
  const LibraryBoundary library(balls, 1, static_cast<double>(probe));
  const LongMeasures exact(balls, probe, library);
  const uint32_t n = static_cast<uint32_t>(balls.size());
  const std::vector<double> area = library.measure().area;
  std::vector<double> by_centre(3 * n), volume_by_centre(3 * n), by_radius(n);
  hsp_derivatives_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.area_centre = by_centre.data();
  outputs.area_radius = by_radius.data();
  outputs.volume_centre = volume_by_centre.data();
  expect_ok(hsp_boundary_get_derivatives(library.handle(), nullptr, &outputs), "hsp_boundary_get_derivatives");
  Errors errors;
  for (uint32_t i = 0; i < n; ++i) {
    const Sums &sums = exact.of(i);
    const Real r = exact.radius(i);
    const Real sphere = 4 * pi * r * r;
    errors.area.add((static_cast<Real>(area[i]) - r * r * sums.steradians) / sphere, n);
    errors.by_radius.add((static_cast<Real>(by_radius[i]) - sums.by_radius) / (8 * pi * r), n);
    const Real centre[] = {sums.by_centre.x, sums.by_centre.y, sums.by_centre.z};
    const Real vector_area[] = {sums.vector_area.x, sums.vector_area.y, sums.vector_area.z};
    for (uint32_t k = 0; k < 3; ++k) {
      errors.by_centre.add((static_cast<Real>(by_centre[3 * i + k]) - centre[k]) / (4 * pi * r), 3 * n);
      errors.vector_area.add((static_cast<Real>(volume_by_centre[3 * i + k]) - vector_area[k]) / sphere, 3 * n);
    }
  }
  return errors;
}

// The errors of version 0.1.0: none may be larger.
struct Limits {
  const char *file;
  int64_t probe;
  Errors errors;
};
constexpr Limits version_0_1[] = {
    {"crambin.pdb", 0, {{7.252, 1.0170}, {0.858, 0.1422}, {2.951, 0.3345}, {6.279, 0.9560}}},
    {"crambin.pdb", 14 * steps_per_angstrom / 10, {{1.728, 0.3316}, {0.611, 0.0528}, {0.888, 0.1134}, {1.758, 0.3189}}},
    {"sod_stand_in.pdb", 0, {{8.735, 0.9928}, {1.269, 0.1487}, {6.578, 0.3409}, {7.983, 0.9643}}},
    {"sod_stand_in.pdb",
     14 * steps_per_angstrom / 10,
     {{4.995, 0.3652}, {0.877, 0.0426}, {2.029, 0.1111}, {4.644, 0.3537}}},
};

TEST(Rounding, OfMolecules) {
  if (std::numeric_limits<Real>::digits < 64) GTEST_SKIP() << "long double is no longer than double here";
  for (const auto &[file, probe, limits] : version_0_1) {
    const Errors errors = errors_of(file, probe);
    const std::string input = std::string(file) + " " + std::to_string(probe) + " ";
    const auto check = [&input](const char *what, const Error &error, const Error &limit) {
      EXPECT_LE(error.largest, limit.largest) << input << what;
      EXPECT_LE(error.mean, limit.mean) << input << what;
      EXPECT_GT(error.mean, 0.01) << "the measurement measures";
      RecordProperty(input + what + ", largest", std::to_string(error.largest));
      RecordProperty(input + what + ", mean", std::to_string(error.mean));
    };
    check("area", errors.area, limits.area);
    check("vector area", errors.vector_area, limits.vector_area);
    check("by centre", errors.by_centre, limits.by_centre);
    check("by radius", errors.by_radius, limits.by_radius);
  }
}

}  // namespace
