// From vertices, each decided once, to loops: a half-edge starts at every vertex on each of its three balls, and each
// half-edge finds the one that follows it. All functions are for consecutive balls and write only what belongs to
// these, so that other workers may do the same for other balls at the same time.
#pragma once

#include "boundary/boundary.hpp"
#include "core/patience.hpp"
#include "sphere/half_edge_chain.hpp"

namespace hsp {

// Consecutive balls, and ranges of vertices and circles: all that lie on one of the balls are in these ranges.
struct TouchingRecords {
  BallRange balls{0, 0};
  IdRange vertices, circles;
};

// The numbers of half-edges and of closed half-edges on some balls.
struct HalfEdgeCounts {
  uint32_t half_edges = 0, closed = 0;
};

// Counts the half-edges on the balls. Afterwards FirstParts of a ball hold where the half-edges of both kinds of the
// next ball begin, counted from the first ball of the range.
HalfEdgeCounts count_half_edges(const TouchingRecords &touching, Patience &patience, BoundaryArrays &boundary);

// After counting: makes the half-edges, which are not chained yet. before: how many lie on the balls before the range.
// Afterwards FirstParts of every ball hold its own first half-edges.
void distribute_half_edges(const TouchingRecords &touching, HalfEdgeCounts before, Patience &patience,
                           BoundaryArrays &boundary);

// After the half-edges of the range, and of the ball behind it, have been distributed: chains half-edges to loops,
// numbered from `loops` on. Returns the number after the last loop.
uint32_t link_half_edges(const BallSet &balls, BallRange range, const HalfEdgeChain &chain, uint32_t loops,
                         Patience &patience, BoundaryArrays &boundary);

}  // namespace hsp
