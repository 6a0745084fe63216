// Every ball is visited once, in the order of the input, for numbers of balls below and beyond what is fetched ahead.
#pragma once

#include "measure/input_order.hpp"
#include "small_union.hpp"

namespace cases {

// Along x, each in a cube of its own, and back.
constexpr SmallBall zigzag[] = {{90, 0, 0, 5}, {0, 0, 0, 5},  {75, 0, 0, 5}, {15, 0, 0, 5},
                                {60, 0, 0, 5}, {30, 0, 0, 5}, {45, 9, 0, 5}, {30, 9, 0, 5},
                                {60, 9, 0, 5}, {15, 9, 0, 5}, {75, 9, 0, 5}, {0, 9, 0, 5}};

inline uint32_t balls_are_visited_in_order() {
  for (uint32_t n = 0; n <= SmallUnion::most_balls; ++n) {
    if (!small_union().build(zigzag, n)) return n;
    const hsp::BallSet &balls = small_union().balls();
    uint32_t visited = 0;
    bool in_order = true, same = true;
    hsp::visit_in_input_order(small_union().grid(), small_union().boundary(), {0, n}, [&](uint32_t i, uint32_t ball) {
      in_order = in_order && i == visited++ && ball < n && balls.caller[ball] == i && balls.x[ball] == zigzag[i].x;
      same = same && i == ball;
    });
    // The grid has an order of its own.
    if (visited != n || !in_order || same != (n < 2)) return n;
  }
  return all_hold;
}

inline constexpr Check measure_input_order[] = {{"balls_are_visited_in_order", balls_are_visited_in_order}};

}  // namespace cases
