// A set of balls moved, turned, scaled, perturbed and repeated, exactly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lattice_ball.hpp"
#include "random_balls.hpp"

namespace oracle {

Balls moved(const Balls &balls, const LatticePoint &shift);

// Every ball larger by a probe.
Balls grown(const Balls &balls, int64_t probe);

// Axis k is axis axes[k] of the balls given, reflected if bit k says so: 48 symmetries.
Balls along_axes(const Balls &balls, const std::array<size_t, 3> &axes, uint32_t reflected = 0);

// All 48 of them, the set itself first.
std::vector<Balls> axis_symmetries(const Balls &balls);

// A short shift, one by a million and some, and shifts to corners of the lattice, as far as the set fits.
std::vector<LatticePoint> shifts_within_lattice(const Balls &balls);

// The five other orders of the axes, and a reflection.
std::vector<Balls> axis_images(const Balls &balls);

// The largest factor with which the set still fits the lattice; 1 if it does not fit.
int64_t largest_scale(const Balls &balls);
Balls scaled(const Balls &balls, int64_t factor);

// The sets in which one ball is moved by one step along an axis, or has a radius larger or smaller by one step.
std::vector<Balls> one_step_off(const Balls &balls);

// The balls, and behind them one further ball for each of them:
Balls with_copies(const Balls &balls);      // the same
Balls with_half_sizes(const Balls &balls);  // concentric, half as large
Balls with_tangents(const Balls &balls);    // half as large, touching it from inside

// The set so many times, as models of one molecule are: each ball moved by at most `most` along each axis.
Balls as_models(const Balls &balls, size_t models, int64_t most, RandomSource &random);

}  // namespace oracle
