// A walk along a loop of arcs, for the functions that list loops.
#pragma once

#include "boundary/boundary.hpp"

namespace hsp::capi {

// Calls visit(half_edge) for every half-edge of a loop of arcs, in walking order.
template <class Visit>
void for_each_half_edge(const Boundary &boundary, uint32_t loop, Visit visit) {
  const LoopElement start = boundary.loop_start(loop);
  if (start.is_circle()) return;
  uint32_t half_edge = start.half_edge();
  do {
    visit(half_edge);
    half_edge = boundary.half_edge(half_edge).next;
  } while (half_edge != start.half_edge());
}

}  // namespace hsp::capi
