#include "contacts/chord_kernel.hpp"
#include "lanes/words.hpp"

namespace hsp::HSP_TARGET {
namespace {

struct Owner {};

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
