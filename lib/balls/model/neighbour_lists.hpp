// The neighbours of all balls at once, as rows of one array: those of the caller's ball i are ids[first[i]] ..
// ids[first[i + 1] - 1], ascending.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

// Whether each pair of balls stands in the rows of both, or only in that of the smaller index.
enum class PairRows { both, smaller };

// Sets first [n + 1]. False, and zeros, if all rows together are longer than 2^32 - 1. Neither this nor the next one is
// finished if that is no longer allowed.
bool count_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Patience patience = Patience());

// More ids than most processors have near memory for.
constexpr uint32_t most_cached_ids = UINT32_C(1) << 22;  // 16 MB

// Fills ids [first[n]]; first is as count_neighbours leaves it, before and after. If there are more than so many ids,
// each row is written at once where that can be done: the same rows, in less time for a large set.
void list_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Span<uint32_t> ids,
                     uint32_t most_cached = most_cached_ids, Patience patience = Patience());

// From the lengths of the rows to where they begin: first[i] becomes the sum of all before it, for all i up to n.
// False, and zeros, if first[n] would be above 2^32 - 1.
bool sum_up(Span<uint32_t> first);

}  // namespace hsp
