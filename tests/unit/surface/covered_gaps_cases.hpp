// The cover of the circle of two balls: the gaps between the free arcs lead around it.
#pragma once

#include "small_union.hpp"
#include "surface/covered_gaps.hpp"

namespace cases {

struct GapCase {
  uint32_t n;
  SmallBall ball[6];
  uint32_t arcs;  // free arcs of the circle of balls 0 and 1, which has radius 300
};
constexpr SmallBall left{0, 0, 0, 500}, right{800, 0, 0, 500};
constexpr GapCase gap_cases[] = {
    {3, {left, right, {400, 300, 0, 100}}, 1},
    {3, {left, right, {400, 500, 0, 500}}, 1},
    {3, {left, right, {400, 400, 0, 100}}, 1},  // touches the circle: a gap of angle 0
    {3, {left, right, {400, 200, 0, 500}}, 1},  // touches its far point from inside: an arc of angle 0
    {4, {left, right, {400, 300, 0, 100}, {400, -300, 0, 120}}, 2},
    {4, {left, right, {400, 300, 0, 100}, {400, 290, 90, 100}}, 1},  // together
    {4, {left, right, {400, 300, 0, 100}, {400, 300, 0, 20}}, 1},    // the last one inside
    {4, {left, right, {400, 400, 0, 100}, {400, -400, 0, 100}}, 2},
    {5, {left, right, {400, 300, 0, 100}, {400, -300, 0, 120}, {400, 0, 300, 110}}, 3},
    {5, {left, right, {400, 300, 0, 280}, {400, -52, 295, 280}, {400, -282, -103, 280}}, 1},  // one gap of most of it
    {6, {left, right, {400, 300, 0, 100}, {400, -300, 0, 120}, {400, 0, 300, 110}, {400, 30, -310, 90}}, 4}};

inline uint32_t arcs_and_gaps_lead_around() {
  return first_failing(gap_cases, [](const GapCase &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::BallSet &balls = small_union().balls();
    const hsp::Boundary &boundary = small_union().boundary();
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t own = small_union().grid().grid_index(side);
      const uint32_t other = small_union().grid().grid_index(1 - side);
      uint32_t arcs = 0;
      uint32_t first = hsp::no_id;
      for (const uint32_t e : boundary.half_edges(own)) {
        if (boundary.half_edge(e).circle != other) continue;
        if (first == hsp::no_id) first = e;
        ++arcs;
      }
      if (arcs != c.arcs) return false;
      // From gap to gap, counter-clockwise: all arcs, once each.
      uint32_t walked = 0;
      uint32_t e = first;
      do {
        const uint32_t end = hsp::vertex_across_gap(balls, boundary, {}, own, e);
        if (end == boundary.half_edge(e).vertex) return false;
        uint32_t behind = hsp::no_id;
        for (const uint32_t f : boundary.half_edges(own)) {
          if (boundary.half_edge(f).circle == other && boundary.end_vertex(f) == end) behind = f;
        }
        if (behind == hsp::no_id) return false;
        e = behind;
      } while (++walked < arcs && e != first);
      if (walked != arcs || e != first) return false;
    }
    return true;
  });
}

inline constexpr Check surface_covered_gaps[] = {{"arcs_and_gaps_lead_around", arcs_and_gaps_lead_around}};

}  // namespace cases
