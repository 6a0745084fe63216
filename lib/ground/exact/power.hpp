// Products and quadratic forms of integer vectors, in 128 bits. Exact if no component and no radius is 2^62 or more in
// size, and the result has room.
#pragma once

#include "exact/plane.hpp"
#include "exact/wide_integer.hpp"

namespace hsp::exact {

template <class Limb>
WideInteger<Limb, 128> times(int64_t a, int64_t b) {
  return product<128>(WideInteger<Limb, 64>::from(a), WideInteger<Limb, 64>::from(b));
}

template <class Limb>
WideInteger<Limb, 128> dot128(const Vector &a, const Vector &b) {
  return times<Limb>(a.x, b.x) + times<Limb>(a.y, b.y) + times<Limb>(a.z, b.z);
}

// Written out, as compilers do not inline dot128() here: location of a point in cells takes 2 % more with it.
inline WideInteger<FastLimb, 128> squared_length(const Vector &d) {
  return times<FastLimb>(d.x, d.x) + times<FastLimb>(d.y, d.y) + times<FastLimb>(d.z, d.z);
}

// The power of a point to a sphere, |d|^2 - r^2 with d from the centre to the point: negative inside, positive outside.
inline WideInteger<FastLimb, 128> power(const Vector &d, int64_t radius) {
  return squared_length(d) - times<FastLimb>(radius, radius);
}

// M of a centre relative to the origin ball: the form by which balls grow at the last level of the symbolic
// perturbation but the ranks (PROOFS.md, section 3).
template <class Limb>
WideInteger<Limb, 128> last_amount(const Vector &v) {
  const auto &[x, y, z] = v;
  return dot128<Limb>({1009 * x + 757 * y + 499 * z, 331 * y + 211 * z, 113 * z}, v);
}

}  // namespace hsp::exact
