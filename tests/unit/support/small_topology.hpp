// A few balls with their topology in memory of fixed size.
#pragma once

#include "small_scenes.hpp"
#include "topology/topology_builder.hpp"

namespace cases {

// Over small_union(), which it builds anew.
class SmallTopology {
 public:
  // False if something does not fit or fails.
  bool build(const SmallBall *balls, uint32_t n) {
    if (!small_union().build(balls, n)) return false;
    const hsp::TopologyLimits limits{n, SmallUnion::most_balls, 120, 30, 0};
    hsp::Workspace measured;
    builder_.carve(measured, limits);
    if (measured.bytes() > sizeof memory_) return false;
    hsp::Workspace workspace(memory_, sizeof memory_);
    builder_.carve(workspace, limits);
    if (builder_.build(grid(), boundary(), n) != hsp::Status::ok) return false;
    topology_ = builder_.structure();
    return true;
  }

  const hsp::CubeGrid &grid() const { return small_union().grid(); }
  const hsp::BallSet &balls() const { return small_union().balls(); }
  const hsp::Boundary &boundary() const { return small_union().boundary(); }
  // The arrays are those of the topology; the numbers beside them are a copy, to be changed at will.
  hsp::Topology &topology() { return topology_; }
  hsp::Span<uint32_t> marks() const { return builder_.marks(); }

 private:
  hsp::TopologyBuilder builder_;
  hsp::Topology topology_;
  alignas(64) unsigned char memory_[32 * 1024];
};

// One for all cases, as it is large for a stack.
inline SmallTopology &small_topology() {
  static SmallTopology one;
  return one;
}

}  // namespace cases
