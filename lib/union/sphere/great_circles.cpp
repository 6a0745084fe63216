#include "sphere/great_circles.hpp"

#include <limits>

#include "core/sorting.hpp"
#include "lanes/wide.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {

using CapBounds = CapPairBounds<double>;
using exact::Plane;
using exact::Vector;

// Odd in the axis, so that both balls of a circle name its points in the plane by the same signs.
Plane meridian_through(const Vector &axis) {
  if (axis.x != 0 || axis.y != 0) return exact::virtual_plane({-axis.y, axis.x, 0}, 0);
  return exact::virtual_plane({axis.z > 0 ? 1 : -1, 0, 0}, 0);
}

namespace {

// The plane of a meridian with normal m, as the plane of two axes: along w = m x z, which is horizontal, and up. The
// direction z, w, -z, -w is a turn counter-clockwise about m. A cap u.x >= b covers of the meridian what satisfies
// along x_w + up x_z >= b, with along = u.w and up = u.z. Where S = along^2 + up^2 and q = S - b^2 > 0 the circles
// cross, in the points  (b (along, up) +- sqrt(q) (up, -along)) / S, of which + is the exit.
//
// The errors of q, of the points and of their tests are below those of the general pair (cap_pair.hpp), whose bounds
// are used here: in units of 2^-53 along has 3.5 + 3.5 + 2, S 23, q 38, each coordinate of a point, with s = 1/S, at
// most 45 s + 24 sqrt(s) + 10 + 20 sqrt(s/q), and a test one and a half times that and 20 more.
struct MeridianAxis {
  double along_x, along_y;

  explicit MeridianAxis(const Vector &m) {
    const double inverse = 1.0 / std::sqrt(static_cast<double>(dot(m, m)));
    along_x = static_cast<double>(m.y) * inverse;
    along_y = -static_cast<double>(m.x) * inverse;
  }
};

// The end points of what a cap covers of a meridian.
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

// Which ends of a cap on a meridian are free.
uint32_t free_ends_of(const Caps &caps, const exact::Predicates &predicates, const Plane &meridian,
                      Span<const MeridianCap> crossing, const MeridianCap &own) {
  using Lanes = CoveredEnds::Lanes;
  const CoveredEnds ends(own);
  constexpr uint32_t both = MeridianCap::free_entry | MeridianCap::free_exit;  // as lanes have their bits
  uint32_t free_ends = both;
  for (uint32_t k = 0; k < crossing.size() && free_ends != 0; ++k) {
    const MeridianCap &other = crossing[k];
    if (&other == &own) continue;
    const Lanes::Real at = other.along * ends.along + other.up * ends.up - other.b;
    if (Lanes::set_lanes(Lanes::absolute(at) > ends.error) == both) {
      free_ends &= static_cast<uint32_t>(Lanes::set_lanes(at < 0.0));
    } else {
      const exact::PointStatus status = predicates.point_status(meridian, caps.plane(own.cap), caps.plane(other.cap));
      free_ends &=
          (status.side[0] < 0 ? MeridianCap::free_entry : 0U) | (status.side[1] < 0 ? MeridianCap::free_exit : 0U);
    }
  }
  return free_ends;
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

[[gnu::cold]] void FreeIntervals::find(const Caps &caps, const exact::Predicates &predicates, const Plane &meridian) {
  bounding_caps_ = 0;
  const MeridianAxis axis(meridian.v);
  uint32_t crossings = 0;
  for (uint32_t l = 0; l < caps.count; ++l) {
    const double along = caps.ux[l] * axis.along_x + caps.uy[l] * axis.along_y;
    const double up = caps.uz[l];
    const double b = caps.b[l];
    const double q = along * along + up * up - b * b;
    caps_[crossings] = {along, up, b, l, 0};
    bool crosses = q > CapBounds::crossing;
    if (!crosses && !(q < -CapBounds::crossing && b > CapBounds::centre)) {
      // Seldom: it covers the meridian, or it must be asked exactly.
      crosses = predicates.crossing(meridian, caps.plane(l)).sign > 0;
      if (!crosses && predicates.side(meridian, caps.plane(l)).sign > 0) return;
    }
    crossings += crosses ? 1U : 0U;
  }
  const Span<MeridianCap> crossing = caps_.part(0, crossings);
  for (MeridianCap &cap : crossing) cap.free_ends = free_ends_of(caps, predicates, meridian, crossing, cap);
  for (const MeridianCap &cap : crossing) {
    if (cap.free_ends != 0) caps_[bounding_caps_++] = cap;
  }
  if (bounding_caps_ > 2) {
    sort_in_place(caps_.part(0, bounding_caps_),
                  [&](const MeridianCap &a, const MeridianCap &b) { return comes_before(caps, meridian.v, a, b); });
  }
}

// From the upper pole the turn goes first towards w = m x z; the lower pole is half a turn away. With e = v.w the signs
// of e and v.z give the side of v, and only two directions on the same side of the poles have to be compared.
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
    // Behind the pole comes side 1, then 2, then -1: the pole is passed on the way down in this order.
    const auto position = [](int where) { return where == 1 ? 1 : where == 2 ? 2 : 3; };
    return position(side_from) > position(side_to);
  }
  // On one side: passed unless `to` comes first; the whole turn if they are equal.
  return side_from == 2 || exact::orientation(m, from, to) <= 0;
}

namespace {

// Whether the highest (+1) or lowest (-1) point lies in a cap. On the unit sphere it is (0, 0, +-1), where a test has
// the errors of u and b alone, 3.5 + 7 + 2 units. Exactly, the poles are p+ and p- of two coordinate planes, whose
// normals may have any length: the filter is sharpest if it is that of the others.
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
