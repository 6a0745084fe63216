// All pairs of balls and parts of sticks of which one may cover the other: what has to be painted first, and whether
// they meet, or do so where they must not. Bodies that meet in space overlap in the view plane, so that one sweep from
// left to right finds both.
//
// Which one is over the other: two disjoint convex bodies that appear over each other do so in one way, wherever they
// overlap. A part of a stick is contained in the balls of the stick's radius around its axis, which are disjoint from
// every other ball and from those of other sticks. So the heights at those points of the axes decide that appear
// closest to each other: two disjoint balls of which one covers a part of the other have the order of their centres.
// Only sticks that end in one ball, with axes u and v from there, may be closer to each other than that near the ball.
// They lie on either side of the plane through its centre across u - v, provided that the ball is at least
//   radius / sin(angle / 2)
// thick, with the radius of the thicker one; then the one whose axis rises more is over the other one, if either is.
// Two balls that are disjoint have the order of their centres, too.
#pragma once

#include "core/patience.hpp"
#include "core/rows.hpp"
#include "maps/stick_scene.hpp"
#include "maps/stick_view.hpp"

namespace hsp {

// Paint `below` first. Balls by their ids; part p of stick k is balls + 2 k + p.
struct StickPair {
  uint32_t below, above;
};

// The bodies above each of some, from pairs, those of later pairs first.
class BodiesAbove {
 public:
  void carve(Workspace &workspace, const StickLimits &limits) {
    first_ = workspace.take<uint32_t>(limits.balls + 2 * static_cast<uint64_t>(limits.sticks) + 1);
    above_ = workspace.take<uint32_t>(limits.pairs);
  }
  void sort(Span<const StickPair> pairs, uint32_t bodies) {
    const uint32_t last = pairs.size() - 1;
    sort_to_rows(
        first_, bodies, pairs.size(), [&](uint32_t k) { return pairs[last - k].below; },
        [&](uint32_t at, uint32_t k) { above_[at] = pairs[last - k].above; });
  }
  Span<const uint32_t> of(uint32_t body) const { return above_.part(first_[body], first_[body + 1]); }

 private:
  Span<uint32_t> first_;  // [bodies + 1]
  Span<uint32_t> above_;  // [pairs]
};

// The box of a body in the view plane.
struct SweptBox {
  double left, right, bottom, top;
  uint32_t body;
};

class StickSweep {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // Finds the pairs of the balls and sticks of a view, some more than once. Those of a stick with its two balls and
  // its parts with each other are among them, those of balls that meet both ways. caller: the caller's numbers of
  // balls. The first conflict that is found ends the sweep; that balls meet is none.
  StickViolation find(const StickView &view, Span<const uint32_t> caller, FixedVector<StickPair> &pairs,
                      Patience &patience);

  // The first balls found that meet. They have no order, and sticks with them none that holds for pictures.
  const StickViolation &meeting() const { return meeting_; }
  // Of all balls and parts, sorted by their left sides.
  Span<const SweptBox> boxes() const { return items_.items(); }

 private:
  void add_items();
  void compare(uint32_t a, uint32_t b);
  void compare_balls(uint32_t a, uint32_t b);
  void compare_ball_and_part(uint32_t ball, uint32_t body);
  void compare_parts(uint32_t a, uint32_t b);
  void add(bool second_is_above, uint32_t a, uint32_t b);
  void refuse(StickConflict conflict, uint32_t first, uint32_t second);

  const Stick &stick_of(uint32_t body) const { return view_->sticks[(body - balls_) / 2]; }
  uint32_t part_of(uint32_t body) const { return (body - balls_) % 2; }

  FixedVector<SweptBox> items_;
  const StickView *view_ = nullptr;
  Span<const uint32_t> caller_;
  FixedVector<StickPair> *pairs_ = nullptr;
  uint32_t balls_ = 0;
  StickViolation violation_;
  StickViolation meeting_;
};

// Which ball or stick is seen at a point of the view plane, from the boxes around them.
class BodySight {
 public:
  // items: sorted by their left sides. Balls inside others do not count.
  BodySight(const StickScene &scene, Span<const SweptBox> items);

  // The body with the highest front besides `except` and, if that is a part of a stick, the other part; no_id if there
  // is none. Certain unless the point is close to a contour, or two fronts are close to each other.
  struct Highest {
    uint32_t body;
    bool certain;
  };
  Highest highest_at(double x, double y, uint32_t except) const;

 private:
  // The height of a body's front, if it is there.
  struct Front {
    bool exists, certain;
    double z;
  };
  Front front_at(uint32_t body, double x, double y) const;

  const StickScene &scene_;
  Span<const SweptBox> items_;
  double widest_ = 0.0;
  double largest_ = 0.0;  // radius
};

// Bodies in an order in which each follows all those that it covers parts of. There may be none: sticks can lie one
// over the other around a circle.
class DrawingOrder {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // Of the bodies that may come next always the one with the smallest depth; of equal ones the first. depth: by body.
  // Writes as many bodies into `order` as have a rank, and returns their number; the others lie over each other in
  // cycles, or over such. O((n + pairs) log n).
  uint32_t sort(Span<const StickPair> pairs, Span<const double> depth, Span<uint32_t> order);

  // A cycle, if the last order had no rank for some bodies: the last of its bodies, and how many it has.
  struct Cycle {
    uint32_t last, length;
  };
  Cycle find_cycle(Span<const StickPair> pairs, uint32_t bodies);

 private:
  BodiesAbove above_;
  Span<uint32_t> waiting_;  // [bodies] pairs whose lower body has no rank yet
  Span<uint32_t> heap_;     // [bodies]
};

}  // namespace hsp
