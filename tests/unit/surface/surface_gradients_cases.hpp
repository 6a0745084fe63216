// Derivatives of area and volume against difference quotients, and what motions and magnification say of them.
#pragma once

#include <cmath>

#include "measure/gradients.hpp"
#include "surface/surface_gradients.hpp"
#include "surface_areas_cases.hpp"

namespace cases {

struct GradientOfScene {
  hsp::Energy energy;
  hsp::EnergyGradient ball[8];
};
// weight [n]; null for all ones.
inline GradientOfScene gradient_of_scene(double tension, double pressure, const double *weight = nullptr) {
  GradientOfScene result{};
  hsp::differentiate_surface(hsp::Executor(), small_union().grid(), small_union().boundary(),
                             small_surface().builder().surface(), {{weight}, tension, pressure}, result.energy,
                             [&result](uint32_t i, const hsp::EnergyGradient &gradient) { result.ball[i] = gradient; });
  return result;
}

// Shifted in space, so that no component is 0 for symmetry alone, and its balls apart in all coordinates.
constexpr SurfaceScene uneven = {6,
                                 {{12345678, 1000000, 7000000, 150000000},
                                  {250000000, -31000000, 4000000, 130000000},
                                  {133000000, 240000000, -9000000, 170000000},
                                  {120000000, 90000000, 270000000, 120000000},
                                  {-170000000, 210000000, 130000000, 140000000},
                                  {420000000, 160000000, 110000000, 160000000}},
                                 usual_probe};
constexpr SurfaceScene uneven_large_probe = with_probe(uneven, 300000000);
constexpr const SurfaceScene *smooth_scenes[] = {
    &one_ball,     &two_far,      &two_far_large_probe, &two_spindle,         &two_small, &two_spindle_unequal,
    &three_throat, &three_almost, &three_open,          &void_in_tetrahedron, &uneven,    &uneven_large_probe};

// Number k of a scene: x, y, z and radius of its balls, then the probe.
inline int32_t &number_of(SurfaceScene &scene, uint32_t k) {
  if (k == 4 * scene.n) return scene.probe;
  SmallBall &ball = scene.ball[k / 4];
  int32_t *const numbers[4] = {&ball.x, &ball.y, &ball.z, &ball.r};
  return *numbers[k % 4];
}

inline double derivative(const GradientOfScene &gradient, const SurfaceScene &scene, uint32_t k) {
  if (k == 4 * scene.n) return gradient.energy.by_probe;
  return k % 4 < 3 ? gradient.ball[k / 4].centre[k % 4] : gradient.ball[k / 4].radius;
}

inline uint32_t derivatives_by_differences() {
  return first_failing(smooth_scenes, [](const SurfaceScene *scene) {
    constexpr double length = 1e8;  // of the scene
    for (uint32_t k = 0; k <= 4 * scene->n; ++k) {
      // Two steps, so that the error of each quotient, quadratic in the step, is known and taken out.
      double of_area[2], of_volume[2];
      for (int level = 0; level < 2; ++level) {
        const int32_t step = level == 0 ? 40000 : 20000;
        hsp::SurfaceMeasure at[2];
        for (int side = 0; side < 2; ++side) {
          SurfaceScene moved = *scene;
          number_of(moved, k) += side == 0 ? step : -step;
          if (!small_surface().build(moved)) return false;
          at[side] = small_surface().total();
        }
        of_area[level] = (at[0].area() - at[1].area()) / (2.0 * step);
        of_volume[level] = (at[0].volume - at[1].volume) / (2.0 * step);
      }
      const double by_area = (4 * of_area[1] - of_area[0]) / 3;
      const double by_volume = (4 * of_volume[1] - of_volume[0]) / 3;
      if (!small_surface().build(*scene)) return false;
      const GradientOfScene area = gradient_of_scene(1, 0);
      const GradientOfScene volume = gradient_of_scene(0, 1);
      if (!near(derivative(area, *scene, k), by_area, 3e-7 * length)) return false;
      if (!near(derivative(volume, *scene, k), by_volume, 3e-7 * length * length)) return false;
    }
    return true;
  });
}

// A gradient under a translation, a rotation about the origin and a magnification.
struct Motion {
  double force[3] = {}, torque[3] = {}, growth, scale = 1.0;
  bool degenerate = false;
};
inline Motion motion_of(const SurfaceScene &scene, const GradientOfScene &gradient) {
  Motion motion;
  motion.growth = gradient.energy.by_probe * scene.probe;
  for (uint32_t i = 0; i < scene.n; ++i) {
    const double c[3] = {static_cast<double>(scene.ball[i].x), static_cast<double>(scene.ball[i].y),
                         static_cast<double>(scene.ball[i].z)};
    const double *const g = gradient.ball[i].centre;
    for (int axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      motion.force[axis] += g[axis];
      motion.torque[axis] += c[next] * g[last] - c[last] * g[next];
      motion.growth += c[axis] * g[axis];
      motion.scale += std::fabs(g[axis]);
    }
    motion.growth += gradient.ball[i].radius * scene.ball[i].r;
    motion.scale += std::fabs(gradient.ball[i].radius);
    motion.degenerate = motion.degenerate || gradient.ball[i].one_sided;
  }
  return motion;
}

// Translation, rotation and magnification; an energy is what it is made of; measures are those of measure_surface.
inline uint32_t motions_and_magnification() {
  return first_failing(smooth_scenes, [](const SurfaceScene *scene) {
    if (!small_surface().build(*scene)) return false;
    const hsp::SurfaceMeasure total = small_surface().total();
    for (int of_volume = 0; of_volume < 2; ++of_volume) {
      const GradientOfScene found = gradient_of_scene(of_volume == 0 ? 1 : 0, of_volume == 0 ? 0 : 1);
      const Motion motion = motion_of(*scene, found);
      const double value = of_volume == 0 ? total.area() : total.volume;
      const double wanted = of_volume == 0 ? 2 * value : 3 * value;
      if (motion.degenerate || !near(found.energy.value, value, 1e-13 * value)) return false;
      if (!near(motion.growth, wanted, 1e-11 * wanted)) return false;
      for (int axis = 0; axis < 3; ++axis) {
        if (!near(motion.force[axis], 0, 1e-11 * wanted / 1e8)) return false;
        if (!near(motion.torque[axis], 0, 1e-11 * wanted)) return false;
      }
    }
    const GradientOfScene mixed = gradient_of_scene(3, 0.5);
    return near(mixed.energy.value, 3 * total.area() + 0.5 * total.volume, 1e-13 * mixed.energy.value);
  });
}

// Four and more spheres through a vertex.
inline uint32_t degenerate_vertices_are_told() {
  const SurfaceScene *const scenes[] = {&four_through_a_point, &eight_through_a_point};
  return first_failing(scenes, [](const SurfaceScene *scene) {
    if (!small_surface().build(*scene)) return false;
    const GradientOfScene found = gradient_of_scene(1, 1);
    uint32_t degenerate = 0;
    for (uint32_t i = 0; i < scene->n; ++i) {
      degenerate += found.ball[i].one_sided ? 1U : 0U;
      if (!std::isfinite(found.ball[i].centre[0]) || !std::isfinite(found.ball[i].radius)) return false;
    }
    return degenerate == scene->n;
  });
}

// Without a probe the surface is the boundary.
inline uint32_t gradients_without_a_probe() {
  SurfaceScene scene = uneven;
  scene.probe = 0;
  for (SmallBall &ball : scene.ball) ball.r += usual_probe / 2;
  // A ball of radius 0 on the sphere of another one.
  scene.ball[scene.n++] = {12345678 + 220000000, 1000000, 7000000, 0};
  if (!small_surface().build(scene)) return 0;
  const GradientOfScene found = gradient_of_scene(1, 0);
  for (uint32_t i = 0; i < scene.n; ++i) {
    const hsp::BallGradient own =
        hsp::gradient_of_ball(small_union().balls(), small_union().boundary(), {}, small_union().grid().grid_index(i));
    const double tolerance = 1e-12 * usual_probe;
    if (!near(found.ball[i].centre[0], own.centre.x, tolerance) ||
        !near(found.ball[i].centre[1], own.centre.y, tolerance) ||
        !near(found.ball[i].centre[2], own.centre.z, tolerance) || !near(found.ball[i].radius, own.radius, tolerance)) {
      return 1 + i;
    }
  }
  return all_hold;
}

inline constexpr Check surface_surface_gradients[] = {{"derivatives_by_differences", derivatives_by_differences},
                                                      {"motions_and_magnification", motions_and_magnification},
                                                      {"degenerate_vertices_are_told", degenerate_vertices_are_told},
                                                      {"gradients_without_a_probe", gradients_without_a_probe}};

}  // namespace cases
