// Blocks of neighbouring cubes, from one cube to the next.
//
// As an example a row with cubes at x = 0, 1, 2, 5 and 6, and the cubes of this row in the blocks around them:
//   block of the cube at 1     0, 1 and 2
//   block of the cube at 2     1 and 2: 0 has dropped out, and no cube is at 3
//   block of the cube at 5     5 and 6
// Both ends of this part of the row only move up, so that along the whole row each takes as many steps as it has cubes.
#include "model/block_sweep.hpp"

#include "core/first_index.hpp"

namespace hsp {
namespace {

bool in_row(const CubeCoordinates &cube, int64_t y, int64_t z) {
  return cube.y == y && cube.z == z;
}
bool before_row(const CubeCoordinates &cube, int64_t y, int64_t z) {
  return cube.z != z ? cube.z < z : cube.y < y;
}

}  // namespace

const CubeBlock &BlockSweep::block_around(uint32_t cube) {
  if (cube == at_) return block_;
  const CubeCoordinates &at = cubes_->coordinates(cube);
  if (grid_->rows().is_there() || grid_->has_images()) {
    at_ = cube;
    block_ = grid_->block_around(at);
    return block_;
  }
  const bool first_call = at_ == no_id;
  if (first_call) skip_to_rows(at);
  const CubeCoordinates &last = cubes_->coordinates(first_call ? cube : at_);
  const bool same_row = !first_call && in_row(last, at.y, at.z);
  if (!same_row) begin_row(at);
  // From one cube to the next one in its row, each row loses and gains one cube at most. This is done without a branch,
  // which could not be predicted.
  const bool next = same_row && at.x == last.x + 1;
  at_ = cube;
  block_.ranges = 0;
  for (Row &row : row_) {
    if (next) {
      row.first += comes_before(row.first, row.end, at.x - 1);
      row.last += comes_before(row.last, row.end, at.x + 2);
    } else {
      while (comes_before(row.first, row.end, at.x - 1) != 0) ++row.first;
      while (comes_before(row.last, row.end, at.x + 2) != 0) ++row.last;
    }
    block_.range[block_.ranges] = grid_->balls_of(row.first, row.last);
    block_.ranges += static_cast<uint32_t>(row.first != row.last);
  }
  return block_;
}

const CubeBlock &BlockSweep::block_around_ball(uint32_t ball) {
  if (grid_ == nullptr) return block_;
  if (of_ball_ == no_id) {
    of_ball_ =
        first_index(0, grid_->cubes(), [this, ball](uint32_t cube) { return grid_->balls_in(cube).last > ball; });
  }
  while (grid_->balls_in(of_ball_).last <= ball) ++of_ball_;
  return block_around(of_ball_);
}

// 1 if the cube is before `end`, the end of its row, and its x is smaller than the given one; else 0.
uint32_t BlockSweep::comes_before(uint32_t cube, uint32_t end, int64_t x) const {
  const bool is_there = cube < end;
  return static_cast<uint32_t>(is_there) & static_cast<uint32_t>(cubes_->coordinates(is_there ? cube : 0).x < x);
}

// Puts the rows to where they would be if the sweep had just been before this cube, the first that it is asked for.
void BlockSweep::skip_to_rows(const CubeCoordinates &at) {
  Row *row = row_;
  for (int64_t z = at.z - 1; z <= at.z + 1; ++z) {
    for (int64_t y = at.y - 1; y <= at.y + 1; ++y, ++row) {
      row->end =
          first_index(0, cubes_->count(), [&](uint32_t cube) { return !before_row(cubes_->coordinates(cube), y, z); });
    }
  }
}

void BlockSweep::begin_row(const CubeCoordinates &at) {
  Row *row = row_;
  for (int64_t z = at.z - 1; z <= at.z + 1; ++z) {
    for (int64_t y = at.y - 1; y <= at.y + 1; ++y, ++row) {
      uint32_t cube = row->end;
      while (cube < cubes_->count() && before_row(cubes_->coordinates(cube), y, z)) ++cube;
      row->first = row->last = cube;
      while (cube < cubes_->count() && in_row(cubes_->coordinates(cube), y, z)) ++cube;
      row->end = cube;
    }
  }
}

}  // namespace hsp
