// Circles on a unit sphere in planes across the axes x and y, and the ends of their chord.
#pragma once

#include "cases.hpp"
#include "sphere/cap_pair.hpp"

namespace cases {

struct TwoCaps {
  double ux[2], uy[2], uz[2], b[2];
};

// The planes 0.6 and 0.48 from the centre meet the sphere at distance 0.64 from their common line's foot.
struct UnitCrossing {
  double a, b, half_chord;
};
constexpr UnitCrossing unit_crossings[] = {{0.6, 0.48, 0.64}, {-0.6, 0.64, 0.48}, {0.0, 0.0, 1.0}, {0.36, -0.48, 0.8}};

inline bool is_there(const hsp::Vec3 &p, const hsp::Vec3 &q) {
  return near(p.x, q.x, 1e-15) && near(p.y, q.y, 1e-15) && near(p.z, q.z, 1e-15);
}

inline uint32_t unit_circles_cross_where_they_should() {
  return first_failing(unit_crossings, [](const UnitCrossing &c) {
    const TwoCaps caps = {{1, 0}, {0, 1}, {0, 0}, {c.a, c.b}};
    const hsp::CapPair pair(caps, 0, 1);
    const hsp::UnitChord chord(caps, 0, 1, pair);
    const hsp::CrossingPoints points(caps, 0, 1, pair);
    return pair.certainly_cross() && is_there(chord.m, {c.a, c.b, 0.0}) &&
           is_there(chord.w, {0.0, 0.0, c.half_chord}) &&
           is_there({points.x[0], points.y[0], points.z[0]}, {c.a, c.b, -c.half_chord}) &&
           is_there({points.x[1], points.y[1], points.z[1]}, {c.a, c.b, c.half_chord});
  });
}

// Beside each other, one in the other, and the other way round.
struct Nested {
  double a, b;
  bool inside, contains;
};
constexpr Nested nested[] = {{0.9, 0.9, false, false}, {0.9, -0.9, true, false}, {-0.9, 0.9, false, true}};

inline uint32_t circles_apart_lie_where_they_should() {
  return first_failing(nested, [](const Nested &c) {
    const TwoCaps caps = {{1, 0}, {0, 1}, {0, 0}, {c.a, c.b}};
    const hsp::CapPair pair(caps, 0, 1);
    return pair.certainly_apart() && pair.certainly_inside() == c.inside && pair.certainly_contains() == c.contains &&
           (pair.certainly_separate() != 0) == (!c.inside && !c.contains);
  });
}

inline constexpr Check sphere_cap_pair[] = {
    {"unit_circles_cross_where_they_should", unit_circles_cross_where_they_should},
    {"circles_apart_lie_where_they_should", circles_apart_lie_where_they_should}};

}  // namespace cases
