// Finds the visible arcs of all curves of balls and sticks, each curve on its own.
#pragma once

#include "maps/hidden_intervals.hpp"
#include "maps/stick_scene.hpp"
#include "maps/stick_sweep.hpp"

namespace hsp {

class StickArcs {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // pairs: those of StickSweep::find(). Bites are those of the view. balls: those of the scene; `inside` of them is
  // set. False if patience ends.
  bool find(const StickScene &scene, const StickView &view, Span<const StickPair> pairs, Span<SeenBall> balls,
            Patience &patience);

  // The arcs, named as stick_scene.hpp says. Those of a body's contour follow each other, in ascending order of their
  // parameters. The label of an end is a T on the contour of a body; a triple point; or a tangency. A tangency has no
  // body at the natural end of a half circle, a line or a crease; on a silhouette it has the ball or stick that goes
  // into the ball there. A plain end is a mistake.
  Span<const MapArc> arcs() const { return arcs_.items(); }
  // False if rounding has decided whether some curve is seen.
  bool certain() const { return certain_; }
  bool overflowed() const { return arcs_.overflowed() || most_hidden_ > hidden_.capacity(); }
  // A limit of edges that suffices to find these arcs, and for their map.
  uint32_t needed_edges() const { return larger_count(most_edges_of(arcs_, not_found_), most_hidden_); }

 private:
  void mark_inside(Span<SeenBall> balls) const;
  void add_silhouette(uint32_t ball);
  void add_crease(uint32_t ball, uint32_t nearer);
  void add_rings(uint32_t stick);
  void add_top_ring(const StickBite &bite);
  void add_contour(uint32_t body);
  void add_line(uint32_t body, bool left);
  bool is_nearer(uint32_t a, uint32_t b) const {
    const SeenBall &one = scene_.balls[a];
    const SeenBall &two = scene_.balls[b];
    return one.z != two.z ? one.z > two.z : a > b;
  }
  template <class Parts>
  bool hide(Parts &parts, uint32_t body, uint32_t except_ball, uint32_t except_stick, const ArcEnd &at_surface);
  template <class Parts>
  bool hide_by_stick(Parts &parts, uint32_t body, uint32_t except_stick);
  bool hide_by_own_stick(uint32_t body, uint32_t ball);
  void begin_curve();
  template <class Parts>
  void end_curve(const Parts &parts, bool hidden, double from, double to, const ArcEnd &natural, uint32_t body,
                 uint32_t nearer);

  StickScene scene_;
  const StickView *view_ = nullptr;
  FixedVector<MapArc> arcs_;            // [edges]
  FixedVector<HiddenInterval> hidden_;  // [edges]
  BodiesAbove above_;
  Span<uint32_t> asked_;    // [sticks] the last curve for which the stick was looked at
  uint64_t not_found_ = 0;  // so many arcs at most were not found, for lack of room
  uint32_t curve_ = 0;
  uint32_t most_hidden_ = 0;
  bool certain_ = true;
};

}  // namespace hsp
