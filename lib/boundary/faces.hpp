// From loops to faces: which loops of one sphere bound the same free piece.
#pragma once

#include "sphere/caps.hpp"
#include "boundary/boundary.hpp"

namespace hsp {

// Scratch memory for one ball with several loops, for as many caps as a ball may have.
struct FaceScratch {
  Span<uint32_t> cluster;   // caps joined where they touch or overlap
  Span<uint32_t> crossing;  // caps that a meridian crosses
  Span<uint32_t> owner;     // of these, the ones that own a free end point: 4 * cap + free entry + 2 * free exit

  static constexpr uint32_t owner_of(uint32_t cap, bool free_entry, bool free_exit) {
    return 4 * cap + (free_entry ? 1U : 0U) + (free_exit ? 2U : 0U);
  }
  static constexpr uint32_t cap_of_owner(uint32_t owner) { return owner / 4; }
  static constexpr bool has_free_exit(uint32_t owner) { return (owner & 2U) != 0; }

  void carve(Workspace &workspace, uint32_t capacity);
};

// The number of clusters of a ball's caps: the connected components of their union. Leaves them in scratch.cluster.
uint32_t count_clusters(const Caps &caps, const FaceScratch &scratch);

// Gathers the loops of every ball into faces. The caps of a ball are gathered again if it has several loops and their
// clusters were not counted, or if only walks over the sphere can tell which loops belong together.
void gather_faces(const CubeGrid &grid, Caps &caps, FaceScratch &scratch, BoundaryStructure &boundary);

// The general case: several clusters of caps and several faces on one sphere. Joins, in `loops` (indices from the
// ball's first loop), the loops that bound a common face.
void join_loops_by_meridians(const Caps &caps, const FaceScratch &scratch, const BoundaryStructure &boundary,
                             const DisjointSets &loops);

}  // namespace hsp
