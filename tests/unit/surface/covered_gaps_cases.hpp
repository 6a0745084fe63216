// The cover of the circle of two balls: the free arcs and the gaps between them are a whole turn, and lead around it.
#pragma once

#include "measure/boundary_positions.hpp"
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

inline uint32_t arcs_and_gaps_are_a_turn() {
  return first_failing(gap_cases, [](const GapCase &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::BallSet &balls = small_union().balls();
    const hsp::Boundary &boundary = small_union().boundary();
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t own = small_union().grid().grid_index(side);
      const uint32_t other = small_union().grid().grid_index(1 - side);
      double turn = 0;
      uint32_t arcs = 0;
      uint32_t first = hsp::no_id;
      for (const uint32_t e : boundary.half_edges(own)) {
        if (boundary.half_edge(e).circle != other) continue;
        if (first == hsp::no_id) first = e;
        turn += hsp::angle_of_arc(balls, boundary, e);
        const hsp::CoveredGap gap = hsp::gap_behind(balls, boundary, {}, own, e);
        turn += hsp::angle_of_gap(balls, boundary, own, e, gap);
        if (gap.vertex == boundary.half_edge(e).vertex || gap.vertex != boundary.end_vertex(gap.half_edge))
          return false;
        ++arcs;
      }
      if (arcs != c.arcs || !near(turn, 2 * hsp::pi, 1e-12)) return false;
      // From gap to gap, counter-clockwise: all arcs, once each.
      uint32_t walked = 0;
      uint32_t e = first;
      do {
        e = hsp::gap_behind(balls, boundary, {}, own, e).half_edge;
      } while (++walked < arcs && e != first);
      if (walked != arcs || e != first) return false;
    }
    return true;
  });
}

// Rounding must not turn a gap that is closed into a whole turn, nor the reverse.
inline uint32_t closed_gaps() {
  struct Closed {
    SmallBall third;
    double gap;
  };
  constexpr Closed closed[] = {{{400, 400, 0, 100}, 0}, {{400, 200, 0, 500}, 2 * hsp::pi}};
  return first_failing(closed, [](const Closed &c) {
    const SmallBall balls[] = {left, right, c.third};
    if (!small_union().build(balls, 3)) return false;
    const uint32_t own = small_union().grid().grid_index(0);
    const uint32_t other = small_union().grid().grid_index(1);
    const hsp::Boundary &boundary = small_union().boundary();
    for (const uint32_t e : boundary.half_edges(own)) {
      if (boundary.half_edge(e).circle != other) continue;
      const hsp::CoveredGap gap = hsp::gap_behind(small_union().balls(), boundary, {}, own, e);
      return near(hsp::angle_of_gap(small_union().balls(), boundary, own, e, gap), c.gap, 1e-14);
    }
    return false;
  });
}

inline constexpr Check surface_covered_gaps[] = {{"arcs_and_gaps_are_a_turn", arcs_and_gaps_are_a_turn},
                                                 {"closed_gaps", closed_gaps}};

}  // namespace cases
