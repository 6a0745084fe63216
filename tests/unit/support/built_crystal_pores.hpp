// Maxima, gates and classes of balls in a periodic box, in memory that grows until it suffices.
#pragma once

#include "brute_pores.hpp"
#include "built_periodic.hpp"
#include "built_pores.hpp"

class BuiltCrystalPores {
 public:
  BuiltCrystalPores(const oracle::Balls &balls, const oracle::BoxRows &box)
      : BuiltCrystalPores(balls, box, BuiltPores::lowest(balls)) {}
  BuiltCrystalPores(const oracle::Balls &balls, const oracle::BoxRows &box, int64_t floor) : floor_(floor) {
    const support::BallList list = BuiltPores::listed(balls);
    double vectors[9];
    for (size_t k = 0; k < 9; ++k) vectors[k] = static_cast<double>(box[k / 3][k % 3]);
    hsp::BallInput input;
    input.n = list.size();
    input.xyz = list.xyz.data();
    input.radius = list.radius.data();
    input.step = 1.0;
    uint32_t first_bad = 0;
    image_memory_.carve(images_, input.n, 40 * input.n + 100);
    status_ = images_.build(input, vectors, first_bad);
    limits_ = {4, 4, 4, 4, 40, 8};
    while (status_ == hsp::Status::ok && retries_ < 100) {
      status_ = build(limits_);
      if (status_ != hsp::Status::capacity) break;
      ++retries_;
      limits_ = builder_.retry_limits();
      status_ = hsp::Status::ok;
    }
  }

  hsp::Status build(const hsp::PoreLimits &limits) {
    memory_.carve(builder_, limits);
    return builder_.build(images_, floor_);
  }
  hsp::Status status() const { return status_; }
  uint32_t retries() const { return retries_; }
  const hsp::PoresBuilder &builder() const { return builder_; }
  hsp::Span<const hsp::PoreMaximum> maxima() const { return builder_.maxima(); }
  hsp::Span<const hsp::PoreGate> gates() const { return builder_.gates(); }
  // The largest level at which a probe gets through the crystal in this number of directions; NaN if no probe does.
  double passage(uint32_t directions) const {
    const uint32_t gate = builder_.passages().gate[directions - 1];
    return gate == hsp::no_id ? std::nan("") : gates()[gate].point.level;
  }
  // The number of directions in which a probe gets through the crystal.
  uint32_t directions(double probe) const {
    uint32_t most = 0;
    while (most < 3 && passage(most + 1) > probe) ++most;
    return most;
  }

 private:
  CarvedMemory image_memory_, memory_;
  hsp::PeriodicImages images_;
  hsp::PoresBuilder builder_;
  hsp::PoreLimits limits_;
  int64_t floor_;
  hsp::Status status_ = hsp::Status::ok;
  uint32_t retries_ = 0;
};
