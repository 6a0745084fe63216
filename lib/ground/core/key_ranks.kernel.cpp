#include "core/key_ranks.hpp"

#include "lanes/wide.hpp"

namespace hsp::HSP_TARGET {

void count_ranks(const int64_t *key, uint32_t count, uint32_t *rank) {
  if constexpr (register_lanes < 4) {  // few of these compare integers of 64 bits
    for (uint32_t k = 0; k < count; ++k) {
      uint32_t smaller = 0;
      for (uint32_t j = 0; j < count; ++j) smaller += static_cast<uint32_t>(key[j] < key[k]);
      rank[k] = smaller;
    }
  } else {
    using L = Wide<double, register_lanes>;
    using Mask = L::Mask;
    for (uint32_t k = 0; k < count; k += 8) {
      const Mask low = L::load_mask(key + k), high = L::load_mask(key + k + 4);
      Mask low_count{}, high_count{};
      for (uint32_t j = 0; j < count; ++j) {
        const Mask other = Mask{} + key[j];
        low_count -= low > other;
        high_count -= high > other;
      }
      L::store_integers(rank + k, low_count);
      L::store_integers(rank + k + 4, high_count);
    }
  }
}

}  // namespace hsp::HSP_TARGET
