// A curve between two parameters, and the parts of it that bodies hide, one body after another: those behind their
// fronts.
//
// Where it may change between hidden and not, it passes the contour of what hides it, its surface, or the planes across
// a stick through the centres of its balls. Such breakpoints only cut: whether a part is hidden is asked in its middle.
// Only on a contour something may come to be seen: elsewhere other bodies hide it or what follows finds no partner.
#pragma once

#include <initializer_list>

#include "core/elementary.hpp"
#include "maps/hidden_intervals.hpp"

namespace hsp {

// Calls visit(t) for the two angles in [-pi, pi] where a cos t + b sin t = level: where a circle passes a plane. None
// if it does not reach it, or only touches it.
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

  // False if the curve lies on the front or contour of some body, or enters it between these, so that roundings decide.
  bool certain() const { return certain_; }

 protected:
  // Drops those of the body before.
  void begin_body() { count_ = 0; }
  bool is_open(double t) const { return t > from_ && t < to_; }
  void add(double t, const ArcEnd &end) {
    if (is_open(t) && count_ < most) at_[count_++] = {t, end};
  }

  // Hides what is deeper than 0; depth(a, b) is that in the middle between two parameters, and nearer to 0 than
  // `shallow` it is not certain. True if that is all.
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
  // From now on looks only between what was hidden at both ends. False if nothing was.
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
