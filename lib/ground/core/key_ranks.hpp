// Finds the ranks of a few keys in ascending order, by counting the smaller keys: no branch depends on a key, as it
// could not be predicted.
//
// As an example keys 30 10 20 10: there are 3, 0, 2 and 0 smaller keys, so that the ranks are 3 0 2 0.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

inline constexpr uint32_t most_counted_keys = 32;

// Writes rank[k] of key[k], for up to most_counted_keys keys. Equal keys get the same rank. Both arrays have room for
// most_counted_keys.
HSP_KERNEL(void, count_ranks, (const int64_t *key, uint32_t count, uint32_t *rank), (key, count, rank))

}  // namespace hsp
