// Paths through free space, in memory that grows until it suffices.
#pragma once

#include "built_grid.hpp"
#include "lattice_lengths.hpp"
#include "paths/path_finder.hpp"

class BuiltPaths {
 public:
  explicit BuiltPaths(const oracle::Balls &balls, uint32_t points = 20000) : grid_(oracle::in_lengths(balls, 1)) {
    hsp::PathLimits limits;
    static_cast<void>(hsp::default_limits(static_cast<uint32_t>(balls.size()), limits.cells));
    limits.points = points;
    do {
      memory_.carve(finder_, limits);
      status_ = finder_.build(grid_.grid());
      limits.cells = finder_.cells().retry_limits();
    } while (status_ == hsp::Status::capacity);
  }

  hsp::Status status() const { return status_; }
  const hsp::CubeGrid &grid() const { return grid_.grid(); }
  const hsp::BallSet &balls() const { return grid().balls(); }
  hsp::PathFinder &finder() { return finder_; }

 private:
  BuiltGrid grid_;
  CarvedMemory memory_;
  hsp::PathFinder finder_;
  hsp::Status status_ = hsp::Status::ok;
};
