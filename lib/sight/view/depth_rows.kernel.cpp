// Floors become results, so that no product and sum are fused here.
#include "view/depth_rows.hpp"

#include <limits>

#include "lanes/wide.hpp"

namespace hsp::HSP_TARGET {
namespace {

using CellLanes = Wide<double, register_lanes>;
using FloorLanes = Wide<float, register_lanes>;
using Heights = CellLanes::Real;

// The distances of the cells' nearest or farthest edges along one axis, squared.
Heights edge_distances(const DiscOnCells &disc, double coordinate, double origin, uint32_t first) {
  constexpr double counted[] = {0.0, 1.0, 2.0, 3.0};
  const Heights low = origin + (static_cast<double>(first) + CellLanes::load(counted)) * disc.cell;
  const Heights below = low - coordinate;
  const Heights above = coordinate - (low + disc.cell);
  // Inside the cell both are negative, outside one of them is.
  const Heights distance = disc.edge == CellEdge::farthest
                               ? CellLanes::smaller(below, above)
                               : CellLanes::larger(CellLanes::larger(below, above), CellLanes::all(0.0));
  return distance * distance;
}

// Some cells of one row, under a disc whose front has its centre at the base.
struct RowCells {
  Heights left_over;  // squared height of the front above its centre; positive where the disc meets the cell
  FloorLanes::Real floor;
  Heights square;  // the square of the floor's height above the centre, with the sign of that height

  RowCells(double in_row, const double *squared, const float *row, double base)
      : left_over(in_row - CellLanes::load(squared)), floor(FloorLanes::load(row)) {
    const Heights above = __builtin_convertvector(floor, Heights) - base;
    square = above * CellLanes::absolute(above);
  }
  // Whether the disc meets some cell in the mask.
  bool any_met(const CellLanes::Mask &mask) const {
    return (CellLanes::set_lanes(left_over > 0.0) & CellLanes::set_lanes(mask)) != 0;
  }
};

}  // namespace

void measure_cells(const DiscOnCells &disc, DiscCells &cells) {
  for (uint32_t k = 0; k < cells.columns; k += register_lanes) {
    CellLanes::store(cells.squared + k, edge_distances(disc, disc.x, disc.left, cells.first_column + k));
  }
  // The lanes behind the last column read this. A constant, since without optimisation a call would be code that other
  // files have as well.
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (uint32_t k = cells.columns; k % register_lanes != 0; ++k) cells.squared[k] = infinite;
  for (uint32_t k = 0; k < cells.rows; k += register_lanes) {
    CellLanes::store(cells.in_row + k, disc.squared - edge_distances(disc, disc.y, disc.bottom, cells.first_row + k));
  }
}

bool hides(const FloorCells &cells, const DiscCells &disc, double base) {
  const float *row = cells.floor + disc.first_row * cells.columns + disc.first_column;
  for (uint32_t r = 0; r < disc.rows; ++r, row += cells.columns) {
    for (uint32_t k = 0; k < disc.columns; k += register_lanes) {
      const RowCells some(disc.in_row[r], disc.squared + k, row + k, base);
      if (some.any_met(some.left_over >= some.square)) return false;
    }
  }
  return true;
}

void raise(const FloorCells &cells, const DiscCells &disc, double base, double margin) {
  for (uint32_t r = 0; r < disc.rows; ++r) {
    const uint32_t row = disc.first_row + r;
    float *const floor = cells.floor + row * cells.columns + disc.first_column;
    for (uint32_t k = 0; k < disc.columns; k += register_lanes) {
      const RowCells some(disc.in_row[r], disc.squared + k, floor + k, base);
      if (!some.any_met(some.left_over > some.square)) continue;  // saves the square root
      // Beyond the disc the height is NaN, which is above nothing.
      const Heights height = base + CellLanes::square_root(some.left_over);
      const Heights lowered = height - 0x1p-22 * CellLanes::absolute(height) - margin;
      const FloorLanes::Real after = __builtin_convertvector(lowered, FloorLanes::Real);
      const FloorLanes::Mask raised = after > some.floor;
      const uint32_t marked = static_cast<uint32_t>(FloorLanes::set_lanes(raised));
      if (marked == 0) continue;
      FloorLanes::store(floor + k, FloorLanes::select(raised, after, some.floor));
      uint8_t *const stale = cells.stale + row / coarse_side * cells.coarse_columns;
      const uint32_t column = disc.first_column + k;
      stale[(column + static_cast<uint32_t>(__builtin_ctz(marked))) / coarse_side] = 1;
      stale[(column + 31U - static_cast<uint32_t>(__builtin_clz(marked))) / coarse_side] = 1;
    }
  }
}

}  // namespace hsp::HSP_TARGET
