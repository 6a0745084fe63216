// The balls of a map: their curves, how these are named where they meet, and where a ball may be seen.
#pragma once

#include "core/sorting.hpp"
#include "maps/curves.hpp"
#include "maps/edge_geometry.hpp"
#include "maps/hidden_intervals.hpp"

namespace hsp {

// A point where arcs of several curves meet, by its bodies. group: one of the scene's; middle and last: further bodies,
// no_id if there are fewer; point: which of the two points with these bodies it is.
struct CornerName {
  uint32_t group, middle, last, point;
};

// Along a crease the triple point where it enters the third ball has one sign of the determinant of the balls and the
// point, the one where it leaves has the other; exchanging two of the balls changes the sign.
inline CornerName name_of_triple(const MapArc &arc, uint32_t end) {
  CornerName name{arc.ball, arc.nearer, arc.end[end].ball, end};
  if (sort_three(name.group, name.middle, name.last)) name.point ^= 1U;
  return name;
}

// The crease ends where the silhouette of the nearer ball begins, and the other way round: both have that ball on their
// left.
inline CornerName name_of_tangency(const MapArc &arc, uint32_t end) {
  const bool silhouette = arc.nearer == no_id;
  const uint32_t far = silhouette ? arc.end[end].ball : arc.ball;
  const uint32_t nearer = silhouette ? arc.ball : arc.nearer;
  const uint32_t point = silhouette ? 1 - end : end;
  return {far < nearer ? far : nearer, far < nearer ? nearer : far, no_id, point};
}

// A ball's extent in the view plane, grown by a margin.
inline double silhouette_area(const SeenBall &ball, double margin) {
  return pi * (ball.r + margin) * (ball.r + margin);
}

// Whether a point is no farther than a margin outside the disc of a ball, and behind its front.
inline bool may_be_seen(const SeenBall &ball, const Vec3 &p, double margin) {
  const double dx = p.x - ball.x;
  const double dy = p.y - ball.y;
  const double outer = ball.r + margin;
  return dx * dx + dy * dy <= outer * outer && depth_behind(p, ball) <= outer * outer - ball.r * ball.r;
}

// The height of a ball's front at a point at or near its disc; of the silhouette beside it.
inline double front_at(const SeenBall &ball, double x, double y) {
  const double dx = x - ball.x;
  const double dy = y - ball.y;
  const double squared = ball.r * ball.r - dx * dx - dy * dy;
  return squared > 0.0 ? ball.z + std::sqrt(squared) : ball.z;
}

struct BallScene {
  Span<const SeenBall> balls;  // nearest top first; their ids are those of bodies

  uint32_t bodies() const { return balls.size(); }
  uint32_t place_of(uint32_t ball) const { return balls[ball].ball; }
  uint32_t ball_of(uint32_t ball) const { return balls[ball].ball; }
  // The order of faces.
  uint32_t body_in_order(uint32_t k) const { return k; }
  double largest() const {
    double largest = 0.0;
    for (const SeenBall &ball : balls) largest = ball.r > largest ? ball.r : largest;
    return largest;
  }

  // A common vertex has the number of its group, and before all T.
  static constexpr bool corners_first = true;
  uint32_t groups() const { return balls.size(); }
  // Of an end of an arc that is no T; false if it is none.
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
  // The parameter of a point of the view plane on the silhouette of a ball, and how long the silhouette is per unit.
  double landing(uint32_t ball, double x, double y) const { return arc_tangent(y - balls[ball].y, x - balls[ball].x); }
  double contour_length(uint32_t ball) const { return balls[ball].r; }

  static constexpr bool is_straight(const MapEdge &) { return false; }
  // Of a parameter of an edge's curve below.
  static constexpr double edge_parameter(const MapEdge &, double t) { return t; }
  EdgeEllipse ellipse_of(const MapEdge &edge) const {
    const SeenBall &ball = balls[edge.ball];
    if (edge.is_silhouette()) return {{ball.x, ball.y, ball.z}, {ball.r, 0.0, 0.0}, {0.0, ball.r, 0.0}};
    const Crease crease(ball, balls[edge.nearer]);
    return {crease.m, crease.rho * crease.a, crease.rho * crease.b};
  }
  EdgeCurve curve(const MapEdge &edge, const MapVertex &, const MapVertex &) const {
    return {ellipse_of(edge), edge.from, edge.to};
  }
  // The middle of an edge on a silhouette, from its vertices where that is well conditioned, as it is sooner found so.
  Vec3 middle_of(const MapEdge &edge, const MapVertex &v, const MapVertex &w) const {
    const SeenBall &ball = balls[edge.ball];
    const double x = v.x + w.x - 2 * ball.x;
    const double y = v.y + w.y - 2 * ball.y;
    const double squared = x * x + y * y;
    if (squared < 0x1p-8 * ball.r * ball.r) return silhouette_point(ball, 0.5 * (edge.from + edge.to));
    const double part = (edge.to - edge.from > pi ? -ball.r : ball.r) / std::sqrt(squared);
    return {ball.x + part * x, ball.y + part * y, ball.z};
  }

  double silhouette_area(uint32_t ball, double margin) const { return hsp::silhouette_area(balls[ball], margin); }
  bool may_be_seen(uint32_t ball, const Vec3 &p, double margin) const {
    return hsp::may_be_seen(balls[ball], p, margin);
  }
  double front_at(uint32_t ball, double x, double y) const { return hsp::front_at(balls[ball], x, y); }
  // No edge that names the ball first is nearer to a point of the view plane.
  double least_distance(uint32_t ball, double x, double y) const {
    const double dx = x - balls[ball].x;
    const double dy = y - balls[ball].y;
    return std::sqrt(dx * dx + dy * dy) - balls[ball].r;
  }
  // Calls visit(body, x, y) for a point of each that is seen if nothing else is before it there.
  template <class Visit>
  bool all_middles(Visit visit) const {
    for (uint32_t k = 0; k < balls.size(); ++k) {
      if (balls[k].inside == 0 && !visit(k, balls[k].x, balls[k].y)) return false;
    }
    return true;
  }
};

}  // namespace hsp
