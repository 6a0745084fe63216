#include "lane_pairs.hpp"

#if HSP_LANES
#include "sphere/crossing_pairs.hpp"

namespace hsp::HSP_TARGET {
namespace {

template <class Lanes>
typename Lanes::Real first(const Lanes &lanes) {
  typename Lanes::Real all[Lanes::lanes];
  lanes.store(all);
  return all[0];
}

template <class Lanes>
LanePair<typename Lanes::Real> pair_in([[maybe_unused]] const ThreeCaps<typename Lanes::Real> &three,
                                       [[maybe_unused]] uint32_t j, [[maybe_unused]] uint32_t k) {
  LanePair<typename Lanes::Real> result{};
  if constexpr (Lanes::lanes > 2) {
    using Cap = LaneCaps<Lanes>;
    const CapPointers<typename Lanes::Real> caps{three.x, three.y, three.z, three.b};
    const Cap u = Cap::all_of(caps, j), v = Cap::all_of(caps, k);
    const LanePairs<Lanes> pair(u, v);
    CrossingPairs<Lanes, 32> pairs;
    pairs.add(0, Lanes::all(0), u, Lanes::all(1), v, pair, 1);
    const LaneCrossings<Lanes> points = pairs.points(0);
    result.g = first(pair.g);
    result.q = first(pair.q);
    result.centre_jk = first(fused_minus(pair.g, u.b, v.b));
    result.centre_kj = first(fused_minus(pair.g, v.b, u.b));
    for (uint32_t l = 0; l < 3; ++l) {
      result.depth[0][l] = first(points.minus.depth(Cap::all_of(caps, l)));
      result.depth[1][l] = first(points.plus.depth(Cap::all_of(caps, l)));
    }
    result.error = first(points.plus.error);
  }
  return result;
}

}  // namespace

LanePair<float> lane_pair(const ThreeCaps<float> &caps, uint32_t j, uint32_t k) {
  return pair_in<Floats>(caps, j, k);
}
LanePair<double> lane_pair(const ThreeCaps<double> &caps, uint32_t j, uint32_t k) {
  return pair_in<Doubles>(caps, j, k);
}

}  // namespace hsp::HSP_TARGET

#endif
