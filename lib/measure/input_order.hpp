// Visits the balls in the order of the input, in which totals are summed. Their records are stored in the order of the
// cubes, so in a set larger than the processor's caches every visit would wait for memory. Prefetching what later
// visits read avoids that; it affects nothing but time.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Calls visit(i, ball) for every ball i of a range of the input, with its index in the grid's order.
template <class Visit>
void visit_in_input_order(const CubeGrid &grid, const Boundary &boundary, IdRange range, Visit visit) {
  constexpr uint32_t far = 8;   // visits ahead: what is found by the ball's index
  constexpr uint32_t near = 4;  // and what is found by that
  const BallSet &balls = grid.balls();
  for (uint32_t i = range.first; i < range.last; ++i) {
    if (i + far < range.last) {
      const uint32_t ball = grid.grid_index(i + far);
      boundary.prefetch_ranges(ball);
      __builtin_prefetch(&balls.x[ball]);
      __builtin_prefetch(&balls.y[ball]);
      __builtin_prefetch(&balls.z[ball]);
      __builtin_prefetch(&balls.r[ball]);
    }
    if (i + near < range.last) boundary.prefetch_half_edges(grid.grid_index(i + near));
    visit(i, grid.grid_index(i));
  }
}

// The same for all balls.
template <class Visit>
void visit_in_input_order(const CubeGrid &grid, const Boundary &boundary, Visit visit) {
  visit_in_input_order(grid, boundary, {0, grid.balls().n}, visit);
}

}  // namespace hsp
