// Spheres through points of integer coordinates, up to the largest: such a point has power 0, and its neighbours along
// an axis have 1 + 2 d.
#pragma once

#include "cases.hpp"
#include "exact/power.hpp"

namespace cases {

struct PointOfSphere {
  hsp::exact::Vector d;
  int64_t radius;
};
constexpr int64_t power_scale = int64_t{1} << 59;
constexpr PointOfSphere points_of_spheres[] = {{{0, 0, 0}, 0},
                                               {{2, 3, 6}, 7},
                                               {{-2, 3, -6}, 7},
                                               {{1, -4, 8}, 9},
                                               {{2 * power_scale, -power_scale, 2 * power_scale}, 3 * power_scale},
                                               {{0, 4 * power_scale, -3 * power_scale}, 5 * power_scale}};

inline uint32_t points_of_a_sphere_have_no_power() {
  return first_failing(points_of_spheres, [](const PointOfSphere &c) {
    const hsp::exact::Vector beyond{c.d.x + 1, c.d.y, c.d.z}, other{c.d.x, c.d.y - 1, c.d.z};
    return hsp::exact::power(c.d, c.radius).sign() == 0 &&
           hsp::exact::power(beyond, c.radius).to_double() == static_cast<double>(2 * c.d.x + 1) &&
           hsp::exact::power(other, c.radius).to_double() == static_cast<double>(1 - 2 * c.d.y);
  });
}

inline uint32_t squared_lengths_are_those_of_radii() {
  return first_failing(points_of_spheres, [](const PointOfSphere &c) {
    const double radius = static_cast<double>(c.radius);
    return hsp::exact::squared_length(c.d).to_double() == radius * radius;
  });
}

inline constexpr Check exact_power[] = {{"points_of_a_sphere_have_no_power", points_of_a_sphere_have_no_power},
                                        {"squared_lengths_are_those_of_radii", squared_lengths_are_those_of_radii}};

}  // namespace cases
