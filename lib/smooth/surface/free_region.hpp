// The part of a unit sphere outside all of its caps, in doubles: its area up to multiples of 2 pi, its vector area, its
// border and pieces. Every answer is certain, given a bound on the errors of the caps; otherwise there is no result.
//
// The crossing points of each pair of circles are computed once. Those that no cap contains are the corners of the
// region. Counter-clockwise along a circle, corners where it leaves another cap (exits) and corners where it enters one
// (entries) take turns; from an exit to the next entry the circle bounds the region.
//
// For circles u.x = a and v.x = b put n = u x v, q = a v - b u and D = n.n - q.q (exact/circle_crossing.hpp). Unlike
// 1 - g^2 - a^2 - b^2 + 2 g a b this keeps its precision where two circles are almost the same, as those of two close
// vertices. Errors in units of e = 2^-53, those of u at most 3.5 A and of a at most 7 A (A the amplification),
// with L^2 = n.n + q.q <= 5:
//   n   2 * 3.5 A + 4 <= 11 A      q   2 * (7 + 3.5) A + 4 <= 25 A
//   D   2 (11 A |n| + 25 A |q|) + 8 L^2 <= 80 A L
// and for the points (q x n +- sqrt(D) n) / n.n, where D > 0, so |q| <= |n| and L <= 1.42 |n|:
//   q x n          (25 + 11 + 2 * 11) A / |n|
//   sqrt(D) n      80 A L / (2 sqrt(D) |n|) + 3 * 11 A / |n|
//   together, as sqrt(D) <= |n|, at most 148 A / sqrt(D); a third cap's u.p - a adds 3.5 A + 7 A, all roundings 20.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/small_code.hpp"
#include "sphere/arc_geometry.hpp"
#include "sphere/caps.hpp"
#include "surface/cut_patches.hpp"

namespace hsp {

enum class Answer : uint8_t { no, yes, unknown };

// A corner of the region: p+ or p- of the circles of two caps. The first circle leaves the cap of the second in p+ and
// enters it in p-; for the second circle it is the reverse.
struct RegionCorner {
  uint32_t exit, entry;  // the circle that leaves the other cap here, and the one that enters
  double root;           // of the discriminant
  Vec3 point;
  double error;          // bound for axis.point - height of any cap
  double turn = 0.0;     // exterior angle
  uint32_t arc = no_id;  // that starts here
};

// A free arc, counter-clockwise about the axis of its circle: the region lies on its right, seen from outside.
struct RegionArc {
  uint32_t circle;
  uint32_t start, end;  // corners; no_id for a whole circle
  uint32_t next;        // the arc that starts where this one ends
  double angle;
  double curvature;       // height * angle, minus the exterior angle where it starts, if it does
  Vec3 vector_area;       // its term
  uint32_t loop = no_id;  // the first arc of its loop, and of the loop around its piece (find_pieces)
  uint32_t piece = no_id;
};

struct FreeRegion {
  // Sum over arcs of height * angle, minus the exterior angles at corners. The area is this plus 2 pi times the Euler
  // characteristic (Gauss-Bonnet).
  double curvature = 0.0;
  Vec3 vector_area{0.0, 0.0, 0.0};  // integral of the point over the region
};

class FreeRegionFinder {
 public:
  // amplification >= 1.
  FreeRegionFinder(const Caps &caps, double amplification, FixedVector<RegionCorner> &corners,
                   FixedVector<RegionArc> &arcs)
      : caps_(caps), error_(amplification * unit_roundoff), corners_(corners), arcs_(arcs) {}

  // False if an answer that matters is unknown, or the answers contradict each other.
  bool find(FreeRegion &region) {
    region = {};
    crossed_ = 0;
    corners_.clear();
    arcs_.clear();
    for (uint32_t k = 1; k < caps_.count; ++k) {
      for (uint32_t j = 0; j < k; ++j) {
        if (!add_corners(j, k)) return false;
      }
    }
    if (corners_.overflowed()) return false;
    for (RegionCorner &corner : corners_.items()) {
      corner.turn = exterior_angle(corner);
      region.curvature -= corner.turn;
    }
    list_corners();
    for (uint32_t k = 0; k < caps_.count; ++k) {
      if (!add_arcs(k)) return false;
    }
    if (arcs_.overflowed()) return false;
    for (RegionArc &arc : arcs_.items()) {
      if (arc.end != no_id) arc.next = corners_[arc.end].arc;
      region.curvature += caps_.b[arc.circle] * arc.angle;
      region.vector_area = region.vector_area + arc.vector_area;
    }
    return true;
  }

 private:
  struct Crossing {
    double root;
    Vec3 point[2];  // p-, p+
    double error;   // as of corners
  };

  static Answer is_positive(double value, double error) {
    return value > error ? Answer::yes : value < -error ? Answer::no : Answer::unknown;
  }
  // Whether two circles j < k cross, and where if they certainly do.
  Answer find_crossing(uint32_t j, uint32_t k, Crossing &crossing) const {
    const CircleCrossing<Vec3, double> pair(caps_.axis(j), caps_.b[j], caps_.axis(k), caps_.b[k]);
    const double D = pair.discriminant(1.0);
    const double scale = error_ * std::sqrt(pair.nn + dot(pair.q, pair.q));
    if (D < -256 * scale) return Answer::no;
    // So far above its error that the first order decides.
    if (!(D > 4096 * scale)) return Answer::unknown;
    const double root = std::sqrt(D);
    crossing = {root, {pair.point(-root), pair.point(root)}, 256 * error_ / root};
    return Answer::yes;
  }
  // Whether cap r contains p+ or p-.
  Answer contains(const Crossing &crossing, int sign, uint32_t r) const {
    return is_positive(dot(caps_.axis(r), crossing.point[sign > 0 ? 1 : 0]) - caps_.b[r], crossing.error);
  }
  // Whether cap r contains circle k, which does not cross its circle, by the centre a u of k: error of a g - b at most
  // 7 A + (2 * 3.5 A + 3) + 7 A + 2.
  Answer lies_inside(uint32_t k, uint32_t r) const {
    return is_positive(caps_.b[k] * dot(caps_.axis(k), caps_.axis(r)) - caps_.b[r], 32 * error_);
  }
  // Seen from the circle's centre each end is uncertain by its error over the circle's radius. Negative if the angle
  // may be 0 or 2 pi.
  double arc_angle(uint32_t k, const RegionCorner &exit, const RegionCorner &entry) const {
    const Vec3 centre = caps_.b[k] * caps_.axis(k);
    const double angle = turn_about(caps_.axis(k), exit.point - centre, entry.point - centre);
    const double radius_squared = (1.0 - caps_.b[k]) * (1.0 + caps_.b[k]);
    const double error = 2 * (exit.error + entry.error);
    const double margin = angle < pi ? angle : 2 * pi - angle;
    return margin > 0.0 && margin * margin * radius_squared > error * error ? angle : -1.0;
  }
  double exterior_angle(const RegionCorner &corner) const {
    const double g = dot(caps_.axis(corner.exit), caps_.axis(corner.entry));
    return arc_tangent(corner.root, g - caps_.b[corner.exit] * caps_.b[corner.entry]);
  }

  bool add_corners(uint32_t j, uint32_t k) {
    Crossing crossing;
    const Answer answer = find_crossing(j, k, crossing);
    if (answer != Answer::yes) return answer == Answer::no;
    crossed_ |= bit(j) | bit(k);
    for (int sign = -1; sign <= 1; sign += 2) {
      Answer covered = Answer::no;
      for (uint32_t r = 0; r < caps_.count && covered != Answer::yes; ++r) {
        if (r == j || r == k) continue;
        const Answer inside = contains(crossing, sign, r);
        if (inside != Answer::no) covered = inside;
      }
      if (covered == Answer::unknown) return false;
      if (covered == Answer::no) {
        corners_.push(
            {sign > 0 ? j : k, sign > 0 ? k : j, crossing.root, crossing.point[sign > 0 ? 1 : 0], crossing.error});
      }
    }
    return true;
  }

  // Adds the arcs of circle k, from each exit to the next entry: if all corners are certain the two take turns.
  bool add_arcs(uint32_t k) {
    bool has_exits = false, good = true;
    for_each_corner(k, true, [&](RegionCorner &exit) {
      has_exits = true;
      double angle = 7.0;
      const RegionCorner *end = nullptr;
      for_each_corner(k, false, [&](const RegionCorner &entry) {
        const double own = arc_angle(k, exit, entry);
        good = good && own >= 0.0;
        if (own >= angle) return;
        angle = own;
        end = &entry;
      });
      good = good && end != nullptr;
      if (!good) return;
      exit.arc = clamped_count(arcs_.required());
      add_arc(k, number_of(exit), number_of(*end), exit.turn, angle, end->point - exit.point);
    });
    return good && (has_exits || add_whole_circle(k));
  }
  // Lists the corners of each circle as bits, if circles and corners are few.
  void list_corners() {
    are_listed_ = !small_code && caps_.count <= few && corners_.size() <= few;
    if (!are_listed_) return;
    for (uint32_t k = 0; k < caps_.count; ++k) exits_[k] = entries_[k] = 0;
    for (uint32_t c = 0; c < corners_.size(); ++c) {
      exits_[corners_[c].exit] |= uint64_t{1} << c;
      entries_[corners_[c].entry] |= uint64_t{1} << c;
    }
  }
  // Calls visit(corner) for the exits or the entries of circle k, in the order of the corners.
  template <class Visit>
  void for_each_corner(uint32_t k, bool exits, Visit visit) {
    if (!small_code && are_listed_) {
      for (uint64_t left = exits ? exits_[k] : entries_[k]; left != 0; left &= left - 1) {
        visit(corners_[static_cast<uint32_t>(__builtin_ctzll(left))]);
      }
      return;
    }
    for (RegionCorner &corner : corners_.items()) {
      if ((exits ? corner.exit : corner.entry) == k) visit(corner);
    }
  }

  // Circle k has no corner: it is covered as a whole, or free as a whole.
  bool add_whole_circle(uint32_t k) {
    // If it crosses other circles and has no corner, it is in other caps as a whole.
    if ((crossed_ & bit(k)) != 0) return true;
    Answer covered = Answer::no;
    for (uint32_t r = 0; r < caps_.count && covered != Answer::yes; ++r) {
      if (r == k) continue;
      Crossing crossing;
      const bool crosses = find_crossing(r < k ? r : k, r < k ? k : r, crossing) == Answer::yes;
      const Answer inside = crosses ? Answer::yes : lies_inside(k, r);
      if (inside != Answer::no) covered = inside;
    }
    if (covered == Answer::no) add_arc(k, no_id, no_id, 0.0, 2 * pi, {0, 0, 0});
    return covered != Answer::unknown;
  }

  // A new arc is its own successor; find() sets that of an arc with ends.
  void add_arc(uint32_t k, uint32_t start, uint32_t end, double turn, double angle, const Vec3 &chord) {
    const SphereArc arc{caps_.axis(k), caps_.b[k], angle, chord};
    arcs_.push({k, start, end, clamped_count(arcs_.required()), angle, arc.height * angle - turn, arc.vector_area()});
  }

  // The bit of one of the first circles; 0 for others.
  static uint64_t bit(uint32_t k) { return k < few ? uint64_t{1} << k : 0; }

  uint32_t number_of(const RegionCorner &corner) const {
    return static_cast<uint32_t>(&corner - corners_.items().data());
  }

  static constexpr uint32_t few = 64;

  const Caps &caps_;
  const double error_;
  FixedVector<RegionCorner> &corners_;
  FixedVector<RegionArc> &arcs_;
  uint64_t crossed_ = 0;                // circles that cross others
  bool are_listed_ = false;             // whether the next two are filled:
  uint64_t exits_[few], entries_[few];  // corners of each circle
};

// Finds the loops of a region inside a spherical triangle, the pieces that they bound, and the Euler characteristic
// (gather_pieces). By Gauss and Bonnet the area on the region's side of a loop is 2 pi plus the sum of height * angle
// over its arcs, minus its exterior angles.
inline bool find_pieces(Span<RegionArc> arcs, int32_t &characteristic) {
  label_loops(arcs);
  const auto excess = [arcs](uint32_t loop) {
    double sum = 0.0;
    for_each_of_loop(arcs, loop, [&](uint32_t k) { sum += arcs[k].curvature; });
    return sum;
  };
  return gather_pieces(arcs, excess, characteristic);
}

}  // namespace hsp
