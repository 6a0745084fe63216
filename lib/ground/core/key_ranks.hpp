// The ranks of a few keys in ascending order, by counting the smaller ones: no branch depends on a key, as none could
// be predicted.
//
// As an example keys 30 10 20 10: of them 3, 0, 2 and 0 are smaller, so that the ranks are 3 0 2 0.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

inline constexpr uint32_t most_counted_keys = 32;

// rank[k] of key[k], for up to that many keys. Equal keys get the same rank. Both arrays have room for
// most_counted_keys.
HSP_KERNEL(void, count_ranks, (const int64_t *key, uint32_t count, uint32_t *rank), (key, count, rank))

}  // namespace hsp
