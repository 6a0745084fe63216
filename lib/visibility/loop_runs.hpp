// The half-edges of a loop, and those of them that are its own: each edge is one half-edge's own, the one along it.
#pragma once

#include <cstdint>

namespace hsp {

// Calls visit(half-edge, first, closes) around a loop. next(h): the half-edge that follows.
template <class Next, class Visit>
void visit_loop(uint32_t first, Next next, Visit visit) {
  uint32_t h = first;
  do {
    const uint32_t following = next(h);
    visit(h, h == first, following == first);
    h = following;
  } while (h != first);
}

// Calls visit(half-edge, begins, closes) for those that run along their edges. A run is as long as such half-edges
// follow each other: a loop with others is entered behind one of these, so that no run is cut in two.
template <class Next, class Visit>
void visit_own_runs(uint32_t first, Next next, Visit visit) {
  const auto is_own = [](uint32_t half_edge) { return half_edge % 2 == 0; };
  uint32_t h = first;
  while (is_own(h) && next(h) != first) h = next(h);
  const bool whole = is_own(h);
  const uint32_t start = next(h);
  bool begins = true;
  h = start;
  do {
    const uint32_t following = next(h);
    if (is_own(h)) visit(h, begins, whole && following == start);
    begins = !is_own(h);
    h = following;
  } while (h != start);
}

}  // namespace hsp
