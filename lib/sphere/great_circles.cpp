#include "sphere/great_circles.hpp"

#include "core/sorting.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {

using exact::Plane;
using exact::Vector;

// Odd in the axis, so that both balls of a circle name its points in the plane by the same signs.
Plane meridian_through(const Vector &axis) {
  if (axis.x != 0 || axis.y != 0) return exact::virtual_plane({-axis.y, axis.x, 0}, 0);
  return exact::virtual_plane({axis.z > 0 ? 1 : -1, 0, 0}, 0);
}

namespace {

enum class Cover { crosses, covers, apart };

// How a cap lies to a great circle.
Cover cover_of(const Caps &caps, const exact::Predicates &predicates, const Plane &circle, uint32_t l) {
  const CapPair pair(caps, caps.count, l);
  if (pair.certainly_cross()) return Cover::crosses;
  if (pair.certainly_apart()) {
    if (pair.certainly_inside()) return Cover::covers;
    if (pair.certainly_outside()) return Cover::apart;
  }
  if (predicates.crossing(circle, caps.plane[l]).sign > 0) return Cover::crosses;
  return predicates.side(circle, caps.plane[l]).sign > 0 ? Cover::covers : Cover::apart;
}

// Whether the entry and the exit of a cap on a great circle are free.
struct FreeEnds {
  bool entry = true;
  bool leave = true;

  FreeEnds(const Caps &caps, const exact::Predicates &predicates, const Plane &circle, Span<const uint32_t> crossing,
           uint32_t own) {
    const CapPair pair(caps, caps.count, own);
    const bool certain = pair.certainly_cross();
    const CrossingPoints points(caps, caps.count, own, pair);
    for (uint32_t k = 0; k < crossing.size() && (entry || leave); ++k) {
      const uint32_t l = crossing[k];
      if (l == own) continue;
      const auto value = [&](int s) {
        return caps.ux[l] * points.x[s] + caps.uy[l] * points.y[s] + caps.uz[l] * points.z[s] - caps.b[l];
      };
      const double at_entry = value(0);
      const double at_exit = value(1);
      if (certain && std::fabs(at_entry) > points.error && std::fabs(at_exit) > points.error) {
        entry = entry && at_entry < 0.0;
        leave = leave && at_exit < 0.0;
      } else {
        const exact::PointStatus status = predicates.point_status(circle, caps.plane[own], caps.plane[l]);
        entry = entry && status.side[0] < 0;
        leave = leave && status.side[1] < 0;
      }
    }
  }
};

// Counter-clockwise about the normal m of a meridian's plane: two half-turns from the direction z, first the one on the
// side of m x z.
template <class AxisOf>
void sort_along_meridian(const Vector &m, Span<uint32_t> items, AxisOf axis_of) {
  const auto half = [&m](const Vector &v) {
    const int64_t e = v.x * m.y - v.y * m.x;
    return e > 0 || (e == 0 && v.z > 0) ? 0 : 1;
  };
  sort_in_place(items, [&](uint32_t a, uint32_t b) {
    const Vector &v = axis_of(a);
    const Vector &w = axis_of(b);
    const int half_v = half(v);
    const int half_w = half(w);
    return half_v != half_w ? half_v < half_w : exact::orientation(m, v, w) > 0;
  });
}

}  // namespace

void FreeIntervals::carve(Workspace &workspace, uint32_t capacity) {
  crossing_ = workspace.take<uint32_t>(capacity);
  bounding_ = workspace.take<uint32_t>(capacity);
}

void FreeIntervals::find(Caps &caps, const exact::Predicates &predicates, const Plane &circle) {
  caps.set_spare_great_circle(circle.v);
  bounding_caps_ = 0;
  uint32_t crossings = 0;
  for (uint32_t l = 0; l < caps.count; ++l) {
    const Cover cover = cover_of(caps, predicates, circle, l);
    if (cover == Cover::covers) return;
    if (cover == Cover::crosses) crossing_[crossings++] = l;
  }
  for (uint32_t a = 0; a < crossings; ++a) {
    const uint32_t own = crossing_[a];
    const FreeEnds ends(caps, predicates, circle, crossing_.part(0, crossings), own);
    if (ends.entry || ends.leave) bounding_[bounding_caps_++] = encode(own, ends.entry, ends.leave);
  }
  if (bounding_caps_ > 2) {
    sort_along_meridian(circle.v, bounding_.part(0, bounding_caps_),
                        [&caps](uint32_t code) -> const Vector & { return caps.plane[cap_of(code)].v; });
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

// The pole lies on the arc iff it lies between the mid-points of the two caps and in neither of them. The poles are p+
// and p- of two coordinate planes, whose normals may have any length: the filter is sharpest if it is that of the
// others.
bool contains_pole(const Caps &caps, const exact::Predicates &predicates, const Plane &meridian,
                   const FreeInterval &interval, int pole) {
  const Plane &leave = caps.plane[interval.exit_cap];
  const Plane &entry = caps.plane[interval.entry_cap];
  if (!pole_lies_between(meridian.v, leave.v, entry.v, pole)) return false;
  int64_t scale = 1;
  while (4.0 * static_cast<double>(scale) * static_cast<double>(scale) <= caps.length_squared) scale *= 2;
  const Plane across_x = exact::virtual_plane({scale, 0, 0}, 0);
  const Plane across_y = exact::virtual_plane({0, scale, 0}, 0);
  return predicates.inside(across_x, across_y, pole, leave) < 0 &&
         predicates.inside(across_x, across_y, pole, entry) < 0;
}

}  // namespace hsp
