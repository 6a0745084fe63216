// The quadratic form M of centres by which balls grow at the last level of the symbolic perturbation but the ranks
// (PROOFS.md, section 3), and the products of vectors for it.
#pragma once

#include "exact/plane.hpp"
#include "exact/wide_integer.hpp"

namespace hsp::exact {

template <class Limb>
WideInteger<Limb, 128> dot128(const Vector &a, const Vector &b) {
  const auto times = [](int64_t p, int64_t q) {
    return product<128>(WideInteger<Limb, 64>::from(p), WideInteger<Limb, 64>::from(q));
  };
  return times(a.x, b.x) + times(a.y, b.y) + times(a.z, b.z);
}

// M of a centre relative to the origin ball.
template <class Limb>
WideInteger<Limb, 128> last_amount(const Vector &v) {
  const auto &[x, y, z] = v;
  return dot128<Limb>({1009 * x + 757 * y + 499 * z, 331 * y + 211 * z, 113 * z}, v);
}

}  // namespace hsp::exact
