// Builds the map of balls and sticks, which needs no drawing order: from the pairs of bodies of which one may cover the
// other to the faces that show each body.
//
// Balls and sticks are convex, so that the properties that a map rests on hold for them: the visible surface is the
// upper envelope of their fronts, only contours hide something, and the circles in which two bodies meet hide nothing
// (lib/sight/maps/THEORY.md). Besides the silhouettes and creases of balls there are the two lines along each stick,
// the half circles at which it leaves its balls, and the one between its halves. Under the conditions of
// stick_sweep.hpp these are all curves: sticks meet nothing else.
//
// Connections are checked as those of a map of balls, except that labels are not trusted. If a check fails the caller
// moves all centres a little.
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

  // Of view only balls, sticks and bites are used. depth [bodies]: faces and paths are sorted by it. Status::capacity
  // if limits.edges is too small; needed_edges() then tells what suffices. Status::check if something does not fit.
  Status build(const StickView &view, Span<const StickPair> pairs, Span<const SweptBox> boxes, Span<const double> depth,
               Patience &patience);
  void set_frame(const ViewFrame &frame, double perturbation) {
    map_.frame = frame;
    map_.perturbation = perturbation;
  }

  const StickMap &structure() const { return map_; }
  // Finds the body at a point of the view plane. boxes: those of build().
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
