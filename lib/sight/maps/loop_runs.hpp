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

// Calls visit(half-edge before, half-edge, half-edge after, begins, closes) for the members of a loop. A run is as long
// as members follow each other: a loop with others is entered behind one of these, so that no run is cut in two.
template <class Next, class IsMember, class Visit>
void visit_runs(uint32_t first, Next next, IsMember is_member, Visit visit) {
  uint32_t h = first;
  while (is_member(h) && next(h) != first) h = next(h);
  const bool whole = is_member(h);
  const uint32_t start = next(h);
  uint32_t before = h;
  bool begins = true;
  h = start;
  do {
    const uint32_t following = next(h);
    if (is_member(h)) visit(before, h, following, begins, whole && following == start);
    begins = !is_member(h);
    before = h;
    h = following;
  } while (h != start);
}

// Calls visit(half-edge, begins, closes) for the runs of those that run along their edges.
template <class Next, class Visit>
void visit_own_runs(uint32_t first, Next next, Visit visit) {
  visit_runs(
      first, next, [](uint32_t half_edge) { return half_edge % 2 == 0; },
      [&](uint32_t, uint32_t h, uint32_t, bool begins, bool closes) { visit(h, begins, closes); });
}

}  // namespace hsp
