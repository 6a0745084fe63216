// The kernel of chord_cuts.hpp for registers of n doubles. Like everything in kernels it has internal
// linkage.
#pragma once

#include "contacts/chord_cuts.hpp"
#include "lanes/wide.hpp"

namespace hsp {
namespace {

template <uint32_t n>
struct ChordKernel {
  using L = Wide<double, n>;
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
    // The lane of the least, and the next one of all others or behind it in its lane; the same where two are equal.
    double least = best[0];
    for (uint32_t lane = 1; lane < n; ++lane) least = best[lane] < least ? best[lane] : least;
    const Mask is_least = best == least;
    const uint64_t set = L::set_lanes(is_least);
    const Real behind = L::select(is_least, second, best);
    double next = behind[0];
    for (uint32_t lane = 1; lane < n; ++lane) next = behind[lane] < next ? behind[lane] : next;
    if ((set & (set - 1)) != 0) next = least;
    const uint32_t lane = static_cast<uint32_t>(__builtin_ctzll(set));
    return {least, next, static_cast<uint32_t>(found[lane]) + lane, static_cast<uint32_t>(-L::sum(unclear))};
  }
};

}  // namespace
}  // namespace hsp
