// Patches, edges and corners by their numbers, and steps between them.
#pragma once

#include "patch_corners_cases.hpp"
#include "surface/surface_map.hpp"

namespace cases {

inline hsp::SurfaceMap small_map() {
  return {small_union().balls(), small_union().boundary(), small_surface().builder().surface()};
}

struct MapCase {
  const SurfaceScene *scene;
  uint32_t patches, edges, corners;
};
constexpr MapCase map_cases[] = {{&three_throat, 8, 13, 6},
                                 {&void_in_tetrahedron, 28, 52, 24},
                                 {&spindle, 4, 2, 2},
                                 // Three faces, an arc in two parts and two arcs, two vertices.
                                 {&cut_spindle, 9, 15, 8},
                                 {&four_through_a_point, 14, 24, 12}};

inline uint32_t known_maps() {
  return first_failing(map_cases, [](const MapCase &c) {
    if (!small_surface().build(*c.scene)) return false;
    const hsp::SurfaceMap map = small_map();
    return map.patch_count() == c.patches && map.edge_count() == c.edges && map.corner_count() == c.corners;
  });
}

// Arcs and their half-edges, and the edges around patches of every kind.
inline uint32_t numbers_of_arcs() {
  for (uint32_t seed = 0; seed < 60; ++seed) {
    if (!small_surface().build(random_scene(seed))) return seed;
    const hsp::SurfaceMap map = small_map();
    const hsp::Boundary &boundary = small_union().boundary();
    for (uint32_t e = 0; e < boundary.half_edge_count(); ++e) {
      const hsp::LoopElement own = hsp::LoopElement::arc(e), twin = hsp::LoopElement::arc(boundary.twin(e));
      const uint32_t arc = map.saddle_of(own);
      const uint32_t side = map.side_of(own);
      if (map.saddle_of(twin) != arc || map.side_of(twin) != 1 - side || map.across(own) != twin) return seed;
      if (map.element_of(arc, side) != own || arc >= boundary.arc_count()) return seed;
      // The rim of the arc on this ball: its convex patch is the face.
      const uint32_t rim = 2 * (2 * arc + side);
      if (map.left(rim + 1 - side) != boundary.face_of(e)) return seed;
      if (map.origin(rim + 1 - side) / 3 != boundary.half_edge(e).vertex) return seed;
    }
  }
  return all_hold;
}

inline uint32_t steps_are_reversible() {
  uint32_t kinds[4] = {0, 0, 0, 0};
  for (uint32_t seed = 0; seed < 200; ++seed) {
    if (!small_surface().build(random_scene(seed))) return seed;
    const hsp::SurfaceMap map = small_map();
    const uint32_t directed = 2 * map.edge_count();
    for (uint32_t h = 0; h < directed; ++h) {
      const uint32_t next = map.next(h);
      if (next >= directed || map.previous(next) != h || map.left(next) != map.left(h)) return seed;
      if (map.origin(next) != map.origin(hsp::SurfaceMap::twin(h))) return seed;
      if (map.left(map.next_loop(h)) != map.left(h)) return seed;
      ++kinds[static_cast<uint32_t>(map.edge(h / 2).kind)];
    }
    for (uint32_t patch = 0; patch < map.patch_count(); ++patch) {
      const uint32_t first = map.first_edge(patch);
      if (first != hsp::no_id && map.left(first) != patch) return seed;
    }
  }
  return kinds[0] > 0 && kinds[2] > 0 && kinds[3] > 0 ? all_hold : 1000;
}

inline constexpr Check surface_surface_map[] = {
    {"known_maps", known_maps}, {"numbers_of_arcs", numbers_of_arcs}, {"steps_are_reversible", steps_are_reversible}};

}  // namespace cases
