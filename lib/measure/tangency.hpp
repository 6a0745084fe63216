// Balls that touch another ball from inside. Such a ball may have no face, so that the boundary holds nothing of the
// touching; but moved outward it would poke out.
#pragma once

#include "exact/exact_predicates.hpp"
#include "model/cube_grid.hpp"

namespace hsp {

// Whether ball `inner` touches ball `outer` from inside, in a point that lies inside no third ball; or whether the two
// are equal.
bool touches_freely_from_inside(const BallSet &balls, const CubeBlock &block, uint32_t inner, uint32_t outer);

// Calls visit(j) for every ball j that ball i touches so.
template <class Visit>
void visit_balls_touched_from_inside(const CubeGrid &grid, uint32_t i, Visit visit) {
  const BallSet &balls = grid.balls();
  const CubeBlock block = grid.block_around(grid.cube_at(balls.ball(i).centre));
  for (uint32_t k = 0; k < block.ranges; ++k) {
    for (uint32_t j = block.range[k].first; j < block.range[k].last; ++j) {
      if (j != i && touches_freely_from_inside(balls, block, i, j)) visit(j);
    }
  }
}

}  // namespace hsp
