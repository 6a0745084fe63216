// Half-edges of small unions: twins, successors and loops, each against its definition.
#pragma once

#include "small_scenes.hpp"

namespace cases {

inline uint32_t half_edges_are_linked() {
  return first_failing_scene([](const Scene &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    if (boundary.half_edge_count() != 3 * c.vertices) return false;
    uint32_t loops = 2 * c.circles;
    for (uint32_t e = 0; e < boundary.half_edge_count(); ++e) {
      const hsp::HalfEdge &half_edge = boundary.half_edge(e);
      const hsp::HalfEdge &next = boundary.half_edge(half_edge.next);
      const uint32_t twin = boundary.twin(e);
      const bool linked = boundary.previous_circle(boundary.ball_of(e), next) == half_edge.circle &&
                          next.loop == half_edge.loop && boundary.ball_of(half_edge.next) == boundary.ball_of(e) &&
                          twin != e && boundary.twin(twin) == e && boundary.half_edge(twin).vertex == next.vertex &&
                          boundary.ball_of(twin) == half_edge.circle &&
                          boundary.half_edge(twin).circle == boundary.ball_of(e);
      if (!linked) return false;
      // A loop counts at the smallest of its half-edges.
      uint32_t smallest = e;
      uint32_t at = half_edge.next;
      for (uint32_t step = 0; at != e; ++step, at = boundary.half_edge(at).next) {
        if (step > boundary.half_edge_count()) return false;
        if (at < smallest) smallest = at;
      }
      loops += smallest == e ? 1U : 0U;
    }
    return boundary.loop_count() == loops;
  });
}

inline constexpr Check boundary_half_edge_links[] = {{"half_edges_are_linked", half_edges_are_linked}};

}  // namespace cases
