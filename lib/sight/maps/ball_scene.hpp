// The balls of a map: their curves, the names of the points where curves meet, and where a ball may be seen. Height is
// the view coordinate z, which grows towards the viewer.
//
// A map of balls consists of two kinds of curves, with these parameters t:
//
// Silhouette of a ball: the points of its sphere at the height of its centre, by their angle t. It runs
// counter-clockwise in the view plane, with the ball on the left.
//
// Crease of two balls, `far` and `near`: the points m + rho (a cos t + b sin t). a is the steepest direction in the
// plane of the circle and b a horizontal one, so that the height m_z + rise cos t is largest at t = 0 and falls to
// either side. The nearer ball is on the left. At most the part above the centre of the nearer ball is seen: the rest
// is covered by that ball. At the height of that centre the crease goes over into the silhouette of the nearer ball.
// Balls that only touch have no crease: rounding would decide where it ends.
#pragma once

#include "core/elementary.hpp"
#include "core/limits.hpp"
#include "core/sorting.hpp"
#include "core/vec3.hpp"
#include "maps/edge_geometry.hpp"
#include "maps/hidden_intervals.hpp"
#include "maps/scene_map.hpp"
#include "maps/seen_balls.hpp"

namespace hsp {

// How deep a point is behind the front of a ball. Above the centre: the square of the radius less that of the distance
// from the centre; below it: the same with the distance in the view plane. Negative if the point is not behind.
inline double depth_behind(const Vec3 &point, const SeenBall &ball) {
  const double dz = point.z - ball.z;
  const double squared = ball.squared_height(point.x, point.y);
  return dz > 0.0 ? squared - dz * dz : squared;
}

inline Vec3 silhouette_point(const SeenBall &ball, double t) {
  const SinCos at = sin_cos(t);
  return {ball.x + ball.r * at.cosine, ball.y + ball.r * at.sine, ball.z};
}

struct Crease {
  Vec3 m{}, a{}, b{};  // a and b of length 1
  double rho = 0.0;
  double rise = 0.0;
  double end = 0.0;  // the part |t| <= end may be seen; pi for the whole circle
  bool exists = false;

  Crease(const SeenBall &far, const SeenBall &near) {
    const Vec3 d{near.x - far.x, near.y - far.y, near.z - far.z};
    const double squared = dot(d, d);
    const double sum = far.r + near.r;
    const double difference = far.r - near.r;
    if (squared >= sum * sum * (1.0 - touching) || squared <= difference * difference) return;
    const double distance = std::sqrt(squared);
    const double height = 0.5 * (distance + difference * sum / distance);
    const double rho_squared = (far.r - height) * (far.r + height);
    if (!(rho_squared > 0.0)) return;
    rho = std::sqrt(rho_squared);
    const Vec3 n{d.x / distance, d.y / distance, d.z / distance};
    m = combine(1.0, {far.x, far.y, far.z}, height, n);
    const double slope = std::sqrt(n.x * n.x + n.y * n.y);
    a = slope > 0.0 ? Vec3{-n.z * (n.x / slope), -n.z * (n.y / slope), slope} : Vec3{1.0, 0.0, 0.0};
    b = slope > 0.0 ? Vec3{n.y / slope, -n.x / slope, 0.0} : Vec3{0.0, 1.0, 0.0};
    rise = rho * slope;
    const double needed = near.z - m.z;
    const double reach = rise * (1.0 - touching);
    if (needed >= reach) return;
    end = needed <= -reach ? pi : arc_tangent(std::sqrt((rise - needed) * (rise + needed)), needed);
    exists = true;
  }

  bool is_whole() const { return end == pi; }
  Vec3 at(const SinCos &t) const { return combine(1.0, m, 1.0, combine(rho * t.cosine, a, rho * t.sine, b)); }
  Vec3 at(double t) const { return at(sin_cos(t)); }
};

// The name of a point where arcs of several curves meet. group: one of the scene's groups, which stands for the first
// body; middle, last: further bodies, no_id if there are fewer; point: which of the two points of these bodies it is.
struct CornerName {
  uint32_t group, middle, last, point;
};

// A crease enters the third ball at one triple point and leaves it at another. The sign of the determinant of the three
// balls and the point is different at these two. Exchanging two of the balls changes the sign, too.
inline CornerName name_of_triple(const MapArc &arc, uint32_t end) {
  CornerName name{arc.body, arc.nearer, arc.end[end].body, end};
  if (sort_three(name.group, name.middle, name.last)) name.point ^= 1U;
  return name;
}

// The end of the crease is the beginning of the silhouette of the nearer ball, and the other way round: both have that
// ball on their left.
inline CornerName name_of_tangency(const MapArc &arc, uint32_t end) {
  const bool silhouette = arc.nearer == no_id;
  const uint32_t far = silhouette ? arc.end[end].body : arc.body;
  const uint32_t nearer = silhouette ? arc.body : arc.nearer;
  const uint32_t point = silhouette ? 1 - end : end;
  return {far < nearer ? far : nearer, far < nearer ? nearer : far, no_id, point};
}

// The points middle + cos t first + sin t second.
struct RoundCurve {
  Vec3 middle, first, second;

  Vec3 at(double t) const {
    const SinCos at = sin_cos(t);
    return combine(1.0, middle, 1.0, combine(at.cosine, first, at.sine, second));
  }
  EdgeCurve part(const MapEdge &edge) const { return {EdgeEllipse(middle, first, second), edge.from, edge.to}; }
};

struct BallScene {
  Span<const SeenBall> balls;  // highest top first; their indices are the ids of bodies

  uint32_t bodies() const { return balls.size(); }
  uint32_t slot_of(uint32_t ball) const { return balls[ball].ball; }
  uint32_t ball_of(uint32_t ball) const { return balls[ball].ball; }
  // The body whose faces come at rank k.
  uint32_t body_in_order(uint32_t k) const { return k; }
  double largest() const {
    double largest = 0.0;
    for (const SeenBall &ball : balls) largest = ball.r > largest ? ball.r : largest;
    return largest;
  }

  // The number of groups of corners: a corner is in the group of its first ball.
  uint32_t groups() const { return balls.size(); }
  // Names the corner at an end of an arc that is no T; false if no corner is there.
  bool name(const MapArc &arc, uint32_t end, CornerName &name) const {
    const MapVertexKind kind = arc.end[end].kind;
    if (kind == MapVertexKind::plain) return false;
    name = kind == MapVertexKind::triple ? name_of_triple(arc, end) : name_of_tangency(arc, end);
    return true;
  }
  MapVertexKind kind_of(const ArcEnd &end, const CornerName &) const { return end.kind; }

  Vec3 at(uint32_t ball, uint32_t nearer, double t) const {
    return nearer == no_id ? silhouette_point(balls[ball], t) : Crease(balls[ball], balls[nearer]).at(t);
  }
  // The parameter of a point of the view plane on the silhouette of a ball; and the length of the silhouette per unit
  // of the parameter.
  double landing(uint32_t ball, double x, double y) const { return arc_tangent(y - balls[ball].y, x - balls[ball].x); }
  double contour_length(uint32_t ball) const { return balls[ball].r; }

  static constexpr bool is_straight(const MapEdge &) { return false; }
  // The parameter of at() for a parameter t of curve().
  static constexpr double edge_parameter(const MapEdge &, double t) { return t; }
  RoundCurve round_curve(uint32_t far, uint32_t nearer) const {
    const SeenBall &ball = balls[far];
    if (nearer == no_id) return {{ball.x, ball.y, ball.z}, {ball.r, 0.0, 0.0}, {0.0, ball.r, 0.0}};
    const Crease crease(ball, balls[nearer]);
    return {crease.m, crease.rho * crease.a, crease.rho * crease.b};
  }
  EdgeCurve curve(const MapEdge &edge, const MapVertex &, const MapVertex &) const {
    return round_curve(edge.body, edge.nearer).part(edge);
  }
  // The middle of an edge on a silhouette. Computed from its vertices if that is well conditioned, as it is faster.
  Vec3 middle_of(const MapEdge &edge, const MapVertex &v, const MapVertex &w) const {
    const SeenBall &ball = balls[edge.body];
    const double x = v.x + w.x - 2 * ball.x;
    const double y = v.y + w.y - 2 * ball.y;
    const double squared = x * x + y * y;
    if (squared < 0x1p-8 * ball.r * ball.r) return silhouette_point(ball, 0.5 * (edge.from + edge.to));
    const double part = (edge.to - edge.from > pi ? -ball.r : ball.r) / std::sqrt(squared);
    return {ball.x + part * x, ball.y + part * y, ball.z};
  }

  // The area of a ball's disc in the view plane, its radius grown by a margin.
  double silhouette_area(uint32_t ball, double margin) const {
    return pi * (balls[ball].r + margin) * (balls[ball].r + margin);
  }
  // Whether the front of a body may be seen at p: p is at most a margin outside the silhouette, and at most about so
  // much behind the front.
  bool may_be_seen(uint32_t body, const Vec3 &p, double margin) const {
    const SeenBall &ball = balls[body];
    const double dx = p.x - ball.x;
    const double dy = p.y - ball.y;
    const double outer = ball.r + margin;
    return dx * dx + dy * dy <= outer * outer && depth_behind(p, ball) <= outer * outer - ball.r * ball.r;
  }
  // The height of a body's front at a point at which it is seen, or near that; beside its disc that of its silhouette.
  double front_at(uint32_t body, double x, double y) const {
    const SeenBall &ball = balls[body];
    const double squared = ball.squared_height(x, y);
    return squared > 0.0 ? ball.z + std::sqrt(squared) : ball.z;
  }
  // A lower bound of the distance from a point of the view plane to an edge that names the ball first.
  double least_distance(uint32_t ball, double x, double y) const {
    const double dx = x - balls[ball].x;
    const double dy = y - balls[ball].y;
    return std::sqrt(dx * dx + dy * dy) - balls[ball].r;
  }
  // Calls visit(body, x, y) with a point of each body that is seen there unless another one is before it. Ends with
  // false when visit returns false.
  template <class Visit>
  bool all_middles(Visit visit) const {
    for (uint32_t k = 0; k < balls.size(); ++k) {
      if (balls[k].inside == 0 && !visit(k, balls[k].x, balls[k].y)) return false;
    }
    return true;
  }
};

struct MapLimits {
  uint32_t balls = 0;       // of the model
  uint32_t neighbours = 0;  // balls whose discs meet one ball's disc and whose tops are above its centre, at most
  uint32_t edges = 0;       // of the map
};

// Limits that suffice for most molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, MapLimits &limits) {
  if (balls > (max_count - 64) / 12) return Status::range;
  limits = {balls, balls < 256 ? balls : 256, 12 * balls + 64};
  return Status::ok;
}

// The visibility map of balls (Section 5.2). Faces come in the order of SeenBalls; the slot of a ball is its number in
// grid order.
using VisibilityMap = SceneMap<BallScene>;

}  // namespace hsp
