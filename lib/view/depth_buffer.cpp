#include "view/depth_buffer.hpp"

namespace hsp {
namespace {

// Cells have a side of 0.2 of the largest radius, which is about the best for molecules (the optimum is flat), or as
// many of them as there is memory for.
constexpr double cell_in_radii = 0.2;
constexpr uint64_t cells_per_ball = 16;
constexpr uint64_t further_cells = 4096;
constexpr uint64_t most_cells = 0xFFFFFFFF;
constexpr uint32_t coarse_side = 4;  // cells

constexpr uint32_t coarse_cells(uint32_t cells) {
  return (cells + coarse_side - 1) / coarse_side;
}

// Cells first .. last - 1 of one direction that an interval meets.
struct CellRange {
  uint32_t first, last;

  CellRange(double low, double high, double origin, double cells_per_length, uint32_t cells) {
    const double a = (low - origin) * cells_per_length;
    const double b = (high - origin) * cells_per_length;
    first = a > 0.0 ? static_cast<uint32_t>(a) : 0;
    last = b > 0.0 ? static_cast<uint32_t>(b) + 1 : 1;
    if (last > cells) last = cells;
  }
};

double nearest_in_cell(double coordinate, double low, double cell) {
  const double below = low - coordinate;
  const double above = coordinate - (low + cell);
  return below > 0.0 ? below : above > 0.0 ? above : 0.0;
}
double farthest_in_cell(double coordinate, double low, double cell) {
  const double from_low = coordinate - low;
  const double from_high = low + cell - coordinate;
  return from_low > from_high ? from_low : from_high;
}

}  // namespace

// The columns that a disc meets, and for each the squared distance of its nearest or farthest edge. A disc is at most
// 10 + 1/2 cells wide, so it meets at most 12.
struct DepthBuffer::Columns {
  static constexpr uint32_t most = 16;
  uint32_t first, count;
  double squared[most];

  template <class Distance>
  Columns(const DepthBuffer &floor, double x, double radius, Distance distance) {
    const CellRange range(x - radius, x + radius, floor.left_, floor.cells_per_length_, floor.columns_);
    first = range.first;
    count = range.last > range.first ? range.last - range.first : 0;
    if (count > most) count = most;
    for (uint32_t k = 0; k < count; ++k) {
      const double d = distance(x, floor.left_ + (first + k) * floor.cell_, floor.cell_);
      squared[k] = d * d;
    }
  }
};

void DepthBuffer::carve(Workspace &workspace, uint32_t balls) {
  const uint64_t wanted = cells_per_ball * balls + further_cells;
  const uint64_t cells = wanted < most_cells ? wanted : most_cells;
  floor_ = workspace.take<float>(cells);
  // c columns and r rows have at most (c + 3)(r + 3)/16 coarse cells, and c + r <= c r + 1.
  coarse_ = workspace.take<float>(cells / 4 + 1);
  stale_ = workspace.take<uint8_t>(cells / 4 + 1);
}

// Coordinates of a view are sums of three products of exact differences by components of an axis. The axes are off by
// at most 10e (towards 3.5e, right 4.5e, their cross product 2e more) and the sums by 3e, so that coordinates are
// within 16e of the largest distance from the origin; the margin is 64 times that. Cells are so much larger than the
// margin that it adds less than half a cell to a disc.
void DepthBuffer::lay_out(const BoundingBox &box, double extent, double largest) {
  margin_ = 0x1p-43 * extent;
  left_ = box.left;
  bottom_ = box.bottom;
  cell_ = cell_in_radii * largest > 16 * margin_ ? cell_in_radii * largest : 16 * margin_;
  const double cells = static_cast<double>(floor_.size());
  const double width = box.right - box.left;
  const double height = box.top - box.bottom;
  while ((width / cell_ + 2.0) * (height / cell_ + 2.0) > cells) cell_ *= 1.25;
  cells_per_length_ = 1.0 / cell_;
  columns_ = static_cast<uint32_t>(width / cell_) + 1;
  rows_ = static_cast<uint32_t>(height / cell_) + 1;
  const float nothing = static_cast<float>(-4.0 * extent - 1.0);
  for (uint32_t cell = 0; cell < columns_ * rows_; ++cell) floor_[cell] = nothing;
  coarse_columns_ = coarse_cells(columns_);
  for (uint32_t cell = 0; cell < coarse_columns_ * coarse_cells(rows_); ++cell) {
    coarse_[cell] = nothing;
    stale_[cell] = 0;
  }
}

float DepthBuffer::lowest_of(uint32_t coarse_column, uint32_t coarse_row) {
  const uint32_t coarse = coarse_row * coarse_columns_ + coarse_column;
  if (stale_[coarse] == 0) return coarse_[coarse];
  stale_[coarse] = 0;
  const uint32_t first_column = coarse_column * coarse_side;
  const uint32_t first_row = coarse_row * coarse_side;
  const uint32_t last_column = first_column + coarse_side < columns_ ? first_column + coarse_side : columns_;
  const uint32_t last_row = first_row + coarse_side < rows_ ? first_row + coarse_side : rows_;
  float lowest = floor_[first_row * columns_ + first_column];
  for (uint32_t row = first_row; row < last_row; ++row) {
    for (uint32_t column = first_column; column < last_column; ++column) {
      const float here = floor_[row * columns_ + column];
      lowest = here < lowest ? here : lowest;
    }
  }
  coarse_[coarse] = lowest;
  return lowest;
}

bool DepthBuffer::is_above(const BoundingBox &box, double height) {
  const double margin = 8 * margin_;
  const double raised = height + margin;
  const CellRange columns(box.left - margin, box.right + margin, left_, cells_per_length_, columns_);
  const CellRange rows(box.bottom - margin, box.top + margin, bottom_, cells_per_length_, rows_);
  for (uint32_t row = rows.first / coarse_side; row < coarse_cells(rows.last); ++row) {
    for (uint32_t column = columns.first / coarse_side; column < coarse_cells(columns.last); ++column) {
      if (static_cast<double>(lowest_of(column, row)) <= raised) return false;
    }
  }
  return true;
}

// The ball made larger by the margin, against the floor: z + sqrt(R^2 - d^2) < floor by squares. Their errors are a few
// e of R^2.
bool DepthBuffer::hides(const ProjectedBall &disc) const {
  const double R = disc.r + 4 * margin_;
  const double squared = R * R * (1.0 + 0x1p-40);
  const double base = disc.z + 4 * margin_;
  const Columns columns(*this, disc.x, R, nearest_in_cell);
  const CellRange rows(disc.y - R, disc.y + R, bottom_, cells_per_length_, rows_);
  for (uint32_t row = rows.first; row < rows.last; ++row) {
    const double dy = nearest_in_cell(disc.y, bottom_ + row * cell_, cell_);
    const double in_row = squared - dy * dy;
    const float *const cell = &floor_[row * columns_ + columns.first];
    for (uint32_t k = 0; k < columns.count; ++k) {
      const double left_over = in_row - columns.squared[k];
      if (left_over <= 0.0) continue;
      const double above = static_cast<double>(cell[k]) - base;
      if (above <= 0.0 || above * above <= left_over) return false;
    }
  }
  return true;
}

// The ball made smaller by the margin raises the floor of the cells that it fills, to the height above their farthest
// corner, less what rounding to a float could add. One more margin makes sure that a ball whose square root is saved
// would not have raised the floor: heights near 0 lie closer together than sums of a base and a root can tell, and the
// order in which balls raise the floor must have no effect.
void DepthBuffer::raise(const ProjectedBall &disc) {
  const double R = disc.r - 4 * margin_;
  if (R <= 0.0) return;
  const double squared = R * R * (1.0 - 0x1p-40);
  const double base = disc.z - 4 * margin_;
  const Columns columns(*this, disc.x, R, farthest_in_cell);
  const CellRange rows(disc.y - R, disc.y + R, bottom_, cells_per_length_, rows_);
  for (uint32_t row = rows.first; row < rows.last; ++row) {
    const double dy = farthest_in_cell(disc.y, bottom_ + row * cell_, cell_);
    const double in_row = squared - dy * dy;
    if (in_row <= 0.0) continue;
    float *const cell = &floor_[row * columns_ + columns.first];
    for (uint32_t k = 0; k < columns.count; ++k) {
      const double left_over = in_row - columns.squared[k];
      if (left_over <= 0.0) continue;
      const double above = static_cast<double>(cell[k]) - base;
      if (above > 0.0 && above * above >= left_over) continue;  // saves the square root
      const double height = base + std::sqrt(left_over);
      const float lowered = static_cast<float>(height - 0x1p-22 * std::fabs(height) - margin_);
      cell[k] = lowered > cell[k] ? lowered : cell[k];
      stale_[row / coarse_side * coarse_columns_ + (columns.first + k) / coarse_side] = 1;
    }
  }
}

}  // namespace hsp
