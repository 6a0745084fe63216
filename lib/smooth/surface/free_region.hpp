// The part of a unit sphere outside all of its caps, for any source of decisions: its area up to multiples of 2 pi, and
// its vector area.
//
// Every pair of circles is asked for its crossing points once, every point whether any cap contains it. The rest
// are the corners of the region. Along a circle they are, counter-clockwise, where another cap ends and where the next
// one begins, by turns; between such two the circle bounds the region. An answer may be "unknown"; then there is no
// result, unless some other cap contains the point for certain.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/small_code.hpp"
#include "core/vec3.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {

enum class Answer : uint8_t { no, yes, unknown };

// A corner of the region: p+ or p- of the circles of two caps, first < second. Circle `first` leaves cap `second` in p+
// and enters it in p-; for circle `second` it is the reverse.
struct RegionCorner {
  uint32_t first, second;
  int32_t sign;
  double root;  // of the discriminant, in the units of the source
  Vec3 point;
  double error;          // of the point
  bool taken;            // as the end of an arc
  double turn = 0.0;     // exterior angle
  uint32_t arc = no_id;  // that starts here

  bool on(uint32_t circle) const { return first == circle || second == circle; }
  uint32_t other(uint32_t circle) const { return first == circle ? second : first; }
  // Whether `circle` leaves the other cap here.
  bool is_exit_of(uint32_t circle) const { return (sign > 0) == (first == circle); }
};

// A free arc, counter-clockwise about the axis of its circle: the region lies on its right, seen from outside.
struct RegionArc {
  uint32_t circle;
  uint32_t start, end;  // corners; no_id for a whole circle
  uint32_t next;        // the arc that starts where this one ends
  double angle;
  double curvature;       // height * angle, minus the exterior angle where it starts
  Vec3 vector_area;       // its term
  uint32_t loop = no_id;  // the first arc of its loop, and of the loop around its piece (region_pieces.hpp)
  uint32_t piece = no_id;
};

struct FreeRegion {
  double curvature = 0.0;           // sum over arcs of height * angle, minus the exterior angles at corners
  Vec3 vector_area{0.0, 0.0, 0.0};  // integral of the point over the region
  uint32_t arcs = 0;                // free arcs, whole circles included
  uint32_t cutting_arcs = 0;        // of these, on circles from `sides` on

  // The area is this plus 2 pi times the Euler characteristic (Gauss-Bonnet), so this modulo 2 pi if it is smaller.
  double steradians() const {
    const double turns = curvature / (2 * pi);
    const double whole = static_cast<double>(static_cast<int64_t>(turns));
    return curvature - 2 * pi * (whole > turns ? whole - 1 : whole);
  }
};

// Circles has
//   uint32_t count() const, Vec3 axis(k), double height(k)             plane of circle k: axis.x = height
//   Answer crossing(j, k, Crossing &) const                            whether circles j < k cross, and where
//   Answer contains(const Crossing &, int sign, r) const               whether cap r contains p+ or p-
//   RegionCorner corner(const Crossing &, int sign) const
//   Answer lies_inside(k, r) const                                     circle k, which crosses none, is in cap r
//   bool ends_sooner(k, exit, a, b) const                              from corner `exit` on, entry a comes before b
//   double arc_angle(k, exit, entry) const                             negative if it may be 0 or 2 pi
//   double exterior_angle(corner) const
template <class Circles>
class FreeRegionFinder {
 public:
  FreeRegionFinder(const Circles &circles, FixedVector<RegionCorner> &corners, FixedVector<RegionArc> &arcs,
                   uint32_t sides)
      : circles_(circles), corners_(corners), arcs_(arcs), sides_(sides) {}

  // False if an answer that matters is unknown, or the answers contradict each other.
  bool find(FreeRegion &region) {
    region_ = {};
    crossed_ = 0;
    corners_.clear();
    arcs_.clear();
    for (uint32_t k = 1; k < circles_.count(); ++k) {
      for (uint32_t j = 0; j < k; ++j) {
        if (!add_corners(j, k)) return false;
      }
    }
    if (corners_.overflowed()) return false;
    for (RegionCorner &corner : corners_.items()) {
      corner.turn = circles_.exterior_angle(corner);
      region_.curvature -= corner.turn;
    }
    list_corners();
    for (uint32_t k = 0; k < circles_.count(); ++k) {
      if (!add_arcs(k)) return false;
    }
    if (arcs_.overflowed()) return false;
    for (RegionArc &arc : arcs_.items()) {
      if (arc.end != no_id) arc.next = corners_[arc.end].arc;
    }
    region = region_;
    return true;
  }

 private:
  bool add_corners(uint32_t j, uint32_t k) {
    typename Circles::Crossing crossing;
    const Answer answer = circles_.crossing(j, k, crossing);
    if (answer != Answer::yes) return answer == Answer::no;
    crossed_ |= bit(j) | bit(k);
    for (int sign = -1; sign <= 1; sign += 2) {
      Answer covered = Answer::no;
      for (uint32_t r = 0; r < circles_.count() && covered != Answer::yes; ++r) {
        if (r == j || r == k) continue;
        const Answer inside = circles_.contains(crossing, sign, r);
        if (inside != Answer::no) covered = inside;
      }
      if (covered == Answer::unknown) return false;
      if (covered == Answer::no) corners_.push(circles_.corner(crossing, sign));
    }
    return true;
  }

  // Every exit takes an entry of its own. As there are as many entries as exits of all circles together, none is left
  // over if this succeeds for all of them.
  bool add_arcs(uint32_t k) {
    bool has_exits = false;
    bool good = true;
    for_each_corner(k, true, [&](RegionCorner &exit) {
      has_exits = true;
      if (!good) return;
      RegionCorner *end = nullptr;
      for_each_corner(k, false, [&](RegionCorner &entry) {
        if (end == nullptr || circles_.ends_sooner(k, exit, entry, *end)) end = &entry;
      });
      good = end != nullptr && !end->taken;
      if (!good) return;
      end->taken = true;
      const double angle = circles_.arc_angle(k, exit, *end);
      good = !(angle < 0.0);
      if (!good) return;
      exit.arc = clamped_count(arcs_.required());
      arcs_.push({k, number_of(exit), number_of(*end), no_id, angle, -exit.turn, {}});
      add_arc(k, angle, end->point - exit.point);
    });
    return good && (has_exits || add_whole_circle(k));
  }

  // Every corner is an exit of one circle and an entry of another. As bits, if there are few of both.
  void list_corners() {
    are_listed_ = !small_code && circles_.count() <= few && corners_.size() <= few;
    if (!are_listed_) return;
    for (uint32_t k = 0; k < circles_.count(); ++k) exits_[k] = entries_[k] = 0;
    for (uint32_t c = 0; c < corners_.size(); ++c) {
      const RegionCorner &corner = corners_[c];
      const bool forward = corner.sign > 0;
      exits_[forward ? corner.first : corner.second] |= uint64_t{1} << c;
      entries_[forward ? corner.second : corner.first] |= uint64_t{1} << c;
    }
  }
  // In the order of the corners.
  template <class Visit>
  void for_each_corner(uint32_t k, bool exits, Visit visit) {
    if (!small_code && are_listed_) {
      for (uint64_t left = exits ? exits_[k] : entries_[k]; left != 0; left &= left - 1) {
        visit(corners_[static_cast<uint32_t>(__builtin_ctzll(left))]);
      }
      return;
    }
    for (RegionCorner &corner : corners_.items()) {
      if (corner.on(k) && corner.is_exit_of(k) == exits) visit(corner);
    }
  }

  // Circle k has no corner: it is covered as a whole, or free as a whole.
  bool add_whole_circle(uint32_t k) {
    // Where circles cross and leave no corner, the rest is in other caps.
    if ((crossed_ & bit(k)) != 0) return true;
    Answer covered = Answer::no;
    for (uint32_t r = 0; r < circles_.count() && covered != Answer::yes; ++r) {
      if (r == k) continue;
      typename Circles::Crossing crossing;
      const bool crosses = circles_.crossing(r < k ? r : k, r < k ? k : r, crossing) == Answer::yes;
      const Answer inside = crosses ? Answer::yes : circles_.lies_inside(k, r);
      if (inside != Answer::no) covered = inside;
    }
    if (covered == Answer::no) {
      arcs_.push({k, no_id, no_id, clamped_count(arcs_.required()), 2 * pi, 0.0, {}});
      add_arc(k, 2 * pi, {0, 0, 0});
    }
    return covered != Answer::unknown;
  }

  void add_arc(uint32_t k, double angle, const Vec3 &chord) {
    const double c = circles_.height(k);
    const Vec3 u = circles_.axis(k);
    region_.curvature += c * angle;
    const Vec3 along = combine(c, cross(u, chord), (1.0 - c) * (1.0 + c) * angle, u);
    region_.vector_area = combine(1.0, region_.vector_area, -0.5, along);
    if (region_.arcs < arcs_.size()) {
      RegionArc &arc = arcs_[region_.arcs];
      arc.curvature += c * angle;
      arc.vector_area = -0.5 * along;
    }
    ++region_.arcs;
    region_.cutting_arcs += k >= sides_ ? 1U : 0U;
  }

  // Of the first circles; others have none.
  static uint64_t bit(uint32_t k) { return k < few ? uint64_t{1} << k : 0; }

  uint32_t number_of(const RegionCorner &corner) const {
    return static_cast<uint32_t>(&corner - corners_.items().data());
  }

  static constexpr uint32_t few = 64;

  const Circles &circles_;
  FixedVector<RegionCorner> &corners_;
  FixedVector<RegionArc> &arcs_;
  const uint32_t sides_;
  FreeRegion region_;
  uint64_t crossed_ = 0;                // circles that cross others
  bool are_listed_ = false;             // the next two hold something:
  uint64_t exits_[few], entries_[few];  // corners of each circle
};

}  // namespace hsp
