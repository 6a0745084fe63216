// Numbers the cubes so that those of one row, with equal y and z, have consecutive numbers in the order of x. The balls
// of neighbouring cubes of a row are then consecutive too, and one search in the hash table finds all of them.
#pragma once

#include "model/cube_table.hpp"

namespace hsp {

// Scratch memory: as many slots as the table of these cubes has, and one link and one entry of order per cube.
struct CubeOrderScratch {
  Span<uint32_t> slots, links, order;
};

// Renumbers the cubes of the table; scratch.links then holds the new number of each old one. Rows keep the order of
// their first cubes. O(cubes) for rows of bounded length, else O(cubes log cubes).
void order_cubes_by_rows(CubeTable &table, CubeOrderScratch scratch);

}  // namespace hsp
