// Surfaces of single shells of the boundary: what they have in common with that of all shells.
#pragma once

#include "surface/surface_check.hpp"
#include "surface/surface_patches.hpp"
#include "surface_map_cases.hpp"

namespace cases {

// The rest's surface is there, too, and both are maps.
inline bool is_a_map() {
  return hsp::check_surface(small_map()).invariant == hsp::SurfaceInvariant::none;
}

inline int32_t euler_number() {
  int32_t euler = 0;
  hsp::count_euler(small_map(), [&euler](uint32_t, int32_t n) { euler += n; });
  return euler;
}

// A void whose probes overlap those outside: apart, neither cuts the other, and all is of genus 0.
inline uint32_t void_apart() {
  const uint32_t both[] = {1, 0, 1};
  if (!small_surface().build(void_in_tetrahedron)) return 0;
  const hsp::SurfaceMeasure whole = small_surface().total();
  if (!small_surface().build_of(void_in_tetrahedron, both, 3)) return 1;
  const hsp::SurfaceMeasure all = small_surface().total();
  if (all.area() != whole.area() || all.volume != whole.volume || euler_number() != -4) return 2;
  hsp::SurfaceMeasure parts[2];
  for (uint32_t shell = 0; shell < 2; ++shell) {
    if (!small_surface().build_of(void_in_tetrahedron, &shell, 1) || !is_a_map()) return 3;
    const hsp::Surface &surface = small_surface().builder().surface();
    if (surface.counts().cut_patches != 0 || surface.shells().count() != 2 || euler_number() != 4) return 4;
    parts[shell] = small_surface().total();
    const hsp::SurfaceMap map = small_map();
    double area = 0;
    for (uint32_t patch = 0; patch < map.patch_count(); ++patch) {
      if (!map.is_chosen(patch)) continue;
      area += hsp::measure_patch(small_map(), patch).area;
    }
    if (!near(small_union().balls().lattice.area(area), parts[shell].area(), 1e-9 * whole.area())) return 5;
  }
  // Convex and saddle patches are the same in all.
  if (!near(parts[0].convex + parts[1].convex, whole.convex, 1e-9 * whole.convex)) return 6;
  if (!near(parts[0].saddle + parts[1].saddle, whole.saddle, 1e-9 * whole.saddle)) return 7;
  if (!(parts[0].concave + parts[1].concave > whole.concave * 1.01)) return 8;
  if (!small_surface().build_of(void_in_tetrahedron, both, 0)) return 9;
  return small_surface().total().area() == 0 ? all_hold : 10;
}

// Six balls around a void, whose circles are smaller than the probe and have an arc outside and one inside: two
// surfaces like a sphere, with cusps in the same places.
constexpr SurfaceScene octahedron = {6,
                                     {{340000000, 0, 0, 90000000},
                                      {-340000000, 0, 0, 90000000},
                                      {0, 340000000, 0, 90000000},
                                      {0, -340000000, 0, 90000000},
                                      {0, 0, 340000000, 90000000},
                                      {0, 0, -340000000, 90000000}},
                                     220000000};
inline uint32_t shared_cusps() {
  for (uint32_t shell = 0; shell < 2; ++shell) {
    if (!small_surface().build_of(octahedron, &shell, 1) || !is_a_map()) return shell;
    const hsp::Surface &surface = small_surface().builder().surface();
    if (surface.cusped_circles().count() != 12 || surface.shells().count() != 2 || euler_number() != 4)
      return 2 + shell;
  }
  return all_hold;
}

// Six balls around a void, almost as an octahedron, and two at random.
inline SurfaceScene caged_scene(uint32_t seed) {
  Random random(seed);
  const int32_t probe = 100000000 + static_cast<int32_t>(random.below(140000000));
  SurfaceScene scene{8, {}, probe};
  const auto shaken = [&random](int32_t x) { return x + static_cast<int32_t>(random.below(30000000)); };
  for (uint32_t k = 0; k < 6; ++k) {
    const int32_t far = k % 2 == 0 ? 340000000 : -340000000;
    const int32_t x = shaken(k / 2 == 0 ? far : 0);
    const int32_t y = shaken(k / 2 == 1 ? far : 0);
    scene.ball[k] = {x, y, shaken(k / 2 == 2 ? far : 0), 310000000 - probe};
  }
  for (uint32_t k = 6; k < 8; ++k) {
    const int32_t x = 300000000 + static_cast<int32_t>(random.below(400000000));
    const int32_t y = static_cast<int32_t>(random.below(400000000));
    scene.ball[k] = {x, y, static_cast<int32_t>(random.below(400000000)), 50000000};
  }
  return scene;
}

// Both parts are maps; cusps that they share are corners of both.
inline uint32_t shells_of_random_sets() {
  uint32_t several = 0, shared = 0;
  for (uint32_t seed = 0; seed < 100; ++seed) {
    const SurfaceScene scene = caged_scene(seed);
    if (!small_surface().build(scene)) {
      if (small_surface().status() == hsp::Status::capacity) continue;
      return seed;
    }
    const uint32_t shells = small_union().boundary().shell_count();
    if (shells < 2) continue;
    const hsp::SurfaceMeasure whole = small_surface().total();
    for (uint32_t shell = 0; shell < shells; ++shell) {
      if (!small_surface().build_of(scene, &shell, 1)) return 1000 + seed;
      if (!is_a_map()) return 2000 + seed;
      const hsp::SurfaceMap map = small_map();
      for (uint32_t corner = 0; corner < map.corner_count(); ++corner) {
        shared += map.other_shell_of_cusp(corner) != hsp::no_id ? 1U : 0U;
      }
      const hsp::SurfaceMeasure part = small_surface().total();
      if (part.convex > whole.convex * (1 + 1e-12)) return 3000 + seed;
    }
    ++several;
  }
  return several > 20 && shared > 0 ? all_hold : 10000 + several;
}

inline constexpr Check surface_chosen_faces[] = {
    {"void_apart", void_apart}, {"shared_cusps", shared_cusps}, {"shells_of_random_sets", shells_of_random_sets}};

}  // namespace cases
