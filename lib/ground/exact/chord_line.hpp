// The line in which two planes meet, (q x n + t n)/N: the line of a chord, in exact numbers that are rounded once. n =
// u x v, N = n.n and q = h_P v - h_Q u as in plane.hpp.
//
// q x n = alpha u + beta v with alpha = h_P v.v - h_Q u.v and beta = h_Q u.u - h_P u.v, so that a third plane meets the
// line where t = -A/B, with A = (q x n).z - h_R N = alpha u.z + beta v.z - h_R N. Bits: alpha, beta, N <= 2 L^4, so A
// and each of its terms are below 5 L^6: 192 bits. Everything follows from products of 128 and 64 bits.
//
// As an example u = (6,0,0) and v = (0,6,0) with h_P = h_Q = 36: n = (0,0,36), N = 1296 and alpha = beta = 36 * 36, so
// that the line is (6,6,0) + t (0,0,1/36). A third plane z = (0,0,6) with h_R = 36 has A = -36 * 1296 and B = 216, so
// that it meets the line where t = 216, in (6,6,6).
#pragma once

#include "exact/discriminant.hpp"
#include "exact/power.hpp"

namespace hsp::exact {

// Factors of a chord's terms in the areas of its contacts (lib/union/contacts), each rounded once.
struct ChordFactors {
  double alpha, beta, third, N;  // third = 2 N - alpha - beta
};

template <class Limb>
class ChordLine {
 public:
  ChordLine(const Plane &P, const Plane &Q) : u_(P.v), v_(Q.v), n_(cross(P.v, Q.v)) {
    const int64_t uv = dot(P.v, Q.v);
    N_ = dot128<Limb>(n_, n_);
    alpha_ = times<Limb>(P.h, dot(Q.v, Q.v)) - times<Limb>(Q.h, uv);
    beta_ = times<Limb>(Q.h, dot(P.v, P.v)) - times<Limb>(P.h, uv);
  }

  ChordFactors factors() const {
    return {alpha_.to_double(), beta_.to_double(), (N_ + N_ - alpha_ - beta_).to_double(), N_.to_double()};
  }
  // The parameter t = -A/B at which a third plane meets the line; A and B are rounded once each. B is not 0.
  double parameter(const Plane &R) const {
    const auto minus_A = product<192>(N_, I64::from(R.h)) - product<192>(alpha_, I64::from(dot(u_, R.v))) -
                         product<192>(beta_, I64::from(dot(v_, R.v)));
    return minus_A.to_double() / dot128<Limb>(n_, R.v).to_double();
  }

 private:
  using I64 = WideInteger<Limb, 64>;
  using I128 = WideInteger<Limb, 128>;

  Vector u_, v_, n_;
  I128 alpha_, beta_, N_;
};

#if defined(__SIZEOF_INT128__) && !defined(HSP_PORTABLE_LIMBS)

// The same with the compiler's products of 128 bits.
template <>
class ChordLine<uint64_t> {
 public:
  ChordLine(const Plane &P, const Plane &Q) : u_(P.v), v_(Q.v), n_(cross(P.v, Q.v)) {
    const int64_t uv = dot(u_, v_);
    N_ = dot128(n_, n_);
    alpha_ = product(P.h, dot(v_, v_)) - product(Q.h, uv);
    beta_ = product(Q.h, dot(u_, u_)) - product(P.h, uv);
  }

  ChordFactors factors() const {
    return {rounded(alpha_), rounded(beta_), rounded(N_ + N_ - alpha_ - beta_), rounded(N_)};
  }
  // A number below 2^125 is b 2^62 + a with |b| <= 2^63 and 0 <= a < 2^62, so no sum of three products with numbers of
  // 62 bits needs more than 128 bits.
  double parameter(const Plane &R) const {
    const int64_t uz = dot(u_, R.v);
    const int64_t vz = dot(v_, R.v);
    const int128 lower = product(low(N_), R.h) - product(low(alpha_), uz) - product(low(beta_), vz);
    const int128 upper = product(high(N_), R.h) - product(high(alpha_), uz) - product(high(beta_), vz) + (lower >> 62);
    return rounded_sum(upper, low(lower)) / rounded(dot128(n_, R.v));
  }

 private:
  static int128 product(int64_t a, int64_t b) { return static_cast<int128>(a) * b; }
  static int128 dot128(const Vector &a, const Vector &b) {
    return product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z);
  }
  static int64_t low(int128 x) { return static_cast<int64_t>(x) & ((INT64_C(1) << 62) - 1); }
  static int64_t high(int128 x) { return static_cast<int64_t>(x >> 62); }
  // Converts the sign and the leading 63 bits; the last of these is set if any bit behind it is: so the conversion
  // rounds as the whole number would. more_follows: further bits behind x are not all 0.
  static double rounded(int128 x, bool more_follows = false) {
    const int64_t top = static_cast<int64_t>(x >> 64);
    const int64_t bottom = static_cast<int64_t>(x);
    if (top == bottom >> 63) return static_cast<double>(bottom);
    const int spare = __builtin_clrsbll(top);
    const uint128 shifted = static_cast<uint128>(x) << spare;
    const bool inexact = static_cast<uint64_t>(shifted) != 0 || more_follows;
    const int64_t leading = static_cast<int64_t>(shifted >> 64) | static_cast<int64_t>(inexact);
    return static_cast<double>(leading) * power_of_two(64 - spare);
  }
  // upper 2^62 + lower with 0 <= lower < 2^62
  static double rounded_sum(int128 upper, int64_t lower) {
    const int64_t top = static_cast<int64_t>(upper >> 64);
    if (top != 0 && top != -1) return rounded(upper, lower != 0) * power_of_two(62);
    return rounded(static_cast<int128>(static_cast<uint128>(upper) << 62) + lower);
  }
  static double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<uint64_t>(exponent + 1023) << 52);
  }

  Vector u_, v_, n_;
  int128 alpha_, beta_, N_;
};

#endif

}  // namespace hsp::exact
