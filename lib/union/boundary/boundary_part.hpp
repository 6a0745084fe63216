// The boundary on some balls of a set alone: half-edges, loops and faces, as class Boundary shows them. The balls
// are the first of the set, and those that meet them are behind them; so each of their vertices is found at one of
// them. Ball by ball there is the same as in the boundary of the whole, whatever the ids are. Nothing is known of the
// others, of shells and components.
#pragma once

#include "boundary/boundary_worker.hpp"
#include "boundary/shells.hpp"

namespace hsp {

class BoundaryPart {
 public:
  // limits: balls of the set, neighbours, and what lies on the balls asked for.
  void carve(Workspace &workspace, const BoundaryLimits &limits);

  // For the first `own` balls, at most 1.5 sides from a centre along each axis; no radius is larger than half a side.
  // Status::capacity if a limit is too small: needed() then reports what suffices.
  Status build(const BallSet &balls, uint32_t own, const double (&centre)[3], double side);
  // For the balls of a grid that are not in its halo.
  Status build(const CubeGrid &grid);
  const BoundaryLimits &needed() const { return needed_; }

  // Twins on other balls, shells and numbers of components are not there. With a grid, the origin of a component is any
  // ball of it.
  const Boundary &boundary() const { return boundary_; }
  // A ball of the halo is inside others if this one is.
  void take_state(uint32_t ball, uint32_t from) { arrays().ball_state[ball] = arrays().ball_state[from]; }
  // With a grid, after it is built: the balls of the set, where each that was asked for is joined to all that meet it.
  // One inside others is joined to one of these, which whatever meets it meets, too. Each has its representative as
  // parent.
  Span<const uint32_t> join_components(const CubeGrid &grid);
  // Numbers the shells, from the faces that have been joined.
  void take_shells(DisjointSets shells) { number_shells(shells, arrays()); }
  // [loops]
  Span<uint32_t> scratch() { return scratch_; }

 private:
  BoundaryArrays &arrays() { return boundary_.a_; }
  Status finish(const BallSet &balls, uint32_t own, BlockSweep sweep);

  BoundaryLimits limits_, needed_;
  Boundary boundary_;
  Span<BoundaryWorker> worker_;  // one, where its alignment is seen to
  Span<uint32_t> scratch_;
};

}  // namespace hsp
