// The inside of the handle hsp_topology.
#pragma once

#include "hsp_boundary.hpp"
#include "topology/topology_builder.hpp"

struct hsp_topology {
  using Builder = hsp::TopologyBuilder;
  static constexpr auto kind = hsp::capi::HandleKind::topology;
  using Given = hsp_topology_limits;
  using Limits = hsp::capi::LimitFields<hsp::TopologyLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                                        offsetof(Given, edges), offsetof(Given, cut_arcs), offsetof(Given, shells)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_boundary> boundary{};
  bool complete = false;

  // Whether results may be read: computed, and neither the boundary nor the model has changed since.
  bool has_results() const { return complete && boundary.is_unchanged(); }
  const hsp::Topology &structure() const { return builder.structure(); }
  const hsp::BallSet &balls() const { return boundary->balls(); }
};
