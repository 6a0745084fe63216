// Finds the blocks around the cubes of a grid, one after the other in the order of the cubes' numbers. If the grid has
// a directory of rows, that is used. Else no hash table is needed: numbers are in the order of z, y and x, so that each
// of the nine rows of a block only moves forward. A sweep over all cubes passes each cube a fixed number of times, and
// a sweep over the last cubes does not pass the first ones.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

class BlockSweep {
 public:
  explicit BlockSweep(const CubeGrid &grid) : grid_(&grid), cubes_(&grid.cube_list()) { block_.levels = grid.levels(); }
  // Without a grid: the same block is around all balls.
  explicit BlockSweep(const CubeBlock &everything) : block_(everything) {}

  // The same as grid.block_around() with the cube's coordinates. From call to call the number of the cube must not
  // fall; cubes may be left out.
  const CubeBlock &block_around(uint32_t cube);

  // The block around the cube of a ball. From call to call the number of the ball must not fall.
  const CubeBlock &block_around_ball(uint32_t ball);

 private:
  // Cubes first .. last - 1 belong to the block, and the row ends before cube `end`.
  struct Row {
    uint32_t first = 0, last = 0, end = 0;
  };

  uint32_t comes_before(uint32_t cube, uint32_t end, int64_t x) const;
  void skip_to_rows(const CubeCoordinates &at);
  void begin_row(const CubeCoordinates &at);

  const CubeGrid *grid_ = nullptr;
  const CubeList *cubes_ = nullptr;
  Row row_[9];
  CubeBlock block_;
  uint32_t at_ = no_id;       // the cube that block_ is around
  uint32_t of_ball_ = no_id;  // the cube of the last ball
};

}  // namespace hsp
