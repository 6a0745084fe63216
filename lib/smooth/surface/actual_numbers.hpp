// The balls of the actual set (actual_balls.hpp) in numbers with an error bound: doubles, or floats of some width.
#pragma once

#include "boundary/boundary.hpp"
#include "numbers/number_vector.hpp"
#include "surface/kept_vertices.hpp"

namespace hsp {

// Numbers of some width, and the balls in them.
template <class Number>
struct ActualNumbers;

template <>
struct ActualNumbers<BoundedDouble> {
  const BallSet &balls;
  const Boundary &boundary;
  KeptVertices &kept;
  static constexpr uint32_t bits = 53;

  // A bound on how far coordinates of the actual set differ from the input: far less than the last bit of a double, but
  // more than the smallest double.
  static constexpr double shift = 0x1p-590;

  // Positions are relative to the ball at hand, where doubles are precise; those of floats to the component's origin.
  static constexpr bool from_one_place = false;
  uint32_t origin_for(uint32_t ball) const { return ball; }
  BoundedDouble number(int64_t value) const { return {static_cast<double>(value)}; }
  // From ball i to ball j.
  void find_difference(uint32_t i, uint32_t j, NumberVector<BoundedDouble> &v) const {
    const Vec3 exact = balls.difference(i, j);
    v = {{exact.x, shift}, {exact.y, shift}, {exact.z, shift}};
  }
  BoundedDouble weight(uint32_t i) const { return product(balls.r[i], balls.r[i]); }
  BoundedDouble weight_difference(uint32_t i, uint32_t j) const {
    const BoundedDouble rest = product(balls.r[i] - balls.r[j], balls.r[i] + balls.r[j]);
    return {rest.value, rest.error + 0x1p-180 * (balls.r[i] * balls.r[i] + balls.r[j] * balls.r[j])};
  }
  BoundedDouble weight_over_probe(uint32_t i) const {
    const double p = static_cast<double>(balls.probe_steps);
    const BoundedDouble rest = product(balls.r[i] - p, balls.r[i] + p);
    return {rest.value, rest.error + 0x1p-180 * balls.r[i] * balls.r[i]};
  }
  // The root of 4 w N - q.q for the vertex (exact/PROOFS.md). The value for the input is exact and rounded once. The
  // value for the actual set differs from it by less than 2^-185 of its terms, so the roots differ by less than the
  // root of that. The balls meet, so the sum of their radii bounds their distances.
  BoundedDouble root_discriminant(uint32_t v, const BoundedDouble &, const NumberVector<BoundedDouble> &) const {
    const double root = boundary.root_discriminant(v);
    const VertexRecord &record = boundary.vertex(v);
    const double length = 4 * (balls.r[record.ball[0]] + balls.r[record.ball[1]] + balls.r[record.ball[2]]);
    return {root, 0x1p-50 * root + 0x1p-85 * (length * length * length)};
  }

 private:
  static BoundedDouble product(double a, double b) { return BoundedDouble(a) * BoundedDouble(b); }
};

template <>
struct ActualNumbers<WideFloat> {
  const BallSet &balls;
  const Boundary &boundary;
  KeptVertices &kept;
  uint32_t bits;

  static constexpr bool from_one_place = true;
  uint32_t origin_for(uint32_t ball) const { return boundary.component_origin(ball); }
  WideFloat number(int64_t value) const { return WideFloat(value, bits); }
  void find_difference(uint32_t i, uint32_t j, NumberVector<WideFloat> &v) const;
  WideFloat weight(uint32_t i) const;
  WideFloat weight_difference(uint32_t i, uint32_t j) const { return weight(i) - weight(j); }
  WideFloat weight_over_probe(uint32_t i) const {
    const WideFloat p = number(balls.probe_steps);
    return weight(i) - p * p;
  }
  WideFloat root_discriminant(uint32_t v, const WideFloat &square, const NumberVector<WideFloat> &q) const;
};

// The discriminant of two circles on a sphere with this weight: 4 weight n.n - q.q, where `square` is n.n, with n and q
// as in exact/PROOFS.md.
template <class Number>
[[gnu::noinline]] Number discriminant_of(const Number &square, const NumberVector<Number> &q, const Number &weight) {
  return (weight * square).scaled(2) - dot(q, q);
}

}  // namespace hsp
