// The union of any balls in a periodic box, in memory of its own.
#pragma once

#include <array>

#include "ball_list.hpp"
#include "carved_memory.hpp"
#include "periodic/periodic_measures.hpp"

// a, b, c as rows.
using BoxVectors = std::array<double, 9>;

class BuiltPeriodic {
 public:
  // A step of 1 leaves whole numbers as they are, 0 lets the set choose.
  BuiltPeriodic(const support::BallList &balls, const BoxVectors &box, double probe = 0.0, double step = 1.0) {
    hsp::BallInput input;
    input.n = balls.size();
    input.xyz = balls.xyz.data();
    input.radius = balls.radius.data();
    input.probe = probe;
    input.step = step;
    hsp::PeriodicLimits limits{input.n, 8, 8, 8, 8, 8, 0};
    for (;;) {
      memory_.carve(periodic_, limits);
      status_ = periodic_.build(input, box.data(), {}, false, first_bad_);
      if (status_ != hsp::Status::capacity) return;
      limits = periodic_.retry_limits();
      ++retries_;
    }
  }

  hsp::Status status() const { return status_; }
  uint32_t first_bad() const { return first_bad_; }
  // From limits that are too small.
  uint32_t retries() const { return retries_; }
  const hsp::PeriodicUnion &get() const { return periodic_; }
  const hsp::PeriodicUnion *operator->() const { return &periodic_; }
  hsp::ContactGroups group_contacts(const uint32_t *group) { return periodic_.group_contacts(group); }
  uint32_t balls() const { return periodic_.images().balls(); }
  hsp::PeriodicTotals totals() const {
    return hsp::measure_periodic(periodic_, [](uint32_t, const hsp::BallMeasure &) {});
  }
  // In the caller's unit.
  hsp::BallMeasure of_ball(uint32_t i) const {
    return hsp::in_caller_units(periodic_.images().lattice(), hsp::measure_in_box(periodic_, i));
  }

 private:
  CarvedMemory memory_;
  hsp::PeriodicUnion periodic_;
  hsp::Status status_ = hsp::Status::state;
  uint32_t first_bad_ = 0;
  uint32_t retries_ = 0;
};
