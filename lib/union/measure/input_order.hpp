// Visits the balls in the order of the input, in which totals are summed. The balls' records are stored in grid order,
// so that in a set larger than the processor's caches every visit would wait for memory. Prefetching the records of
// later visits avoids this; it affects nothing but time.
#pragma once

#include <type_traits>

#include "boundary/boundary.hpp"
#include "core/ahead.hpp"
#include "core/small_code.hpp"

namespace hsp {

// Stands for no `pass`: balls that the boundary leaves out are visited as others are.
struct PassNone {};

// Calls visit(i, ball) for every ball i of a range of the input; `ball` is its index in grid order. If `pass` is given
// and code is not small, calls pass(run) instead for each run of consecutive balls that the boundary leaves out.
template <class Visit, class Pass = PassNone>
void visit_in_input_order(const CubeGrid &grid, const Boundary &boundary, IdRange range, Visit visit, Pass pass = {}) {
  const BallSet &balls = grid.balls();
  const bool is_far = !small_code && balls.n > ahead::few_balls;
  const uint32_t half_edges = range.empty() ? 0 : boundary.half_edges(grid.own_balls() - 1).last;
  for (uint32_t i = range.first; i < range.last; ++i) {
    if constexpr (!small_code && !std::is_same_v<Pass, PassNone>) {
      const uint32_t first = i;
      while (i < range.last && boundary.is_left_out(grid.grid_index(i))) ++i;
      if (first < i) pass(IdRange{first, i});
      if (i == range.last) return;
    }
    if (is_far && i + ahead::ranges < range.last) {
      const uint32_t ball = grid.grid_index(i + ahead::ranges);
      boundary.prefetch_ranges(ball);
      balls.prefetch(ball);
    }
    if (is_far && i + ahead::half_edges < range.last)
      boundary.prefetch_half_edges(grid.grid_index(i + ahead::half_edges));
    if (is_far && i + ahead::neighbours < range.last) {
      const uint32_t ball = grid.grid_index(i + ahead::neighbours);
      boundary.prefetch_vertices(ball, half_edges);
      boundary.prefetch_neighbours(balls, ball, half_edges);
    }
    visit(i, grid.grid_index(i));
  }
}

}  // namespace hsp
