// Finds the neighbours of all balls at once, as rows of one array: the neighbours of the caller's ball i are
// ids[first[i]] .. ids[first[i + 1] - 1], by the caller's indices, ascending.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

// Whether each pair of balls is listed in the rows of both balls, or only in the row of the smaller index.
enum class PairRows { both, smaller };

// Sets first [n + 1]. False, and zeros in `first`, if all rows together are longer than 2^32 - 1. If `patience` allows
// no more work, neither this function nor list_neighbours() is finished.
bool count_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Patience patience = Patience());

// As many ids as fit the caches of most processors.
constexpr uint32_t most_cached_ids = UINT32_C(1) << 22;  // 16 MB

// Fills ids [first[n]]. `first` is as count_neighbours() leaves it, before and after the call. If there are more than
// most_cached ids, each row is written at once where possible: the rows are the same, but take less time in a large
// set.
void list_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Span<uint32_t> ids,
                     uint32_t most_cached = most_cached_ids, Patience patience = Patience());

// Turns the lengths of rows into their beginnings: first[i] becomes the sum of all entries before it, for all i up to
// n. False, and zeros, if first[n] would be above 2^32 - 1.
bool sum_up(Span<uint32_t> first);

}  // namespace hsp
