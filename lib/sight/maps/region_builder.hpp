// What is seen of balls and sticks without a drawing order, exactly: from the pairs of which one may cover the other to
// the faces that show each.
//
// Balls and sticks are convex, so that what the visibility map rests on holds for them as well: the surface that is
// seen is the upper envelope of their fronts, only contours hide something, and the circles where two of them meet hide
// nothing (lib/sight/maps/THEORY.md). Besides the silhouettes and creases of balls there are the two lines along
// each stick, and the half circles where it leaves its balls. Under the conditions of stick_sweep.hpp these are all:
// nothing else of sticks meets anything.
//
// Like a map it rests on floating-point roots, and what holds it together is checked: every end finds its partners,
// every T its contour (region_linker.hpp), and then what region_loops.hpp lists. Where that fails all centres are moved
// a little by whoever calls this.
#pragma once

#include "maps/region_arcs.hpp"
#include "maps/region_linker.hpp"
#include "maps/region_loops.hpp"

namespace hsp {

class RegionBuilder {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);
  void clear() { regions_.clear(); }

  // view: balls, sticks and bites. depth [bodies]: of paths, which are sorted by it. Status::capacity if limits.edges
  // is too small; needed_edges() then tells what suffices. Status::check if something does not fit.
  Status build(const StickView &view, Span<const StickPair> pairs, Span<const SweptBox> boxes,
               Span<const double> depth);
  void set_frame(const ViewFrame &frame, double perturbation) {
    regions_.frame = frame;
    regions_.perturbation = perturbation;
  }

  const StickRegions &structure() const { return regions_; }
  // For points of the view plane. boxes: as for build.
  BodySight sight(Span<const SweptBox> boxes) const { return {regions_.scene, boxes, arcs_.inside()}; }
  // Scratch memory for checks; [2 edges].
  Span<uint32_t> scratch() { return linker_.scratch(); }
  uint32_t needed_edges() const { return arcs_.needed_edges(); }

 private:
  void add_paths();

  StickRegions regions_;
  RegionArcs arcs_;
  RegionLinker linker_;
  RegionLoops loops_;
  Span<SeenBall> balls_;  // [balls]
  uint32_t edges_ = 0;    // the limit
};

}  // namespace hsp
