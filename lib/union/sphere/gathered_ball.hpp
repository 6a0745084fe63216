// The caps of one ball, gathered again for questions that its loops alone do not answer, with scratch memory for them.
#pragma once

#include "sphere/caps.hpp"
#include "sphere/great_circles.hpp"

namespace hsp {

struct GatheredBall {
  Caps caps;
  FreeIntervals intervals;

  void carve(Workspace &workspace, uint32_t neighbours) {
    caps.carve(workspace, neighbours);
    intervals.carve(workspace, neighbours);
  }
  void gather(const CubeGrid &grid, uint32_t i) { gather(grid, grid.block_around(cube_of(grid, i)), i); }
  // The same with the cubes around the ball's own already looked up.
  void gather(const CubeGrid &grid, const CubeBlock &block, uint32_t i) {
    caps.gather(grid.balls(), block, i, nullptr);
  }
  static CubeCoordinates cube_of(const CubeGrid &grid, uint32_t i) { return grid.cube_at(grid.balls().ball(i).centre); }
};

}  // namespace hsp
