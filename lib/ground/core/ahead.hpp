// How many steps before its turn a loop asks memory for what it is going to read or write. It affects nothing but time.
// Short steps need more of them, and what is found by way of something else that is asked for, fewer. Where small code
// matters more than speed, most loops do not ask.
#pragma once

#include <cstdint>

namespace hsp::ahead {

inline constexpr uint32_t input_balls = 64;  // balls in the caller's order, while others are rounded or put into cubes
inline constexpr uint32_t slots = 32;        // of a hash table, while cubes are entered
inline constexpr uint32_t rows = 8;          // rows of neighbours that are written; twice as many for where they begin
inline constexpr uint32_t extents = 16;      // of cubes, from the highest one down
inline constexpr uint32_t vertices = 16;     // their half-edges, while faces are joined
inline constexpr uint32_t outputs = 24;      // areas and volumes that are written in the caller's order

// Visits of balls in the caller's order: what is found by a ball's index, by that, and by that in turn.
inline constexpr uint32_t ranges = 24, half_edges = 12, neighbours = 6;

// Sets of so many balls or vertices stay in the caches.
inline constexpr uint32_t few_balls = 16384, few_vertices = 32768;

}  // namespace hsp::ahead
