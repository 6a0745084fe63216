// What is behind the handle hsp_topology.
#pragma once

#include "hsp_boundary.hpp"
#include "topology/topology_builder.hpp"

struct hsp_topology {
  using Builder = hsp::TopologyBuilder;

  Builder builder;
  const hsp_boundary *boundary = nullptr;  // what was computed last
  uint64_t computed = 0;
  bool attempted = false;
  bool complete = false;

  // Whether results may be read: computed, and neither the boundary nor the model has changed since.
  bool has_results() const { return complete && computed == boundary->computed && boundary->has_results(); }
  const hsp::Topology &structure() const { return builder.structure(); }
  const hsp::BallSet &balls() const { return boundary->balls(); }
};
