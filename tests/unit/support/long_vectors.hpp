// Positions, circles and turns in long doubles, for comparison with the library's doubles. Centres, radii and offsets
// are read from the library's records; the formulas are the textbook's.
#pragma once

#include <cmath>
#include <numbers>

#include "topology/positions.hpp"

namespace long_vectors {

struct Vector {
  long double x = 0, y = 0, z = 0;
};
inline Vector operator+(const Vector &a, const Vector &b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector &a, const Vector &b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(long double s, const Vector &a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline long double dot(const Vector &a, const Vector &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(const Vector &a, const Vector &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline long double length(const Vector &a) {
  return std::sqrt(dot(a, a));
}

inline Vector centre(const hsp::BallSet &balls, uint32_t i) {
  return {balls.x[i], balls.y[i], balls.z[i]};
}
inline Vector position(const hsp::BallSet &balls, const hsp::Position &position) {
  return centre(balls, position.ball) + Vector{position.offset.x, position.offset.y, position.offset.z};
}

// The circle in which two spheres meet; the axis is a unit vector from ball a to ball b.
struct Circle {
  Vector centre, axis;
  long double radius = 0;

  Circle(const hsp::BallSet &balls, uint32_t a, uint32_t b) {
    const Vector v = long_vectors::centre(balls, b) - long_vectors::centre(balls, a);
    const long double distance = length(v);
    const long double ra = balls.r[a];
    const long double rb = balls.r[b];
    const long double along = (distance * distance + ra * ra - rb * rb) / (2 * distance);
    axis = (1 / distance) * v;
    centre = long_vectors::centre(balls, a) + along * axis;
    const long double squared = ra * ra - along * along;
    radius = squared > 0 ? std::sqrt(squared) : 0;
  }
};

// The angle from one direction to another counter-clockwise about an axis, in [0, 2 pi).
inline long double turn(const Vector &axis, const Vector &from, const Vector &to) {
  const long double angle = std::atan2(dot(axis, cross(from, to)) / length(axis), dot(from, to));
  return angle < 0 ? angle + 2 * std::numbers::pi_v<long double> : angle;
}

}  // namespace long_vectors
