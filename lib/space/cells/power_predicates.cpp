#include "cells/power_predicates.hpp"

#include <initializer_list>

#include "exact/power.hpp"

namespace hsp {
namespace {

using exact::Vector;
template <int bits>
using Integer = exact::WideInteger<exact::FastLimb, bits>;
using I128 = Integer<128>;
using I192 = Integer<192>;

template <int bits>
struct LongVector {
  Integer<bits> x, y, z;
};

Integer<64> wide(int64_t a) {
  return Integer<64>::from(a);
}
I128 times(int64_t a, int64_t b) {
  return exact::product<128>(wide(a), wide(b));
}
I128 long_dot(const Vector &a, const Vector &b) {
  return times(a.x, b.x) + times(a.y, b.y) + times(a.z, b.z);
}
LongVector<128> long_cross(const Vector &a, const Vector &b) {
  return {times(a.y, b.z) - times(a.z, b.y), times(a.z, b.x) - times(a.x, b.z), times(a.x, b.y) - times(a.y, b.x)};
}
template <int out, int bits>
Integer<out> dot(const LongVector<bits> &a, const Vector &b) {
  return exact::product<out>(a.x, wide(b.x)) + exact::product<out>(a.y, wide(b.y)) +
         exact::product<out>(a.z, wide(b.z));
}
template <int out, int a_bits, int b_bits>
Integer<out> dot(const LongVector<a_bits> &a, const LongVector<b_bits> &b) {
  return exact::product<out>(a.x, b.x) + exact::product<out>(a.y, b.y) + exact::product<out>(a.z, b.z);
}

// A linear form in the perturbations of weights. It decides the linear predicates whose value is 0.
template <int bits>
class Inflations {
 public:
  // Adds the perturbation of a plane's h times a coefficient.
  void add(const PowerPlane &plane, const Integer<bits> &coefficient) {
    if (plane.is_side()) return;
    add(plane.near, coefficient);
    add(plane.far, -coefficient);
  }
  int sign(const BallSet &balls) const {
    uint32_t best = no_id;
    int sign = 0;
    for (int k = 0; k < count_; ++k) {
      const int candidate = coefficient_[k].sign();
      if (candidate == 0 || (best != no_id && !balls.ranks_before(ball_[k], best))) continue;
      best = ball_[k];
      sign = candidate;
    }
    return sign;
  }

 private:
  void add(uint32_t ball, const Integer<bits> &coefficient) {
    for (int k = 0; k < count_; ++k) {
      if (ball_[k] != ball) continue;
      coefficient_[k] = coefficient_[k] + coefficient;
      return;
    }
    ball_[count_] = ball;
    coefficient_[count_++] = coefficient;
  }

  uint32_t ball_[8] = {};
  Integer<bits> coefficient_[8];
  int count_ = 0;
};

}  // namespace

// Planes as integers, relative to the origin, and numbers computed from three of them.
struct PowerPredicates::Numbers {
  struct Plane {
    Vector v;
    I128 h;
  };

  explicit Numbers(const PowerPredicates &of) : p(of) {}

  Vector from_origin(uint32_t ball) const { return p.balls_.exact_difference(p.origin_, ball); }
  I128 radical(uint32_t ball) const {
    const int64_t r = static_cast<int64_t>(p.balls_.r[p.origin_]);
    const int64_t s = static_cast<int64_t>(p.balls_.r[ball]);
    return squared_length(from_origin(ball)) + times(r - s, r + s);
  }
  Plane plane(const PowerPlane &name) const {
    if (!name.is_side()) {
      if (name.near == p.origin_) return {from_origin(name.far), radical(name.far)};
      return {p.balls_.exact_difference(name.near, name.far), radical(name.far) - radical(name.near)};
    }
    const uint32_t axis = name.side() / 2;
    const bool upper = name.side() % 2 != 0;
    const int64_t sign = upper ? 1 : -1;
    const Vector &low = p.frame_.low();
    const int64_t corner = axis == 0 ? low.x : axis == 1 ? low.y : low.z;
    const int64_t centre = axis == 0 ? p.centre_.x : axis == 1 ? p.centre_.y : p.centre_.z;
    const int64_t distance = corner + (upper ? p.frame_.exact_side() : 0) - centre;
    return {{axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0}, I128::from(2 * sign * distance)};
  }
  int64_t W() const {
    const int64_t r = static_cast<int64_t>(p.balls_.r[p.origin_]);
    return 4 * r * r;
  }
  // The ball of lowest rank among the origin and the other balls of up to three planes.
  uint32_t lowest(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R) const {
    uint32_t best = p.origin_;
    for (const PowerPlane *plane : {&P, &Q, &R}) {
      if (!plane->is_side() && p.balls_.ranks_before(plane->far, best)) best = plane->far;
    }
    return best;
  }

  const PowerPredicates &p;
};

namespace {

// H = h_P (v x z) + h_Q (z x u) + h_R (u x v), and the three products; B = (u x v).z.
template <class Plane>
struct CommonPoint {
  CommonPoint(const Plane &P, const Plane &Q, const Plane &R)
      : qr(long_cross(Q.v, R.v)), rp(long_cross(R.v, P.v)), n(long_cross(P.v, Q.v)), B(dot<128>(n, R.v)) {
    const auto part = [&](const I128 &a, const I128 &b, const I128 &c) {
      return exact::product<192>(P.h, a) + exact::product<192>(Q.h, b) + exact::product<192>(R.h, c);
    };
    H = {part(qr.x, rp.x, n.x), part(qr.y, rp.y, n.y), part(qr.z, rp.z, n.z)};
  }

  LongVector<128> qr, rp, n;
  I128 B;
  LongVector<192> H;
};
template <class Plane>
CommonPoint(const Plane &, const Plane &, const Plane &) -> CommonPoint<Plane>;

}  // namespace

int PowerPredicates::side_of(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R, const PowerPlane &S) const {
  const Numbers numbers(*this);
  const CommonPoint point(numbers.plane(P), numbers.plane(Q), numbers.plane(R));
  const Numbers::Plane plane = numbers.plane(S);
  // h_S B - s.H, linear in the weights.
  int sign = (exact::product<192>(point.B, plane.h) - dot<192>(point.H, plane.v)).sign();
  if (sign == 0) {
    Inflations<128> inflations;
    inflations.add(S, point.B);
    inflations.add(P, -dot<128>(point.qr, plane.v));
    inflations.add(Q, -dot<128>(point.rp, plane.v));
    inflations.add(R, -dot<128>(point.n, plane.v));
    sign = inflations.sign(balls_);
  }
  return sign * point.B.sign();
}

bool PowerPredicates::is_outside(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R) const {
  const Numbers numbers(*this);
  const CommonPoint point(numbers.plane(P), numbers.plane(Q), numbers.plane(R));
  const auto square = exact::product<256>(point.B, point.B);
  const auto HH = dot<320>(point.H, point.H);
  const int F = (exact::product<320>(square, wide(numbers.W())) - HH).sign();
  if (F != 0) return F < 0;
  const uint32_t lowest = numbers.lowest(P, Q, R);
  if (!P.is_side() && lowest == P.far) return dot<256>(point.H, point.qr).sign() <= 0;
  if (!Q.is_side() && lowest == Q.far) return dot<256>(point.H, point.rp).sign() <= 0;
  if (!R.is_side() && lowest == R.far) return dot<256>(point.H, point.n).sign() <= 0;
  auto sum = square + square;
  if (!P.is_side()) sum = sum - dot<256>(point.H, point.qr);
  if (!Q.is_side()) sum = sum - dot<256>(point.H, point.rp);
  if (!R.is_side()) sum = sum - dot<256>(point.H, point.n);
  return sum.sign() <= 0;
}

bool PowerPredicates::meets_line(const PowerPlane &P, const PowerPlane &Q) const {
  const Numbers numbers(*this);
  const Numbers::Plane p = numbers.plane(P), q = numbers.plane(Q);
  const LongVector<128> n = long_cross(p.v, q.v);
  const I192 N = dot<192>(n, n);
  const auto part = [&](int64_t a, int64_t b) {
    return exact::product<128>(p.h, wide(b)) - exact::product<128>(q.h, wide(a));
  };
  const LongVector<128> radical{part(p.v.x, q.v.x), part(p.v.y, q.v.y), part(p.v.z, q.v.z)};
  const int D = (exact::product<256>(N, wide(numbers.W())) - dot<256>(radical, radical)).sign();
  if (D != 0) return D > 0;
  // Half of the derivative by the weight of the lowest rank; the second one is negative.
  const I192 alpha = dot<192>(radical, q.v);
  const I192 minus_beta = dot<192>(radical, p.v);
  const uint32_t lowest = numbers.lowest(P, Q, Q);
  if (!P.is_side() && lowest == P.far) return alpha.sign() > 0;
  if (!Q.is_side() && lowest == Q.far) return minus_beta.sign() < 0;
  I192 sum = N + N;
  if (!P.is_side()) sum = sum - alpha;
  if (!Q.is_side()) sum = sum + minus_beta;
  return sum.sign() > 0;
}

int PowerPredicates::side_of_middle(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R) const {
  const Numbers numbers(*this);
  const CommonPoint point(numbers.plane(P), numbers.plane(Q), numbers.plane(R));
  // -A = H.n, linear in the weights.
  const int sign = dot<256>(point.H, point.n).sign();
  if (sign != 0) return sign;
  Inflations<192> inflations;
  inflations.add(P, dot<192>(point.qr, point.n));
  inflations.add(Q, dot<192>(point.rp, point.n));
  inflations.add(R, dot<192>(point.n, point.n));
  return inflations.sign(balls_);
}

bool PowerPredicates::meets_plane(const PowerPlane &P) const {
  const Numbers numbers(*this);
  const Numbers::Plane p = numbers.plane(P);
  const I128 U = squared_length(p.v);
  const int delta = (exact::product<192>(U, wide(numbers.W())) - exact::product<192>(p.h, p.h)).sign();
  if (delta != 0) return delta > 0;
  if (P.is_side()) return true;
  if (numbers.lowest(P, P, P) == P.far) return p.h.sign() > 0;
  return (U + U - p.h).sign() > 0;
}

int PowerPredicates::side_of_disc(const PowerPlane &P, const PowerPlane &R) const {
  const Numbers numbers(*this);
  const Numbers::Plane p = numbers.plane(P), r = numbers.plane(R);
  const I128 U = squared_length(p.v);
  const I128 uz = long_dot(p.v, r.v);
  // beta = h_R u.u - h_P u.z, linear in the weights.
  const int sign = (exact::product<192>(r.h, U) - exact::product<192>(p.h, uz)).sign();
  if (sign != 0) return sign;
  Inflations<128> inflations;
  inflations.add(R, U);
  inflations.add(P, -uz);
  return inflations.sign(balls_);
}

int PowerPredicates::side_of_centre(const PowerPlane &P) const {
  const int sign = Numbers(*this).plane(P).h.sign();
  if (sign != 0 || P.is_side()) return sign;
  return balls_.ranks_before(origin_, P.far) ? 1 : -1;
}

bool PowerPredicates::reaches(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R,
                              const exact::Vector &point) const {
  const Numbers numbers(*this);
  const CommonPoint common(numbers.plane(P), numbers.plane(Q), numbers.plane(R));
  const Vector y{2 * (point.x - centre_.x), 2 * (point.y - centre_.y), 2 * (point.z - centre_.z)};
  const int sign = (dot<192>(common.H, y) - exact::product<192>(common.B, squared_length(y))).sign();
  return sign * common.B.sign() >= 0;
}

Vec3 PowerPredicates::common_point(const PowerPlane &P, const PowerPlane &Q, const PowerPlane &R) const {
  const Numbers numbers(*this);
  const CommonPoint common(numbers.plane(P), numbers.plane(Q), numbers.plane(R));
  const double B = common.B.to_double();
  return {common.H.x.to_double() / B, common.H.y.to_double() / B, common.H.z.to_double() / B};
}

}  // namespace hsp
