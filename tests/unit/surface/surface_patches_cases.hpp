// Areas and volumes of patches sum to those of the balls' shares.
#pragma once

#include "surface/surface_patches.hpp"
#include "surface_map_cases.hpp"

namespace cases {

inline bool patches_sum_to_total() {
  const hsp::SurfaceMap map = small_map();
  const hsp::SurfaceMeasure total = small_surface().total();
  double area[4] = {0, 0, 0, 0};
  double volume = 0;
  for (uint32_t patch = 0; patch < map.patch_count(); ++patch) {
    const hsp::BallMeasure measure = hsp::measure_patch(map, patch);
    if (!(measure.area >= 0)) return false;
    area[static_cast<uint32_t>(map.patch(patch).kind)] += measure.area;
    volume += measure.volume;
  }
  const auto &lattice = small_union().balls().lattice;
  return near(lattice.area(area[0]), total.convex, 1e-9 * total.area()) &&
         near(lattice.area(area[1] + area[3]), total.saddle, 1e-9 * total.area()) &&
         near(lattice.area(area[2]), total.concave, 1e-9 * total.area()) &&
         near(lattice.volume(volume), total.volume, 1e-9 * total.volume);
}

inline uint32_t areas_of_patches() {
  for (const MapCase &c : map_cases) {
    if (!small_surface().build(*c.scene) || !patches_sum_to_total()) return static_cast<uint32_t>(&c - map_cases);
  }
  for (uint32_t seed = 0; seed < 100; ++seed) {
    if (!small_surface().build(random_scene(seed)) || !patches_sum_to_total()) return 100 + seed;
  }
  return all_hold;
}

inline constexpr Check surface_surface_patches[] = {{"areas_of_patches", areas_of_patches}};

}  // namespace cases
