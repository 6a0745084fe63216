#include "lane_circles.hpp"

#if HSP_LANES
#include "sphere/covered_circles.hpp"

namespace hsp::HSP_TARGET {

uint32_t covered_circles(const FloatCapArrays &circles, const FloatCapArrays &caps, uint32_t count) {
  using SomeCaps = CoveredArcs::SomeCaps;
  constexpr uint32_t n = Floats::lanes;
  const CapPointers<float> all{circles.x, circles.y, circles.z, circles.b};
  uint32_t found = 0;
  for (uint32_t k = 0; k < 16; k += Fractions::lanes) {
    CoveredArcs arcs(SomeCaps::load(all, k), SomeCaps::load(all, k + n));
    for (uint32_t t = 0; t < count; ++t) {
      float fractions[4][n];
      store_as_fractions(SomeCaps::all_of({caps.x, caps.y, caps.z, caps.b}, t), fractions[0], fractions[1],
                         fractions[2], fractions[3]);
      arcs.cover(FractionCap::all_of({fractions[0], fractions[1], fractions[2], fractions[3]}, t % n));
    }
    const CoveredArcs::Covered covered = arcs.covered();
    found |= (covered.low | covered.high << n) << k;
  }
  return found;
}

}  // namespace hsp::HSP_TARGET

#endif
