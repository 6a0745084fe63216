// Successors among several arcs of one circle, by the angles at which they end.
#pragma once

#include "cases.hpp"
#include "find_next.hpp"
#include "sphere/half_edges.hpp"

namespace cases {

// Circle 0 lies across z; circles 1 to 8 are seen from its centre in eight directions, every 45 degrees.
constexpr hsp::exact::Vector compass[] = {{0, 0, 1},  {5, 0, 1},   {5, 5, 1},  {0, 5, -2}, {-5, 5, 0},
                                          {-5, 0, 3}, {-5, -5, 1}, {0, -5, 1}, {5, -5, -1}};

struct ArcEnds {
  uint32_t start;  // the circle whose entry the half-edge starts at
  uint32_t candidates;
  uint32_t end[4];    // circles whose exits on circle 0 are free
  uint32_t expected;  // the one that comes first, clockwise from the start
};
constexpr ArcEnds arc_ends[] = {{1, 1, {5}, 5},          {1, 2, {5, 8}, 8},    {1, 2, {8, 5}, 8},
                                {1, 3, {2, 3, 4}, 4},    {5, 3, {2, 3, 4}, 4}, {5, 4, {8, 7, 6, 1}, 1},
                                {3, 4, {8, 7, 6, 1}, 1}, {3, 2, {3, 4}, 4},    {3, 1, {3}, 3},
                                {6, 4, {6, 7, 8, 5}, 5}, {6, 2, {6, 7}, 7},    {2, 2, {4, 1}, 1}};

inline uint32_t arcs_end_at_the_next_exit() {
  return first_failing(arc_ends, [](const ArcEnds &c) {
    const auto direction = [](uint32_t circle) { return compass[circle]; };
    struct Candidate {
      uint32_t previous_circle, circle;
    } arcs[6];
    const auto previous = [](const Candidate &arc) { return arc.previous_circle; };
    arcs[0] = {c.start, 0};
    arcs[1] = {3, 4};  // on other circles
    for (uint32_t k = 0; k < c.candidates; ++k) arcs[2 + k] = {0, c.end[k]};
    const uint32_t found =
        support::find_next(hsp::Span<Candidate>(arcs, 2 + c.candidates), arcs[0], previous, direction);
    return found >= 2 && found < 2 + c.candidates && arcs[found].circle == c.expected;
  });
}

inline uint32_t bits_of_vertices() {
  using hsp::VertexRecord;
  const VertexRecord plus{{3, 5, 9}, VertexRecord::positive_bit}, tie{{3, 5, 9}, VertexRecord::tied_bit};
  const bool conditions[] = {plus.positive(),      !plus.tied(),         !tie.positive(),     tie.tied(),
                             plus.slot_of(3) == 0, plus.slot_of(5) == 1, plus.slot_of(9) == 2};
  return first_false(conditions);
}

inline constexpr Check sphere_half_edges[] = {{"arcs_end_at_the_next_exit", arcs_end_at_the_next_exit},
                                              {"bits_of_vertices", bits_of_vertices}};

}  // namespace cases
