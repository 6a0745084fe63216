// Maxima, gates and classes of some balls, in memory that grows until it suffices.
#pragma once

#include <algorithm>

#include "built_grid.hpp"
#include "lattice_ball.hpp"
#include "pores/pores_builder.hpp"

class BuiltPores {
 public:
  // Pores down to the level at which the largest ball has shrunk to nothing.
  explicit BuiltPores(const oracle::Balls &balls) : BuiltPores(balls, lowest(balls)) {}
  BuiltPores(const oracle::Balls &balls, int64_t floor) : grid_(listed(balls)) {
    static_cast<void>(hsp::default_limits(static_cast<uint32_t>(balls.size()), limits_));
    status_ = build(limits_, floor);
    while (status_ == hsp::Status::capacity && retries_ < 40) {
      ++retries_;
      limits_ = builder_.retry_limits();
      status_ = build(limits_, floor);
    }
  }

  hsp::Status build(const hsp::PoreLimits &limits, int64_t floor, const hsp::PoresBuilder *before = nullptr) {
    memory_.carve(builder_, limits);
    return builder_.build(grid_.grid(), floor, hsp::Patience(), before);
  }

  hsp::Status status() const { return status_; }
  uint32_t retries() const { return retries_; }
  const hsp::PoreLimits &limits() const { return limits_; }
  hsp::PoresBuilder &builder() { return builder_; }
  const hsp::CubeGrid &grid() const { return grid_.grid(); }
  const hsp::PoresBuilder &builder() const { return builder_; }
  hsp::Span<const hsp::PoreMaximum> maxima() const { return builder_.maxima(); }
  hsp::Span<const hsp::PoreGate> gates() const { return builder_.gates(); }
  // The number of components of the free space for a probe, including the outside.
  int components(double probe) const {
    int count = 1;
    for (const auto &maximum : maxima()) count += maximum.point.level > probe ? 1 : 0;
    for (const auto &gate : gates()) count -= gate.merges && gate.point.level > probe ? 1 : 0;
    return count;
  }

  static int64_t lowest(const oracle::Balls &balls) {
    int64_t largest = 0;
    for (const oracle::LatticeBall &ball : balls) largest = std::max(largest, ball.radius);
    return -largest - 1;
  }
  static support::BallList listed(const oracle::Balls &balls) {
    support::BallList list;
    for (const oracle::LatticeBall &ball : balls) {
      list.add(static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z),
               static_cast<double>(ball.radius));
    }
    return list;
  }

 private:
  BuiltGrid grid_;
  CarvedMemory memory_;
  hsp::PoresBuilder builder_;
  hsp::PoreLimits limits_;
  hsp::Status status_ = hsp::Status::ok;
  uint32_t retries_ = 0;
};
