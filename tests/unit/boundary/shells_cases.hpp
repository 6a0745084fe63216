// Shells of small unions: their number, and that faces share one exactly if a chain of arcs and circles joins them.
#pragma once

#include "small_scenes.hpp"

namespace cases {

inline uint32_t shells_are_connected() {
  return first_failing_scene([](const Scene &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    if (boundary.shell_count() != c.shells || boundary.face_count() != c.faces || c.faces > 40) return false;
    // The smallest face that each is joined to, spread until nothing changes.
    uint32_t label[40];
    for (uint32_t f = 0; f < c.faces; ++f) label[f] = f;
    for (bool changed = true; changed;) {
      changed = false;
      const auto join = [&](uint32_t f, uint32_t g) {
        const uint32_t smaller = label[f] < label[g] ? label[f] : label[g];
        changed = changed || label[f] != label[g];
        label[f] = label[g] = smaller;
      };
      for (uint32_t e = 0; e < boundary.half_edge_count(); ++e)
        join(boundary.face_of(e), boundary.face_of(boundary.twin(e)));
      for (uint32_t k = 0; k < boundary.circle_count(); ++k) {
        join(boundary.face_of_loop(boundary.circle(k).loop[0]), boundary.face_of_loop(boundary.circle(k).loop[1]));
      }
    }
    uint32_t known = 0;
    for (uint32_t f = 0; f < c.faces; ++f) {
      const uint32_t expected = label[f] == f ? known++ : boundary.face(label[f]).shell;
      if (boundary.face(f).shell != expected) return false;
    }
    return known == c.shells;
  });
}

inline constexpr Check boundary_shells[] = {{"shells_are_connected", shells_are_connected}};

}  // namespace cases
