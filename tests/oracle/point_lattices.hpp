// Balls on chosen points of a cubic lattice: simple, face-centred, diamond and whatever else a condition describes; on
// spheres, and around a point.
#pragma once

#include <cstdint>
#include <functional>

#include "lattice_ball.hpp"

namespace oracle {

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

// The 26 points around the origin, times spacing. Squares close at 0.7072 of it, the middle at 1.
inline Balls cage_of_26(int64_t spacing, int64_t radius) {
  Balls balls;
  for (int64_t k = 0; k < 27; ++k)
    if (k != 13) balls.push_back({spacing * (k % 3 - 1), spacing * (k / 3 % 3 - 1), spacing * (k / 9 - 1), radius});
  return balls;
}

}  // namespace oracle
