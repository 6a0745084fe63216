// The boundary of balls in lengths, as callers give them.
#pragma once

#include <cstdint>

#include "boundary/boundary_builder.hpp"
#include "built_grid.hpp"

class BuiltUnion {
 public:
  explicit BuiltUnion(const support::BallList &balls, double probe = 0.0, double step = 1e-8)
      : built_(balls, probe, step) {
    const uint32_t n = balls.size();
    memory_.carve(builder_, hsp::BoundaryLimits{n, n, 8 * n + 64, 2 * n + 16, 0});
    status_ = built_.status() == hsp::Status::ok ? builder_.build(built_.grid()) : built_.status();
  }

  hsp::Status status() const { return status_; }
  const hsp::CubeGrid &grid() const { return built_.grid(); }
  const hsp::BallSet &balls() const { return grid().balls(); }
  const hsp::Boundary &boundary() const { return builder_.boundary(); }
  // The index in the grid's order of the ball that was given as number i.
  uint32_t ball(uint32_t i) const { return grid().grid_index(i); }

 private:
  BuiltGrid built_;
  CarvedMemory memory_;
  hsp::BoundaryBuilder builder_;
  hsp::Status status_ = hsp::Status::ok;
};
