// Derivatives of the sum of the balls' shares of the area, times weights that are not equal, against difference
// quotients of these shares, and what motions and magnification say of them.
#pragma once

#include "surface_gradients_cases.hpp"

namespace cases {

constexpr double uneven_weights[8] = {1.0, -0.5, 2.0, 0.25, 1.5, -1.25, 0.0, 3.0};

inline double weighted_area(const SurfaceScene &scene, const double *weight) {
  double sum = 0.0;
  for (uint32_t i = 0; i < scene.n; ++i) sum += weight[i] * small_surface().of_ball(i).area();
  return sum;
}

// The small ball's half of its saddle, and what is its only third, pass from one side of a centre to the other.
constexpr SurfaceScene waist_beyond_a_centre = {4,
                                                {{0, 0, 0, 170000000},
                                                 {190000000, 7000000, 3000000, 30000000},
                                                 {60000000, 210000000, 40000000, 90000000},
                                                 {-40000000, 20000000, 230000000, 100000000}},
                                                usual_probe};

// By the quotient of one number of a scene, of three steps, each half as large as the one before; false where it does
// not converge.
inline bool quotient(const SurfaceScene &scene, const double *weight, uint32_t k, double &found, double &error) {
  double of_area[3];
  for (int level = 0; level < 3; ++level) {
    const int32_t step = 40000 >> level;
    double at[2];
    for (int side = 0; side < 2; ++side) {
      SurfaceScene moved = scene;
      number_of(moved, k) += side == 0 ? step : -step;
      if (!small_surface().build(moved)) return false;
      at[side] = weighted_area(moved, weight);
    }
    of_area[level] = (at[0] - at[1]) / (2.0 * step);
  }
  const double coarse = (4 * of_area[1] - of_area[0]) / 3;
  found = (4 * of_area[2] - of_area[1]) / 3;
  error = found < coarse ? coarse - found : found - coarse;
  return true;
}

inline uint32_t weighted_derivatives_by_differences() {
  const SurfaceScene *const scenes[] = {&one_ball,
                                        &two_far,
                                        &two_far_large_probe,
                                        &two_spindle,
                                        &two_small,
                                        &two_spindle_unequal,
                                        &three_throat,
                                        &three_open,
                                        &uneven,
                                        &uneven_large_probe,
                                        &waist_beyond_a_centre,
                                        &void_in_tetrahedron};
  return first_failing(scenes, [](const SurfaceScene *scene) {
    constexpr double length = 1e8;  // of the scene
    for (uint32_t k = 0; k <= 4 * scene->n; ++k) {
      double by_area = 0.0, error = 0.0;
      if (!quotient(*scene, uneven_weights, k, by_area, error) || error > 1e-6 * length) return false;
      if (!small_surface().build(*scene)) return false;
      const GradientOfScene found = gradient_of_scene(1, 0, uneven_weights);
      if (!near(found.energy.area, weighted_area(*scene, uneven_weights), 1e-12 * length * length)) return false;
      if (!near(derivative(found, *scene, k), by_area, error + 3e-7 * length)) return false;
    }
    return true;
  });
}

// Sets at random, with creases between probes of different balls. Where something is born within the steps quotients
// do not converge.
inline uint32_t weighted_derivatives_of_random_sets() {
  Random random(9);
  uint32_t compared = 0, uncertain = 0, creases = 0;
  for (uint32_t round = 0; round < 60; ++round) {
    SurfaceScene scene{7, {}, static_cast<int32_t>(80000000 + random.below(200000000))};
    for (SmallBall &ball : scene.ball) {
      const auto coordinate = [&random] { return static_cast<int32_t>(random.below(600000000)); };
      ball.x = coordinate();
      ball.y = coordinate();
      ball.z = coordinate();
      ball.r = static_cast<int32_t>(80000000 + random.below(100000000));
    }
    const uint32_t k = random.below(4 * scene.n + 1);
    double by_area = 0.0, error = 0.0;
    if (!quotient(scene, uneven_weights, k, by_area, error) || !small_surface().build(scene)) return round;
    ++compared;
    if (error > 1e4) {
      ++uncertain;
      continue;
    }
    creases += small_surface().builder().surface().cut_patches().creases().size();
    const GradientOfScene found = gradient_of_scene(1, 0, uneven_weights);
    if (!near(derivative(found, scene, k), by_area, error + 1e3)) return round;
  }
  if (4 * uncertain >= compared) return 1000 + uncertain;
  return creases > 50 ? all_hold : 2000 + creases;
}

// Translation, rotation and magnification.
inline uint32_t motions_of_weighted_areas() {
  return first_failing(smooth_scenes, [](const SurfaceScene *scene) {
    if (!small_surface().build(*scene)) return false;
    const GradientOfScene found = gradient_of_scene(1, 0, uneven_weights);
    const Motion motion = motion_of(*scene, found);
    const double tolerance = 1e-11 * motion.scale;
    for (int axis = 0; axis < 3; ++axis) {
      if (!near(motion.force[axis], 0, tolerance) || !near(motion.torque[axis], 0, tolerance * 4e8)) return false;
    }
    return near(motion.growth, 2 * found.energy.area, tolerance * 4e8);
  });
}

// A multiple of the area has that multiple of its derivatives.
inline uint32_t equal_weights() {
  return first_failing(smooth_scenes, [](const SurfaceScene *scene) {
    if (!small_surface().build(*scene)) return false;
    constexpr double thrice[8] = {3, 3, 3, 3, 3, 3, 3, 3};
    const GradientOfScene plain = gradient_of_scene(1, 0.5), found = gradient_of_scene(1, 1.5, thrice);
    for (uint32_t k = 0; k <= 4 * scene->n; ++k) {
      const double expected = 3 * derivative(plain, *scene, k);
      if (!near(derivative(found, *scene, k), expected, 1e-13 * (1e8 * 1e8 + std::fabs(expected)))) return false;
    }
    return near(found.energy.value, 3 * plain.energy.value, 1e-13 * 3 * plain.energy.value);
  });
}

// Without a probe the surface is the boundary.
inline uint32_t weights_without_a_probe() {
  SurfaceScene scene = uneven;
  scene.probe = 0;
  for (SmallBall &ball : scene.ball) ball.r += usual_probe / 2;
  // A ball whose circle lies beyond its centre.
  scene.ball[scene.n++] = {12345678 + 150000000, 1000000, 47000000, 80000000};
  if (!small_surface().build(scene)) return 0;
  const GradientOfScene found = gradient_of_scene(1, 0, uneven_weights);
  for (uint32_t i = 0; i < scene.n; ++i) {
    const hsp::BallGradient own = hsp::gradient_of_ball(small_union().balls(), small_union().boundary(),
                                                        {uneven_weights}, small_union().grid().grid_index(i));
    const double tolerance = 1e-11 * usual_probe;
    if (!near(found.ball[i].centre[0], own.centre.x, tolerance) ||
        !near(found.ball[i].centre[1], own.centre.y, tolerance) ||
        !near(found.ball[i].centre[2], own.centre.z, tolerance) || !near(found.ball[i].radius, own.radius, tolerance)) {
      return 1 + i;
    }
  }
  return all_hold;
}

// A circle in the plane of a centre: 3-4-5, probe 1.
inline uint32_t waist_at_a_centre() {
  SurfaceScene scene = {2, {{0, 0, 0, 400000000}, {0, 400000000, 0, 200000000}}, 100000000};
  constexpr double equal[2] = {2, 2};
  if (!small_surface().build(scene)) return 0;
  if (!gradient_of_scene(1, 0, uneven_weights).ball[0].one_sided) return 1;
  if (!gradient_of_scene(1, 0, uneven_weights).ball[1].one_sided) return 2;
  if (gradient_of_scene(1, 0, equal).ball[0].one_sided || gradient_of_scene(1, 0).ball[1].one_sided) return 3;
  ++scene.ball[1].y;
  if (!small_surface().build(scene)) return 4;
  return gradient_of_scene(1, 0, uneven_weights).ball[1].one_sided ? 5 : all_hold;
}

inline constexpr Check surface_weighted_joints[] = {
    {"weighted_derivatives_by_differences", weighted_derivatives_by_differences},
    {"weighted_derivatives_of_random_sets", weighted_derivatives_of_random_sets},
    {"motions_of_weighted_areas", motions_of_weighted_areas},
    {"equal_weights", equal_weights},
    {"weights_without_a_probe", weights_without_a_probe},
    {"waist_at_a_centre", waist_at_a_centre}};

}  // namespace cases
