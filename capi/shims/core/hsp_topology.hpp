// The inside of the handle hsp_topology.
#pragma once

#include "hsp_boundary.hpp"
#include "topology/topology_builder.hpp"

struct hsp_topology : hsp::capi::FromBoundary<hsp::TopologyBuilder> {
  static constexpr auto kind = hsp::capi::HandleKind::topology;
  using Given = hsp_topology_limits;
  using Limits = hsp::capi::LimitFields<hsp::TopologyLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                                        offsetof(Given, edges), offsetof(Given, cut_arcs), offsetof(Given, shells)>;
};
