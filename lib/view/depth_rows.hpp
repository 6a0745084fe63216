// The cells of a depth buffer that a disc meets, row by row, and what is asked of them: one by one, or for AVX2 four at
// a time. Both give the same answers and the same floors, to the last bit.
#pragma once

#include <cstdint>

namespace hsp {

// A disc is at most 10 + 1/2 cells wide, so it meets at most 12 columns and 12 rows.
struct DiscCells {
  static constexpr uint32_t most = 16;
  uint32_t first_column, columns, first_row, rows;
  double squared[most];  // distance of each column; infinite behind the last one
  double in_row[most];   // R^2 less the squared distance of each row
};

// Cells 0, 1, .. of each of the rows, and of the coarse rows the marks that a cell has been raised.
struct FloorCells {
  float *floor;
  uint32_t columns;
  uint8_t *stale;
  uint32_t coarse_columns;
};

// Coarse cells of 4 x 4 cells.
inline constexpr uint32_t coarse_side = 4;

// Whether no point of a front shows above the floor; base and R^2 are those of the ball made larger.
bool hides_one_by_one(const FloorCells &cells, const DiscCells &disc, double base);
// Raises the floor to a front, less a margin and the rounding to a float.
void raise_one_by_one(const FloorCells &cells, const DiscCells &disc, double base, double margin);

// The same, four cells at a time.
#if HSP_AVX2
bool hides_avx2(const FloorCells &cells, const DiscCells &disc, double base);
void raise_avx2(const FloorCells &cells, const DiscCells &disc, double base, double margin);
#else
inline bool hides_avx2(const FloorCells &, const DiscCells &, double) {
  return false;
}
inline void raise_avx2(const FloorCells &, const DiscCells &, double, double) {}
#endif

}  // namespace hsp
