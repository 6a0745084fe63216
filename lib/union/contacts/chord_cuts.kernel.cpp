#include "contacts/chord_cuts.hpp"
#include "lanes/wide.hpp"
#include "lanes/words.hpp"

namespace hsp::HSP_TARGET {
namespace {

struct Owner {};

// L: lanes, for caps. Word: one number, or one number in all of these lanes, for the chord.
template <class L, class Word>
struct ChordKernel {
  using T = typename Word::Real;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  static constexpr uint32_t n = L::lanes;

  static Real in_all(const Word &word) {
    if constexpr (sizeof word == sizeof(T)) {
      return L::all(word.v);
    } else {
      return Real(word.v);
    }
  }
  // nearest_cut(). Each lane keeps the first and the second cut of its own caps.
  static uint32_t nearest(const CapPointers<T> &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k,
                          uint32_t side) {
    const auto u = LaneCaps<Word>::all_of(caps, j), v = LaneCaps<Word>::all_of(caps, k);
    const LanePairs<Word> pair(u, v);
    const LaneChords<Word> chord(u, v, pair.g, pair.q);
    if (!pair.certainly_cross_in_points()) return no_cut;  // also if numbers are NaN
    const Real mx = -in_all(chord.mx), my = -in_all(chord.my), mz = -in_all(chord.mz);
    const Real gamma = L::all(static_cast<T>(static_cast<int32_t>(2 * side) - 1)) * in_all(chord.gamma);
    const Real wx = gamma * in_all(chord.nx), wy = gamma * in_all(chord.ny), wz = gamma * in_all(chord.nz);
    const Real none = L::all(4), bound = 2 * in_all(chord.error);
    const Real steep = 4 * bound;
    Mask number{};
    for (uint32_t lane = 0; lane < n; ++lane) number[lane] = static_cast<typename L::Signed>(lane);
    number += static_cast<typename L::Signed>(first);
    Mask nearest{}, unclear{};
    Real best = none, second = none, slope = none;
    for (uint32_t t = first; t < last; t += n) {
      const Real ux = L::load(caps.x + t), uy = L::load(caps.y + t), uz = L::load(caps.z + t);
      const Real depth = L::fused(mz, uz, L::fused(my, uy, L::fused(mx, ux, L::load(caps.b + t))));  // -f
      const Real slant = L::fused(wz, uz, L::fused(wy, uy, wx * ux));                                // g
      const Mask may_cut = slant + bound > L::absolute(depth), is_clear = L::both(may_cut, slant > steep);
      unclear += may_cut - is_clear;
      const Real s = L::select(is_clear, (depth - bound) / slant, none);  // a lower bound of the cut
      const Mask is_first = s < best;
      nearest = is_first ? number : nearest;
      slope = L::select(is_first, slant, slope);
      second = L::smaller(second, L::larger(best, s));
      best = L::smaller(s, best);
      number += n;
    }
    const T least = L::least(best);
    const uint32_t lane = static_cast<uint32_t>(__builtin_ctzll(L::set_lanes(best == L::all(least))));
    const Real most = L::all(least + 2 * bound[0] / slope[lane]);  // an upper bound of the first cut
    const uint64_t before = L::set_lanes(best <= most);
    return L::sum(unclear) == -2 && least < 2 && (before & (before - 1)) == 0 && L::set_lanes(second <= most) == 0
               ? static_cast<uint32_t>(nearest[lane])
               : no_cut;
  }
};

}  // namespace

uint32_t nearest_cut(const CapPointers<double> &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k,
                     uint32_t side) {
  return ChordKernel<Wide<double, register_lanes>, OwnedDouble<Owner>>::nearest(caps, first, last, j, k, side);
}
#if HSP_LANES
uint32_t nearest_cut(const CapPointers<float> &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k,
                     uint32_t side) {
  return ChordKernel<Wide<float, Floats::lanes>, Floats>::nearest(caps, first, last, j, k, side);
}
#endif

}  // namespace hsp::HSP_TARGET
