// A boundary with its inner records open, for tests that look at the records or break them.
#pragma once

#include <cstdint>

#include "boundary/boundary_builder.hpp"
#include "built_grid.hpp"
#include "lattice_ball.hpp"

class BuiltBoundary {
 public:
  // Lattice step 1, so that the numbers stand for themselves.
  explicit BuiltBoundary(const oracle::Balls &balls, bool with_levels = true);

  const hsp::CubeGrid &grid() const { return built_.grid(); }
  const hsp::BallSet &balls() const { return grid().balls(); }
  const hsp::Boundary &boundary() const { return builder_.boundary(); }
  // The arrays behind the boundary, to be broken by a test.
  hsp::BoundaryArrays &arrays() { return builder_.arrays(); }
  // Scratch memory for the library's own checks.
  hsp::Span<uint32_t> scratch() { return builder_.scratch(); }
  // The largest number of balls that meet any one ball.
  uint32_t neighbours() const { return builder_.needed().neighbours; }
  // The id in the grid's order of the ball that was given as number `caller`.
  uint32_t grid_index(uint32_t caller) const { return grid().grid_index(caller); }
  hsp::Status status() const { return status_; }

 private:
  BuiltGrid built_;
  CarvedMemory memory_;
  hsp::BoundaryBuilder builder_;
  hsp::Status status_ = hsp::Status::ok;
};
