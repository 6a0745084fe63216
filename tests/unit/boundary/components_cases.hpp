// Components of small unions: their number and their order, that of their first balls in the input.
#pragma once

#include "small_scenes.hpp"

namespace cases {

inline uint32_t components_in_the_order_of_the_input() {
  return first_failing_scene([](const Scene &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    // The first ball that each is joined to, spread until nothing changes.
    uint32_t label[8], number[8];
    for (uint32_t i = 0; i < c.n; ++i) label[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (uint32_t i = 0; i < c.n; ++i) {
        for (uint32_t j = 0; j < i; ++j) {
          const SmallBall &a = c.ball[i], &b = c.ball[j];
          const int64_t dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z, reach = a.r + b.r;
          if (dx * dx + dy * dy + dz * dz > reach * reach || label[i] == label[j]) continue;
          label[i] = label[j] = label[i] < label[j] ? label[i] : label[j];
          changed = true;
        }
      }
    }
    uint32_t known = 0;
    for (uint32_t i = 0; i < c.n; ++i) {
      number[i] = label[i] == i ? known++ : number[label[i]];
      if (boundary.component(small_union().grid().grid_index(i)) != number[i]) return false;
    }
    return known == c.components && boundary.component_count() == c.components;
  });
}

inline constexpr Check boundary_components[] = {
    {"components_in_the_order_of_the_input", components_in_the_order_of_the_input}};

}  // namespace cases
