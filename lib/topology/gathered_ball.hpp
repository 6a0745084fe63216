// The caps of one ball, gathered again for questions that its loops alone do not answer, with scratch memory for them.
#pragma once

#include "boundary/caps.hpp"
#include "boundary/faces.hpp"

namespace hsp {

struct GatheredBall {
  Caps caps;
  FaceScratch scratch;

  void carve(Workspace &workspace, uint32_t neighbours) {
    caps.carve(workspace, neighbours);
    scratch.carve(workspace, neighbours);
  }
  void gather(const CubeGrid &grid, uint32_t i) {
    caps.gather(grid.balls(), grid.block_around(grid.cube_at(grid.balls().ball(i).centre)), i, nullptr);
  }
};

}  // namespace hsp
