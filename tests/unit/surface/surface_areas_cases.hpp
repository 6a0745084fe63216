// Areas and volumes: known values, shares of balls, and what must hold for every set.
#pragma once

#include <cmath>

#include "core/elementary.hpp"
#include "small_surface.hpp"

namespace cases {

constexpr SurfaceScene two_balls_at(int32_t r, int32_t other, int32_t distance, int32_t probe) {
  return {2, {{0, 0, 0, r}, {distance, 0, 0, other}}, probe};
}
constexpr SurfaceScene two_far = two_balls_at(170000000, 170000000, 540000000, usual_probe);
constexpr SurfaceScene two_far_large_probe = two_balls_at(170000000, 170000000, 540000000, 300000000);
constexpr SurfaceScene two_spindle = two_balls_at(170000000, 170000000, 610000000, usual_probe);
constexpr SurfaceScene two_spindle_unequal = two_balls_at(200000000, 120000000, 560000000, usual_probe);
constexpr SurfaceScene two_small = two_balls_at(170000000, 30000000, 190000000, usual_probe);
constexpr SurfaceScene one_ball = {1, {{5, 6, 7, 100000000}}, usual_probe};

struct KnownSurface {
  const SurfaceScene *scene;
  double convex, saddle, concave, volume;  // areas in 1e-16, volume in 1e-24
};
constexpr KnownSurface known_surfaces[] = {
    {&one_ball, 12.566370614359, 0, 0, 4.188790204786},
    {&two_far, 67.9475820122, 6.8766538896, 0, 41.80379383311},
    {&two_far_large_probe, 57.1796599912, 23.7817453226, 0, 47.93581275002},
    {&two_spindle, 72.0478671336, 0.6013316682, 0, 41.16523321646},
    {&two_spindle_unequal, 66.2984492731, 2.3200072966, 0, 40.84146738944},
    {&two_small, 34.3749409815, 2.5627595996, 0, 20.82937123191},
    {&three_throat, 89.1358433827, 24.3930994435, 6.35405963625, 66.99444771262},
    {&three_almost, 94.0598133676, 21.1175258521, 1.12838415294, 64.01665722428},
    {&three_open, 97.3975152429, 15.0946412977, 0, 62.85155162832},
    {&void_in_tetrahedron, 108.55494545, 36.4811662779, 22.6266317068, 92.23100491818},
    {&four_through_a_point, 76.903094407, 33.136994481, 4.740968667, 87.0340342233},
    {&eight_through_a_point, 41.887902048, 36.817856936, 24.630086404, 50.3578563445}};

inline uint32_t known_areas_and_volumes() {
  return first_failing(known_surfaces, [](const KnownSurface &c) {
    if (!small_surface().build(*c.scene)) return false;
    const hsp::SurfaceMeasure found = small_surface().total();
    return near(found.convex * 1e-16, c.convex, 1.1e-9) && near(found.saddle * 1e-16, c.saddle, 1.1e-9) &&
           near(found.concave * 1e-16, c.concave, 1.1e-9) && near(found.volume * 1e-24, c.volume, 1.1e-9);
  });
}

// Equal balls of a symmetric set have equal shares, and shares add up to the whole.
inline uint32_t shares_of_balls() {
  const SurfaceScene *const scenes[] = {&two_far, &two_spindle, &three_throat, &three_open, &void_in_tetrahedron};
  return first_failing(scenes, [](const SurfaceScene *scene) {
    if (!small_surface().build(*scene)) return false;
    const hsp::SurfaceMeasure whole = small_surface().total();
    const double n = scene->n;
    for (uint32_t i = 0; i < scene->n; ++i) {
      const hsp::SurfaceMeasure own = small_surface().of_ball(i);
      // Coordinates of some are rounded.
      if (!near(own.convex * n, whole.convex, 1e-8 * whole.convex)) return false;
      if (!near(own.saddle * n, whole.saddle, 1e-7 * whole.saddle)) return false;
      if (!near(own.concave * n, whole.concave, 1e-7 * whole.concave)) return false;
    }
    return true;
  });
}

// The saddle between unequal balls is split where the probe's profile turns.
inline uint32_t saddle_is_split_at_its_waist() {
  if (!small_surface().build(two_small)) return 0;
  const double R[] = {3.1, 1.7};
  const double d = 1.9;
  const double h[] = {(d * d + R[0] * R[0] - R[1] * R[1]) / (2 * d), (d * d + R[1] * R[1] - R[0] * R[0]) / (2 * d)};
  const double rho = std::sqrt(R[1] * R[1] - h[1] * h[1]);
  // The waist lies beyond the small ball's centre: that ball has none of it.
  const double t = hsp::arc_tangent(h[0], rho) + hsp::arc_tangent(h[1], rho);
  const double area = 2 * hsp::pi * 1.4 * (rho * t - 1.4 * (h[0] / R[0] + h[1] / R[1]));
  const bool conditions[] = {h[1] < 0, near(small_surface().of_ball(0).saddle * 1e-16, area, 1e-12),
                             small_surface().of_ball(1).saddle == 0};
  return first_false(conditions);
}

// Where the probe grows and the spheres of its centre stay, the volume falls by the area: V' = -A. This sees every
// boundary between patches.
inline uint32_t volume_falls_by_the_area() {
  const SurfaceScene *const scenes[] = {&two_far,    &two_spindle,  &two_small,           &three_throat,
                                        &three_open, &three_almost, &void_in_tetrahedron, &four_through_a_point};
  return first_failing(scenes, [](const SurfaceScene *scene) {
    constexpr int32_t h = 20000;
    double volume[2];
    for (int side = 0; side < 2; ++side) {
      const int32_t by = side == 0 ? -h : h;
      SurfaceScene moved = *scene;
      moved.probe += by;
      for (SmallBall &ball : moved.ball) ball.r -= by;
      if (!small_surface().build(moved)) return false;
      volume[side] = small_surface().total().volume;
    }
    if (!small_surface().build(*scene)) return false;
    const double area = small_surface().total().area();
    return near((volume[0] - volume[1]) / (2.0 * h), area, 1e-6 * area);
  });
}

// Random sets: V' = -A again, and the same bits in another order.
inline uint32_t random_sets() {
  Random random(4);
  for (uint32_t round = 0; round < 60; ++round) {
    SurfaceScene scene{7, {}, static_cast<int32_t>(40000000 + random.below(200000000))};
    for (SmallBall &ball : scene.ball) {
      const auto coordinate = [&random] { return static_cast<int32_t>(random.below(500000000)); };
      ball = {coordinate(), coordinate(), coordinate(), static_cast<int32_t>(50000000 + random.below(120000000))};
    }
    if (!small_surface().build(scene)) return round;
    const hsp::SurfaceMeasure whole = small_surface().total();
    hsp::SurfaceMeasure own[7];
    for (uint32_t i = 0; i < 7; ++i) own[i] = small_surface().of_ball(i);
    SurfaceScene reversed = scene;
    for (uint32_t i = 0; i < 7; ++i) reversed.ball[i] = scene.ball[6 - i];
    if (!small_surface().build(reversed)) return round;
    for (uint32_t i = 0; i < 7; ++i) {
      const hsp::SurfaceMeasure again = small_surface().of_ball(6 - i);
      if (again.convex != own[i].convex || again.saddle != own[i].saddle || again.concave != own[i].concave ||
          again.volume != own[i].volume || own[i].convex < 0 || own[i].saddle < 0 || own[i].concave < 0) {
        return round;
      }
    }
    double volume[2];
    constexpr int32_t h = 500;
    for (int side = 0; side < 2; ++side) {
      const int32_t by = side == 0 ? -h : h;
      SurfaceScene moved = scene;
      moved.probe += by;
      for (SmallBall &ball : moved.ball) ball.r -= by;
      if (!small_surface().build(moved)) return round;
      volume[side] = small_surface().total().volume;
    }
    if (!near((volume[0] - volume[1]) / (2.0 * h), whole.area(), 3e-5 * whole.area())) return round;
  }
  return all_hold;
}

inline constexpr Check surface_surface_areas[] = {{"known_areas_and_volumes", known_areas_and_volumes},
                                                  {"shares_of_balls", shares_of_balls},
                                                  {"saddle_is_split_at_its_waist", saddle_is_split_at_its_waist},
                                                  {"volume_falls_by_the_area", volume_falls_by_the_area},
                                                  {"random_sets", random_sets}};

}  // namespace cases
