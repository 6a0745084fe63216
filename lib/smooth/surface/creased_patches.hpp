// Concave patches with creases: their borders chained to loops, the loops gathered to pieces, these measured and put
// with their corners, which have the same number in all patches that meet there.
#pragma once

#include "surface/concave_patches.hpp"
#include "surface/creases.hpp"
#include "surface/patch_loops.hpp"

namespace hsp {

class CreasedPatches {
 public:
  struct Inputs {
    const ActualBalls &actual;
    const Creases &creases;
    const CuspedCircles &cusped;
    const ProbeGrid &grid;
  };

  // For at most so many creases, and so many arcs around any one patch.
  void carve(Workspace &workspace, uint32_t creases, uint32_t arcs);

  // Status::capacity if there is no room for the arcs of a patch, for which most_arcs() would do, or in the cut
  // patches; Status::degenerate if borders do not close, or no width tells what they bound.
  Status fill(const Inputs &in, CutPatches &cut);

  uint32_t most_arcs() const { return most_arcs_; }

  // The border of the patch of a vertex, in no order; none if no crease is there, or no room.
  Span<BorderArc> find_border(const Inputs &in, uint32_t v);

 private:
  void add_sides(const Inputs &in, uint32_t v);
  void add_creases(const Inputs &in, uint32_t v);
  void push(const Inputs &in, uint32_t across, uint32_t start, uint32_t end, uint32_t crease);
  void store_arc(uint32_t k, CutPatches &cut);
  Status store_patch(const Inputs &in, uint32_t v, CutPatches &cut);
  void measure_piece(const PatchLoops &loops, uint32_t piece, double &steradians, Vec3 &vector_area,
                     CreaseSums &sums) const;
  void number_corners(const Inputs &in, CutPatches &cut);

  FixedVector<BorderArc> arcs_;  // of the patch at hand
  Span<ArcFigures> figures_;     // of these
  Span<uint32_t> crease_;        // [creases] the first of the two arcs of one; then numbers of corners
  uint32_t most_arcs_ = 0;
};

}  // namespace hsp
