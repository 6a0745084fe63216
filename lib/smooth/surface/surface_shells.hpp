// The connected components of the smooth surface. They are not those of the boundary: probes on both sides of a thin
// wall join two outsides, cusps may part what the boundary joins.
//
// Two convex patches are joined by a whole saddle patch between them. A piece of a cut patch is joined to the convex
// patches at its corners, and to the pieces across its creases. Nothing else joins anything: a part of a saddle with
// cusps adjoins one convex patch, whole concave patches lie between whole saddles.
#pragma once

#include "core/disjoint_sets.hpp"
#include "surface/patch_corners.hpp"

namespace hsp {

class SurfaceShells {
 public:
  // Memory for all faces and pieces of cut patches.
  void use(Span<uint32_t> memory) { shell_ = memory; }
  // Incomplete if `patience` stops it.
  void find(const Boundary &boundary, const CuspedCircles &cusped, const CutPatches &cut, Patience &patience);

  uint32_t count() const { return count_; }
  uint32_t of_face(uint32_t face) const { return shell_[face]; }
  uint32_t of_piece(uint32_t piece) const { return shell_[faces_ + piece]; }

 private:
  void join_saddles(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience, DisjointSets &sets);
  void join_pieces(const Boundary &boundary, const CutPatches &cut, Patience &patience, DisjointSets &sets);

  Span<uint32_t> shell_;  // [faces + pieces]
  uint32_t faces_ = 0;
  uint32_t count_ = 0;
};

}  // namespace hsp
