// The blocks around the cubes of a grid, one after the other in the order of their numbers. Where the grid has a
// directory of rows, it is asked. Elsewhere, as this is the order of z, y and x, each of the nine rows of a block only
// ever moves forward: so a sweep over all cubes walks over them a fixed number of times and asks the hash table
// nothing; one over the last cubes does not walk over the first ones.
#pragma once

#include "model/cube_grid.hpp"

namespace hsp {

class BlockSweep {
 public:
  explicit BlockSweep(const CubeGrid &grid) : grid_(&grid), cubes_(&grid.cube_list()) { block_.levels = grid.levels(); }
  // No grid: one block is around all balls.
  explicit BlockSweep(const CubeBlock &everything) : block_(everything) {}

  // The same as grid.block_around() of the cube's coordinates. Cubes must not descend from call to call, and may be
  // left out.
  const CubeBlock &block_around(uint32_t cube);

  // The block around the cube of a ball. Balls must not descend from call to call.
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
  uint32_t at_ = no_id;  // the cube that it is around
  uint32_t of_ball_ = no_id;
};

}  // namespace hsp
