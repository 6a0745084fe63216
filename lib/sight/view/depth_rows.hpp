// Kernels on the cells of a depth buffer that a disc meets, row by row: as many cells at a time as a register of the
// target holds doubles, with the same answers and the same floors for all targets, to the last bit.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

// Most discs are at most 10 + 1/2 cells wide, so they meet at most 12 columns and 12 rows.
struct DiscCells {
  static constexpr uint32_t most = 16;
  uint32_t first_column, columns, first_row, rows;
  double squared[most];  // squared distance of each column; infinite behind the last one
  double in_row[most];   // R^2 less the squared distance of each row
};

enum class CellEdge : uint8_t { nearest, farthest };

// A disc on cells; cell 0 has its corner at `left` and `bottom`. squared: the square of its radius, or a little more or
// less.
struct DiscOnCells {
  double x, y, squared;
  double left, bottom, cell;
  CellEdge edge;
};

// The floors of all cells, row by row, and for each coarse cell the mark that one of its cells has been raised. Three
// floats behind the last row are read, and written as they were.
struct FloorCells {
  float *floor;
  uint32_t columns;
  uint8_t *stale;
  uint32_t coarse_columns;
};

// A coarse cell has 4 x 4 cells.
inline constexpr uint32_t coarse_side = 4;

// Sets the distances of the cells whose columns and rows are given.
HSP_KERNEL(void, measure_cells, (const DiscOnCells &disc, DiscCells &cells), (disc, cells))
// Whether no point of a ball's front is above the floor. base: the height of the centre; base and R^2 are those of the
// ball made larger by the margin.
HSP_KERNEL(bool, hides, (const FloorCells &cells, const DiscCells &disc, double base), (cells, disc, base))
// Raises the floor to a front, less a margin and the rounding to a float.
HSP_KERNEL(void, raise, (const FloorCells &cells, const DiscCells &disc, double base, double margin),
           (cells, disc, base, margin))

}  // namespace hsp
