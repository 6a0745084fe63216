// Hidden surface removal for balls and sticks by a drawing order that is known to be right: from the balls, the ends of
// sticks and a direction to paths in the view plane.
//
// Painted are: of a ball its front hemisphere without the caps inside sticks that go away from the viewer; of a
// part of a stick its front between the junction circles, a little longer where what covers it is painted later, so
// that no background shows through the seams of anti-aliased pictures (stick_outlines.hpp). The order is one in which
// whatever covers something comes later (stick_sweep.hpp). Then what is seen is what is painted last:
//   a ball at the farther end comes before the stick. Where both are painted the stick is over it, because the stick's
//     front beyond the junction circle is above the ball's centre and outside the ball.
//   a ball at the nearer end comes after the stick. Where both are painted the ball is over it: where the stick is, the
//     ball's front is inside it, in the cap that is left out.
//   all others are disjoint, so that one of two is over the other wherever they overlap.
// Where balls meet, or bodies cover each other around a circle, there is no such order. Then what is seen of each body
// is found instead, from the same pairs (stick_map_builder.hpp); also where the caller wants that as a map.
#pragma once

#include "maps/stick_map_builder.hpp"
#include "maps/stick_outlines.hpp"
#include "maps/stick_sweep.hpp"
#include "model/ball_set.hpp"

namespace hsp {

// A stick between two balls, by the caller's numbers. Whole: not in two halves, but all of the first ball's.
struct StickEnds {
  uint32_t first, second;
  bool whole;
  StickStrands strands = StickStrands::one;
};

class StickViewBuilder : public Limited<StickLimits> {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // radius: of all sticks of one strand, in lattice steps, positive. as_map: a map also where there is an order.
  // Status::capacity if a limit is too small; needed() then tells what suffices, with 0 for what is not known yet.
  // Status::conflict if it cannot be drawn; violation() tells why. It also tells why there is no drawing order where
  // there is a result without. Status::degenerate if there is none because roundings cannot be overcome,
  // Status::not_finite if a component of the direction is not, Status::stopped if more is not allowed.
  template <class EndsOf>
  Status build(const BallSet &balls, const ViewDirection &direction, uint32_t count, double radius, bool as_map,
               EndsOf ends_of, Patience patience = Patience()) {
    Status status = begin(balls, direction, count);
    for (uint32_t k = 0; k < count && status == Status::ok; ++k) status = add_stick(balls, k, ends_of(k), radius);
    return status == Status::ok ? finish(balls, as_map, patience) : status;
  }

  // Its sticks and centres are a little moved where the map is of moved balls.
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
