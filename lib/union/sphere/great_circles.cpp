// Finds the free intervals of a meridian. Each begins and ends where a cap's part of the meridian ends in a point that
// no other cap covers.
//
// As an example three caps of 30 degrees about axes in the plane of the meridian, in degrees from the direction z on:
//   axis      covers          free ends
//      0     -30 to  30       the entry, as 30 lies in the second cap
//     45      15 to  75       the exit
//    180     150 to 210       both
// So 75 to 150 is free, from the exit of the second cap to the entry of the third, and so is 210 to 330. If there are
// many caps, they are sorted by their entries: if no cap covers more than 60 degrees, 75 can lie only in caps that
// begin between 15 and 75.
#include "sphere/great_circles.hpp"

#include <limits>

#include "core/extremes.hpp"
#include "core/first_index.hpp"
#include "core/small_code.hpp"
#include "core/sorting.hpp"
#include "lanes/wide.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {

using CapBounds = CapPairBounds<double>;
using exact::Plane;
using exact::Vector;

// The normal is an odd function of the axis, so that both balls of a circle name its points in the plane by the same
// signs.
Plane meridian_through(const Vector &axis) {
  if (axis.x != 0 || axis.y != 0) return exact::virtual_plane({-axis.y, axis.x, 0}, 0);
  return exact::virtual_plane({axis.z > 0 ? 1 : -1, 0, 0}, 0);
}

namespace {

// The plane of a meridian with normal m has two axes: along w, the horizontal unit vector parallel to m x z, and up.
// The directions z, w, -z, -w are a turn counter-clockwise about m. Of the meridian, a cap u.x >= b covers the points
// with along x_w + up x_z >= b, where along = u.w and up = u.z. With S = along^2 + up^2 and q = S - b^2, the circles
// cross if q > 0, in the points  (b (along, up) +- sqrt(q) (up, -along)) / S, of which + is the exit.
//
// The errors of q, of the points and of their tests are below those of the general pair (cap_pair.hpp), whose bounds
// are used here: in units of 2^-53 along has 3.5 + 3.5 + 2, S 23, q 38, each coordinate of a point, with s = 1/S, at
// most 45 s + 24 sqrt(s) + 10 + 20 sqrt(s/q), and a test one and a half times that and 20 more.
struct MeridianAxis {
  double along_x, along_y;

  [[gnu::always_inline]] explicit MeridianAxis(const Vector &m) {
    const double inverse = 1.0 / std::sqrt(static_cast<double>(dot(m, m)));
    along_x = static_cast<double>(m.y) * inverse;
    along_y = -static_cast<double>(m.x) * inverse;
  }
};

// The end points of the part that a cap covers of a meridian.
struct CoveredEnds {
  using Lanes = Wide<double, 2>;
  Lanes::Real along, up;  // lane 0: entry, lane 1: exit
  double error;           // of along_l x_w + up_l x_z - b_l for any cap l

  explicit CoveredEnds(const MeridianCap &cap) {
    const double S = cap.along * cap.along + cap.up * cap.up;
    const double q = S - cap.b * cap.b;
    const double root = std::sqrt(q);
    const double s = 1.0 / S;
    const double middle = cap.b * s;
    const double half_chord = root * s;
    const Lanes::Real chord{-half_chord, half_chord};
    along = middle * cap.along + chord * cap.up;
    up = middle * cap.up - chord * cap.along;
    // False for NaN, as everything below is.
    const bool certain = q > CapBounds::points;
    error = certain ? unit_roundoff * s * (CapBounds::point_s * s + CapBounds::point_root / root)
                    : std::numeric_limits<double>::infinity();
  }
};

constexpr uint32_t both_ends = MeridianCap::free_entry | MeridianCap::free_exit;  // bit of lane 0, bit of lane 1

// Returns the bits of free_ends, ends of a cap on a meridian that are free so far, that lie in none of `others`.
uint32_t free_ends_of(const Caps &caps, const exact::Predicates &predicates, const Plane &meridian,
                      Span<const MeridianCap> others, const MeridianCap &own, uint32_t free_ends) {
  using Lanes = CoveredEnds::Lanes;
  const CoveredEnds ends(own);
  for (uint32_t k = 0; k < others.size() && free_ends != 0; ++k) {
    const MeridianCap &other = others[k];
    if (&other == &own) continue;
    const Lanes::Real at = other.along * ends.along + other.up * ends.up - other.b;
    if (Lanes::set_lanes(Lanes::absolute(at) > ends.error) == both_ends) {
      free_ends &= static_cast<uint32_t>(Lanes::set_lanes(at < 0.0));
    } else {
      const exact::PointStatus status = predicates.point_status(meridian, caps.plane(own.cap), caps.plane(other.cap));
      free_ends &=
          (status.side[0] < 0 ? MeridianCap::free_entry : 0U) | (status.side[1] < 0 ? MeridianCap::free_exit : 0U);
    }
  }
  return free_ends;
}

// The place of a direction on the meridian, counter-clockwise from z: 2^32 is a whole turn. It grows with the angle but
// not in proportion. Its lowest two bits are 0.
uint32_t place_of(double along, double up) {
  const double size = std::fabs(along) + std::fabs(up), part = along >= 0.0 ? 1.0 - up / size : 3.0 + up / size;
  return static_cast<uint32_t>(static_cast<int64_t>(part * 0x1p30)) & ~both_ends;
}

// Sorts many caps on a meridian so that few caps have to be tested for each end. Long caps, and caps whose ends are in
// doubt, come first: they may reach any end. The others follow in the order of their entries, and none of them is
// longer than `longest_`. If ends are not in doubt, the errors of their places are far below `slack`.
class CapsByPlace {
 public:
  static constexpr uint32_t fewest = 32;

  explicit CapsByPlace(Span<MeridianCap> crossing) : crossing_(crossing) {
    uint64_t sum = 0, certain = 0;
    for (MeridianCap &cap : crossing) {
      const uint32_t length = length_of(cap, cap.free_ends);
      if (length == in_doubt) continue;
      sum += length;
      ++certain;
    }
    if (certain > 0) longest_ = smaller_of(static_cast<uint32_t>(sum / certain), half_turn / 4) * 4;
    for (uint32_t k = 0; k < crossing.size(); ++k) {
      uint32_t entry;
      if (length_of(crossing[k], entry) <= longest_) continue;
      const MeridianCap other = crossing[first_];
      crossing[first_++] = crossing[k];
      crossing[k] = other;
    }
    sort_in_place(crossing.part(first_, crossing.size()),
                  [](const MeridianCap &a, const MeridianCap &b) { return a.free_ends < b.free_ends; });
  }

  // Calls visit(part) for parts of the caps. Together these hold every cap that may reach an end of cap k.
  template <class Visit>
  void visit_near(uint32_t k, Visit visit) const {
    const uint32_t count = crossing_.size();
    if (k < first_) return visit(crossing_);
    visit(crossing_.part(0, first_));
    uint32_t entry;
    const uint32_t length = length_of(crossing_[k], entry), low = entry - longest_ - slack,
                   high = entry + length + slack;
    const uint32_t from = first_from(low), to = first_from(high);
    if (low < high) return visit(crossing_.part(from, to));
    visit(crossing_.part(from, count));
    visit(crossing_.part(first_, to));
  }

 private:
  static constexpr uint32_t slack = UINT32_C(1) << 14, half_turn = UINT32_C(1) << 31, in_doubt = UINT32_MAX;

  // The length from the entry to the exit, as a difference of places; in_doubt where the ends, which may be NaN then,
  // are not known well.
  static uint32_t length_of(const MeridianCap &cap, uint32_t &entry) {
    const CoveredEnds ends(cap);
    entry = 0;
    if (ends.error > 0x1p-20) return in_doubt;
    entry = place_of(ends.along[0], ends.up[0]);
    const uint32_t length = place_of(ends.along[1], ends.up[1]) - entry;
    return length < half_turn / 2 ? length : in_doubt;
  }
  uint32_t first_from(uint32_t place) const {
    return first_index(first_, crossing_.size(),
                       [&](uint32_t k) { return (crossing_[k].free_ends & ~both_ends) >= place; });
  }

  Span<MeridianCap> crossing_;
  uint32_t first_ = 0;  // the first cap that is not long
  uint32_t longest_ = 0;
};

[[gnu::cold, gnu::noinline]] void find_ends_by_place(const Caps &caps, const exact::Predicates &predicates,
                                                     const Plane &meridian, Span<MeridianCap> crossing) {
  const CapsByPlace by_place(crossing);
  for (uint32_t k = 0; k < crossing.size(); ++k) {
    uint32_t free_ends = both_ends;
    by_place.visit_near(k, [&](Span<const MeridianCap> others) {
      free_ends = free_ends_of(caps, predicates, meridian, others, crossing[k], free_ends);
    });
    crossing[k].free_ends |= free_ends;
  }
  for (MeridianCap &cap : crossing) cap.free_ends &= both_ends;
}

// Whether cap a comes before cap b, counter-clockwise about the normal m of a meridian from the direction z: first the
// half-turn on the side of w = m x z, then the other. The errors of a cross product in the meridian's plane are below
// 2 (9 + 3.5) + 3 units.
bool comes_before(const Caps &caps, const Vector &m, const MeridianCap &a, const MeridianCap &b) {
  constexpr double certain = 32 * unit_roundoff;
  const double turn = a.up * b.along - a.along * b.up;
  if (std::fabs(a.along) > certain && std::fabs(b.along) > certain && std::fabs(turn) > certain) {
    return (a.along > 0.0) != (b.along > 0.0) ? a.along > 0.0 : turn > 0.0;
  }
  const Vector v = caps.direction(a.cap);
  const Vector w = caps.direction(b.cap);
  const auto half = [&m](const Vector &u) {
    const int64_t along = u.x * m.y - u.y * m.x;
    return along > 0 || (along == 0 && u.z > 0) ? 0 : 1;
  };
  const int half_v = half(v);
  const int half_w = half(w);
  return half_v != half_w ? half_v < half_w : exact::orientation(m, v, w) > 0;
}

}  // namespace

void FreeIntervals::carve(Workspace &workspace, uint32_t capacity) {
  caps_ = workspace.take<MeridianCap>(capacity);
}

bool FreeIntervals::is_marked(const Plane &meridian) const {
  const MeridianAxis axis(meridian.v);
  return sectors_.is_marked(axis.along_x, axis.along_y);
}

void FreeIntervals::make_index(const Caps &caps) {
  constexpr uint32_t words = sizeof(MeridianCap) / sizeof(uint32_t);
  const uint32_t sectors = MeridianSectors::sectors_for(caps.count);
  const uint32_t listed = MeridianSectors::entries_for_each * caps.count;
  static_assert(MeridianSectors::entries_for_each + 2 < words);
  room_ = caps_.size() - (caps.count + listed + sectors + 1 + words - 1) / words;
  uint32_t *const behind = reinterpret_cast<uint32_t *>(caps_.data() + room_);
  of_caps_ = {behind, caps.count};
  sectors_.start(caps, {{behind + caps.count, sectors + 1}, {behind + caps.count + sectors + 1, listed}});
}

namespace {

enum class OnMeridian { nothing, crosses, covers };

// Whether cap l crosses a meridian or covers it. Writes it to `cap` as a cap in the meridian's plane.
[[gnu::always_inline]] inline OnMeridian on_meridian(const Caps &caps, const exact::Predicates &predicates,
                                                     const Plane &meridian, const MeridianAxis &axis, uint32_t l,
                                                     MeridianCap &cap) {
  const double along = caps.ux[l] * axis.along_x + caps.uy[l] * axis.along_y;
  const double up = caps.uz[l];
  const double b = caps.b[l];
  const double q = along * along + up * up - b * b;
  cap = {along, up, b, l, 0};
  if (q > CapBounds::crossing) return OnMeridian::crosses;
  if (q < -CapBounds::crossing && b > CapBounds::centre) return OnMeridian::nothing;
  // Seldom: it covers the meridian, or it must be asked exactly.
  if (predicates.crossing(meridian, caps.plane(l)).sign > 0) return OnMeridian::crosses;
  return predicates.side(meridian, caps.plane(l)).sign > 0 ? OnMeridian::covers : OnMeridian::nothing;
}

// Finds by the index the caps that cross a meridian. Returns how many, no_id if a cap covers the meridian, or
// crossing.size() if there may be more than fit.
[[gnu::cold, gnu::noinline]] uint32_t find_by_sectors(const MeridianSectors &sectors, const Caps &caps,
                                                      const exact::Predicates &predicates, const Plane &meridian,
                                                      const MeridianAxis &axis, Span<MeridianCap> crossing) {
  uint32_t crossings = 0;
  bool covered = false;
  sectors.visit(axis.along_x, axis.along_y, [&](uint32_t l) {
    const OnMeridian found = on_meridian(caps, predicates, meridian, axis, l, crossing[crossings]);
    covered = found == OnMeridian::covers;
    crossings += found == OnMeridian::crosses ? 1U : 0U;
    return !covered && crossings < crossing.size();
  });
  return covered ? no_id : crossings;
}

}  // namespace

void FreeIntervals::find(const Caps &caps, const exact::Predicates &predicates, const Plane &meridian) {
  bounding_caps_ = 0;
  const MeridianAxis axis(meridian.v);
  uint32_t crossings = 0;
  if (!small_code && indexed_) {
    crossings = find_by_sectors(sectors_, caps, predicates, meridian, axis, caps_.part(0, room_));
    if (crossings == no_id) return;
    indexed_ = crossings < room_;
  }
  if (small_code || !indexed_) {
    crossings = 0;
    for (uint32_t l = 0; l < caps.count; ++l) {
      const OnMeridian found = on_meridian(caps, predicates, meridian, axis, l, caps_[crossings]);
      if (found == OnMeridian::covers) return;
      crossings += found == OnMeridian::crosses ? 1U : 0U;
    }
  }
  const Span<MeridianCap> crossing = caps_.part(0, crossings);
  if (!small_code && crossings >= CapsByPlace::fewest) {
    find_ends_by_place(caps, predicates, meridian, crossing);
  } else {
    for (MeridianCap &cap : crossing) {
      cap.free_ends = free_ends_of(caps, predicates, meridian, crossing, cap, both_ends);
    }
  }
  for (const MeridianCap &cap : crossing) {
    if (cap.free_ends != 0) caps_[bounding_caps_++] = cap;
  }
  const Span<MeridianCap> bounding = caps_.part(0, bounding_caps_);
  if (bounding_caps_ > 2) {
    sort_in_place(bounding,
                  [&](const MeridianCap &a, const MeridianCap &b) { return comes_before(caps, meridian.v, a, b); });
  } else if (!small_code && bounding_caps_ == 2 && bounding[1].cap < bounding[0].cap) {
    const MeridianCap other = bounding[0];
    bounding[0] = bounding[1];
    bounding[1] = other;
  }
}

// From the upper pole, a counter-clockwise turn goes first towards w = m x z; the lower pole is half a turn away. With
// e = v.w the signs of e and v.z say on which side of the poles v is. Only two directions on the same side have to be
// compared.
bool pole_lies_between(const Vector &m, const Vector &from, const Vector &to, int pole) {
  const auto side = [&](const Vector &v) {
    const int64_t e = v.x * m.y - v.y * m.x;
    if (e != 0) return (e > 0) == (pole > 0) ? 1 : -1;
    return (v.z > 0) == (pole > 0) ? 0 : 2;  // the direction of the pole, or of the other one
  };
  const int side_from = side(from);
  const int side_to = side(to);
  if (side_from == 0 || side_to == 0) return false;
  if (side_from != side_to) {
    // Behind the pole comes side 1, then 2, then -1. A turn from a later to an earlier one of these passes the pole.
    const auto position = [](int where) { return where == 1 ? 1 : where == 2 ? 2 : 3; };
    return position(side_from) > position(side_to);
  }
  // On one side: the turn passes the pole unless it comes to `to` before. Equal directions are a whole turn apart.
  return side_from == 2 || exact::orientation(m, from, to) <= 0;
}

namespace {

// Whether the highest (+1) or lowest (-1) point lies in a cap. On the unit sphere it is (0, 0, +-1), where a test has
// the errors of u and b alone, 3.5 + 7 + 2 units. For the exact stage the poles are p+ and p- of two coordinate planes.
// Their normals may have any length; the filter is sharpest if it is about that of the other planes' normals.
bool covers_pole(const Caps &caps, const exact::Predicates &predicates, uint32_t cap, int pole) {
  constexpr double certain = 16 * unit_roundoff;
  const double value = (pole > 0 ? caps.uz[cap] : -caps.uz[cap]) - caps.b[cap];
  if (std::fabs(value) > certain) return value > 0.0;
  int64_t scale = 1;
  while (4.0 * static_cast<double>(scale) * static_cast<double>(scale) <= caps.length_squared) scale *= 2;
  const Plane across_x = exact::virtual_plane({scale, 0, 0}, 0);
  const Plane across_y = exact::virtual_plane({0, scale, 0}, 0);
  return predicates.inside(across_x, across_y, pole, caps.plane(cap)) > 0;
}

}  // namespace

// The pole lies on the arc iff it lies between the mid-points of the two caps and in neither of them.
bool contains_pole(const Caps &caps, const exact::Predicates &predicates, const Plane &meridian,
                   const FreeInterval &interval, int pole) {
  return !covers_pole(caps, predicates, interval.exit_cap, pole) &&
         !covers_pole(caps, predicates, interval.entry_cap, pole) &&
         pole_lies_between(meridian.v, caps.direction(interval.exit_cap), caps.direction(interval.entry_cap), pole);
}

}  // namespace hsp
