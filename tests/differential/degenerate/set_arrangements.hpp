// A set of balls moved, turned, scaled, perturbed and repeated, exactly.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lattice_ball.hpp"

namespace degenerate {

oracle::Balls moved(const oracle::Balls &balls, const std::array<int64_t, 3> &shift);

// A short shift, one by a million and some, and shifts to corners of the lattice, as far as the set fits.
std::vector<std::array<int64_t, 3>> shifts_within_lattice(const oracle::Balls &balls);

// The five other orders of the axes, and a reflection.
std::vector<oracle::Balls> axis_images(const oracle::Balls &balls);

// The largest factor with which the set still fits the lattice; 1 if it does not fit.
int64_t largest_scale(const oracle::Balls &balls);
oracle::Balls scaled(const oracle::Balls &balls, int64_t factor);

// The sets in which one ball is moved by one step along an axis, or has a radius larger or smaller by one step.
std::vector<oracle::Balls> one_step_off(const oracle::Balls &balls);

// The balls, and behind them one further ball for each of them:
oracle::Balls with_copies(const oracle::Balls &balls);      // the same
oracle::Balls with_half_sizes(const oracle::Balls &balls);  // concentric, half as large
oracle::Balls with_tangents(const oracle::Balls &balls);    // half as large, touching it from inside

}  // namespace degenerate
