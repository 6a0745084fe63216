// Vertices near each other, against all pairs.
#pragma once

#include <cmath>

#include "small_surface.hpp"
#include "surface/probe_grid.hpp"

namespace cases {

struct GridMemory {
  alignas(64) unsigned char bytes[8 * 1024];
};

inline uint32_t pairs_of_overlapping_probes() {
  static GridMemory memory;
  Random random(20261121);
  for (uint32_t round = 0; round < 40; ++round) {
    SmallBall balls[10];
    // In the last rounds far from the origin, where doubles hold whole steps and little more.
    const int32_t origin = round < 30 ? 0 : 1500000000;
    for (SmallBall &ball : balls) {
      ball = {origin + static_cast<int32_t>(random.below(1500)), static_cast<int32_t>(random.below(1500)) - origin,
              static_cast<int32_t>(random.below(1500)), static_cast<int32_t>(random.below(300))};
    }
    const int32_t probe = 1 + static_cast<int32_t>(random.below(400));
    if (!small_union().build(balls, 10, probe)) return round;
    const hsp::BallSet &set = small_union().balls();
    const hsp::Boundary &boundary = small_union().boundary();
    hsp::ProbeGrid grid;
    hsp::Workspace measured;
    grid.carve(measured, boundary.vertex_count());
    if (measured.bytes() > sizeof memory.bytes) return round;
    hsp::Workspace workspace(memory.bytes, sizeof memory.bytes);
    grid.carve(workspace, boundary.vertex_count());
    grid.build(set, boundary);
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      uint32_t seen[60] = {};
      grid.visit_around(set, v, [&seen](uint32_t w) { ++seen[w]; });
      for (uint32_t w = 0; w < boundary.vertex_count(); ++w) {
        const hsp::Vec3 to = grid.difference(set, v, w);
        const hsp::Vec3 back = grid.difference(set, w, v);
        if (to.x != -back.x || to.y != -back.y || to.z != -back.z) return round;
        double p[3], q[3];
        hsp::to_coordinates(set, hsp::position_of_vertex(set, boundary, v), p);
        hsp::to_coordinates(set, hsp::position_of_vertex(set, boundary, w), q);
        if (!near(to.x, q[0] - p[0], 1e-5) || !near(to.y, q[1] - p[1], 1e-5) || !near(to.z, q[2] - p[2], 1e-5)) {
          return round;
        }
        const bool overlap = std::sqrt(dot(to, to)) < 2.0 * probe;
        if (seen[w] > 1 || (overlap && seen[w] == 0)) return round;
      }
    }
  }
  return all_hold;
}

inline constexpr Check surface_probe_grid[] = {{"pairs_of_overlapping_probes", pairs_of_overlapping_probes}};

}  // namespace cases
