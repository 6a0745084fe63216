// Step 3 of Section 4.2 over a computed boundary.
#pragma once

#include "topology/regions.hpp"
#include "topology/topology.hpp"

namespace hsp {

// Limits for one boundary, from the numbers of its loops. They suffice unless great circles cross faces unusually
// often. neighbours: as for TopologyBuilder::build.
TopologyLimits limits_for(const BallSet &balls, const Boundary &boundary, uint32_t neighbours);

class TopologyBuilder : public Limited<TopologyLimits> {
 public:
  void carve(Workspace &workspace, const TopologyLimits &limits);

  // neighbours: the largest number of balls that meet one ball of the boundary. Status::capacity if a limit is too
  // small; needed() then reports what suffices, with 0 for numbers that are not known yet. Status::stopped if
  // `patience` allows no more work.
  Status build(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours, Patience patience = Patience());

  const Topology &structure() const { return structure_; }

  // Scratch memory for checks; [edges].
  Span<uint32_t> marks() const { return structure_.marks; }

 private:
  Topology structure_;
  CutArcFinder finder_;
  GatheredBall gathered_;
};

}  // namespace hsp
