// The exact stage on a sphere of radius 7, whose point (2, 3, 6) and the like have integer coordinates: every answer
// follows from small integers. Both widths of limbs.
#pragma once

#include "cases.hpp"
#include "exact/exact_predicates.hpp"

namespace cases {

// The half-space v.p >= t of points p relative to the centre; planes are in the coordinates 2 p.
struct HalfSpace {
  hsp::exact::Vector v;
  int64_t t;

  constexpr hsp::exact::Plane plane() const { return hsp::exact::virtual_plane(v, 2 * t); }
};
constexpr hsp::exact::Sphere sphere_of_radius_7{4 * 49, 0};

template <class Limb>
uint32_t circles_across_two_axes() {
  // x = a and y = b meet the sphere in common points iff a^2 + b^2 < 49. Else x >= a contains y = b, or not.
  for (int64_t a = -6; a <= 6; ++a) {
    for (int64_t b = -6; b <= 6; ++b) {
      const hsp::exact::Plane P = HalfSpace{{1, 0, 0}, a}.plane();
      const hsp::exact::Plane Q = HalfSpace{{0, 1, 0}, b}.plane();
      using Stage = hsp::exact::ExactPredicates<Limb>;
      const bool cross = a * a + b * b < 49;
      if ((Stage::crossing(sphere_of_radius_7, P, Q).sign > 0) != cross)
        return static_cast<uint32_t>(13 * (a + 6) + b + 6);
      // Circle x = a is centred at (a, 0, 0), inside y >= b iff b < 0.
      if (!cross && (Stage::side(sphere_of_radius_7, P, Q).sign > 0) != (b < 0)) {
        return static_cast<uint32_t>(13 * (a + 6) + b + 6);
      }
      const double D = 49.0 * 4 - 4.0 * static_cast<double>(a * a + b * b);  // W n.n - q.q
      if (cross && Stage::discriminant(sphere_of_radius_7, P, Q) != D)
        return static_cast<uint32_t>(13 * (a + 6) + b + 6);
    }
  }
  return all_hold;
}

// Half-spaces that do not pass through (2, 3, 6) and (2, 3, -6).
constexpr HalfSpace half_spaces[] = {{{0, 0, 1}, 0},   {{0, 0, -1}, 5}, {{1, 1, 1}, 10},  {{1, 1, 1}, 12},
                                     {{-1, -2, 3}, 9}, {{2, 1, -1}, 2}, {{5, -3, -2}, 3}, {{-1, -1, -1}, 0}};

template <class Limb>
uint32_t points_of_integer_coordinates() {
  return first_failing(half_spaces, [](const HalfSpace &c) {
    const hsp::exact::PointStatus status = hsp::exact::ExactPredicates<Limb>::point_status(
        sphere_of_radius_7, HalfSpace{{1, 0, 0}, 2}.plane(), HalfSpace{{0, 1, 0}, 3}.plane(), c.plane());
    for (int point = 0; point < 2; ++point) {
      const int64_t value = dot(c.v, {2, 3, point == 1 ? 6 : -6}) - c.t;
      if (status.side[point] != (value > 0 ? 1 : -1) || status.tied[point]) return false;
    }
    return true;
  });
}

// 2 x + 3 y = 13 and z = 6 touch in (2, 3, 6): of a third plane that goes through it both points are on it.
constexpr HalfSpace through_the_point[] = {{{1, 0, 0}, 2}, {{0, -1, 0}, -3}, {{1, 1, 1}, 11}, {{3, -2, 1}, 6}};

template <class Limb>
uint32_t circles_that_touch_on_a_third_one() {
  return first_failing(through_the_point, [](const HalfSpace &c) {
    const hsp::exact::PointStatus status = hsp::exact::ExactPredicates<Limb>::point_status(
        sphere_of_radius_7, HalfSpace{{2, 3, 0}, 13}.plane(), HalfSpace{{0, 0, 1}, 6}.plane(), c.plane());
    return status.tied[0] && status.tied[1];
  });
}

// Of the sphere with W = 1 and planes across two axes through its centre it is 1.
template <class Limb>
uint32_t the_least_discriminant() {
  const HalfSpace P{{1, 0, 0}, 0}, Q{{0, 1, 0}, 0};
  return hsp::exact::ExactPredicates<Limb>::discriminant({1, 0}, P.plane(), Q.plane()) == 1.0 ? all_hold : 0;
}

inline constexpr Check exact_exact_predicates[] = {
    {"circles_that_touch_on_a_third_one, fast limbs", circles_that_touch_on_a_third_one<hsp::exact::FastLimb>},
    {"circles_that_touch_on_a_third_one, portable limbs", circles_that_touch_on_a_third_one<uint32_t>},
    {"the_least_discriminant, fast limbs", the_least_discriminant<hsp::exact::FastLimb>},
    {"the_least_discriminant, portable limbs", the_least_discriminant<uint32_t>},
    {"circles_across_two_axes, fast limbs", circles_across_two_axes<hsp::exact::FastLimb>},
    {"circles_across_two_axes, portable limbs", circles_across_two_axes<uint32_t>},
    {"points_of_integer_coordinates, fast limbs", points_of_integer_coordinates<hsp::exact::FastLimb>},
    {"points_of_integer_coordinates, portable limbs", points_of_integer_coordinates<uint32_t>}};

}  // namespace cases
