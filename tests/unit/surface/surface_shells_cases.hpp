// How many shells a surface has, and what they consist of.
#pragma once

#include "surface_map_cases.hpp"

namespace cases {

struct ShellCase {
  const SurfaceScene *scene;
  uint32_t shells;
};
constexpr ShellCase shell_cases[] = {{&three_throat, 1}, {&void_in_tetrahedron, 1}, {&spindle, 2},
                                     {&three_open, 3},   {&cut_spindle, 1},         {&four_through_a_point, 1}};

inline uint32_t shells_of_known_surfaces() {
  return first_failing(shell_cases, [](const ShellCase &c) {
    return small_surface().build(*c.scene) && small_surface().builder().surface().shells().count() == c.shells;
  });
}

// Patches on both sides of an edge are in one shell, and no two shells could be one: each is reached by steps.
inline uint32_t shells_are_components() {
  for (uint32_t seed = 0; seed < 150; ++seed) {
    if (!small_surface().build(random_scene(seed))) return seed;
    const hsp::SurfaceMap map = small_map();
    constexpr uint32_t most = 400;
    uint32_t set[most];
    if (map.patch_count() > most) return seed;
    for (uint32_t k = 0; k < map.patch_count(); ++k) set[k] = k;
    // The smallest number of a component spreads over it.
    for (bool changed = true; changed;) {
      changed = false;
      for (uint32_t h = 0; h < 2 * map.edge_count(); ++h) {
        const uint32_t a = map.left(h);
        const uint32_t b = map.left(hsp::SurfaceMap::twin(h));
        if (set[a] <= set[b]) continue;
        set[a] = set[b];
        changed = true;
      }
    }
    uint32_t components = 0;
    for (uint32_t k = 0; k < map.patch_count(); ++k) {
      if (set[k] == k) ++components;
      if (map.shell_of(k) != map.shell_of(set[k])) return seed;
    }
    if (components != small_surface().builder().surface().shells().count()) return seed;
  }
  return all_hold;
}

inline constexpr Check surface_surface_shells[] = {{"shells_of_known_surfaces", shells_of_known_surfaces},
                                                   {"shells_are_components", shells_are_components}};

}  // namespace cases
