// Circles on a sphere whose common points have integer coordinates, in planes across the axes and oblique ones.
#pragma once

#include "cases.hpp"
#include "exact/circle_crossing.hpp"

namespace cases {

// The circles in the planes u.p = a and v.p = b on the sphere |p|^2 = W meet in p+ and p-; D = W n.n - q.q.
struct Crossing {
  hsp::Vec3 u;
  double a;
  hsp::Vec3 v;
  double b;
  double W, root_D;
  hsp::Vec3 plus, minus;
};
constexpr Crossing crossings[] = {{{1, 0, 0}, 2, {0, 1, 0}, 3, 49, 6, {2, 3, 6}, {2, 3, -6}},
                                  {{0, 1, 0}, 3, {1, 0, 0}, 2, 49, 6, {2, 3, -6}, {2, 3, 6}},
                                  {{2, 0, 0}, 4, {0, 4, 0}, 12, 49, 48, {2, 3, 6}, {2, 3, -6}},
                                  {{0, 0, 1}, -2, {0, 1, 0}, 1, 9, 2, {-2, 1, -2}, {2, 1, -2}},
                                  {{1, 1, 0}, 5, {1, -1, 0}, -1, 49, 12, {2, 3, -6}, {2, 3, 6}},
                                  {{1, 0, 0}, 0, {0, 0, 1}, 0, 25, 5, {0, -5, 0}, {0, 5, 0}}};

inline bool near(const hsp::Vec3 &p, const hsp::Vec3 &q, double tolerance) {
  return near(p.x, q.x, tolerance) && near(p.y, q.y, tolerance) && near(p.z, q.z, tolerance);
}

inline uint32_t circles_cross_where_they_should() {
  return first_failing(crossings, [](const Crossing &c) {
    const hsp::CircleCrossing<hsp::Vec3, double> crossing(c.u, c.a, c.v, c.b);
    return crossing.discriminant(c.W) == c.root_D * c.root_D && near(crossing.point(c.root_D), c.plus, 1e-14) &&
           near(crossing.point(-c.root_D), c.minus, 1e-14) &&
           near(crossing.point(c.root_D, 2.0), {2 * c.plus.x, 2 * c.plus.y, 2 * c.plus.z}, 1e-14);
  });
}

inline constexpr Check exact_circle_crossing[] = {{"circles_cross_where_they_should", circles_cross_where_they_should}};

}  // namespace cases
