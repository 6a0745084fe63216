#include "model/row_directory.hpp"

namespace hsp {

void RowDirectory::build(const CubeList &cubes, Span<const uint32_t> first_ball, Span<uint32_t> cells) {
  clear();
  if (cubes.count() == 0) return;
  const CubeCoordinates &low = cubes.low(), &high = cubes.high();
  // Computed in doubles, which do not overflow. No factor is above 2^52.
  const double wanted = static_cast<double>(high.x - low.x + 2) * static_cast<double>(high.y - low.y + 1) *
                        static_cast<double>(high.z - low.z + 1);
  if (wanted > static_cast<double>(cells.size())) return;
  low_ = low;
  width_ = high.x - low.x + 1;
  rows_y_ = high.y - low.y + 1;
  rows_z_ = high.z - low.z + 1;
  cells_ = cells.part(0, static_cast<uint32_t>(wanted));

  for (uint32_t &cell : cells_) cell = 0;
  for (uint32_t cube = 0; cube < cubes.count();) {
    const CubeCoordinates &row = cubes.coordinates(cube);
    const uint32_t begin = static_cast<uint32_t>(((row.z - low.z) * rows_y_ + row.y - low.y) * (width_ + 1));
    uint32_t column = 0;
    for (; cube < cubes.count(); ++cube) {
      const CubeCoordinates &at = cubes.coordinates(cube);
      if (at.y != row.y || at.z != row.z) break;
      for (; column <= static_cast<uint32_t>(at.x - low.x); ++column) cells_[begin + column] = first_ball[cube];
    }
    for (; column <= static_cast<uint32_t>(width_); ++column) cells_[begin + column] = first_ball[cube];
  }
}

void RowDirectory::describe(QueryGrid &grid) const {
  const int64_t low[4] = {low_.x, low_.y, low_.z, 0}, size[4] = {width_, rows_y_, rows_z_, 0};
  for (int axis = 0; axis < 4; ++axis) {
    grid.low[axis] = static_cast<double>(low[axis]);
    grid.size[axis] = static_cast<double>(size[axis]);
  }
  grid.row = static_cast<uint64_t>(width_) + 1;
  grid.layer = static_cast<uint64_t>(rows_y_);
  grid.cells = cells_.data();
}

}  // namespace hsp
