// All pairs of balls and parts of sticks of which one may cover the other: which of them has to be painted first, and
// whether they meet where they must not. Bodies that meet in space overlap in the view plane, so that one sweep from
// left to right finds both.
//
// Which body of a pair is over the other: if two disjoint convex bodies overlap in the view plane, the same one is over
// the other wherever they overlap. If one of two disjoint balls covers a part of the other, its centre is nearer. A
// part of a stick is contained in the balls of the stick's radius around points of its axis; these balls are disjoint
// from every other ball and from those of other sticks. So the heights of the axes decide, at the points that appear
// closest to each other. The exception are sticks that end in the same ball: near that ball they may be closer to each
// other. Let u and v be their axes from its centre. They lie on different sides of the plane through the centre across
// u - v, provided that the radius of the ball is at least
//   radius / sin(angle / 2)
// with the radius of the thicker stick. Then the stick whose axis rises more is over the other, if either is.
#pragma once

#include "core/patience.hpp"
#include "core/rows.hpp"
#include "maps/stick_scene.hpp"
#include "maps/stick_view.hpp"

namespace hsp {

// Body `below` has to be painted before `above`. A ball has its id as number, part p of stick k has balls + 2 k + p.
struct StickPair {
  uint32_t below, above;
};

// Of each body the bodies above it, sorted from pairs; those of later pairs come first.
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

  // Finds the pairs of the balls and sticks of a view, some of them more than once. The pairs contain each stick with
  // its two balls, and its parts with each other; balls that meet are in two pairs, one each way. caller: the caller's
  // numbers of balls. The first conflict found ends the sweep; balls that meet are no conflict.
  StickViolation find(const StickView &view, Span<const uint32_t> caller, FixedVector<StickPair> &pairs,
                      Patience &patience);

  // The first two balls found that meet. They have no drawing order, so that there is none for the picture.
  const StickViolation &meeting() const { return meeting_; }
  // The boxes of all balls and parts, sorted by their left sides.
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

// Finds the ball or stick that is seen at a point of the view plane, from the boxes around them.
class BodySight {
 public:
  // items: sorted by their left sides. Balls inside others do not count.
  BodySight(const StickScene &scene, Span<const SweptBox> items);

  // The body with the highest front at a point. Left out are `except` and, if that is a part of a stick, the other
  // part. Certain unless the point is close to a contour, or two fronts are close to each other.
  HighestBody highest_at(double x, double y, uint32_t except) const;

 private:
  // The height of a body's front at a point, if it has one there.
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

// An order of bodies in which each follows all bodies that it covers parts of. There may be none: sticks can lie over
// each other around a circle.
class DrawingOrder {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // Sorts bodies. Of those that may come next the one with the smallest depth does; of equal ones the first. depth: by
  // body. Writes into `order` all bodies that have a rank, and returns their number. The others lie over each other in
  // cycles, or over bodies of a cycle. O((n + pairs) log n).
  uint32_t sort(Span<const StickPair> pairs, Span<const double> depth, Span<uint32_t> order);

  // A cycle, found if sort() has left bodies without a rank: its body with the largest number, and how many it has.
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
