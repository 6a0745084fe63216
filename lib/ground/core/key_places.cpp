#include "core/key_places.hpp"

namespace hsp {

void count_places(const int64_t *key, uint32_t count, uint32_t *place) {
  for (uint32_t k = 0; k < count; ++k) {
    uint32_t smaller = 0;
    for (uint32_t j = 0; j < count; ++j) smaller += static_cast<uint32_t>(key[j] < key[k]);
    place[k] = smaller;
  }
}

}  // namespace hsp
