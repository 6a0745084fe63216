// Balls on chosen points of a cubic lattice: simple, face-centred, diamond and whatever else a condition describes; on
// spheres, and around a point.
#ifndef HARDSPHERE_TESTS_ORACLE_POINT_LATTICES_HPP
#define HARDSPHERE_TESTS_ORACLE_POINT_LATTICES_HPP

#include <cstdint>
#include <functional>

#include "lattice_ball.hpp"

namespace oracle {

/// The points of 0 .. n - 1 cubed that satisfy a condition, times scale.
inline Balls chosen_points(std::int64_t n, std::int64_t scale, std::int64_t radius,
                           const std::function<bool(std::int64_t, std::int64_t, std::int64_t)> &chosen) {
  Balls balls;
  for (std::int64_t x = 0; x < n; ++x)
    for (std::int64_t y = 0; y < n; ++y)
      for (std::int64_t z = 0; z < n; ++z)
        if (chosen(x, y, z)) balls.push_back({scale * x, scale * y, scale * z, radius});
  return balls;
}

/// All points at a whole distance from the origin, times scale: centres on a sphere, to the last bit.
inline Balls balls_on_sphere(std::int64_t distance, std::int64_t scale, std::int64_t radius) {
  Balls balls;
  for (std::int64_t x = -distance; x <= distance; ++x)
    for (std::int64_t y = -distance; y <= distance; ++y)
      for (std::int64_t z = -distance; z <= distance; ++z)
        if (x * x + y * y + z * z == distance * distance) balls.push_back({scale * x, scale * y, scale * z, radius});
  return balls;
}

/// The 26 points around the origin, times spacing. Squares close at 0.7072 of it, the middle at 1.
inline Balls cage_of_26(std::int64_t spacing, std::int64_t radius) {
  Balls balls;
  for (std::int64_t k = 0; k < 27; ++k)
    if (k != 13) balls.push_back({spacing * (k % 3 - 1), spacing * (k / 3 % 3 - 1), spacing * (k / 9 - 1), radius});
  return balls;
}

}  // namespace oracle

#endif
