// The kernel of chord_cuts.hpp for registers of n doubles. Like everything in kernels it has internal
// linkage.
#pragma once

#include "contacts/chord_cuts.hpp"
#include "lanes/wide.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {
namespace {

template <uint32_t n>
struct ChordKernel {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Word = OwnedDouble<ChordKernel>;

  // Each lane has its own first and second.
  static uint32_t nearest(const CapColumns &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k,
                          double direction) {
    const LaneCaps<Word> u = cap_in<Word>(caps, j), v = cap_in<Word>(caps, k);
    const LanePairs<Word> pair(u, v);
    const LaneChords<Word> chord(u, v, pair.g, pair.q);
    // Written so that what is not a number is certain of nothing.
    if (!(pair.certainly_cross_in_points() && chord.error.v <= CapColumns::most_error)) return no_cut;
    const double gamma = direction * chord.gamma.v;
    const Real mx = L::all(-chord.mx.v), my = L::all(-chord.my.v), mz = L::all(-chord.mz.v);
    const Real wx = L::all(gamma * chord.nx.v), wy = L::all(gamma * chord.ny.v), wz = L::all(gamma * chord.nz.v);
    const Real slope = L::all(CapColumns::least_slope);
    const Real twice = L::all(2 * CapColumns::least_slope);
    const Real none = L::all(CapColumns::none), start = L::all(CapColumns::start), shift = L::all(CapColumns::shift);
    constexpr int64_t numbers = CapColumns::most_caps - 1;
    Mask number{};
    for (uint32_t lane = 0; lane < n; ++lane) number[lane] = lane;
    number += first;
    Real best = none + shift, second = best;
    Mask unclear{};
    for (uint32_t t = first; t < last; t += n) {
      const Real ux = L::load(caps.ux + t), uy = L::load(caps.uy + t), uz = L::load(caps.uz + t);
      const Real depth = L::fused(mz, uz, L::fused(my, uy, L::fused(mx, ux, L::load(caps.b + t))));  // -f
      const Real slant = L::fused(wz, uz, L::fused(wy, uy, wx * ux));                                // g
      unclear += L::larger(depth, L::absolute(slant)) <= twice;
      const Real quotient = L::select(slant > slope, depth / L::larger(slant, slope), none);
      const Real s = L::number((L::bits(L::larger(quotient, start) + shift) & ~(Mask{} + numbers)) | number);
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
    const double gap = chord.error.v * (8 / CapColumns::least_slope) + 0x1p-29;
    uint64_t bits = 0;
    std::memcpy(&bits, &least, sizeof bits);
    return L::count(unclear) == 2 && least < 2.0 + CapColumns::shift && next - least > gap
               ? static_cast<uint32_t>(bits & numbers)
               : no_cut;
  }
};

}  // namespace
}  // namespace hsp
