// Random balls in a random periodic box, with a weight for each, and how such a set is changed.
#pragma once

#include <cmath>
#include <vector>

#include "built_periodic.hpp"
#include "random_balls.hpp"

// Lengths of a few units on a lattice of this step.
inline constexpr double fine_step = 1e-8;

struct WeightedBox {
  WeightedBox(oracle::RandomSource &random, uint32_t n) {
    const auto between = [&](double low, double high) { return low + (high - low) * random.fraction(); };
    box = {between(3.5, 5), 0, 0, between(-1.5, 1.5), between(3.5, 5), 0, 0, 0, 0};
    box[6] = between(-1.5, 1.5);
    box[7] = between(-1.5, 1.5);
    box[8] = between(3.5, 5);
    for (uint32_t i = 0; i < n; ++i) {
      const double x = between(-4, 8);
      const double y = between(-4, 8);
      const double z = between(-4, 8);
      balls.add(x, y, z, std::round(1e8 * between(0.6, 1.3)) / 1e8);
      weights.push_back(between(-1, 2));
    }
  }
  BuiltPeriodic built() const { return {balls, box, 0.0, fine_step}; }

  // Component (p, q) of the strain grows. The box keeps the form that the library wants if the strain is upper
  // triangular.
  void strain(size_t p, size_t q, double by) {
    for (size_t row = 0; row < 3; ++row) box[3 * row + p] += by * box[3 * row + q];
    for (size_t i = 0; i < balls.radius.size(); ++i) balls.xyz[3 * i + p] += by * balls.xyz[3 * i + q];
  }

  // Component k of the box grows, with the balls at fixed multiples of its vectors.
  void change_box(size_t k, double by) {
    const size_t row = k / 3;
    const size_t axis = k % 3;
    for (size_t i = 0; i < balls.radius.size(); ++i) {
      const double *const at = &balls.xyz[3 * i];
      double place[3];
      place[2] = at[2] / box[8];
      place[1] = (at[1] - place[2] * box[7]) / box[4];
      place[0] = (at[0] - place[2] * box[6] - place[1] * box[3]) / box[0];
      balls.xyz[3 * i + axis] += by * place[row];
    }
    box[k] += by;
  }

  support::BallList balls;
  BoxVectors box;
  std::vector<double> weights;
};
