// Loops around what is seen of balls and sticks from linked half-edges, their faces, and what proves that they fit
// together.
#pragma once

#include "core/disjoint_sets.hpp"
#include "maps/region_faces.hpp"

namespace hsp {

class RegionLoops {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // Fills loops, those of a body one after the other, and faces. False where something does not fit:
  //   1. half-edges do not chain up to loops;
  //   2. the labels of a loop's edges name two bodies;
  //   3. behind a contour the body that the loop names is not the highest one, or a loop has no labels and nowhere
  //      along it is it certain what is behind;
  //   4. the same beside a short edge, of whatever loop;
  //   5. the numbers contradict Euler's formula;
  //   6. the middle of a body is seen, but the body has no loop;
  //   7. what is seen of a body has no area;
  //   8. a hole lies in no face of its owner.
  // depth [bodies]: loops are in its ascending order.
  bool find(const BodySight &sight, Span<const double> depth, StickRegions &regions);

 private:
  bool trace(uint32_t first, StickRegions &regions);
  bool name_owner(const BodySight &sight, const StickRegions &regions, MapLoop &loop) const;
  static void number_loops(StickRegions &regions);
  bool fits_euler(StickRegions &regions);
  bool middles_have_loops(const BodySight &sight, const StickRegions &regions);

  Span<uint8_t> traced_;   // [2 edges]
  Span<uint8_t> seen_;     // [bodies]
  Span<uint32_t> parent_;  // [edges] of vertices
};

}  // namespace hsp
