// What is behind the handle hsp_topology.
#pragma once

#include "hsp_boundary.hpp"
#include "topology/topology_builder.hpp"

struct hsp_topology {
  using Builder = hsp::TopologyBuilder;
  static constexpr uint64_t kind = 0x746F706F6C6F6779;  // "topology" in ASCII

  uintptr_t tag;
  Builder builder;
  const hsp_boundary *boundary = nullptr;  // what was computed last
  uint64_t computed = 0;
  bool complete = false;

  // Whether results may be read: computed, and neither the boundary nor the model has changed since.
  bool has_results() const {
    return complete && hsp::capi::is_live(boundary) && computed == boundary->computed && boundary->has_results();
  }
  const hsp::Topology &structure() const { return builder.structure(); }
  // The same with its shells scanned.
  const hsp::Topology &scanned() { return builder.scanned(boundary->structure()); }
  const hsp::BallSet &balls() const { return boundary->balls(); }
};
