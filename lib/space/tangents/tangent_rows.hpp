// The linear algebra of points that are equally far from several balls: rows, the lines that these leave, and forms,
// for any type of number.
#pragma once

#include <type_traits>

#include "tangents/tangent_point.hpp"

namespace hsp {
namespace {

using Bounded = BoundedDouble;
using Integer = TangentPoint::Integer;
using Long = TangentPoint::Long;

template <class Number>
using Triple = NumberTriple<Number>;

template <class Number>
Number dot(const Triple<Number> &a, const Triple<Number> &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
Triple<Number> cross(const Triple<Number> &a, const Triple<Number> &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Number>
Triple<Number> operator+(const Triple<Number> &a, const Triple<Number> &b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Number>
Triple<Number> operator-(const Triple<Number> &a) {
  return {-a.x, -a.y, -a.z};
}
template <class Number>
Triple<Number> operator*(const Number &s, const Triple<Number> &a) {
  return {s * a.x, s * a.y, s * a.z};
}

// Differences of coordinates and radii are integers below 2^53.
template <class Number>
Number number(double integer) {
  if constexpr (std::is_same_v<Number, Integer>) {
    return Integer(static_cast<int64_t>(integer));
  } else {
    return Bounded(integer);
  }
}

template <class Number>
Triple<Number> difference(const BallSet &balls, uint32_t from, uint32_t to) {
  const Vec3 d = balls.difference(from, to);
  return {number<Number>(d.x), number<Number>(d.y), number<Number>(d.z)};
}

// v.y + e z = w
template <class Number>
struct Row {
  Triple<Number> v;
  Number e, w;
};
template <class Number>
Row<Number> row_of(const BallSet &balls, uint32_t base, uint32_t ball) {
  const Triple<Number> C = difference<Number>(balls, base, ball);
  const Number e = number<Number>(balls.r[ball] - balls.r[base]);
  return {C, e, dot(C, C) - e * e};
}
template <class Number>
Row<Number> plane_row(const Triple<Number> &normal) {
  return {normal, number<Number>(0.0), number<Number>(0.0)};
}

template <class Number>
struct CurveRows {
  CurveRows(const BallSet &balls, const TangentCurve &curve)
      : first(row_of<Number>(balls, curve.base, curve.second)), second(row_of<Number>(balls, curve.base, curve.third)) {
    if (curve.in_plane) second = plane_row(cross(first.v, second.v));
    normal = cross(first.v, second.v);
  }
  Row<Number> first, second;
  Triple<Number> normal;  // of the plane or line through the centres
};

// The line that three rows leave, if they do not fix z.
template <class Number>
struct SteepLine {
  SteepLine(const CurveRows<Number> &rows, const Row<Number> &third) {
    const Row<Number> &first = rows.first, &second = rows.second;
    const Triple<Number> N1 = cross(second.v, third.v), N2 = cross(third.v, first.v);
    D = dot(first.v, N1);
    P = first.w * N1 + second.w * N2 + third.w * rows.normal;
    Q = -(first.e * N1 + second.e * N2 + third.e * rows.normal);
  }
  Number A() const { return dot(Q, Q) - D * D; }
  Number b() const { return dot(P, Q); }
  Number c() const { return dot(P, P); }
  Triple<Number> position_at(const Number &z) const {
    return {(P.x + Q.x * z) / D, (P.y + Q.y * z) / D, (P.z + Q.z * z) / D};
  }

  Triple<Number> P, Q;
  Number D;
};

// The same line in plain doubles with static error bounds. Let l1, l2, l3 be bounds of the lengths of the v, M their
// product, S the sum of those that belong to balls, and u = 2^-53. A v that is a product of others is wrong by 6 u of
// its length. So the errors are below: a component of a cross product N: (3 + 24) u l l; D: l (27 sqrt(3) + 6 sqrt(3) +
// 4) u l l < 80 u M; w: 10 u l^2, as |e| < l; P: (27 + 10 + 5) u M S < 64 u M S; Q: 3 (27 + 5) u M < 128 u M.
struct RoughLine {
  RoughLine(const BallSet &balls, const TangentCurve &curve, uint32_t last) {
    struct PlainRow {
      Vec3 v;
      double e, w;
    };
    const auto row = [&](uint32_t ball) {
      const Vec3 C = balls.difference(curve.base, ball);
      const double e = balls.r[ball] - balls.r[curve.base];
      return PlainRow{C, e, dot(C, C) - e * e};
    };
    const auto length = [](const Vec3 &v) { return 1.0001 * std::sqrt(dot(v, v)); };
    const PlainRow first = row(curve.second);
    PlainRow second = row(curve.third);
    double S = length(first.v);
    double M = S;
    Vec3 normal = cross(first.v, second.v);
    if (curve.in_plane) {
      second = {normal, 0.0, 0.0};
      normal = cross(first.v, second.v);
      M *= length(second.v);
    } else {
      const double l = length(second.v);
      M *= l;
      S += l;
    }
    const PlainRow third = last == no_id ? PlainRow{normal, 0.0, 0.0} : row(last);
    const double l = length(third.v);
    M *= l;
    if (last != no_id) S += l;
    const Vec3 N1 = cross(second.v, third.v), N2 = cross(third.v, first.v);
    error_P = 64 * unit_roundoff * M * S;
    error_Q = 128 * unit_roundoff * M;
    D = {dot(first.v, N1), 80 * unit_roundoff * M};
    P = combine(first.w, N1, second.w, N2) + third.w * normal;
    Q = combine(-first.e, N1, -second.e, N2) - third.e * normal;
    // Each is a sum of three products, of vectors all components of which have one error bound: sqrt(3) < 1.75.
    const double PP = dot(P, P), QQ = dot(Q, Q), size_P = std::sqrt(PP) + 2.0 * error_P;
    const double rounding = 4 * unit_roundoff;
    size_Q = std::sqrt(QQ) + 2.0 * error_Q;
    square_Q = {QQ, 3.5 * size_Q * error_Q + rounding * size_Q * size_Q};
    product = {dot(P, Q), 1.75 * (size_P * error_Q + size_Q * error_P) + rounding * size_P * size_Q};
    square_P = {PP, 3.5 * size_P * error_P + rounding * size_P * size_P};
  }
  Bounded A() const { return square_Q - D * D; }
  Bounded b() const { return product; }
  Bounded c() const { return square_P; }
  // (P + Q z) / D, with one error bound for all components.
  Triple<Bounded> position_at(const Bounded &z) const {
    const double inverse = 1.0 / D.value;
    const Vec3 y = combine(inverse, P, inverse * z.value, Q);
    const double size = std::fabs(z.value) + z.error;
    const double least = std::fabs(D.value) - D.error, length = std::sqrt(dot(P, P)) + size_Q * size;
    const double error = 1.001 * ((error_P + error_Q * size + size_Q * z.error + 8 * unit_roundoff * length) / least +
                                  length * D.error / (least * least));
    return {{y.x, error}, {y.y, error}, {y.z, error}};
  }

  Vec3 P, Q;
  Bounded D, square_P, product, square_Q;
  double error_P, error_Q, size_Q;
};

template <class Number>
Row<Number> last_row(const BallSet &balls, const TangentCurve &curve, const CurveRows<Number> &rows, uint32_t last) {
  return last == no_id ? plane_row(rows.normal) : row_of<Number>(balls, curve.base, last);
}

// The same form with another ball as base.
template <class Number>
AffineForm<Number> moved(const BallSet &balls, const AffineForm<Number> &form, uint32_t base) {
  if (form.origin == base) return form;
  const Number twice = number<Number>(2.0);
  const Number e = number<Number>(balls.r[form.origin] - balls.r[base]);
  return {form.a, form.c, form.k + twice * (form.c * e - dot(form.a, difference<Number>(balls, base, form.origin))),
          base};
}

template <class Number>
AffineForm<Number> homogeneous(const Triple<Number> &a, const Number &c, uint32_t origin) {
  return {a, c, number<Number>(0.0), origin};
}

}  // namespace
}  // namespace hsp
