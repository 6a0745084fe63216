// A set of balls of which some move at a time, with area, volume and an energy and their derivatives. Only the balls
// that moved and those that they met before or meet now are computed again: what lies on the others has not changed.
// So all numbers are, bit for bit, those of a boundary that is computed of the balls as they are: what lies on a ball
// does not depend on ids or cubes, and sums are trees whose shape depends on the number of terms alone. The boundary's
// records are not kept.
#pragma once

#include "measure/energy.hpp"
#include "measure/totals.hpp"
#include "moving/ball_group.hpp"
#include "moving/component_update.hpp"
#include "moving/sum_tree.hpp"

namespace hsp {

struct MovingLimits {
  uint32_t balls = 0;
  uint32_t neighbours = 0;
};

// Limits that suffice for most molecules.
constexpr Status default_limits(uint32_t balls, MovingLimits &limits) {
  if (balls > max_count) return Status::range;
  limits = {balls, balls < 256 ? balls : 256};
  return Status::ok;
}

// Balls that get new positions or radii: number k is ball ball[k] of the caller's.
struct BallMoves {
  uint32_t count = 0;
  const uint32_t *ball = nullptr;
  const double *xyz = nullptr;     // [count][3], null for centres that stay
  const double *radius = nullptr;  // [count], without the probe; null for radii that stay
};

// How many of everything lies on the boundary.
struct MovingCounts {
  uint32_t exposed = 0, contained = 0, components = 0;
  uint64_t half_edges = 0, circle_sides = 0, loops = 0, faces = 0;
};

class MovingBalls : public Limited<MovingLimits> {
 public:
  void carve(Workspace &workspace, const MovingLimits &limits);

  // Takes the balls of a grid, and what energy is to be known; computes everything. Radii may grow up to half the side
  // of its cubes. On failure there are no balls. Status::capacity if a limit is too small: needed() reports what
  // suffices. Status::stopped if more is not allowed.
  Status set(const CubeGrid &grid, const EnergyTerms &terms, Patience patience = Patience());
  // Moves some balls. Refused moves change nothing; then first_bad is the number of the first move that is to blame, or
  // no_id. Status::id: no such ball, or the same again; not_finite, negative, range: as for a grid, and range for a
  // radius above half the side of the cubes; capacity and stopped as above.
  Status move(const BallMoves &moves, uint32_t &first_bad, Patience patience = Patience());
  // Takes the last move back; Status::state if there is none, or it has been taken back.
  Status undo();

  uint32_t size() const { return records_.balls.n; }
  // The largest radius that a ball may have, probe included, in lattice steps.
  int64_t largest_radius() const { return cells_.side() / 2; }
  const exact::Lattice &lattice() const { return records_.balls.lattice; }
  int64_t probe_steps() const { return records_.balls.probe_steps; }

  // Of all balls, in the caller's unit.
  BallMeasure totals() const;
  Energy energy() const;
  const MovingCounts &counts() const { return counts_; }
  // Of one ball of the caller's.
  exact::LatticeBall placed(uint32_t caller) const { return records_.balls.ball(slot_[caller]); }
  const MovingBall &record(uint32_t caller) const { return records_.ball[slot_[caller]]; }
  BallMeasure measure(uint32_t caller) const;
  EnergyGradient gradient(uint32_t caller) const;
  // The balls of which anything may have changed by the last move: those that moved, those that they met or meet, and
  // those whose component has another origin, or one that moved.
  uint32_t changed_count() const { return changed_count_; }
  // Calls visit(caller) for each of them, in any order.
  template <class Visit>
  void visit_changed(Visit visit) const {
    for (uint32_t k = 0; changed_count_ != 0 && k < records_.noted(); ++k) {
      if (records_.entry(k).listed) visit(records_.balls.caller[records_.entry(k).ball]);
    }
  }

  // The balls as they are as a grid of the same cubes: what a fresh computation begins with. Status::capacity, and the
  // grid stays as it is, if it has no room for them.
  Status write(CubeGrid &grid) const;

  // For tests that do without the code for wide registers.
  BoundaryPart &part() { return group_.part(); }

 private:
  using Sums = SumTree<4>;

  Status forget(Status status);
  Status stage(const BallMoves &moves, uint32_t &first_bad);
  Status round_move(const BallMoves &moves, uint32_t k);
  void place_again(uint32_t i, const exact::LatticeBall &ball);
  uint32_t place_all(const BallMoves &moves);
  uint32_t place_one(uint32_t caller);
  void note_meeting(const exact::LatticeBall &ball);
  void note_what_meets(uint32_t i);
  Status update(uint32_t former, Patience &patience);
  void sum_up(uint32_t affected, Patience &patience);
  void put_back();
  void take_back();
  Sums::Term term_of(uint32_t i) const;
  AreaWeights weights() const { return {weighted_ ? weight_.data() : nullptr, touching_balls_}; }
  EnergyTerms terms() const { return {weights(), tension_, pressure_}; }

  MovingRecords records_;
  BallCells cells_;
  ComponentUpdate components_;
  Sums sums_;  // area, weighted area, volume, derivative by the probe
  MovingCounts counts_, counts_before_;
  bool may_undo_ = false;
  uint32_t changed_count_ = 0;

  Span<uint32_t> slot_;                // [balls] of the caller's balls
  Span<exact::LatticeBall> new_ball_;  // [moves]
  Span<double> weight_;                // [balls] of the caller's balls
  bool weighted_ = false;
  TouchingBalls touching_balls_ = TouchingBalls::meet;
  double tension_ = 0.0, pressure_ = 0.0;
  BallGroup group_;
};

}  // namespace hsp
