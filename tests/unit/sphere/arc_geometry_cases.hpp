// Circles, crossing points and angles on spheres where they follow from Pythagorean numbers or from one arc cosine.
#pragma once

#include "cases.hpp"
#include "exact/lattice_ball.hpp"
#include "sphere/arc_geometry.hpp"

namespace cases {

inline bool near_vector(const hsp::Vec3 &p, const hsp::Vec3 &q, double tolerance) {
  return near(p.x, q.x, tolerance) && near(p.y, q.y, tolerance) && near(p.z, q.z, tolerance);
}

// On a ball of radius 5 at the origin.
struct OneCircle {
  hsp::exact::LatticeBall other;
  hsp::Vec3 axis, centre;
  double radius;
};
constexpr OneCircle one_circle[] = {{{{8, 0, 0}, 5, 1}, {1, 0, 0}, {4, 0, 0}, 3},
                                    {{{0, 6, 0}, 5, 1}, {0, 1, 0}, {0, 3, 0}, 4},
                                    {{{0, 0, -3}, 4, 1}, {0, 0, -1}, {0, 0, -3}, 4},
                                    {{{-4, 0, 0}, 3, 1}, {-1, 0, 0}, {-4, 0, 0}, 3},
                                    {{{10, 0, 0}, 5, 1}, {1, 0, 0}, {5, 0, 0}, 0}};

inline uint32_t circles_have_centre_and_radius() {
  return first_failing(one_circle, [](const OneCircle &c) {
    const hsp::exact::LatticeBall own{{0, 0, 0}, 5, 0};
    const hsp::CircleGeometry circle(sphere_of(own), plane_of(own, c.other));
    return near_vector(circle.axis, c.axis, 1e-15) && near_vector(circle.centre, c.centre, 1e-14) &&
           near(circle.radius, c.radius, 1e-14) && near(circle.height, dot(c.axis, c.centre), 1e-14);
  });
}

// Balls of radius 7 at (0, 0, 0), (2 x, 0, 0) and (0, 2 y, 0) meet in (x, y, z) and (x, y, -z) if x^2 + y^2 + z^2 = 49.
struct IntegerPoint {
  int64_t x, y, z;
};
constexpr IntegerPoint integer_points[] = {{2, 3, 6}, {3, 2, 6}, {2, 6, 3},  {6, 2, 3},
                                           {3, 6, 2}, {6, 3, 2}, {-2, 3, 6}, {-6, -3, 2}};

inline uint32_t spheres_cross_in_integer_points() {
  return first_failing(integer_points, [](const IntegerPoint &c) {
    const hsp::exact::LatticeBall own{{0, 0, 0}, 7, 0};
    const hsp::exact::Plane P = plane_of(own, {{2 * c.x, 0, 0}, 7, 1});
    const hsp::exact::Plane Q = plane_of(own, {{0, 2 * c.y, 0}, 7, 2});
    const double root_D = std::sqrt(hsp::exact::Exact::discriminant(sphere_of(own), P, Q));
    // p+ is on the side of u x v, whose sign is that of x y.
    const double z = static_cast<double>(c.x * c.y > 0 ? c.z : -c.z);
    const hsp::Vec3 plus{static_cast<double>(c.x), static_cast<double>(c.y), z};
    const hsp::Vec3 minus{plus.x, plus.y, -z};
    const hsp::CrossingPointFinder finder(sphere_of(own), 196.0);
    const hsp::CrossingPointFinder::Point found = finder.find(P, Q);
    return near_vector(hsp::crossing_point(P, Q, +1, root_D), plus, 1e-14) &&
           near_vector(hsp::crossing_point(P, Q, -1, root_D), minus, 1e-14) &&
           near_vector(found.position, plus, 1e-12) && near(found.root_D, root_D, 1e-12 * root_D);
  });
}

// Angles between directions across an axis, against multiples of 45 degrees.
struct Turn {
  hsp::Vec3 axis, from, to;
  double eighths;  // of the whole turn
};
constexpr Turn turns[] = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 2},  {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, 6},
                          {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 6}, {{0, 0, 1}, {1, 0, 0}, {-2, 0, 0}, 4},
                          {{0, 0, 1}, {1, 1, 0}, {1, 0, 0}, 7},  {{1, 0, 0}, {0, 1, 0}, {0, 1, 1}, 1},
                          {{0, 1, 0}, {0, 0, 2}, {3, 0, 0}, 2},  {{0, 1, 0}, {0, 0, 2}, {-3, 0, -3}, 5}};

inline uint32_t turns_about_axes() {
  return first_failing(turns, [](const Turn &c) {
    return near(hsp::turn_about(c.axis, c.from, c.to), c.eighths * hsp::pi / 4, 1e-15 * 8);
  });
}

// On a ball of radius 7 the circle of a ball of radius 7 at (0, 0, 6) is 3 high and sqrt(40) wide. A ball of radius 6
// at distance 10 across z covers what is 5.65 or more along: half of it is acos(5.65 / sqrt(40)).
struct Arc {
  hsp::exact::Vector from, to;
  double eighths;  // of a turn from one direction to the other, counter-clockwise
};
constexpr Arc free_arcs[] = {{{10, 0, 0}, {0, 10, 0}, 2},  {{10, 0, 0}, {-10, 0, 0}, 4}, {{10, 0, 0}, {0, -10, 0}, 6},
                             {{0, 10, 0}, {10, 0, 0}, 6},  {{0, -10, 0}, {10, 0, 0}, 2}, {{10, 0, 0}, {10, 0, 0}, 8},
                             {{0, -10, 0}, {0, -10, 0}, 8}};

inline uint32_t free_arcs_have_their_angles() {
  return first_failing(free_arcs, [](const Arc &c) {
    const hsp::exact::LatticeBall own{{0, 0, 0}, 7, 0};
    const hsp::exact::Plane P = plane_of(own, {{0, 0, 6}, 7, 1});
    const hsp::exact::Plane Q = plane_of(own, {c.from, 6, 2});
    const hsp::exact::Plane R = plane_of(own, {c.to, 6, c.eighths == 8 ? 2U : 3U});
    const double root_exit = std::sqrt(hsp::exact::Exact::discriminant(sphere_of(own), P, Q));
    const double root_entry = std::sqrt(hsp::exact::Exact::discriminant(sphere_of(own), P, R));
    const double half = std::acos(5.65 / std::sqrt(40.0));
    return near(hsp::arc_angle(P, Q, root_exit, R, root_entry), c.eighths * hsp::pi / 4 - 2 * half, 1e-13);
  });
}

inline constexpr Check sphere_arc_geometry[] = {{"circles_have_centre_and_radius", circles_have_centre_and_radius},
                                                {"spheres_cross_in_integer_points", spheres_cross_in_integer_points},
                                                {"turns_about_axes", turns_about_axes},
                                                {"free_arcs_have_their_angles", free_arcs_have_their_angles}};

}  // namespace cases
