// Balls at which derivatives jump though their vertices do not show it.
#pragma once

#include "small_surface.hpp"
#include "surface/degenerate_balls.hpp"

namespace cases {

struct DegenerateCase {
  SurfaceScene scene;
  uint32_t balls;  // bit i: ball i
};
constexpr DegenerateCase degenerate_cases[] = {
    // The spheres of all three share the circle x = -50; ball 1 has no face.
    {{3, {{-100, 0, 0, 50}, {0, 0, 0, 50}, {200, 0, 0, 150}}, 200}, 7},
    // On one line, but with a circle each.
    {{3, {{-100, 0, 0, 50}, {0, 0, 0, 51}, {200, 0, 0, 150}}, 200}, 0},
    // Probes that touch each other in the plane of the balls, or do not quite.
    {{3, {{0, 0, 0, 50}, {100, 0, 0, 50}, {0, 100, 0, 50}}, 25}, 7},
    {{3, {{0, 0, 0, 50000}, {100000, 0, 0, 50000}, {0, 100000, 0, 50000}}, 25001}, 0},
    // The last sphere passes through the vertex of the others in the origin; or just not.
    {{4, {{300, 0, 0, 200}, {0, 300, 0, 200}, {0, 0, 300, 200}, {100, 200, 200, 200}}, 100}, 8},
    {{4, {{300, 0, 0, 200}, {0, 300, 0, 200}, {0, 0, 300, 200}, {100, 200, 200, 199}}, 100}, 0},
    // Without a probe nothing is asked.
    {{3, {{-100, 0, 0, 250}, {0, 0, 0, 250}, {200, 0, 0, 350}}, 0}, 0}};

inline uint32_t degenerate_balls_are_visited() {
  return first_failing(degenerate_cases, [](const DegenerateCase &c) {
    if (!small_surface().build(c.scene)) return false;
    const hsp::CubeGrid &grid = small_union().grid();
    uint32_t seen = 0;
    hsp::visit_degenerate_balls(grid, small_union().boundary(), small_surface().builder().surface(), true,
                                [&](uint32_t ball) { seen |= 1U << grid.balls().caller[ball]; });
    return seen == c.balls;
  });
}

inline uint32_t touching_probes() {
  if (!small_surface().build(degenerate_cases[2].scene)) return 0;
  if (small_surface().builder().surface().touching().size() != 2) return 1;
  // Built again the same memory has none.
  if (!small_surface().build(degenerate_cases[3].scene)) return 2;
  return small_surface().builder().surface().touching().size() == 0 ? all_hold : 3;
}

inline constexpr Check surface_degenerate_balls[] = {{"degenerate_balls_are_visited", degenerate_balls_are_visited},
                                                     {"touching_probes", touching_probes}};

}  // namespace cases
