// Free space as cells, in memory that grows until it suffices.
#pragma once

#include "built_grid.hpp"
#include "cells/free_space_builder.hpp"
#include "lattice_lengths.hpp"

class BuiltFreeSpace {
 public:
  explicit BuiltFreeSpace(const oracle::Balls &balls)
      : BuiltFreeSpace(balls, usual_limits(static_cast<uint32_t>(balls.size()))) {}
  BuiltFreeSpace(const oracle::Balls &balls, const hsp::FreeSpaceLimits &limits) : grid_(oracle::in_lengths(balls, 1)) {
    status_ = build(limits);
    while (status_ == hsp::Status::capacity && retries_ < 20) {
      ++retries_;
      status_ = build(builder_.retry_limits());
    }
  }

  hsp::Status build(const hsp::FreeSpaceLimits &limits) {
    memory_.carve(builder_, limits);
    return builder_.build(grid_.grid());
  }

  hsp::Status status() const { return status_; }
  uint32_t retries() const { return retries_; }
  const hsp::CubeGrid &grid() const { return grid_.grid(); }
  const hsp::BallSet &balls() const { return grid_.grid().balls(); }
  const hsp::FreeSpace &space() const { return builder_.structure(); }
  hsp::FreeSpaceBuilder &builder() { return builder_; }

 private:
  static hsp::FreeSpaceLimits usual_limits(uint32_t balls) {
    hsp::FreeSpaceLimits limits;
    static_cast<void>(hsp::default_limits(balls, limits));
    return limits;
  }

  BuiltGrid grid_;
  CarvedMemory memory_;
  hsp::FreeSpaceBuilder builder_;
  hsp::Status status_ = hsp::Status::ok;
  uint32_t retries_ = 0;
};
