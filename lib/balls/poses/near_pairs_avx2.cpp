#include "poses/near_pairs.hpp"

#if HSP_AVX2
#include "lanes/avx2_lanes.hpp"
#include "poses/near_pairs_kernel.hpp"

namespace hsp {

uint32_t find_near_pairs_avx2(const SphereLevels &fixed, const SphereLevels &moving, const FloatPose &pose,
                              PairWalk &walk) {
  return PairWalker<Floats>(fixed, moving, pose, walk).find();
}

}  // namespace hsp
#endif
