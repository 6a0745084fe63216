// Balls on chosen points of a cubic lattice: simple, face-centred, diamond and whatever else a condition describes.
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

}  // namespace oracle

#endif
