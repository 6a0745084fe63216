#include "surface/arc_parts.hpp"

#include "core/elementary.hpp"
#include "core/sorting.hpp"
#include "surface/cut_patches.hpp"

namespace hsp {
namespace {

double angle_between(const Vec3 &a, const Vec3 &b) {
  const Vec3 n = cross(a, b);
  return arc_tangent(std::sqrt(dot(n, n)), dot(a, b));
}

}  // namespace

uint32_t ArcParts::find(const RegionArc &arc, Span<const RegionCorner> corners, Part (&parts)[most]) const {
  const uint32_t k = arc.circle;
  if (SettledCircles::is_side(k)) return find_on_side(arc, corners, parts);
  uint32_t coincident = 0;
  probe_.for_each_at_position(k, [&coincident](uint32_t) { ++coincident; });
  if (coincident == 1) {
    parts[0] = {probe_.caps().ball[k], arc.angle};
    return 1;
  }
  // The sides between vertices at one position, where their patches meet in a crease.
  const double height = circles_.height(k);
  const Vec3 axis = circles_.axis(k);
  const Vec3 centre = height * axis;
  const double radius = std::sqrt((1.0 - height) * (1.0 + height));
  const bool whole = arc.start == no_id;
  const Vec3 sideways = cross(axis, probe_.corner(0));
  const double length = std::sqrt(dot(sideways, sideways));
  const Vec3 x = whole ? (radius / length) * sideways : corners[arc.start].point - centre;
  const Vec3 y = cross(axis, x);
  const auto at = [&](double turn) {
    const SinCos s = sin_cos(turn);
    return centre + combine(s.cosine, x, s.sine, y);
  };
  const uint32_t first = whole ? no_id : owner_of_end(k, corners[arc.start]);
  const uint32_t last = whole ? no_id : owner_of_end(k, corners[arc.end]);
  double cut[most];
  uint32_t cuts = 0;
  patches_.for_each_side_between(k, [&](uint32_t u, uint32_t, uint32_t slot, const Vec3 &n) {
    // (centre + x cos + y sin + from_u) . n = 0
    const Vec3 from_u = -patches_.way(probe_.vertex(), u);
    const double a = dot(x, n);
    const double b = dot(y, n);
    const double c = -dot(centre + from_u, n);
    const double size = std::sqrt(a * a + b * b);
    if (!(std::fabs(c) < size)) return;
    const double middle = arc_tangent(b, a);
    const double off = arc_tangent(std::sqrt((size - c) * (size + c)), c);
    for (int sign = -1; sign <= 1; sign += 2) {
      double turn = middle + sign * off;
      while (turn < 0.0) turn += 2 * pi;
      while (turn >= 2 * pi) turn -= 2 * pi;
      const bool at_first = first != no_id && (turn < same_position || turn > 2 * pi - same_position);
      if (at_first || (last != no_id && std::fabs(turn - arc.angle) < same_position)) continue;
      if (!(turn < arc.angle) || cuts == most - 3) continue;
      if (patches_.depth_in(u, at(turn), slot) > 0.0) cut[cuts++] = turn;
    }
  });
  sort_in_place(Span<double>(cut, cuts), [](double a, double b) { return a < b; });
  uint32_t count = 0;
  double from = 0.0;
  for (uint32_t i = 0; i <= cuts; ++i) {
    const double to = i < cuts ? cut[i] : arc.angle;
    const uint32_t across = patches_.vertex_at(k, at(0.5 * from + 0.5 * to));
    if (count > 0 && parts[count - 1].across == across) {
      parts[count - 1].angle += to - from;
    } else {
      parts[count++] = {across, to - from};
    }
    from = to;
  }
  if (whole && count > 1 && parts[count - 1].across == parts[0].across) {
    parts[0].angle += parts[--count].angle;
  }
  // Where it ends on such a side, parts without length.
  if (first != no_id && first != parts[0].across) {
    for (uint32_t i = count++; i > 0; --i) parts[i] = parts[i - 1];
    parts[0] = {first, 0.0};
  }
  if (last != no_id && last != parts[count - 1].across) parts[count++] = {last, 0.0};
  return count;
}

// Of an arc of a cap with several vertices at its position, that ends on the side between two of them, at a corner with
// another probe or on a side with a vertex at the same position behind it: which of the two has this corner. no_id if
// there is no such side.
uint32_t ArcParts::owner_of_end(uint32_t cap, const RegionCorner &end) const {
  const uint32_t other = end.other(cap);
  const uint32_t own = probe_.vertex();
  const bool on_side = SettledCircles::is_side(other);
  if (on_side && !circles_.is_beyond_opposite_probe(other, end.point)) return no_id;
  uint32_t owner = no_id;
  patches_.for_each_side_between(cap, [&](uint32_t u, uint32_t across, uint32_t slot, const Vec3 &inward) {
    if (!(std::fabs(dot(inward, end.point - patches_.way(own, u))) < same_position)) return;
    if (!(patches_.depth_in(u, end.point, slot) > 0.0)) return;
    owner = on_side ? patches_.owner_on_side(own, circles_.opposite_probe(other), u, across, end.point)
                    : patches_.owner_of_corner(u, across, own, probe_.caps().ball[other], end.point);
  });
  return owner;
}

uint32_t ArcParts::find_on_side(const RegionArc &arc, Span<const RegionCorner> corners, Part (&parts)[most]) const {
  const uint32_t side = arc.circle;
  const uint32_t slot = patches_.boundary().vertex(probe_.vertex()).slot_of(probe_.ball_opposite(side));
  if (circles_.opposite_probe(side) == no_id || arc.start == no_id) {
    parts[0] = {PatchArc::side(slot), arc.angle};
    return 1;
  }
  // It runs from one ball's corner to the other's, or from or to a cap beyond the axis.
  const RegionCorner &start = corners[arc.start];
  const RegionCorner &end = corners[arc.end];
  const bool from_ball = SettledCircles::is_side(start.other(side));
  const bool to_ball = SettledCircles::is_side(end.other(side));
  const Vec3 first = from_ball ? circles_.cusp_near(side, start.point) : start.point;
  const Vec3 last = to_ball ? circles_.cusp_near(side, end.point) : end.point;
  uint32_t count = 0;
  if (from_ball) parts[count++] = {PatchArc::side(slot), angle_between(start.point, first)};
  parts[count++] = {circles_.opposite_probe(side), angle_between(first, last)};
  if (to_ball) parts[count++] = {PatchArc::side(slot), angle_between(last, end.point)};
  return count;
}

}  // namespace hsp
