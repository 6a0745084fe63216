#include "contacts/chord_kernel.hpp"

namespace hsp::HSP_TARGET {

uint32_t nearest_cut(const CapColumns &caps, uint32_t first, uint32_t last, uint32_t j, uint32_t k, double direction) {
  return ChordKernel<register_lanes>::nearest(caps, first, last, j, k, direction);
}

}  // namespace hsp::HSP_TARGET
