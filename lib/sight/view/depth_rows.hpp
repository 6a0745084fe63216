// The cells of a depth buffer that a disc meets, row by row, and what is asked of them: one by one, or for AVX2 four at
// a time. Both give the same answers and the same floors, to the last bit.
#pragma once

#include <cstdint>
#include <limits>

#include "lanes/wide.hpp"

namespace hsp {

// A disc is at most 10 + 1/2 cells wide, so it meets at most 12 columns and 12 rows.
struct DiscCells {
  static constexpr uint32_t most = 16;
  uint32_t first_column, columns, first_row, rows;
  double squared[most];  // distance of each column; infinite behind the last one
  double in_row[most];   // R^2 less the squared distance of each row
};

enum class CellEdge : uint8_t { nearest, farthest };

// A disc on cells whose number 0 begins at `left` and `bottom`. squared: of its radius, or a little more or less.
struct DiscOnCells {
  double x, y, squared;
  double left, bottom, cell;
  CellEdge edge;
};

namespace {

// Fills in the distances of the cells' nearest or farthest edges, for registers of n doubles.
template <uint32_t n>
class EdgeDistances {
 public:
  explicit EdgeDistances(const DiscOnCells &disc) : disc_(disc) {}

  void fill(DiscCells &cells) const {
    for (uint32_t k = 0; k < cells.columns; k += n) {
      L::store(cells.squared + k, square(disc_.x, disc_.left, cells.first_column + k));
    }
    // Read by four lanes behind the last column.
    for (uint32_t k = cells.columns; k % 4 != 0; ++k) cells.squared[k] = infinite;
    for (uint32_t k = 0; k < cells.rows; k += n) {
      L::store(cells.in_row + k, disc_.squared - square(disc_.y, disc_.bottom, cells.first_row + k));
    }
  }

 private:
  using L = Wide<double, n>;
  using Real = typename L::Real;

  // A constant, since without optimisation a call would be code that other files have as well.
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  Real square(double coordinate, double origin, uint32_t first) const {
    constexpr double counted[] = {0.0, 1.0, 2.0, 3.0};
    const Real low = origin + (static_cast<double>(first) + L::load(counted)) * disc_.cell;
    const Real below = low - coordinate;
    const Real above = coordinate - (low + disc_.cell);
    // Inside both are negative, and outside one of them.
    const Real distance =
        disc_.edge == CellEdge::farthest ? L::smaller(below, above) : L::larger(L::larger(below, above), L::all(0.0));
    return distance * distance;
  }

  const DiscOnCells &disc_;
};

}  // namespace

// Cells 0, 1, .. of each of the rows, and of the coarse rows the marks that a cell has been raised.
struct FloorCells {
  float *floor;
  uint32_t columns;
  uint8_t *stale;
  uint32_t coarse_columns;
};

// Coarse cells of 4 x 4 cells.
inline constexpr uint32_t coarse_side = 4;

// Fills in the distances of the cells that are counted.
void measure_cells(const DiscOnCells &disc, DiscCells &cells);
// Whether no point of a front shows above the floor; base and R^2 are those of the ball made larger.
bool hides_one_by_one(const FloorCells &cells, const DiscCells &disc, double base);
// Raises the floor to a front, less a margin and the rounding to a float.
void raise_one_by_one(const FloorCells &cells, const DiscCells &disc, double base, double margin);

// The same, four cells at a time.
#if HSP_AVX2
void measure_cells_avx2(const DiscOnCells &disc, DiscCells &cells);
bool hides_avx2(const FloorCells &cells, const DiscCells &disc, double base);
void raise_avx2(const FloorCells &cells, const DiscCells &disc, double base, double margin);
#else
inline void measure_cells_avx2(const DiscOnCells &, DiscCells &) {}
inline bool hides_avx2(const FloorCells &, const DiscCells &, double) {
  return false;
}
inline void raise_avx2(const FloorCells &, const DiscCells &, double, double) {}
#endif

}  // namespace hsp
