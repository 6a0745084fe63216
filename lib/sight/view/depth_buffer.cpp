#include "view/depth_buffer.hpp"

#include "view/depth_rows.hpp"

namespace hsp {
namespace {

// Cells have a side of 0.2 of a radius, which is about the best for molecules (the optimum is flat). They are larger if
// there would be more cells than memory.
constexpr double cell_in_radii = 0.2;
constexpr uint64_t cells_per_ball = 16;
constexpr uint64_t further_cells = 4096;
constexpr uint64_t most_cells = 0xFFFFFFFF;

constexpr uint32_t coarse_cells(uint32_t cells) {
  return (cells + coarse_side - 1) / coarse_side;
}

// The cells first .. last - 1 along one axis.
struct CellRange {
  uint32_t first, last;

  CellRange(uint32_t first_cell, uint32_t end) : first(first_cell), last(end) {}
  // Those that an interval meets.
  CellRange(double low, double high, double origin, double cells_per_length, uint32_t cells) {
    const double a = (low - origin) * cells_per_length;
    const double b = (high - origin) * cells_per_length;
    first = a > 0.0 ? static_cast<uint32_t>(a) : 0;
    last = b > 0.0 ? static_cast<uint32_t>(b) + 1 : 1;
    if (last > cells) last = cells;
  }
  CellRange common(const CellRange &other) const {
    return {first > other.first ? first : other.first, last < other.last ? last : other.last};
  }
};

// The cells of a coarse cell along one axis; or the coarse cells of a tile.
CellRange parts_of(uint32_t coarse, uint32_t cells) {
  const uint32_t first = coarse * coarse_side;
  return CellRange{first, cells}.common({first, first + coarse_side});
}

float lowest_of(Span<float> floor, uint32_t row_length, const CellRange &columns, const CellRange &rows) {
  float lowest = floor[rows.first * row_length + columns.first];
  for (uint32_t row = rows.first; row < rows.last; ++row) {
    for (uint32_t column = columns.first; column < columns.last; ++column) {
      const float here = floor[row * row_length + column];
      lowest = here < lowest ? here : lowest;
    }
  }
  return lowest;
}

}  // namespace

// Calls visit(cells) for the cells that a disc meets, with the distances of their nearest or farthest edges: at once,
// or block by block for a disc that is far larger than most. Ends and is false where visit(cells) is. squared: the
// square of the radius, or a little more or less.
template <class Visit>
bool DepthBuffer::visit_cells(double x, double y, double radius, double squared, CellEdge edge, Visit visit) const {
  const CellRange columns(x - radius, x + radius, left_, cells_per_length_, columns_);
  const CellRange rows(y - radius, y + radius, bottom_, cells_per_length_, rows_);
  const auto some = [](uint32_t count) { return count < DiscCells::most ? count : DiscCells::most; };
  DiscCells cells;
  for (uint32_t row = rows.first; row < rows.last; row += cells.rows) {
    for (uint32_t column = columns.first; column < columns.last; column += cells.columns) {
      cells.first_column = column;
      cells.columns = some(columns.last - column);
      cells.first_row = row;
      cells.rows = some(rows.last - row);
      const DiscOnCells disc{x, y, squared, left_, bottom_, cell_, edge};
      measure_cells(target_, disc, cells);
      if (!visit(cells)) return false;
    }
  }
  return true;
}

void DepthBuffer::carve(Workspace &workspace, uint32_t balls) {
  target_ = workspace.target();
  const uint64_t wanted = cells_per_ball * balls + further_cells;
  const uint64_t cells = wanted < most_cells ? wanted : most_cells;
  floor_ = workspace.take<float>(cells);
  // c columns and r rows have at most (c + 3)(r + 3)/16 coarse cells, and c + r <= c r + 1. The same holds for tiles.
  const uint64_t coarse = cells / 4 + 1;
  coarse_ = workspace.take<float>(coarse);
  stale_ = workspace.take<uint8_t>(coarse);
  tile_ = workspace.take<float>(coarse / 4 + 1);
  stale_tile_ = workspace.take<uint8_t>(coarse / 4 + 1);
}

// Coordinates of a view are sums of three products of exact differences by components of an axis. The axes are off by
// at most 10e (towards 3.5e, right 4.5e, their cross product 2e more) and the sums by 3e, so that coordinates are
// within 16e of the largest distance from the origin; the margin is 64 times that. Cells are so much larger than the
// margin that it adds less than half a cell to a disc.
void DepthBuffer::lay_out(const BoundingBox &box, double extent, double radius) {
  margin_ = 0x1p-43 * extent;
  left_ = box.left;
  bottom_ = box.bottom;
  cell_ = cell_in_radii * radius > 16 * margin_ ? cell_in_radii * radius : 16 * margin_;
  const double cells = static_cast<double>(floor_.size());
  const double width = box.right - box.left;
  const double height = box.top - box.bottom;
  // There is memory for more floats than cells: for a row and a column more.
  while ((width / cell_ + 2.0) * (height / cell_ + 2.0) > cells) cell_ *= 1.25;
  cells_per_length_ = 1.0 / cell_;
  columns_ = static_cast<uint32_t>(width / cell_) + 1;
  rows_ = static_cast<uint32_t>(height / cell_) + 1;
  const float nothing = static_cast<float>(-4.0 * extent - 1.0);
  for (uint32_t cell = 0; cell < columns_ * rows_; ++cell) floor_[cell] = nothing;
  coarse_columns_ = coarse_cells(columns_);
  coarse_rows_ = coarse_cells(rows_);
  for (uint32_t cell = 0; cell < coarse_columns_ * coarse_rows_; ++cell) {
    coarse_[cell] = nothing;
    stale_[cell] = 0;
  }
  tile_columns_ = coarse_cells(coarse_columns_);
  for (uint32_t cell = 0; cell < tile_columns_ * coarse_cells(coarse_rows_); ++cell) {
    tile_[cell] = nothing;
    stale_tile_[cell] = 0;
  }
}

void DepthBuffer::look_after_coarse_cell(uint32_t coarse_column, uint32_t coarse_row) {
  const uint32_t coarse = coarse_row * coarse_columns_ + coarse_column;
  coarse_[coarse] = lowest_of(floor_, columns_, parts_of(coarse_column, columns_), parts_of(coarse_row, rows_));
  stale_[coarse] = 0;
  stale_tile_[coarse_row / coarse_side * tile_columns_ + coarse_column / coarse_side] = 1;
}

void DepthBuffer::look_after_tile(uint32_t tile_column, uint32_t tile_row) {
  const uint32_t tile = tile_row * tile_columns_ + tile_column;
  tile_[tile] =
      lowest_of(coarse_, coarse_columns_, parts_of(tile_column, coarse_columns_), parts_of(tile_row, coarse_rows_));
  stale_tile_[tile] = 0;
}

// The margin is that of hides() for the radius and for the height, and as much again for rounding R^2.
bool DepthBuffer::is_above(const BoundingBox &box, double height) {
  const double margin = 16 * margin_;
  const double raised = height + margin;
  const CellRange columns(box.left - margin, box.right + margin, left_, cells_per_length_, columns_);
  const CellRange rows(box.bottom - margin, box.top + margin, bottom_, cells_per_length_, rows_);
  const CellRange coarse_columns{columns.first / coarse_side, coarse_cells(columns.last)};
  const CellRange coarse_rows{rows.first / coarse_side, coarse_cells(rows.last)};
  const auto is_lower = [raised](float floor) { return static_cast<double>(floor) <= raised; };
  for (uint32_t row = coarse_rows.first / coarse_side; row < coarse_cells(coarse_rows.last); ++row) {
    for (uint32_t column = coarse_columns.first / coarse_side; column < coarse_cells(coarse_columns.last); ++column) {
      const uint32_t tile = row * tile_columns_ + column;
      if (!is_lower(tile_[tile])) continue;
      const CellRange own_columns = coarse_columns.common(parts_of(column, coarse_columns_));
      const CellRange own_rows = coarse_rows.common(parts_of(row, coarse_rows_));
      for (uint32_t y = own_rows.first; y < own_rows.last; ++y) {
        for (uint32_t x = own_columns.first; x < own_columns.last; ++x) {
          const uint32_t coarse = y * coarse_columns_ + x;
          if (!is_lower(coarse_[coarse])) continue;
          if (stale_[coarse] == 0) return false;
          look_after_coarse_cell(x, y);
          if (is_lower(coarse_[coarse])) return false;
        }
      }
      if (stale_tile_[tile] != 0) look_after_tile(column, row);
    }
  }
  return true;
}

// The ball, made larger by the margin, is compared with the floor: z + sqrt(R^2 - d^2) < floor, by squares. The errors
// of the squares are a few e of R^2.
bool DepthBuffer::hides(const ProjectedBall &disc) const {
  const double R = disc.r + 4 * margin_;
  const double base = disc.z + 4 * margin_;
  return visit_cells(disc.x, disc.y, R, R * R * (1.0 + 0x1p-40), CellEdge::nearest,
                     [&](const DiscCells &cells) { return hsp::hides(target_, floor_cells(), cells, base); });
}

// The ball, made smaller by the margin, raises the floor of the cells that it fills to the height of its front above
// their farthest corner, less a bound of rounding to a float. One more margin is subtracted, so that a ball whose
// square root is not computed would certainly not have raised the floor: near 0 floats are closer together than the
// rounding of a sum of base and root, and the order in which balls raise the floor must have no effect.
void DepthBuffer::raise(const ProjectedBall &disc) {
  const double R = disc.r - 4 * margin_;
  if (R <= 0.0) return;
  const double base = disc.z - 4 * margin_;
  visit_cells(disc.x, disc.y, R, R * R * (1.0 - 0x1p-40), CellEdge::farthest, [&](const DiscCells &cells) {
    hsp::raise(target_, floor_cells(), cells, base, margin_);
    return true;
  });
}

}  // namespace hsp
