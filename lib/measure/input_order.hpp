// Visits the balls in the caller's order, which totals are summed in. Their records lie in the order of the cubes, so
// that in a set larger than the processor's caches every visit would wait for memory: what later visits will read is
// asked for ahead. That has no effect but on time.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp {

// Calls visit(i, place) for every ball i, with its place in the grid's order.
template <class Visit>
void visit_in_callers_order(const CubeGrid &grid, const BoundaryStructure &boundary, Visit visit) {
  constexpr uint32_t far = 8;   // visits ahead: what is found by the place
  constexpr uint32_t near = 4;  // and what is found by that
  const BallSet &balls = grid.balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (i + far < balls.n) {
      const uint32_t place = grid.place(i + far);
      __builtin_prefetch(&boundary.first_use[place]);
      __builtin_prefetch(&boundary.first_face[place]);
      __builtin_prefetch(&boundary.first_loop[place]);
      __builtin_prefetch(&boundary.first_circle_side[place]);
      __builtin_prefetch(&boundary.component_parent[place]);
      __builtin_prefetch(&balls.x[place]);
      __builtin_prefetch(&balls.y[place]);
      __builtin_prefetch(&balls.z[place]);
      __builtin_prefetch(&balls.r[place]);
    }
    if (i + near < balls.n) {
      const uint32_t place = grid.place(i + near);
      constexpr uint32_t step = 3;  // uses in 64 bytes
      for (uint32_t u = boundary.first_use[place]; u < boundary.first_use[place + 1]; u += step) {
        __builtin_prefetch(&boundary.uses[u]);
      }
    }
    visit(i, grid.place(i));
  }
}

}  // namespace hsp
