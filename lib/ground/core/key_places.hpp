// The places of a few keys in ascending order, by counting the smaller ones: no branch depends on a key, as none could
// be predicted.
#pragma once

#include <cstdint>

namespace hsp {

inline constexpr uint32_t most_counted_keys = 32;

// place[k] of key[k], for up to that many keys. Equal keys get the same place.
void count_places(const int64_t *key, uint32_t count, uint32_t *place);
// The same, four at a time, for processors with AVX2. Both arrays have room for most_counted_keys.
void count_places_wide(const int64_t *key, uint32_t count, uint32_t *place);

}  // namespace hsp
