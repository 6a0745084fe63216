// From vertices, each decided once, to loops: every vertex starts a half-edge on each of its three balls, and each
// half-edge finds the one that follows it. All functions are for consecutive balls, and write only what belongs to
// them, so that others may do the same for other balls meanwhile.
#pragma once

#include "boundary/boundary.hpp"
#include "core/patience.hpp"
#include "sphere/half_edge_chain.hpp"

namespace hsp {

// Consecutive balls, and where vertices and circles are found that lie on them: no others do.
struct TouchingRecords {
  BallRange balls{0, 0};
  IdRange vertices, circles;
};

// How many half-edges of both kinds there are on some balls.
struct HalfEdgeCounts {
  uint32_t half_edges = 0, closed = 0;
};

// Counts half-edges. Afterwards the first half-edges of both kinds of a ball of the range are those of the next one,
// counted from the first ball of the range.
HalfEdgeCounts count_half_edges(const TouchingRecords &touching, Patience &patience, BoundaryArrays &boundary);

// After counting: makes half-edges, not chained yet, behind so many that lie on the balls before. Afterwards the first
// half-edges of every ball are what they should be.
void distribute_half_edges(const TouchingRecords &touching, HalfEdgeCounts before, Patience &patience,
                           BoundaryArrays &boundary);

// After distributing, also to the ball behind the range: chains half-edges to loops, numbered from `loops` on. Returns
// the number after the last one.
uint32_t link_half_edges(const BallSet &balls, BallRange range, const HalfEdgeChain &chain, uint32_t loops,
                         Patience &patience, BoundaryArrays &boundary);

}  // namespace hsp
