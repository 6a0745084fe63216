// The neighbours of all balls at once, as rows of one array: those of the caller's ball i are ids[first[i]] ..
// ids[first[i + 1] - 1], ascending.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

// Whether each pair of balls stands in the rows of both, or only in that of the smaller index.
enum class PairRows { both, smaller };

// Sets first [n + 1]. False, and zeros, if all rows together are longer than 2^32 - 1.
bool count_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first);

// Fills ids [first[n]]; first is as count_neighbours leaves it, before and after.
void list_neighbours(const CubeGrid &grid, PairRows rows, Span<uint32_t> first, Span<uint32_t> ids);

// From the lengths of the rows to where they begin: first[i] becomes the sum of all before it, for all i up to n.
// False, and zeros, if first[n] would be above 2^32 - 1.
bool sum_up(Span<uint32_t> first);

}  // namespace hsp
