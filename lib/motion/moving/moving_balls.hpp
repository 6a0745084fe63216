// A set of balls of which some move at a time, with area, volume, an energy and their derivatives. Only the balls that
// moved, and those that they met before or meet now, are computed again: the boundary on the others has not changed.
// All numbers have the bits of a fresh computation: those of one ball do not depend on ids or cubes, and sums are trees
// whose shape depends on the number of terms alone. The records of the boundary are not kept.
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

// Balls that get new positions or radii: move k is of the caller's ball ball[k].
struct BallMoves {
  uint32_t count = 0;
  const uint32_t *ball = nullptr;
  const double *xyz = nullptr;     // [count][3], null for centres that stay
  const double *radius = nullptr;  // [count], without the probe; null for radii that stay
};

// The numbers of the parts of the boundary.
struct MovingCounts {
  uint32_t exposed = 0, contained = 0, components = 0;
  uint64_t half_edges = 0, circle_sides = 0, loops = 0, faces = 0;
};

class MovingBalls : public Limited<MovingLimits> {
 public:
  void carve(Workspace &workspace, const MovingLimits &limits);

  // Takes the balls of a grid, and the terms of the energy; computes everything. Radii may grow up to half the side of
  // the grid's cubes. On failure there are no balls. Status::capacity if a limit is too small: needed() reports what
  // suffices. Status::stopped if patience has ended.
  Status set(const CubeGrid &grid, const EnergyTerms &terms, Patience patience = Patience());
  // Moves some balls. On failure nothing changes, and first_bad is the number of the first move that is to blame, or
  // no_id. Status::id: a ball does not exist, or moves twice; not_finite, negative, range: as for a grid, and range for
  // a radius above half the side of the cubes; capacity and stopped as for set().
  Status move(const BallMoves &moves, uint32_t &first_bad, Patience patience = Patience());
  // Takes the last move back; Status::state if there is none, or it has been taken back.
  Status undo();

  uint32_t size() const { return records_.balls.n; }
  // The largest radius that a ball may have, probe included, in lattice steps.
  int64_t largest_radius() const { return cells_.side() / 2; }
  const exact::Lattice &lattice() const { return records_.balls.lattice; }
  int64_t probe_steps() const { return records_.balls.probe_steps; }

  // Sums over all balls, in the caller's unit.
  BallMeasure totals() const;
  Energy energy() const;
  const MovingCounts &counts() const { return counts_; }
  // The ball on the lattice, the record, the measures and the derivatives of one of the caller's balls.
  exact::LatticeBall placed(uint32_t caller) const { return records_.balls.ball(slot_[caller]); }
  const MovingBall &record(uint32_t caller) const { return records_.ball[slot_[caller]]; }
  BallMeasure measure(uint32_t caller) const;
  EnergyGradient gradient(uint32_t caller) const;
  // How many balls may have other numbers since the last move: those that moved, those that they met or meet, and those
  // whose component has another origin, or one that moved.
  uint32_t changed_count() const { return changed_count_; }
  // Calls visit(caller) for each of them, in any order.
  template <class Visit>
  void visit_changed(Visit visit) const {
    for (uint32_t k = 0; changed_count_ != 0 && k < records_.noted(); ++k) {
      if (records_.entry(k).listed) visit(records_.balls.caller[records_.entry(k).ball]);
    }
  }

  // Writes the balls at their present places to a grid with the same cubes, from which a fresh computation can begin.
  // Status::capacity if the grid has no room for them; then it stays as it is.
  Status write(CubeGrid &grid) const;

  // For tests without the code for wide registers.
  BoundaryPart &part() { return group_.part(); }

 private:
  using Sums = SumTree<4>;

  void note_all();
  Status forget(Status status);
  Status stage(const BallMoves &moves, uint32_t &first_bad);
  Status round_move(const BallMoves &moves, uint32_t k);
  void place_again(uint32_t i, const exact::LatticeBall &ball);
  uint32_t place_all(const BallMoves &moves);
  uint32_t place_one(uint32_t caller);
  void note_what_meets(uint32_t i);
  Status update(uint32_t former, Patience &patience);
  void sum_up(uint32_t affected, Patience &patience);
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

  Span<uint32_t> slot_;                // [balls] the number here of each of the caller's balls
  Span<exact::LatticeBall> new_ball_;  // [moves]
  Span<double> weight_;                // [balls] in the caller's order
  bool weighted_ = false;
  TouchingBalls touching_balls_ = TouchingBalls::meet;
  double tension_ = 0.0, pressure_ = 0.0;
  BallGroup group_;
};

}  // namespace hsp
