// The caps of one ball, gathered again for questions that its loops alone do not answer, with scratch memory for them.
#pragma once

#include "sphere/caps.hpp"
#include "boundary/faces.hpp"

namespace hsp {

struct GatheredBall {
  Caps caps;
  FaceScratch scratch;

  void carve(Workspace &workspace, uint32_t neighbours) {
    caps.carve(workspace, neighbours);
    scratch.carve(workspace, neighbours);
  }
  void gather(const CubeGrid &grid, uint32_t i) { gather(grid, grid.block_around(cube_of(grid, i)), i); }
  // The same with the cubes around the ball's own looked up already.
  void gather(const CubeGrid &grid, const CubeBlock &block, uint32_t i) {
    caps.gather(grid.balls(), block, i, nullptr);
  }
  static CubeCoordinates cube_of(const CubeGrid &grid, uint32_t i) { return grid.cube_at(grid.balls().ball(i).centre); }
};

}  // namespace hsp
