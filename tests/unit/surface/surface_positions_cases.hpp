// Corners and edges lie where their balls and probes say.
#pragma once

#include "core/elementary.hpp"
#include "measure/areas.hpp"
#include "surface/surface_positions.hpp"
#include "surface_map_cases.hpp"

namespace cases {

inline hsp::Vec3 place_of(const hsp::Position &position) {
  return hsp::offset_from_origin(small_union().balls(), small_union().boundary(), position.ball) + position.offset;
}

// From the start of an edge, turned by its angle about its axis, to its end.
inline uint32_t edges_lead_from_corner_to_corner() {
  for (uint32_t seed = 0; seed < 150; ++seed) {
    if (!small_surface().build(random_scene(seed))) return seed;
    const hsp::SurfaceMap map = small_map();
    for (uint32_t edge = 0; edge < map.edge_count(); ++edge) {
      if (map.origin(2 * edge) == hsp::no_id) continue;
      const hsp::ArcPosition arc = hsp::position_of_edge(map, edge);
      const hsp::Vec3 centre = place_of(arc.centre);
      const hsp::Vec3 start = place_of(hsp::position_of_corner(map, map.origin(2 * edge))) - centre;
      const hsp::Vec3 end = place_of(hsp::position_of_corner(map, map.origin(2 * edge + 1))) - centre;
      const hsp::SinCos turn = hsp::sin_cos(arc.angle);
      const hsp::Vec3 off = hsp::combine(turn.cosine, start, turn.sine, hsp::cross(arc.axis, start)) - end;
      if (!(std::sqrt(hsp::dot(off, off)) < 10.0)) return seed;  // of 1.4e8 steps
      if (!near(std::sqrt(hsp::dot(start, start)), arc.radius, 10.0)) return seed;
    }
  }
  return all_hold;
}

// Every corner is at the probe's distance from the vertices whose patches meet there, and the cusps of a circle as far
// from its plane on either side.
inline uint32_t cusps_of_a_circle() {
  if (!small_surface().build(spindle)) return 0;
  const hsp::Surface &surface = small_surface().builder().surface();
  hsp::Vec3 cusp[2];
  for (uint32_t s = 0; s < 2; ++s) {
    cusp[s] = place_of(hsp::position_of_corner(small_map(), s));
  }
  const hsp::Vec3 between = cusp[1] - cusp[0];
  const double half = std::sqrt(1.4e8 * 1.4e8 - (3.1e8 * 3.1e8 - 3.05e8 * 3.05e8));
  const hsp::Vec3 other = place_of({surface.cusped_circles().ball(0, 1), {0, 0, 0}}) -
                          place_of({surface.cusped_circles().ball(0, 0), {0, 0, 0}});
  if (!near(std::sqrt(hsp::dot(between, between)), 2 * half, 1.0)) return 1;
  return hsp::dot(between, other) > 0 ? all_hold : 2;
}

inline constexpr Check surface_surface_positions[] = {
    {"edges_lead_from_corner_to_corner", edges_lead_from_corner_to_corner}, {"cusps_of_a_circle", cusps_of_a_circle}};

}  // namespace cases
