// The visible part of balls and sticks without a drawing order, exactly: from the pairs of which one may cover the
// other to the faces that show each.
//
// Balls and sticks are convex, so that what the visibility map rests on holds for them as well: the surface that is
// seen is the upper envelope of their fronts, only contours hide something, and the circles where two of them meet hide
// nothing (lib/sight/maps/THEORY.md). Besides the silhouettes and creases of balls there are the two lines along
// each stick, and the half circles where it leaves its balls. Under the conditions of stick_sweep.hpp these are all:
// nothing else of sticks meets anything.
//
// Its connections are checked as of a map of balls, with the difference that labels are not trusted. Where that
// fails the caller moves all centres a little.
#pragma once

#include "maps/map_faces.hpp"
#include "maps/map_linker.hpp"
#include "maps/stick_arcs.hpp"
#include "maps/stick_scene.hpp"
#include "maps/stick_sweep.hpp"

namespace hsp {

class StickMapBuilder {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);
  void clear() { map_.clear(); }

  // view: balls, sticks and bites. depth [bodies]: faces and paths are sorted by it. Status::capacity if limits.edges
  // is too small; needed_edges() then tells what suffices. Status::check if something does not fit.
  Status build(const StickView &view, Span<const StickPair> pairs, Span<const SweptBox> boxes, Span<const double> depth,
               Patience &patience);
  void set_frame(const ViewFrame &frame, double perturbation) {
    map_.frame = frame;
    map_.perturbation = perturbation;
  }

  const StickMap &structure() const { return map_; }
  // For points of the view plane. boxes: as for build.
  BodySight sight(Span<const SweptBox> boxes) const { return {map_.scene, boxes}; }
  // Scratch memory for checks; [2 edges + 1].
  Span<uint32_t> scratch() { return faces_.scratch(); }
  uint32_t needed_edges() const { return arcs_.needed_edges(); }

 private:
  StickMap map_;
  StickArcs arcs_;
  MapLinker<StickScene> linker_;
  MapFaceFinder<StickScene> faces_;
  Span<SeenBall> balls_;  // [balls]
  Span<uint32_t> order_;  // [bodies]
  uint32_t edges_ = 0;    // the limit
};

}  // namespace hsp
