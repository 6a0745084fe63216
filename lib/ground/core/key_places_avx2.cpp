#include "core/key_places.hpp"

#if HSP_AVX2
#include "lanes/avx2_lanes.hpp"

namespace hsp {

void count_places_wide(const int64_t *key, uint32_t count, uint32_t *place) {
  for (uint32_t k = 0; k < count; k += 8) {
    const LongIntegers low = LongIntegers::load(key + k), high = LongIntegers::load(key + k + 4);
    LongCounts smaller_low, smaller_high;
    for (uint32_t j = 0; j < count; ++j) {
      const LongIntegers other = LongIntegers::all_of(key + j);
      smaller_low.count_greater(low, other);
      smaller_high.count_greater(high, other);
    }
    smaller_low.store(place + k);
    smaller_high.store(place + k + 4);
  }
}

}  // namespace hsp
#endif
