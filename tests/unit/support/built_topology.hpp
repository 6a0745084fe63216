// A topology with its inner records open, for tests that look at the records or break them.
#pragma once

#include "built_boundary.hpp"
#include "topology/topology_builder.hpp"

class BuiltTopology {
 public:
  explicit BuiltTopology(const oracle::Balls &balls);

  const hsp::CubeGrid &grid() const { return boundary_.grid(); }
  const hsp::BallSet &balls() const { return boundary_.balls(); }
  uint32_t grid_index(uint32_t caller) const { return boundary_.grid_index(caller); }
  const hsp::Boundary &boundary() const { return boundary_.boundary(); }
  hsp::BoundaryArrays &boundary_arrays() { return boundary_.arrays(); }
  // The arrays are those of the topology itself; the counts in the struct are a copy, which tests may change.
  hsp::Topology &structure() { return structure_; }
  const hsp::TopologyBuilder &builder() const { return builder_; }
  hsp::Span<uint32_t> marks() const { return builder_.marks(); }
  // In the same memory, as far as it is allowed.
  hsp::Status build_again(hsp::Patience patience) {
    return builder_.build(grid(), boundary(), boundary_.neighbours(), patience);
  }
  // Not ok if the boundary or the topology failed.
  hsp::Status status() const { return status_; }

 private:
  void build();

  BuiltBoundary boundary_;
  CarvedMemory memory_;
  hsp::TopologyBuilder builder_;
  hsp::Topology structure_;
  hsp::Status status_ = hsp::Status::ok;
};
