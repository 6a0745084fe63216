#include "built_topology.hpp"

#include <algorithm>

BuiltTopology::BuiltTopology(const oracle::Balls &balls) : boundary_(balls) {
  build();
}

// Starts from limits of 0 and takes those that come back, as a caller may.
void BuiltTopology::build() {
  status_ = boundary_.status();
  if (status_ != hsp::Status::ok) return;
  hsp::TopologyLimits limits;
  for (int attempt = 0; attempt < 4; ++attempt) {
    memory_.carve(builder_, limits);
    status_ = builder_.build(grid(), boundary(), boundary_.neighbours());
    if (status_ != hsp::Status::capacity) break;
    const hsp::TopologyLimits &needed = builder_.needed();
    limits.balls = std::max(limits.balls, needed.balls);
    limits.neighbours = std::max(limits.neighbours, needed.neighbours);
    limits.edges = std::max(limits.edges, needed.edges);
    limits.cut_arcs = std::max(limits.cut_arcs, needed.cut_arcs);
    limits.shells = needed.shells;
  }
  structure_ = builder_.structure();
}
