// Balls and sticks in view coordinates: which parts of them are painted, and in which order, if they have one. A stick
// meets other bodies only inside the balls in which it ends; stick_sweep.hpp checks that.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/limits.hpp"
#include "core/status.hpp"
#include "core/vec3.hpp"
#include "core/workspace.hpp"
#include "lanes/floating_point.hpp"
#include "view/projected_arcs.hpp"

namespace hsp {

// A stick: a solid cylinder around the segment from the centre of one ball, the foot, to that of another one. At most
// its side between the two junction circles is seen, the circles in which it leaves the balls.
//
// A point of the view plane has these coordinates relative to a stick: a along the axis as it is seen, w across it, to
// the left. Let u be the axis, of length 1, and h the length at which it is seen. With v = sqrt(radius^2 - w^2) the
// front of the stick over the point is (a u_z + v) / h higher than the foot, and at the position (a + u_z v) / h along
// the axis.
//
// The points of the front at one position s along the axis are the half circle t in [0, pi] of
//   s u + radius (cos t across + sin t rise),   across = (-e_y, e_x, 0), rise = (-u_z e, h), e = (u_x, u_y)/h
// The contour, t = 0 and t = pi, appears as two lines. As u_z is not negative, half circles bulge towards the foot.

// The segment of the points from + t (to - from), t in [0, 1].
struct Segment {
  Vec3 from, to;

  Vec3 at(double t) const { return combine(1.0 - t, from, t, to); }
  // Its shadow in the view plane.
  Segment flat() const { return {{from.x, from.y, 0.0}, {to.x, to.y, 0.0}}; }
};

inline double clamped_to_one(double t) {
  return t > 0.0 ? (t < 1.0 ? t : 1.0) : 0.0;
}

// Parameters of the closest points of two segments, and the square of their distance.
struct ClosestPoints {
  double first, second;
  double squared;
};

// The closest points of a segment and a point.
inline ClosestPoints closest_points(const Segment &a, const Vec3 &point) {
  const Vec3 u = a.to - a.from;
  const double uu = dot(u, u);
  const double s = uu > 0.0 ? clamped_to_one(dot(u, point - a.from) / uu) : 0.0;
  const Vec3 gap = point - a.at(s);
  return {s, 0.0, dot(gap, gap)};
}
// The closest points of two segments; of parallel segments one of the closest pairs.
inline ClosestPoints closest_points(const Segment &a, const Segment &b) {
  const Vec3 u = a.to - a.from;
  const Vec3 v = b.to - b.from;
  const Vec3 r = b.from - a.from;
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const double ur = dot(u, r);
  const double vr = dot(v, r);
  // The closest points of the lines have s uu - t uv = ur and s uv - t vv = vr. Then s is moved into [0, 1], and t to
  // the closest point of that; then s again, as t was moved into [0, 1], too.
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 0.0 ? clamped_to_one((ur * vv - uv * vr) / determinant) : 0.0;
  const double t = vv > 0.0 ? clamped_to_one((s * uv - vr) / vv) : 0.0;
  s = uu > 0.0 ? clamped_to_one((ur + t * uv) / uu) : 0.0;
  const Vec3 gap = b.at(t) - a.at(s);
  return {s, t, dot(gap, gap)};
}

// A ball in view coordinates.
struct PlacedBall {
  Vec3 centre;
  double r;
};

// A stick is painted as strands, parts of its front that run along it side by side. A stick of several strands is
// thicker.
enum class StickStrands : uint32_t {
  one = 0,    // all of the front
  two = 1,    //
  three = 2,  //
  dashed = 3  // two, the right one dashed: right as seen from the ball that was named first
};
inline constexpr double radius_of_several = 1.5;  // the radius of a stick of several strands, in that of the others

// A strand between its two sides; these are given in radii to the left of the axis, as seen from the foot.
struct Strand {
  double left, right;
  bool dashed;

  double middle() const { return 0.5 * (left + right); }
  double half() const { return 0.5 * (left - right); }
};
struct StrandList {
  Strand strand[3];
  uint32_t count;
};
// The number of dashes. They are as long as the gaps between them, and no dash is in both halves of a stick. The disc
// of the nearer ball covers them.
inline constexpr uint32_t dashes = 4;

struct Stick {
  Vec3 foot;           // the centre of the farther ball
  Vec3 axis;           // of length 1, towards the nearer ball
  double e[2];         // of length 1, the axis as it is seen
  double seen;         // h
  double radius;       // of the cylinder
  double length;       // between the centres
  double first, last;  // positions of the junction circles along the axis, from the foot
  uint32_t ball[2];    // the farther and the nearer one
  uint32_t caller;     // the caller's number
  uint32_t parts;      // 2: each half belongs to its ball. 1: all of it belongs to the ball that was named first. 0:
                       // it is inside its balls, which meet
  uint32_t owner[2];   // the balls that the parts belong to
  uint32_t turned;     // 1 if the caller named the nearer ball first, else 0
  StickStrands strands;
  bool inside;  // whether it was inside its balls before they were moved

  // The position at which the halves meet: the middle between the junction circles.
  double middle() const { return 0.5 * (first + last); }
  // The caller's number of a part: 0 for the ball that was named first, 1 for the other; 0 for a whole stick.
  uint32_t half_of(uint32_t part) const { return parts == 2 ? part ^ turned : 0; }
  double begin_of(uint32_t part) const { return part == 0 ? first : middle(); }
  double end_of(uint32_t part) const { return part + 1 == parts ? last : middle(); }

  StrandList strand_list() const {
    switch (strands) {
      case StickStrands::two:
        return {{{1.0, 0.28, false}, {-0.28, -1.0, false}}, 2};
      case StickStrands::three:
        return {{{1.0, 0.58, false}, {0.21, -0.21, false}, {-0.58, -1.0, false}}, 3};
      case StickStrands::dashed:
        return {{{1.0, 0.28, turned != 0}, {-0.28, -1.0, turned == 0}}, 2};
      default:
        return {{{1.0, -1.0, false}}, 1};
    }
  }
  // The circle of a strand at position s, as of a thinner stick beside the axis in the view plane.
  ProjectedEllipse circle_of(const Strand &strand, double s) const {
    ProjectedEllipse circle = circle_at(s);
    for (int k = 0; k < 2; ++k) {
      circle.centre[k] += strand.middle() * circle.major[k];
      circle.major[k] *= strand.half();
      circle.minor[k] *= strand.half();
    }
    return circle;
  }
  // The position at which a strand leaves the ball at its foot, in the mean over its circle.
  double begin_of(const Strand &strand, double foot_radius) const {
    const double squared = strand.middle() * strand.middle() + strand.half() * strand.half();
    return std::sqrt(foot_radius * foot_radius - squared * radius * radius);
  }
  Vec3 on_axis(double s) const { return combine(1.0, foot, s, axis); }
  Segment axis_between(double from, double to) const { return {on_axis(from), on_axis(to)}; }
  Segment axis_of(uint32_t part) const { return axis_between(begin_of(part), end_of(part)); }

  // The circle at position s as it appears in the view plane. Its front half is t in [0, pi].
  ProjectedEllipse circle_at(double s) const {
    const Vec3 centre = on_axis(s);
    const double rise = radius * axis.z;
    return {{centre.x, centre.y}, {-radius * e[1], radius * e[0]}, {-rise * e[0], -rise * e[1]}};
  }
};

// The stick from the farther ball, `foot`, to the nearer one, `top`. The balls have to be thicker than the stick, and
// their centres different. If first >= last in the result, the stick is inside the balls.
inline Stick stick_between(const PlacedBall &foot, const PlacedBall &top, double radius) {
  Stick stick{};
  const Vec3 d = top.centre - foot.centre;
  stick.foot = foot.centre;
  stick.radius = radius;
  stick.length = std::sqrt(dot(d, d));
  stick.axis = 1.0 / stick.length * d;
  if (stick.axis.z < 0.0) stick.axis.z = 0.0;  // of equal depths, up to rounding
  stick.seen = std::sqrt(stick.axis.x * stick.axis.x + stick.axis.y * stick.axis.y);
  stick.e[0] = stick.seen > 0.0 ? stick.axis.x / stick.seen : 1.0;
  stick.e[1] = stick.seen > 0.0 ? stick.axis.y / stick.seen : 0.0;
  stick.first = std::sqrt((foot.r - radius) * (foot.r + radius));
  stick.last = stick.length - std::sqrt((top.r - radius) * (top.r + radius));
  return stick;
}

// Whether the nearer ball certainly hides all of a part of a stick: the part lies within the ball's disc. Then the ball
// has no bite either. Also right for sticks that point at the viewer, whose e means nothing.
inline bool hidden_by_top(const Stick &stick, uint32_t part, double top_radius) {
  return (stick.length - stick.begin_of(part)) * stick.seen + stick.radius <= top_radius;
}

struct StickLimits {
  uint32_t balls = 0;  // of the model
  uint32_t sticks = 0;
  uint32_t pairs = 0;  // pairs of balls and parts of sticks that may cover each other; two for balls that meet
  uint32_t edges = 0;  // edges of the map, if there is no drawing order or a map is wanted
};

// Limits that suffice for most molecules whose balls and sticks have a drawing order. Status::range if one would be
// larger than max_count.
constexpr Status default_limits(uint32_t balls, StickLimits &limits) {
  if (balls > (max_count - 64) / 64) return Status::range;
  limits = {balls, 2 * balls, 64 * balls + 64, 0};
  return Status::ok;
}

// Why bodies cannot be drawn, or have no drawing order. Two numbers of the caller's come with it, as said here.
enum class StickConflict : uint32_t {
  none = 0,
  balls_meet = 1,     // two balls: no order
  no_ball = 2,        // a stick, and a ball that does not exist
  same_ends = 3,      // two sticks between the same balls; or one stick twice, whose ends are one ball
  thin_ball = 4,      // a stick, and a ball at its end that is not thicker
  sharp_angle = 5,    // two sticks that meet outside the ball where both end
  sticks_meet = 6,    // two sticks
  stick_in_ball = 7,  // a stick, and a ball that it runs into
  cycle = 8,          // a stick of a cycle, and how many balls and parts of sticks the cycle has: no order
};

struct StickViolation {
  StickConflict conflict = StickConflict::none;
  uint32_t first = no_id, second = no_id;
};

// The bite of a stick: the part that it cuts off from the disc of the ball at its nearer end. Instead of the silhouette
// between the angles middle - half and middle + half the junction circle from t = from to pi - from bounds the disc.
struct StickBite {
  double middle, half;
  double from;
  uint32_t stick;
};

// A ball, or a part of a stick, as it is painted.
struct StickPath {
  uint32_t ball;   // in grid order: the ball itself, or the one that the part belongs to
  uint32_t stick;  // no_id for a ball
  uint32_t part;
};

struct StickView {
  ViewFrame frame;
  Span<PlacedBall> balls;  // grid order
  FixedVector<Stick> sticks;
  Span<uint32_t> first_bite;     // [balls + 1]
  FixedVector<StickBite> bites;  // ball after ball, counter-clockwise
  FixedVector<StickPath> paths;  // in drawing order

  void carve(Workspace &workspace, const StickLimits &limits) {
    balls = workspace.take<PlacedBall>(limits.balls);
    sticks = FixedVector<Stick>(workspace.take<Stick>(limits.sticks));
    first_bite = workspace.take<uint32_t>(static_cast<uint64_t>(limits.balls) + 1);
    bites = FixedVector<StickBite>(workspace.take<StickBite>(limits.sticks));
    paths = FixedVector<StickPath>(workspace.take<StickPath>(limits.balls + 2 * static_cast<uint64_t>(limits.sticks)));
  }
  void clear() {
    sticks.clear();
    bites.clear();
    paths.clear();
  }
  Span<const StickBite> bites_of(uint32_t ball) const {
    return bites.items().part(first_bite[ball], first_bite[ball + 1]);
  }
};

}  // namespace hsp
