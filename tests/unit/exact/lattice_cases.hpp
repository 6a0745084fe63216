// Steps of lattices: the smallest power of ten that holds the largest radius, and given ones.
#pragma once

#include "cases.hpp"
#include "exact/lattice.hpp"

namespace cases {

struct DefaultStep {
  double radius, probe, step;  // 0 if there is none
};
constexpr DefaultStep default_steps[] = {{1.8, 0, 1e-8},
                                         {3.2, 0, 1e-8},
                                         {10.7, 0, 1e-8},
                                         {10.8, 0, 1e-7},
                                         {1.07, 0, 1e-9},
                                         {0.0, 0, 1e-8},
                                         {1.073741823, 0, 1e-9},
                                         {1.073741824, 0, 1e-8},
                                         {1.8e6, 0, 1e-2},
                                         {1.8e-6, 0, 1e-14},
                                         {1.05e-16, 0, 1e-22},
                                         {1.04e-16, 0, 0},  // fewer than 2^20 steps
                                         {0.6e-16, 0.5e-16, 1e-22},
                                         {1e-300, 0, 0},
                                         {0, 1e-24, 0},
                                         {1e30, 0, 1e22 / 10},
                                         {1e300, 0, 0},
                                         // Each rounds up on its own, and the sum would be 2^30.
                                         {0.5368709115, 0.5368709115, 1e-8}};

inline uint32_t default_steps_hold_the_largest_radius() {
  return first_failing(default_steps, [](const DefaultStep &c) {
    hsp::exact::Lattice lattice;
    const bool found = hsp::exact::Lattice::for_largest_radius(c.radius, c.probe, lattice);
    return found == (c.step > 0.0) && (!found || lattice.step() == c.step);
  });
}

// Of points, by the largest coordinate.
struct StepOfPoints {
  double largest, step;  // 0 if there is none
};
constexpr StepOfPoints steps_of_points[] = {
    {0.0, 1e-8}, {1.07, 1e-9},    {1.08, 1e-8},   {9e-10, 1e-18}, {50.0, 1e-8},      {1.12e7, 1e-8},  {1.13e7, 1e-7},
    {1e20, 1e5}, {1.12e37, 1e22}, {1.2e37, 1e22}, {1e300, 1e22},  {1.05e-16, 1e-22}, {1.04e-16, 0.0}, {5e-324, 0.0}};

inline uint32_t points_have_steps_by_coordinates() {
  return first_failing(steps_of_points, [](const StepOfPoints &c) {
    hsp::exact::Lattice lattice;
    const bool found = hsp::exact::Lattice::for_points(c.largest, lattice);
    return found == (c.step > 0.0) && (!found || lattice.step() == c.step);
  });
}

inline uint32_t any_other_step_works_too() {
  const hsp::exact::Lattice lattice = hsp::exact::Lattice::with_step(0.25);
  const bool conditions[] = {lattice.steps(1.0) == 4.0, lattice.length(4.0) == 1.0, lattice.area(16.0) == 1.0,
                             lattice.volume(64.0) == 1.0};
  return first_false(conditions);
}

inline constexpr Check exact_lattice[] = {
    {"default_steps_hold_the_largest_radius", default_steps_hold_the_largest_radius},
    {"points_have_steps_by_coordinates", points_have_steps_by_coordinates},
    {"any_other_step_works_too", any_other_step_works_too}};

}  // namespace cases
