// D = W n.n - q.q of plane.hpp, and Delta = W u.u - h^2, rounded once; 0 if they are negative. The values are those of
// ExactPredicates, which is for limbs of any width. The functions here use the compiler's products of 128 bits, if
// there are such; they are called for every vertex and every contact.
#pragma once

#include "exact/exact_predicates.hpp"

namespace hsp::exact {

#if defined(__SIZEOF_INT128__) && !defined(HSP_PORTABLE_LIMBS)

__extension__ typedef __int128 int128;

// high 2^64 + low, rounded to the nearest double; 0 if it is negative.
inline double rounded_or_zero(int128 high, uint64_t low) {
  if (high < 0) return 0.0;
  const uint64_t top = static_cast<uint64_t>(high >> 64);
  const uint64_t middle = static_cast<uint64_t>(high);
  // The two limbs that hold the leading bits, and what lies below them.
  const bool is_long = top != 0;
  const uint128 leading = static_cast<uint128>(is_long ? top : middle) << 64 | (is_long ? middle : low);
  const uint64_t below = is_long ? low : 0;
  const uint64_t first = static_cast<uint64_t>(leading >> 64);
  if (first == 0) return static_cast<double>(low);
  const int spare = std::countl_zero(first);
  const uint128 shifted = leading << spare;
  // The leading 63 bits; the last of these is set if any bit behind it is: so the conversion rounds as the whole number
  // would.
  const uint64_t bits = static_cast<uint64_t>(shifted >> 65);
  const bool inexact = ((static_cast<uint64_t>(shifted >> 64) & 1) | static_cast<uint64_t>(shifted) | below) != 0;
  const double rounded = static_cast<double>(static_cast<int64_t>(bits | static_cast<uint64_t>(inexact)));
  const int exponent = (is_long ? 128 : 64) + 1 - spare;
  return rounded * std::bit_cast<double>(static_cast<uint64_t>(exponent + 1023) << 52);
}

inline double discriminant(const Sphere &sphere, const Plane &P, const Plane &Q) {
  const auto product = [](int64_t a, int64_t b) { return static_cast<int128>(a) * b; };
  const Vector n = cross(P.v, Q.v);
  const uint128 nn = static_cast<uint128>(product(n.x, n.x) + product(n.y, n.y) + product(n.z, n.z));
  const uint64_t W = static_cast<uint64_t>(sphere.W);
  const uint128 lower = static_cast<uint128>(static_cast<uint64_t>(nn)) * W;
  const uint128 upper = static_cast<uint128>(static_cast<uint64_t>(nn >> 64)) * W;

  // A component of q is at most 2^94 in size: it is b 2^48 + a with |b| <= 2^46 and 0 <= a < 2^48. No product of two
  // such parts, nor a sum of six products, needs more than 128 bits.
  int128 aa = 0, ab = 0, bb = 0;
  const auto add_square = [&](int64_t u, int64_t v) {
    const int128 q = product(P.h, v) - product(Q.h, u);
    const int64_t a = static_cast<int64_t>(q) & ((INT64_C(1) << 48) - 1);
    const int64_t b = static_cast<int64_t>(q >> 48);
    aa += product(a, a);
    ab += product(a, b);
    bb += product(b, b);
  };
  add_square(P.v.x, Q.v.x);
  add_square(P.v.y, Q.v.y);
  add_square(P.v.z, Q.v.z);

  // q.q = bb 2^96 + ab 2^49 + aa.
  const int128 low =
      static_cast<int128>(static_cast<uint64_t>(lower)) - static_cast<uint64_t>(aa) - (static_cast<uint64_t>(ab) << 49);
  const int128 high = static_cast<int128>(upper) + static_cast<int128>(lower >> 64) - (aa >> 64) - (ab >> 15) -
                      bb * (INT64_C(1) << 32) + (low >> 64);
  return rounded_or_zero(high, static_cast<uint64_t>(low));
}

// Delta = W u.u - h^2 for U = u.u, of which |Delta| < 2^125.
inline double circle_discriminant(const Sphere &sphere, const Plane &P, int64_t U) {
  const int128 Delta = static_cast<int128>(sphere.W) * U - static_cast<int128>(P.h) * P.h;
  return rounded_or_zero(Delta >> 64, static_cast<uint64_t>(Delta));
}

#else

inline double circle_discriminant(const Sphere &sphere, const Plane &P, int64_t) {
  const double Delta = Exact::circle_discriminant(sphere, P);
  return Delta > 0.0 ? Delta : 0.0;
}

inline double discriminant(const Sphere &sphere, const Plane &P, const Plane &Q) {
  return Exact::discriminant(sphere, P, Q);
}

#endif

}  // namespace hsp::exact
