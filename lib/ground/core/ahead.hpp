// Prefetch distances: how many steps ahead a loop prefetches the memory that it is going to read or write. They affect
// nothing but time. If steps are short, the distance is long. If an address is found in memory that is prefetched
// itself, the distance is shorter than for that memory. Small code mostly does without.
#pragma once

#include <cstdint>

namespace hsp::ahead {

inline constexpr uint32_t input_balls = 64;  // balls in the caller's order, while others are rounded or put into cubes
inline constexpr uint32_t slots = 32;        // of a hash table, while cubes are inserted
inline constexpr uint32_t rows = 8;          // rows of neighbours that are written; twice as many for their beginnings
inline constexpr uint32_t extents = 16;      // of cubes, from the highest one down
inline constexpr uint32_t vertices = 16;     // half-edges of vertices, while faces are joined
inline constexpr uint32_t outputs = 24;      // areas and volumes that are written in the caller's order

// Visits of balls in the caller's order: ranges are found by a ball's index, half-edges by its ranges, and neighbours
// by its half-edges.
inline constexpr uint32_t ranges = 24, half_edges = 12, neighbours = 6;

// Sets of up to so many balls or vertices stay in the caches.
inline constexpr uint32_t few_balls = 16384, few_vertices = 32768;

}  // namespace hsp::ahead
