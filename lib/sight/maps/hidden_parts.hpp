// A curve between two parameters, and the parts of it that bodies hide, one body after another: those behind the front
// of a body.
//
// The curve changes between hidden and visible only at breakpoints: where it passes the contour of the body, its
// surface, or a plane across a stick through the centre of one of its balls. Breakpoints only cut: whether a part is
// hidden is decided in its middle. Only at a contour a part may become visible. At any other breakpoint another body
// hides the curve, or linking the arc's end finds no partner.
#pragma once

#include <initializer_list>

#include "core/elementary.hpp"
#include "maps/hidden_intervals.hpp"

namespace hsp {

// Calls visit(t) for the two angles t in [-pi, pi] with a cos t + b sin t = level, at which a circle passes a plane.
// Never, if the circle does not reach the plane or only touches it.
template <class Visit>
void visit_level(double a, double b, double level, Visit visit) {
  const double squared = a * a + b * b;
  if (!(level * level < squared)) return;
  const double middle = arc_tangent(b, a);
  const double half = arc_tangent(std::sqrt(squared - level * level), level);
  for (const double t : {middle - half, middle + half}) visit(t > pi ? t - 2 * pi : t < -pi ? t + 2 * pi : t);
}

class HiddenParts {
 public:
  HiddenParts(double from, double to, FixedVector<HiddenInterval> &hidden) : from_(from), to_(to), hidden_(hidden) {}

  // False if rounding decides: the curve lies on the front or the contour of some body, or enters it between both.
  bool certain() const { return certain_; }

 protected:
  // Drops the breakpoints of the body before.
  void begin_body() { count_ = 0; }
  bool is_open(double t) const { return t > from_ && t < to_; }
  void add(double t, const ArcEnd &end) {
    if (is_open(t) && count_ < most) at_[count_++] = {t, end};
  }

  // Hides the parts that are behind the body. depth(a, b): how deep the curve is behind it in the middle between the
  // parameters a and b; a depth nearer to 0 than `shallow` is not certain. True if the whole curve is hidden.
  template <class Depth>
  bool cut(double shallow, Depth depth) {
    sort_breakpoints({at_, count_});
    bool all = false;
    rest_[0] = from_;
    rest_[1] = to_;
    const auto hide = [&](const HiddenInterval &part) {
      all = part.from == from_ && part.to == to_;
      if (all) return;
      hidden_.push(part);
      if (part.from == from_) rest_[0] = part.to;
      if (part.to == to_) rest_[1] = part.from;
    };
    if (!visit_hidden({at_, count_}, from_, to_, shallow, depth, hide)) certain_ = false;
    return all;
  }
  // From now on looks only at what the last body has left, if it has hidden a part at one end or both. False if it has
  // not.
  bool narrow() {
    const bool narrower = rest_[0] != from_ || rest_[1] != to_;
    from_ = rest_[0];
    to_ = rest_[1];
    return narrower;
  }

  static constexpr uint32_t most = 48;
  double from_, to_;
  Breakpoint at_[most];
  uint32_t count_ = 0;
  bool certain_ = true;
  FixedVector<HiddenInterval> &hidden_;

 private:
  double rest_[2]{};
};

}  // namespace hsp
