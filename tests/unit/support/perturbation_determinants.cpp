#include "perturbation_determinants.hpp"

#include <tuple>

namespace perturbation {
namespace {

Integer inner(const int64_t (&a)[3], const int64_t (&b)[3]) {
  return Integer(static_cast<Int128>(a[0]) * b[0] + static_cast<Int128>(a[1]) * b[1] +
                 static_cast<Int128>(a[2]) * b[2]);
}

Integer determinant_2(const Integer &a, const Integer &b, const Integer &c, const Integer &d) {
  return a * d - b * c;
}

Integer determinant_3(const Integer (&m)[3][3]) {
  return m[0][0] * determinant_2(m[1][1], m[1][2], m[2][1], m[2][2]) -
         m[0][1] * determinant_2(m[1][0], m[1][2], m[2][0], m[2][2]) +
         m[0][2] * determinant_2(m[1][0], m[1][1], m[2][0], m[2][1]);
}

Integer determinant_4(const Integer (&m)[4][4]) {
  Integer sum;
  for (int column = 0; column < 4; ++column) {
    Integer minor[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int k = 0, to = 0; k < 4; ++k) {
        if (k != column) minor[i][to++] = m[i + 1][k];
      }
    }
    const Integer term = m[0][column] * determinant_3(minor);
    sum = column % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

}  // namespace

Balls::Balls(const Ball (&four)[4], int gap) : gap_(gap) {
  const auto key = [](const Ball &ball) {
    return std::make_tuple(ball.centre[0], ball.centre[1], ball.centre[2], ball.radius, ball.index);
  };
  for (int k = 0; k < 4; ++k) {
    ball_[k] = four[k];
    rank_[k] = 0;
    for (int l = 0; l < 4; ++l) rank_[k] += key(four[l]) < key(four[k]) ? 1 : 0;
  }
}

Integer Balls::weight(int k) const {
  const Integer given = Integer(static_cast<Int128>(ball_[k].radius) * ball_[k].radius);
  if (gap_ == 0) return given;
  // Seen from the first ball: whatever meets is near enough.
  Int128 x[3];
  for (int axis = 0; axis < 3; ++axis) x[axis] = static_cast<Int128>(ball_[k].centre[axis]) - ball_[0].centre[axis];
  const Int128 form =
      x[0] * (1009 * x[0] + 757 * x[1] + 499 * x[2]) + x[1] * (331 * x[1] + 211 * x[2]) + 113 * x[2] * x[2];
  const auto scaled = [this](const Integer &amount, int exponent) {
    return amount.times_power_of_two(unit_bits() - 64 * exponent * gap_);
  };
  return scaled(given, 0) + scaled(given, 1) + scaled(Integer(1), 3) + scaled(Integer(x[0]), 4) +
         scaled(Integer(x[1]), 5) + scaled(Integer(x[2]), 6) + scaled(Integer(form), 7) +
         scaled(Integer(1), 8 + rank_[k]);
}

Relation relation(const Balls &balls, int a, int b) {
  int64_t u[3];
  for (int k = 0; k < 3; ++k) u[k] = balls[b].centre[k] - balls[a].centre[k];
  const Integer w_a = balls.weight(a);
  const Integer w_b = balls.weight(b);
  // The distance lies between |r_a - r_b| and r_a + r_b iff |U - w_a - w_b| < 2 r_a r_b.
  const Integer t = inner(u, u).times_power_of_two(balls.unit_bits()) - w_a - w_b;
  const int sign = (t * t - Integer(4) * w_a * w_b).sign();
  if (sign == 0) return Relation::tangent;
  if (sign < 0) return Relation::circle;
  if (t.sign() > 0) return Relation::disjoint;
  return (w_a - w_b).sign() < 0 ? Relation::first_in_second : Relation::second_in_first;
}

HalfSpace half_space(const Balls &balls, int origin, int other) {
  HalfSpace result;
  for (int k = 0; k < 3; ++k) result.v[k] = balls[other].centre[k] - balls[origin].centre[k];
  result.h =
      inner(result.v, result.v).times_power_of_two(balls.unit_bits()) + balls.weight(origin) - balls.weight(other);
  return result;
}

HalfSpace half_space_of_plane(const Balls &balls, const int64_t (&v)[3], int64_t h) {
  return {{v[0], v[1], v[2]}, Integer(h).times_power_of_two(balls.unit_bits())};
}

Integer Origin::D(const HalfSpace &P, const HalfSpace &Q) const {
  const Integer uv = inner(P.v, Q.v);
  return determinant_3(
      {{inner(P.v, P.v), uv, P.h}, {uv, inner(Q.v, Q.v), Q.h}, {P.h, Q.h, W.times_power_of_two(unit_bits)}});
}

Integer Origin::beta(const HalfSpace &P, const HalfSpace &R) const {
  return determinant_2(inner(P.v, P.v), inner(P.v, R.v), P.h, R.h);
}

Integer Origin::A(const HalfSpace &P, const HalfSpace &Q, const HalfSpace &R) const {
  const Integer uv = inner(P.v, Q.v);
  return -determinant_3(
      {{inner(P.v, P.v), uv, P.h}, {uv, inner(Q.v, Q.v), Q.h}, {inner(P.v, R.v), inner(Q.v, R.v), R.h}});
}

Integer Origin::B(const HalfSpace &P, const HalfSpace &Q, const HalfSpace &R) const {
  Integer rows[3][3];
  for (int k = 0; k < 3; ++k) {
    rows[0][k] = Integer(P.v[k]);
    rows[1][k] = Integer(Q.v[k]);
    rows[2][k] = Integer(R.v[k]);
  }
  return determinant_3(rows);
}

Integer Origin::F(const HalfSpace &P, const HalfSpace &Q, const HalfSpace &R) const {
  const Integer uv = inner(P.v, Q.v);
  const Integer uz = inner(P.v, R.v);
  const Integer vz = inner(Q.v, R.v);
  return determinant_4({{inner(P.v, P.v), uv, uz, P.h},
                        {uv, inner(Q.v, Q.v), vz, Q.h},
                        {uz, vz, inner(R.v, R.v), R.h},
                        {P.h, Q.h, R.h, W.times_power_of_two(unit_bits)}});
}

Integer Origin::N(const HalfSpace &P, const HalfSpace &Q) const {
  const Integer uv = inner(P.v, Q.v);
  return determinant_2(inner(P.v, P.v), uv, uv, inner(Q.v, Q.v));
}

int Origin::point_sign(const Integer &D, const Integer &A, const Integer &B, int s) {
  const int first = A.sign();
  const int second = D.sign() == 0 ? 0 : s * B.sign();
  if (second == 0) return first;
  if (first == 0 || first == second) return second;
  return first * (A * A - B * B * D).sign();
}

}  // namespace perturbation
