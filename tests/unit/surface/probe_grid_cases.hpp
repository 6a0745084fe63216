// Where probes stand, against the exact positions, and the differences between them.
#pragma once

#include "near_probes_cases.hpp"

namespace cases {

inline uint32_t positions_and_differences() {
  Random random(20261121);
  for (uint32_t round = 0; round < 40; ++round) {
    if (!searched_probes().build(random, round)) return round;
    const hsp::BallSet &set = small_union().balls();
    const hsp::Boundary &boundary = small_union().boundary();
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      const hsp::Position &placed = searched_probes().grid().position(v);
      const hsp::Position exact = hsp::position_of_vertex(set, boundary, v);
      const hsp::Vec3 error = placed.offset - exact.offset;
      if (placed.ball != exact.ball || std::sqrt(dot(error, error)) > 1e-10) return round;
      for (uint32_t w = 0; w < boundary.vertex_count(); ++w) {
        const hsp::Vec3 to = from_to(v, w);
        const hsp::Vec3 back = from_to(w, v);
        if (to.x != -back.x || to.y != -back.y || to.z != -back.z) return round;
        double p[3], q[3];
        hsp::to_coordinates(set, hsp::position_of_vertex(set, boundary, v), p);
        hsp::to_coordinates(set, hsp::position_of_vertex(set, boundary, w), q);
        if (!near(to.x, q[0] - p[0], 1e-5) || !near(to.y, q[1] - p[1], 1e-5) || !near(to.z, q[2] - p[2], 1e-5)) {
          return round;
        }
      }
    }
  }
  return all_hold;
}

inline constexpr Check surface_probe_grid[] = {{"positions_and_differences", positions_and_differences}};

}  // namespace cases
