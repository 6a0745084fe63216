// The kernel of chord_cuts.hpp for registers of n doubles. chord_kernel.cpp and chord_kernel_avx2.cpp compile it; like
// everything in files for AVX2 it has internal linkage.
#pragma once

#include "contacts/chord_cuts.hpp"
#include "core/double_lanes.hpp"

namespace hsp {
namespace {

template <uint32_t n>
struct ChordKernel {
  using L = DoubleLanes<n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Vector = VectorOf<Real>;

  // Each lane has its own first and second.
  static NearestCut nearest(const CapColumns &caps, uint32_t first, uint32_t last, const ChordRay &ray) {
    const Vector m{L::all(ray.m[0]), L::all(ray.m[1]), L::all(ray.m[2])};
    const Vector w{L::all(ray.w[0]), L::all(ray.w[1]), L::all(ray.w[2])};
    const Real slope = L::all(ChordRay::least_slope);
    const Real none = L::all(ChordRay::none);
    Real best = none;
    Real second = none;
    Mask found{};
    Mask unclear{};
    for (uint32_t t = first; t < last; t += n) {
      const Vector u{L::load(caps.ux + t), L::load(caps.uy + t), L::load(caps.uz + t)};
      const Real depth = L::load(caps.b + t) - dot(m, u);  // -f
      const Real g = dot(w, u);
      unclear += L::both(L::absolute(g) <= slope, depth <= 2 * slope);
      const Real s = L::select(g > slope, depth / g, none);
      const Mask closer = s < best;
      second = L::smaller(second, L::larger(best, s));
      best = L::smaller(s, best);
      found = L::bits(L::select(closer, L::number(Mask{} + static_cast<int64_t>(t)), L::number(found)));
    }
    NearestCut result{best[0], second[0], static_cast<uint32_t>(found[0]), static_cast<uint32_t>(-L::sum(unclear))};
    for (uint32_t lane = 1; lane < n; ++lane) {
      const bool closer = best[lane] < result.s;
      const double other = closer ? result.s : best[lane];
      if (closer) {
        result.s = best[lane];
        result.cap = static_cast<uint32_t>(found[lane]) + lane;
      }
      if (other < result.second) result.second = other;
      if (second[lane] < result.second) result.second = second[lane];
    }
    return result;
  }
};

}  // namespace
}  // namespace hsp
