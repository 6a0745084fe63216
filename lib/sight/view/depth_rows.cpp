#include "view/depth_rows.hpp"

#include <cmath>

namespace hsp {

void measure_cells(const DiscOnCells &disc, DiscCells &cells) {
  EdgeDistances<register_lanes>(disc).fill(cells);
}

bool hides_one_by_one(const FloorCells &cells, const DiscCells &disc, double base) {
  const float *row = cells.floor + disc.first_row * cells.columns + disc.first_column;
  for (uint32_t r = 0; r < disc.rows; ++r, row += cells.columns) {
    for (uint32_t k = 0; k < disc.columns; ++k) {
      const double left_over = disc.in_row[r] - disc.squared[k];
      if (left_over <= 0.0) continue;
      const double above = static_cast<double>(row[k]) - base;
      if (above <= 0.0 || above * above <= left_over) return false;
    }
  }
  return true;
}

void raise_one_by_one(const FloorCells &cells, const DiscCells &disc, double base, double margin) {
  for (uint32_t r = 0; r < disc.rows; ++r) {
    if (disc.in_row[r] <= 0.0) continue;
    const uint32_t row = disc.first_row + r;
    float *const floor = cells.floor + row * cells.columns + disc.first_column;
    uint8_t *const stale = cells.stale + row / coarse_side * cells.coarse_columns;
    for (uint32_t k = 0; k < disc.columns; ++k) {
      const double left_over = disc.in_row[r] - disc.squared[k];
      if (left_over <= 0.0) continue;
      const double above = static_cast<double>(floor[k]) - base;
      if (above > 0.0 && above * above >= left_over) continue;  // saves the square root
      const double height = base + std::sqrt(left_over);
      const float lowered = static_cast<float>(height - 0x1p-22 * std::fabs(height) - margin);
      if (!(lowered > floor[k])) continue;
      floor[k] = lowered;
      stale[(disc.first_column + k) / coarse_side] = 1;
    }
  }
}

}  // namespace hsp
