// The boundary on some balls of a set alone: half-edges, loops and faces, as class Boundary shows them. The balls
// are the first of the set, and those that meet them are behind them; so each of their vertices is found at one of
// them. Ball by ball there is the same as in the boundary of the whole, whatever the ids are. Nothing is known of the
// others, of shells and components.
#pragma once

#include "boundary/boundary_worker.hpp"

namespace hsp {

class BoundaryPart : public Limited<BoundaryLimits> {
 public:
  // limits: balls of the set, neighbours, and what lies on the balls asked for.
  void carve(Workspace &workspace, const BoundaryLimits &limits);

  // For the first `own` balls, at most 1.5 sides from a centre along each axis; no radius is larger than half a side.
  // Status::capacity if a limit is too small: needed() then reports what suffices.
  Status build(const BallSet &balls, uint32_t own, const double (&centre)[3], double side);

  // Twins on other balls, shells and components are not there.
  const Boundary &boundary() const { return boundary_; }

 private:
  BoundaryArrays &arrays() { return boundary_.a_; }

  Boundary boundary_;
  Span<BoundaryWorker> worker_;  // one, where its alignment is seen to
  Span<uint32_t> scratch_;
};

}  // namespace hsp
