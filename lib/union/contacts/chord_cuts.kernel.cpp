#include "contacts/chord_kernel.hpp"

namespace hsp::HSP_TARGET {

uint32_t nearest_cut(const CapColumns &caps, uint32_t first, uint32_t last, const ChordRay &ray) {
  return ChordKernel<register_lanes>::nearest(caps, first, last, ray);
}

}  // namespace hsp::HSP_TARGET
