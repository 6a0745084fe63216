// A grid over balls of any number, in memory of its own.
#pragma once

#include "ball_list.hpp"
#include "carved_memory.hpp"
#include "model/cube_grid.hpp"

class BuiltGrid {
 public:
  // A step of 1 leaves whole numbers as they are, 0 lets the set choose.
  explicit BuiltGrid(const support::BallList &balls, double probe = 0.0, double step = 1.0) {
    const uint32_t n = balls.size();
    memory_.carve(grid_, n);
    uint32_t first_bad = 0;
    status_ = grid_.build({n, balls.xyz.data(), balls.radius.data(), probe, step}, first_bad);
  }

  hsp::CubeGrid &grid() { return grid_; }
  const hsp::CubeGrid &grid() const { return grid_; }
  hsp::Status status() const { return status_; }

 private:
  CarvedMemory memory_;
  hsp::CubeGrid grid_;
  hsp::Status status_ = hsp::Status::state;
};
