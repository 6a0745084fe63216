// The boundary on the first balls of a set alone: half-edges, loops and faces, as class Boundary has them. The set
// contains behind them all balls that meet them, so that each of their vertices is found. On each ball there is the
// same as in the boundary of the whole set, whatever the ids are. Nothing is known of the other balls, of shells and
// components.
#pragma once

#include "boundary/boundary_worker.hpp"

namespace hsp {

class BoundaryPart : public Limited<BoundaryLimits> {
 public:
  // limits: the balls of the set and their neighbours; all else for the first balls alone.
  void carve(Workspace &workspace, const BoundaryLimits &limits);

  // Computes the boundary on the first `own` balls. They are at most 1.5 sides from a centre along each axis; no radius
  // is larger than half a side. Status::capacity if a limit is too small: needed() then reports what suffices.
  Status build(const BallSet &balls, uint32_t own, const double (&centre)[3], double side);

  // Twins on other balls, shells and components are not there.
  const Boundary &boundary() const { return boundary_; }

 private:
  BoundaryArrays &arrays() { return boundary_.a_; }

  Boundary boundary_;
  Span<BoundaryWorker> worker_;  // one, in the workspace, which aligns it
  Span<uint32_t> scratch_;
};

}  // namespace hsp
