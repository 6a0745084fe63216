// The library's results for lattice balls as a `computed` (tests/api/support/computed.h), for which the invariants of
// the C interface are written, released with the object.
#pragma once

#include <boundary_invariants.h>

#include <string>

#include "lattice_lengths.hpp"
#include "library_run.hpp"

class ComputedBalls {
 public:
  explicit ComputedBalls(const oracle::Balls &balls) {
    const support::BallList list = oracle::in_lengths(balls, 1);
    hsp_model_options options;
    expect_ok(hsp_model_options_init(&options, sizeof options), "hsp_model_options_init");
    options.step = 1;
    expect_ok(computed_make(list.size(), list.xyz.data(), list.radius.data(), &options, &computed_), "computed_make");
  }
  ~ComputedBalls() { computed_release(&computed_); }
  ComputedBalls(const ComputedBalls &) = delete;
  ComputedBalls &operator=(const ComputedBalls &) = delete;

  const computed *get() const { return &computed_; }

 private:
  computed computed_{};
};

// A broken invariant as a complaint.
inline std::string complaint_of(const char *broken) {
  return broken == nullptr ? "" : std::string(broken) + "; ";
}

// The first invariant of the boundary that does not hold.
inline std::string boundary_invariant_broken(const oracle::Balls &balls) {
  return complaint_of(broken_boundary(ComputedBalls(balls).get()));
}
