#include "built_boundary.hpp"

#include "lattice_lengths.hpp"

BuiltBoundary::BuiltBoundary(const oracle::Balls &balls) {
  const uint32_t n = static_cast<uint32_t>(balls.size());
  const support::BallList list = oracle::in_lengths(balls, 1);
  hsp::Workspace measured;
  grid_.carve(measured, n);
  grid_memory_.resize(measured.bytes());
  hsp::Workspace grid_workspace(grid_memory_.data(), grid_memory_.size());
  grid_.carve(grid_workspace, n);
  uint32_t first_bad = 0;
  status_ = grid_.build({n, list.xyz.data(), list.radius.data(), 0.0, 1.0}, first_bad);
  if (status_ != hsp::Status::ok) return;

  const hsp::BoundaryLimits limits{n, n, 8 * n * n, n * n};
  hsp::Workspace boundary_measured;
  builder_.carve(boundary_measured, limits);
  boundary_memory_.resize(boundary_measured.bytes());
  hsp::Workspace boundary_workspace(boundary_memory_.data(), boundary_memory_.size());
  builder_.carve(boundary_workspace, limits);
  status_ = builder_.build(grid_);
}
