// The blocks around the cubes of a grid, one after the other in the order of their numbers. As this is the order of z,
// y and x, each of the nine rows of a block only ever moves forward: so a sweep over all cubes walks over them a fixed
// number of times and asks the hash table nothing.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

class BlockSweep {
 public:
  explicit BlockSweep(const CubeGrid &grid) : grid_(grid), table_(grid.table()) {}

  // The same as grid.block_around() of the cube's coordinates. Cubes must not descend from call to call, and may be
  // left out.
  const CubeBlock &block_around(uint32_t cube) {
    if (cube == at_) return block_;
    const CubeCoordinates &at = table_.coordinates(cube);
    const bool first_call = at_ == no_id;
    const CubeCoordinates &last = table_.coordinates(first_call ? cube : at_);
    if (first_call || !in_row(last, at.y, at.z)) begin_row(at);
    // From one cube to the next, a row loses and gains one cube at most: no branch is needed, and none could be
    // predicted.
    const bool next = !first_call && in_row(last, at.y, at.z) && at.x == last.x + 1;
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
      block_.range[block_.ranges] = grid_.balls_of(row.first, row.last);
      block_.ranges += static_cast<uint32_t>(row.first != row.last);
    }
    return block_;
  }

  // The block around the cube of a ball. Balls must not descend from call to call.
  const CubeBlock &block_around_ball(uint32_t ball) {
    while (grid_.balls_in(of_ball_).last <= ball) ++of_ball_;
    return block_around(of_ball_);
  }

 private:
  // Cubes first .. last - 1 belong to the block, and the row ends before cube `end`.
  struct Row {
    uint32_t first = 0, last = 0, end = 0;
  };

  static bool in_row(const CubeCoordinates &cube, int64_t y, int64_t z) { return cube.y == y && cube.z == z; }
  // 1 if the cube is one of the row and its x is smaller, else 0.
  uint32_t comes_before(uint32_t cube, uint32_t end, int64_t x) const {
    const bool is_there = cube < end;
    return static_cast<uint32_t>(is_there) & static_cast<uint32_t>(table_.coordinates(is_there ? cube : 0).x < x);
  }

  void begin_row(const CubeCoordinates &at) {
    Row *row = row_;
    for (int64_t z = at.z - 1; z <= at.z + 1; ++z) {
      for (int64_t y = at.y - 1; y <= at.y + 1; ++y, ++row) {
        uint32_t cube = row->end;
        while (cube < table_.count() && comes_before(table_.coordinates(cube), y, z)) ++cube;
        row->first = row->last = cube;
        while (cube < table_.count() && in_row(table_.coordinates(cube), y, z)) ++cube;
        row->end = cube;
      }
    }
  }
  static bool comes_before(const CubeCoordinates &cube, int64_t y, int64_t z) {
    return cube.z != z ? cube.z < z : cube.y < y;
  }

  const CubeGrid &grid_;
  const CubeTable &table_;
  Row row_[9];
  CubeBlock block_;
  uint32_t at_ = no_id;  // the cube that it is around
  uint32_t of_ball_ = 0;
};

}  // namespace hsp
