#include "poses/near_pairs.hpp"

#include "poses/near_pairs_kernel.hpp"

namespace hsp::HSP_TARGET {

uint32_t find_near_pairs(const SphereLevels &fixed, const SphereLevels &moving, const FloatPose &pose, PairWalk &walk) {
  return PairWalker(fixed, moving, pose, walk).find();
}

}  // namespace hsp::HSP_TARGET
