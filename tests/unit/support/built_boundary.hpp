// A boundary with its inner records open, for tests that look at them or break them.
#pragma once

#include <cstdint>
#include <vector>

#include "boundary/boundary_builder.hpp"
#include "lattice_ball.hpp"
#include "model/cube_grid.hpp"

class BuiltBoundary {
 public:
  // Lattice step 1, so that the numbers stand for themselves.
  explicit BuiltBoundary(const oracle::Balls &balls);

  const hsp::CubeGrid &grid() const { return grid_; }
  const hsp::BallSet &balls() const { return grid_.balls(); }
  const hsp::Boundary &boundary() const { return builder_.boundary(); }
  // The arrays behind it, to be broken.
  hsp::BoundaryArrays &arrays() { return builder_.arrays(); }
  // Memory for checks.
  hsp::Span<uint32_t> scratch() { return builder_.scratch(); }
  // Most balls that meet any one ball.
  uint32_t neighbours() const { return builder_.needed().neighbours; }
  // The id in the grid's order of the ball that was given as number `caller`.
  uint32_t grid_index(uint32_t caller) const { return grid_.grid_index(caller); }
  hsp::Status status() const { return status_; }

 private:
  hsp::CubeGrid grid_;
  hsp::BoundaryBuilder builder_;
  std::vector<unsigned char> grid_memory_, boundary_memory_;
  hsp::Status status_ = hsp::Status::ok;
};
