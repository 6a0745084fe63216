#if HSP_AVX2
#include "contacts/chord_kernel.hpp"

namespace hsp {

NearestCut nearest_cut_avx2(const CapColumns &caps, uint32_t first, uint32_t last, const ChordRay &ray) {
  return ChordKernel<4>::nearest(caps, first, last, ray);
}

}  // namespace hsp
#endif
