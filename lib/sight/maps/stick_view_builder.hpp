// Hidden surface removal for balls and sticks by a drawing order that is known to be right: from the balls, the ends of
// sticks and a direction to paths in the view plane.
//
// Of a ball its front hemisphere is painted, without the caps inside sticks that go away from the viewer. Of a part of
// a stick its front between the junction circles is painted, and a little more under bodies painted later, so that no
// background shows through the seams of anti-aliased pictures (stick_outlines.hpp). In the drawing order a body that
// covers another one comes later (stick_sweep.hpp). Then the body painted last at a point is the one seen there:
//   the ball at the farther end comes before the stick. At points of both the stick is over the ball, because the
//     stick's front beyond the junction circle is above the ball's centre and outside the ball.
//   the ball at the nearer end comes after the stick. At points of both the ball is over the stick: the part of the
//     ball's front that is inside the stick is the cap, which is not painted.
//   any other two bodies are disjoint, so that the same one is over the other wherever they overlap.
// If balls meet, or bodies cover each other around a circle, there is no such order. Then the visible part of each body
// is found from the same pairs (stick_map_builder.hpp); also if the caller wants a map.
#pragma once

#include "maps/stick_map_builder.hpp"
#include "maps/stick_outlines.hpp"
#include "maps/stick_sweep.hpp"
#include "model/ball_set.hpp"

namespace hsp {

// A stick between two balls, by the caller's numbers. whole: the stick has no halves, and belongs to the first ball.
struct StickEnds {
  uint32_t first, second;
  bool whole;
  StickStrands strands = StickStrands::one;
};

class StickViewBuilder : public Limited<StickLimits> {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // radius: that of all sticks of one strand, in lattice steps, positive. as_map: build a map also if there is a
  // drawing order. Status::capacity if a limit is too small; needed() then tells what suffices, with 0 for what is not
  // known yet. Status::conflict if the scene cannot be drawn; violation() tells why. After a success without a drawing
  // order it tells why there is none. Status::degenerate if no move of the balls gives a map, Status::not_finite if a
  // component of the direction is not finite, Status::stopped if patience has ended.
  template <class EndsOf>
  Status build(const BallSet &balls, const ViewDirection &direction, uint32_t count, double radius, bool as_map,
               EndsOf ends_of, Patience patience = Patience()) {
    Status status = begin(balls, direction, count);
    for (uint32_t k = 0; k < count && status == Status::ok; ++k) status = add_stick(balls, k, ends_of(k), radius);
    return status == Status::ok ? finish(balls, as_map, patience) : status;
  }

  // The view. Its sticks and centres are moved a little if the map is one of moved balls.
  const StickView &structure() const { return view_; }
  const StickMap &map() const { return map_.structure(); }
  PaintedPaths paths() const { return map().exist ? paths_of(map()) : paths_of(view_); }
  const StickViolation &violation() const { return violation_; }
  // The body that the map shows at a point.
  BodySight sight() const { return map_.sight(sweep_.boxes()); }
  // Scratch memory for writers of pictures, [balls + 2 sticks], and for checks of the map, [2 edges + 1].
  Span<uint32_t> scratch() { return order_; }
  Span<uint32_t> more_scratch() { return map_.scratch(); }

 private:
  Status begin(const BallSet &balls, const ViewDirection &direction, uint32_t count);
  Status add_stick(const BallSet &balls, uint32_t k, const StickEnds &ends, double radius);
  Status finish(const BallSet &balls, bool as_map, Patience &patience);
  Status find_pairs(const BallSet &balls, Patience &patience);
  Status find_map(const BallSet &balls, Patience &patience);
  Status find_moved_map(const BallSet &balls, const Perturbation &perturbation, Patience &patience);
  Status refuse(StickConflict conflict, uint32_t first, uint32_t second);
  Stick make_stick(uint32_t one, uint32_t other, double radius, uint32_t caller, bool whole) const;
  void move(const BallSet &balls, const Perturbation &perturbation);
  void find_depths();
  void find_bites();
  void add_paths(uint32_t bodies);
  StickPath path_of(uint32_t body) const;

  StickViolation violation_;
  StickView view_;
  StickSweep sweep_;
  DrawingOrder sorter_;
  StickMapBuilder map_;
  FixedVector<StickPair> pairs_;
  Span<uint32_t> grid_of_;  // [balls] by the caller's numbers
  Span<double> depth_;      // [balls + 2 sticks]
  Span<uint32_t> order_;    // [balls + 2 sticks]
  uint32_t balls_ = 0;
};

}  // namespace hsp
