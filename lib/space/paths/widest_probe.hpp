// The widest ball-shaped probe that gets from one point to another, or to the outside, and the balls that stop a wider
// one.
//
// A probe of radius p can if both points lie in one region of the balls grown by p, which is decided exactly; so p is
// bisected to one lattice step. The passage that closes there is one between three balls, the gate, with the centre of
// the probe in their plane. With y from the first centre, y.v_k = (|v_k|^2 + r_1^2 - r_k^2) / 2 + p (r_1 - r_k) for the
// other two, so that y = y_0 + p y_1 in their plane, and |y| = r_1 + p is quadratic in p: D(p) = 0. Or nothing closes
// before the probe touches a ball at one of the points: then that ball is the gate.
#pragma once

#include "cells/free_space_builder.hpp"

namespace hsp {

struct ProbeLimits {
  FreeSpaceLimits cells;  // of the grown balls
  uint32_t balls = 0;
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, ProbeLimits &limits) {
  limits.balls = balls;
  return default_limits(balls, limits.cells);
}

struct WidestProbe {
  bool passes;       // whether a point does: else there is neither a radius nor a gate
  double radius;     // in lattice steps; infinite without balls
  uint32_t gate[3];  // indices of the caller, ascending; no_id behind the last one
};

class WidestProbeFinder {
 public:
  void carve(Workspace &workspace, const ProbeLimits &limits);
  // `to` is null for the outside. Status::capacity: a limit is too small, retry_limits(). Status::range: a probe passes
  // with which the largest ball lies beyond the lattice.
  Status find(const BallSet &balls, const exact::Vector &from, const exact::Vector *to, WidestProbe &widest);
  // The same in two parts: whether a point passes, and if more is open how wide a probe does. The search begins beside
  // a guess, in steps, if it is not negative. The result does not depend on that, but how long it takes does.
  Status begin(const BallSet &balls, const exact::Vector &from, const exact::Vector *to, WidestProbe &widest,
               bool &open);
  Status narrow(const BallSet &balls, double guess, WidestProbe &widest);

  // The limits that suffice, after Status::ok.
  const ProbeLimits &needed() const { return needed_; }
  // The limits to try again with after Status::capacity. Wider probes may need more, so that each step is a large one.
  ProbeLimits retry_limits() const;
  uint32_t builds() const { return builds_; }

 private:
  Status pass(int64_t probe, bool &passes);
  bool is_beyond_centres(const BallSet &balls, const exact::Vector &x) const;
  void touched_ball(const BallSet &balls, WidestProbe &widest) const;
  void find_gate(int64_t probe, WidestProbe &widest) const;
  bool closes(uint32_t i, uint32_t j, uint32_t k, int64_t probe, double &beyond, Vec3 &at) const;
  bool is_covered(uint32_t i, uint32_t j, uint32_t k, const Vec3 &at, double probe) const;

  Span<double> xyz_, radius_;  // of the caller's order, in lattice steps
  CubeGrid grid_;
  FreeSpaceBuilder builder_;
  exact::Vector from_{}, to_{};
  ProbeLimits limits_, needed_;
  bool to_outside_ = false;
  int64_t most_ = 0;  // with which the probe touches a ball at one of the points
  uint32_t n_ = 0, builds_ = 0;
};

}  // namespace hsp
