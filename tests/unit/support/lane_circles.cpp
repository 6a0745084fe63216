#include "lane_circles.hpp"

#if HSP_AVX2
#include "sphere/covered_circles_avx2.hpp"

uint32_t covered_circles(const FloatCapArrays &circles, const FloatCapArrays &caps, uint32_t count) {
  using hsp::CoveredArcs;
  CoveredArcs arcs(CoveredArcs::Caps8::load({circles.x, circles.y, circles.z, circles.b}, 0));
  for (uint32_t t = 0; t < count; ++t) {
    arcs.cover(CoveredArcs::Caps8::all_of({caps.x, caps.y, caps.z, caps.b}, t));
  }
  return arcs.covered();
}

#endif
