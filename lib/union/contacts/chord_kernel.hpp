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

  // Each lane has its own first and second.
  static uint32_t nearest(const CapColumns &caps, uint32_t first, uint32_t last, const ChordRay &ray) {
    const Real mx = L::all(-ray.m[0]), my = L::all(-ray.m[1]), mz = L::all(-ray.m[2]);
    const Real wx = L::all(ray.w[0]), wy = L::all(ray.w[1]), wz = L::all(ray.w[2]);
    const Real slope = L::all(ChordRay::least_slope);
    const Real twice = L::all(2 * ChordRay::least_slope);
    const Real none = L::all(ChordRay::none);
    constexpr int64_t numbers = ChordRay::most_caps - 1;
    Mask number{};
    for (uint32_t lane = 0; lane < n; ++lane) number[lane] = first + lane;
    Real best = none, second = none;
    Mask unclear{};
    for (uint32_t t = first; t < last; t += n) {
      const Real ux = L::load(caps.ux + t), uy = L::load(caps.uy + t), uz = L::load(caps.uz + t);
      const Real depth = L::fused(mz, uz, L::fused(my, uy, L::fused(mx, ux, L::load(caps.b + t))));  // -f
      const Real g = L::fused(wz, uz, L::fused(wy, uy, wx * ux));
      unclear |= L::larger(depth, L::absolute(g)) <= twice;
      const Real quotient = L::select(g > slope, depth / g, none);
      const Real s = L::number((L::bits(quotient) & ~(Mask{} + numbers)) | number);
      second = L::smaller(second, L::larger(best, s));
      best = L::smaller(s, best);
      number += n;
    }
    double least = best[0], next = second[0];
    for (uint32_t lane = 1; lane < n; ++lane) {
      const double larger = least < best[lane] ? best[lane] : least;
      const double other = next < second[lane] ? next : second[lane];
      next = larger < other ? larger : other;
      least = least < best[lane] ? least : best[lane];
    }
    const double gap = ray.error * (8 / ChordRay::least_slope) + 0x1p-34;
    const bool certain = ray.error <= ChordRay::most_error && !L::any(unclear) && least < 2.0 && next - least > gap;
    uint64_t bits = 0;
    std::memcpy(&bits, &least, sizeof bits);
    return certain ? static_cast<uint32_t>(bits & numbers) : no_cut;
  }
};

}  // namespace
}  // namespace hsp
