// The visible parts of all curves of balls and sticks, each curve on its own.
#pragma once

#include "maps/hidden_intervals.hpp"
#include "maps/stick_scene.hpp"
#include "maps/stick_sweep.hpp"

namespace hsp {

class StickArcs {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // pairs: of all bodies that may cover each other, those of balls that meet both ways. Bites are those of the view.
  // balls: those of the scene; finds which of them lie inside other ones.
  // False if that is stopped.
  bool find(const StickScene &scene, const StickView &view, Span<const StickPair> pairs, Span<SeenBall> balls,
            Patience &patience);

  // Those of a body's contour follow each other, in ascending order of their parameters. They are named as
  // stick_scene.hpp says. An end is a T on the contour of a body; or, as a tangency with no ball, a natural end of a
  // half circle, a line or a crease, or with a ball or stick that goes into the ball of a silhouette there; or a triple
  // point. A plain end is a mistake.
  Span<const MapArc> arcs() const { return arcs_.items(); }
  // False if roundings decided whether some whole curve is seen.
  bool certain() const { return certain_; }
  bool overflowed() const { return arcs_.overflowed() || most_hidden_ > hidden_.capacity(); }
  // No more edges are needed for these arcs and to find them.
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
  Span<uint32_t> asked_;    // [sticks] the last curve for which a stick was asked
  uint64_t not_found_ = 0;  // arcs at most
  uint32_t curve_ = 0;
  uint32_t most_hidden_ = 0;
  bool certain_ = true;
};

}  // namespace hsp
