// Volume, weighted area and its mean over a window of radii as one ball of a set moves: how steep, and how bent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lattice_ball.hpp"

enum class Quantity { volume, area, mean };

// In lengths of so many steps of the lattice; derivatives are by such a length.
inline constexpr double steps_of_length = 0x1p24;

struct MovedBall {
  oracle::Balls balls;
  size_t moving = 0;
  std::array<double, 3> direction{};  // of any length
  std::vector<double> weights;
  double window = 0;

  // The set with the ball moved by t times the direction, and all radii grown by `grown` times their weights.
  [[nodiscard]] oracle::Balls at(double t, double grown) const;
};

struct SlopeAndBend {
  double slope, bend;
};

// By t.
SlopeAndBend derivatives(const MovedBall &moved, Quantity quantity, double t);

oracle::LatticeBall ball_of(double x, double y, double z, double radius);
