#include "surface/patch_loops.hpp"

#include "surface/arc_places.hpp"

namespace hsp {
namespace {

// Takes signs, and remembers whether all of them so far were certain.
class CertainSigns {
 public:
  template <class Number>
  bool positive(const Number &number) {
    const int sign = number.sign();
    if (sign == 0) all_ = false;
    return sign > 0;
  }
  bool all() const { return all_; }
  void fail() { all_ = false; }

 private:
  bool all_ = true;
};

template <class Number>
[[gnu::noinline]] void to_unit(const ActualPoints<Number> &actual, NumberVector<Number> &a) {
  a *= actual.number(1) / square_root(dot(a, a));
}
template <class Number>
[[gnu::noinline]] void to_point_of_arc(const ActualPoints<Number> &actual, const BorderArc &arc,
                                       ArcPlace<Number> &place, NumberVector<Number> &point) {
  const Number radius = square_root(actual.probe_weight() - dot(place.middle, place.middle));
  if (arc.is_whole()) {
    actual.find_across(place.axis, axis_least_along(to_double(place.axis)), point);
  } else {
    place.end -= place.start;
    point = cross(place.end, place.axis);
    to_unit(actual, point);
    place.end *= actual.number(307 / (1 + static_cast<int64_t>(arc.loop)) + 3).scaled(-11) / radius;
    point += place.end;
  }
  to_unit(actual, point);
  point *= radius;
  point += place.middle;
}
// A point of an arc. It is not quite in the middle, as the middles of several arcs may lie in one plane.
template <class Number>
[[gnu::noinline]] void find_point_of_arc(const ActualPoints<Number> &actual, uint32_t vertex, const BorderArc &arc,
                                         NumberVector<Number> &point) {
  ArcPlace<Number> place;
  find_place(actual, vertex, arc, place);
  to_point_of_arc(actual, arc, place, point);
}

// Whether the great circle's piece between two points crosses an arc an odd number of times. If one of the two points
// is on the arc's circle (`own`), that crossing does not count.
template <class Number>
class Crossings {
 public:
  Crossings(const ActualPoints<Number> &actual, const NumberVector<Number> &from, const NumberVector<Number> &to,
            CertainSigns &signs)
      : actual_(actual), from_(from), to_(to), signs_(signs) {}

  [[gnu::noinline]] bool odd(uint32_t vertex, const BorderArc &arc, const NumberVector<Number> *own) {
    ArcPlace<Number> place;
    find_place(actual_, vertex, arc, place);
    return odd(place, arc.is_whole(), own);
  }

 private:
  [[gnu::noinline]] bool odd(const ArcPlace<Number> &arc, bool is_whole, const NumberVector<Number> *own) {
    NumberVector<Number> great = cross(from_, to_), n = cross(arc.axis, great);
    const Number square = dot(n, n);
    NumberVector<Number> foot = cross(great, n);
    foot *= dot(arc.axis, arc.middle) / square;
    const Number left = (actual_.probe_weight() - dot(foot, foot)) / square;
    if (own == nullptr && !signs_.positive(left)) return false;
    n *= square_root(left);
    bool odd = false;
    uint32_t seen = 0;
    for (int turn = 0; turn < 2; ++turn) {
      // The foot plus n, and minus n.
      foot += n;
      if (turn == 0) {
        n *= actual_.number(-2);
      }
      if (own != nullptr && is_same(foot, *own)) continue;
      ++seen;
      if (signs_.positive(determinant(great, from_, foot)) && signs_.positive(determinant(great, foot, to_)) &&
          (is_whole || is_on(arc, foot))) {
        odd = !odd;
      }
    }
    if (own != nullptr && seen != 1) signs_.fail();
    return odd;
  }

  // Of the two points where the circles cross, one is the given point, and the other certainly is not.
  [[gnu::noinline]] static bool is_same(const NumberVector<Number> &a, const NumberVector<Number> &b) {
    NumberVector<Number> apart = a;
    apart -= b;
    return dot(apart, apart).sign() == 0;
  }
  [[gnu::noinline]] bool is_on(const ArcPlace<Number> &arc, const NumberVector<Number> &x) {
    NumberVector<Number> at = x;
    at -= arc.middle;
    if (signs_.positive(determinant(arc.axis, arc.start, arc.end))) {
      return signs_.positive(determinant(arc.axis, arc.start, at)) &&
             signs_.positive(determinant(arc.axis, at, arc.end));
    }
    return !(signs_.positive(determinant(arc.axis, arc.end, at)) &&
             signs_.positive(determinant(arc.axis, at, arc.start)));
  }

  const ActualPoints<Number> &actual_;
  const NumberVector<Number> &from_, &to_;
  CertainSigns &signs_;
};

// Whether the way from x to y begins on the patch's side of an arc that x lies on.
template <class Number>
[[gnu::noinline]] bool begins_inside(const ActualPoints<Number> &actual, uint32_t vertex, uint32_t across,
                                     const NumberVector<Number> &x, const NumberVector<Number> &y,
                                     CertainSigns &signs) {
  NumberVector<Number> axis, way = cross(x, y);
  find_axis(actual, vertex, across, axis);
  way = cross(way, x);
  return !signs.positive(dot(axis, way));
}

// Two loops bound one piece iff no other loop separates them. A way from one to the other crosses every other loop an
// even number of times then; for the two loops themselves it counts also on which side the way begins and ends.
template <class Number>
bool group_in(const ActualPoints<Number> &actual, uint32_t vertex, Span<BorderArc> arcs) {
  CertainSigns signs;
  const uint32_t n = arcs.size();
  const auto is_loop = [&](uint32_t k) { return arcs[k].loop == k; };
  for (uint32_t k = 0; k < n; ++k) arcs[k].piece = arcs[k].loop;
  for (uint32_t a = 0; a < n; ++a) {
    if (!is_loop(a)) continue;
    for (uint32_t b = a + 1; b < n; ++b) {
      if (!is_loop(b) || arcs[a].piece == arcs[b].piece) continue;
      uint32_t on_b = b;
      while (arcs[on_b].across == arcs[a].across && arcs[on_b].next != b) on_b = arcs[on_b].next;
      NumberVector<Number> from, to;
      find_point_of_arc(actual, vertex, arcs[a], from);
      find_point_of_arc(actual, vertex, arcs[on_b], to);
      const bool inside_a = begins_inside(actual, vertex, arcs[a].across, from, to, signs);
      const bool inside_b = begins_inside(actual, vertex, arcs[on_b].across, to, from, signs);
      Crossings<Number> crossings(actual, from, to, signs);
      bool same = true;
      for (uint32_t c = 0; c < n && same && signs.all(); ++c) {
        if (!is_loop(c)) continue;
        bool odd = false;
        for_each_of_loop(arcs, c, [&](uint32_t k) {
          const bool starts = arcs[k].across == arcs[a].across, ends = arcs[k].across == arcs[on_b].across;
          // If the arc's circle is a great circle, its other crossing is the opposite point, which is not on the way.
          if (!((starts || ends) && arcs[k].is_side())) {
            odd = odd != crossings.odd(vertex, arcs[k], starts ? &from : ends ? &to : nullptr);
          }
        });
        same = c == a ? inside_a != odd : c == b ? inside_b != odd : !odd;
      }
      if (!signs.all()) return false;
      if (!same) continue;
      const uint32_t old = arcs[b].piece, kept = arcs[a].piece;
      for (BorderArc &arc : arcs) {
        if (arc.piece == old) arc.piece = kept;
      }
    }
  }
  return true;
}

}  // namespace

bool PatchLoops::chain() {
  const uint32_t n = arcs_.size();
  for (BorderArc &arc : arcs_) arc.next = arc.loop = no_id;
  for (uint32_t k = 0; k < n; ++k) {
    if (arcs_[k].is_whole()) {
      arcs_[k].next = k;
      continue;
    }
    for (uint32_t j = 0; j < n; ++j) {
      if (j != k && arcs_[j].end == arcs_[k].end) return false;
      if (arcs_[j].start != arcs_[k].end) continue;
      if (arcs_[k].next != no_id) return false;
      arcs_[k].next = j;
    }
    if (arcs_[k].next == no_id) return false;
  }
  label_loops(arcs_);
  return true;
}

double PatchLoops::steradians(uint32_t loop, Span<const ArcFigures> figures) const {
  double sum = 2 * pi;
  for_each_of_loop(arcs_, loop, [&](uint32_t k) { sum += figures[k].height * figures[k].angle - figures[k].exterior; });
  return sum;
}

bool PatchLoops::group(Span<const ArcFigures> figures) {
  int32_t characteristic = 0;
  const auto excess = [&](uint32_t loop) { return steradians(loop, figures) - 2 * pi; };
  if (gather_pieces(arcs_, excess, characteristic)) return true;
  return actual_.decide_at(vertex_, [&](const auto &actual) { return group_in(actual, vertex_, arcs_) ? 1 : 0; }) != 0;
}

}  // namespace hsp
