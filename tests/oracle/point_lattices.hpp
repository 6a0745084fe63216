// Balls on chosen points of a cubic lattice: simple, face-centred, diamond and whatever else a condition describes; on
// spheres, around a point, and around an axis.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

#include "lattice_lengths.hpp"

namespace oracle {

inline Balls joined(Balls balls, const Balls &more) {
  balls.insert(balls.end(), more.begin(), more.end());
  return balls;
}

// A box lattice of so many balls along each axis.
inline Balls box_lattice(const std::array<int64_t, 3> &counts, const std::array<int64_t, 3> &sides, int64_t radius) {
  Balls balls;
  for (int64_t i = 0; i < counts[0]; ++i)
    for (int64_t j = 0; j < counts[1]; ++j)
      for (int64_t k = 0; k < counts[2]; ++k) balls.push_back({i * sides[0], j * sides[1], k * sides[2], radius});
  return balls;
}

// The same along the orthogonal directions (2, 3, 6), (3, -6, 2), (6, 2, -3), all of length 7.
inline Balls slanted_lattice(const std::array<int64_t, 3> &counts, const std::array<int64_t, 3> &sides,
                             int64_t radius) {
  Balls balls;
  for (const LatticeBall &b : box_lattice(counts, sides, radius))
    balls.push_back({2 * b.x + 3 * b.y + 6 * b.z, 3 * b.x - 6 * b.y + 2 * b.z, 6 * b.x + 2 * b.y - 3 * b.z, radius});
  return balls;
}

// Conditions for chosen_points: the face-centred lattice, and diamond in cubes of side 4, with bonds along (1, 1, 1)
// between the even face-centred points and their copies.
inline bool is_face_centred(int64_t x, int64_t y, int64_t z) {
  return (x + y + z) % 2 == 0;
}
inline bool is_diamond(int64_t x, int64_t y, int64_t z) {
  const int64_t odd = x % 2;
  return y % 2 == odd && z % 2 == odd && (x + y + z - 3 * odd) % 4 == 0;
}

// The points of 0 .. n - 1 cubed that satisfy a condition, times scale.
inline Balls chosen_points(int64_t n, int64_t scale, int64_t radius,
                           const std::function<bool(int64_t, int64_t, int64_t)> &chosen) {
  Balls balls;
  for (int64_t x = 0; x < n; ++x)
    for (int64_t y = 0; y < n; ++y)
      for (int64_t z = 0; z < n; ++z)
        if (chosen(x, y, z)) balls.push_back({scale * x, scale * y, scale * z, radius});
  return balls;
}

// All points at a whole distance from the origin, times scale: centres on a sphere, to the last bit.
inline Balls balls_on_sphere(int64_t distance, int64_t scale, int64_t radius) {
  Balls balls;
  for (int64_t x = -distance; x <= distance; ++x)
    for (int64_t y = -distance; y <= distance; ++y)
      for (int64_t z = -distance; z <= distance; ++z)
        if (x * x + y * y + z * z == distance * distance) balls.push_back({scale * x, scale * y, scale * z, radius});
  return balls;
}

// The balls of balls_on_sphere whose centres lie in the plane of two axes.
inline Balls balls_on_circle(int64_t distance, int64_t scale, int64_t radius, size_t first = 0, size_t second = 1) {
  Balls balls;
  for (const LatticeBall &ball : balls_on_sphere(distance, scale, radius))
    if (centre_of(ball)[3 - first - second] == 0) balls.push_back(ball);
  return balls;
}

// A ring of equal balls around the z axis, evenly spaced, each centre rounded to the lattice. The first centre is
// `turned` times the angle between neighbours away from the x axis.
inline Balls ring_around_z(int members, double ring_radius, int64_t height, int64_t radius, double turned = 0) {
  Balls balls;
  for (int k = 0; k < members; ++k) {
    const double angle = 2 * std::numbers::pi * (k + turned) / members;
    balls.push_back(nearest_ball({ring_radius * std::cos(angle), ring_radius * std::sin(angle),
                                  static_cast<double>(height), static_cast<double>(radius)}));
  }
  return balls;
}

// Balls at the 26 lattice points around the origin, times `spacing`. Four balls of a square close the window between
// them from a radius of 0.7072 spacing on; the origin is covered from a radius of 1 spacing on.
inline Balls cage_of_26(int64_t spacing, int64_t radius) {
  Balls balls;
  for (const LatticeBall &b : box_lattice({3, 3, 3}, {spacing, spacing, spacing}, radius))
    balls.push_back({b.x - spacing, b.y - spacing, b.z - spacing, radius});
  balls.erase(balls.begin() + 13);
  return balls;
}

}  // namespace oracle
