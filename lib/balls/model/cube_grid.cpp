#include "model/cube_grid.hpp"

#include "core/small_code.hpp"

namespace hsp {

CubeGrid::CubeGrid() = default;

void CubeGrid::carve(Workspace &workspace, uint32_t n) {
  target_ = workspace.target();
  OrderedBalls::carve(workspace, n);
  index_.carve(workspace, n);
  levels_.use(target_, in_lanes());
}

void CubeGrid::build_index() {
  index_.build(*this, in_lanes());
  build_levels();
}

void CubeGrid::use_no_levels() {
  levels_.clear();
  index_.build_rows(*this, in_lanes());
}

void CubeGrid::build_levels() {
  levels_.clear();
  if (small_code || !RadiusLevels::may_save_work(*this)) return;
  levels_.build(*this, index_.end_rows());
  if (!levels_.is_there()) index_.build_rows(*this, in_lanes());
}

Status CubeGrid::build(const BallInput &input, uint32_t &first_bad, Patience patience) {
  const Status status = sort(input, index_.end(), first_bad, patience);
  build_index();
  return status;
}

void CubeGrid::build(const BallSet &given, uint32_t own, Patience patience) {
  sort(given, own, index_.end(), patience);
  build_index();
}

void CubeGrid::build(const BallSet &balls, Span<const uint32_t> slot, int64_t side, Patience patience) {
  sort(balls, slot, side, index_.end(), patience);
  build_index();
}

BallRange CubeGrid::balls_in_row(int64_t x_low, int64_t x_high, int64_t y, int64_t z) const {
  const uint64_t along_x = linear_hash({1, 0, 0});
  uint64_t linear = linear_hash({x_low, y, z});
  for (int64_t x = x_low; x <= x_high; ++x, linear += along_x) {
    const uint32_t cube = index_.find(*this, {x, y, z}, linear);
    if (cube == no_id) continue;
    // The other cubes of the row have the next numbers.
    uint32_t end = cube + 1;
    for (; end < cubes(); ++end) {
      const CubeCoordinates &next = cube_list().coordinates(end);
      if (next.x > x_high || next.y != y || next.z != z) break;
    }
    return balls_of(cube, end);
  }
  return {0, 0};
}

// Rows of cubes from `low` to `high`, nine at most.
void CubeGrid::add_rows(const CubeCoordinates &low, const CubeCoordinates &high, CubeBlock &block) const {
  if (rows().is_there()) {
    block.ranges += rows().find(low, high, {block.range + block.ranges, 9});
    return;
  }
  for (int64_t z = low.z; z <= high.z; ++z) {
    for (int64_t y = low.y; y <= high.y; ++y) {
      const BallRange range = balls_in_row(low.x, high.x, y, z);
      if (!range.empty()) block.range[block.ranges++] = range;
    }
  }
}

CubeBlock CubeGrid::block_around(const CubeCoordinates &centre) const {
  CubeBlock block;
  block.levels = levels();
  CubeCoordinates low{centre.x - 1, centre.y - 1, centre.z - 1};
  CubeCoordinates high{centre.x + 1, centre.y + 1, centre.z + 1};
  if (!has_images() || halo().is_far_from(centre)) {
    add_rows(low, high, block);
    return block;
  }
  const int64_t last = halo().last_own_layer();
  add_rows(low, {high.x, high.y, high.z < last ? high.z : last}, block);
  low.z += halo().lift();
  high.z += halo().lift();
  if (low.z <= last) low.z = last + 1;
  add_rows(low, high, block);
  return block;
}

}  // namespace hsp
