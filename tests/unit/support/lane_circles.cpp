#include "lane_circles.hpp"

#if HSP_AVX2
#include "sphere/covered_circles_avx2.hpp"

uint32_t covered_circles(const FloatCapArrays &circles, const FloatCapArrays &caps, uint32_t count) {
  using hsp::CoveredArcs;
  using Caps8 = CoveredArcs::Caps8;
  const hsp::CapPointers<float> all{circles.x, circles.y, circles.z, circles.b};
  CoveredArcs arcs(Caps8::load(all, 0), Caps8::load(all, 8));
  for (uint32_t t = 0; t < count; ++t) {
    float fractions[4][8];
    hsp::store_as_fractions(Caps8::all_of({caps.x, caps.y, caps.z, caps.b}, t), fractions[0], fractions[1],
                            fractions[2], fractions[3]);
    arcs.cover(hsp::FractionCap::all_of({fractions[0], fractions[1], fractions[2], fractions[3]}, t % 8));
  }
  const CoveredArcs::Covered covered = arcs.covered();
  return covered.low | covered.high << 8;
}

#endif
