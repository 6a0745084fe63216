// The widest probe between two points as paths/widest_probe.hpp finds it, by cells of balls that grow; the search
// begins beside the answer of all pores, which takes as long as a few such steps. So the result is the same, bit for
// bit, and is decided by the cells. Where pores have no room in the limits that suffice for most sets, or on the
// lattice, the search goes without them.
#pragma once

#include "paths/widest_probe.hpp"
#include "pockets/class_tree.hpp"

namespace hsp {

class GateFinder {
 public:
  void carve(Workspace &workspace, const ProbeLimits &limits);
  // As WidestProbeFinder::find, of the balls of a grid.
  Status find(const CubeGrid &grid, const exact::Vector &from, const exact::Vector *to, WidestProbe &widest);

  const ProbeLimits &needed() const { return probes_.needed(); }
  ProbeLimits retry_limits() const { return probes_.retry_limits(); }
  uint32_t builds() const { return probes_.builds(); }

 private:
  double guess(const CubeGrid &grid, const exact::Vector &from, const exact::Vector *to);

  WidestProbeFinder probes_;
  Span<PoresBuilder> pores_;  // [1], as handles are made on the stack
};

}  // namespace hsp
