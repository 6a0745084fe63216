// The scene of balls and sticks: the names and points of the curves that bound what is seen of them.
//
// Bodies are numbered as in stick_sweep.hpp: balls by their ids, then part p of stick k as balls + 2 k + p. A curve is
// named like an edge of a visibility map, by a body and a nearer one:
//   ball, none    the silhouette, at the angle t
//   part, none    the two lines of the contour. At the position s along the axis the right line has t = s / length, the
//                 left one t = -s / length. So the part is always on the left
//   ball, ball    their crease, with the nearer one on the left
//   ball, part    the half circle in which a stick leaves the ball at its foot, with the stick on the left
//   part, part    the half circle between the halves of a stick, with the nearer half on the left
//   part, ball    the half circle in which a stick enters the ball at its top, as far as it is above the ball's centre,
//                 with the ball on the left
// On half circles t = 0 is in the middle, and t increases from the left of the stick to its right.
#pragma once

#include "maps/ball_scene.hpp"
#include "maps/map_paths.hpp"
#include "maps/stick_view.hpp"

namespace hsp {

// The points start + t step.
struct StraightCurve {
  Vec3 start, step;

  Vec3 at(double t) const { return combine(1.0, start, t, step); }
};

// The front of a stick over a point of the view plane.
struct StickFront {
  bool exists;    // false beside the stick, and beyond the centres of its balls
  double z, s;    // its height, and the position along the axis
  double beside;  // how far the point is inside the contour: the radius less the distance from the axis as it is seen
};

inline StickFront front_of(const Stick &stick, double x, double y) {
  const double dx = x - stick.foot.x;
  const double dy = y - stick.foot.y;
  const double a = dx * stick.e[0] + dy * stick.e[1];
  const double w = std::fabs(dy * stick.e[0] - dx * stick.e[1]);
  const double beside = stick.radius - w;
  if (!(beside > 0.0)) return {false, 0.0, 0.0, beside};
  const double v = std::sqrt(beside * (stick.radius + w));
  const double s = (a + stick.axis.z * v) / stick.seen;
  return {s > 0.0 && s < stick.length, stick.foot.z + (a * stick.axis.z + v) / stick.seen, s, beside};
}

enum class StickRing : uint32_t { foot = 0, middle = 1, top = 2 };

// A scene of balls, in grid order, and of sticks.
struct StickScene : BallScene {
  Span<const Stick> sticks;
  Span<const uint32_t> order;  // the order of faces: bodies by their depths

  uint32_t bodies() const { return balls.size() + 2 * sticks.size(); }
  uint32_t slot_of(uint32_t body) const { return body; }
  // The ball in whose colour a body is painted: itself, or the owner of a part of a stick.
  uint32_t ball_of(uint32_t body) const { return is_ball(body) ? body : stick_at(body).owner[part_of(body)]; }
  uint32_t body_in_order(uint32_t k) const { return order[k]; }
  double largest() const {
    double largest = BallScene::largest();
    for (const Stick &stick : sticks) largest = stick.length > largest ? stick.length : largest;
    return largest;
  }

  bool is_ball(uint32_t body) const { return body < balls.size(); }
  uint32_t stick_of(uint32_t body) const { return (body - balls.size()) / 2; }
  uint32_t part_of(uint32_t body) const { return (body - balls.size()) % 2; }
  uint32_t body_of(uint32_t stick, uint32_t part) const { return balls.size() + 2 * stick + part; }
  const Stick &stick_at(uint32_t body) const { return sticks[stick_of(body)]; }
  bool is_straight(uint32_t body, uint32_t nearer) const { return nearer == no_id && !is_ball(body); }
  bool is_straight(const MapEdge &edge) const { return is_straight(edge.body, edge.nearer); }

  StickRing ring_of(uint32_t body, uint32_t nearer) const {
    return is_ball(body) ? StickRing::foot : is_ball(nearer) ? StickRing::top : StickRing::middle;
  }

  // The curve of this name, which is not the contour of a stick.
  RoundCurve round_curve(uint32_t body, uint32_t nearer) const {
    if (nearer == no_id || (is_ball(body) && is_ball(nearer))) return BallScene::round_curve(body, nearer);
    const Stick &stick = stick_at(is_ball(body) ? nearer : body);
    const StickRing ring = ring_of(body, nearer);
    const double s = ring == StickRing::foot ? stick.first : ring == StickRing::top ? stick.last : stick.middle();
    const double up = -stick.axis.z;
    return {stick.on_axis(s), stick.radius * Vec3{up * stick.e[0], up * stick.e[1], stick.seen},
            stick.radius * Vec3{stick.e[1], -stick.e[0], 0.0}};
  }

  static StraightCurve line_of(const Stick &stick, bool left) {
    const double side = left ? stick.radius : -stick.radius;
    return {stick.foot + side * Vec3{-stick.e[1], stick.e[0], 0.0}, (left ? -stick.length : stick.length) * stick.axis};
  }

  Vec3 at(uint32_t body, uint32_t nearer, double t) const {
    return is_straight(body, nearer) ? line_of(stick_at(body), t < 0.0).at(t) : round_curve(body, nearer).at(t);
  }

  EdgeCurve curve(const MapEdge &edge, const MapVertex &v, const MapVertex &w) const {
    if (!is_straight(edge)) return round_curve(edge.body, edge.nearer).part(edge);
    const Vec3 from{v.x, v.y, 0.0};
    const Vec3 to{w.x, w.y, 0.0};
    return {EdgeEllipse(combine(0.5, from, 0.5, to), 0.5 * (to - from), Vec3{}), -pi, 0.0};
  }
  double edge_parameter(const MapEdge &edge, double t) const {
    return is_straight(edge) ? edge.from + 0.5 * (1.0 + sin_cos(t).cosine) * (edge.to - edge.from) : t;
  }
  Vec3 middle_of(const MapEdge &edge, const MapVertex &, const MapVertex &) const {
    return at(edge.body, edge.nearer, 0.5 * (edge.from + edge.to));
  }

  // The number of groups of corners: triple points by their first ball, then tangencies by theirs, then the ends of
  // half circles by their stick: first all at the foot, then all in the middle, then all at the top.
  uint32_t groups() const { return 2 * balls.size() + 3 * sticks.size(); }
  uint32_t group_of(StickRing ring, uint32_t stick) const {
    return 2 * balls.size() + static_cast<uint32_t>(ring) * sticks.size() + stick;
  }
  // Names the corner at an end of an arc that is no T; false if no corner is there.
  bool name(const MapArc &arc, uint32_t end, CornerName &name) const;
  MapVertexKind kind_of(const ArcEnd &end, const CornerName &name) const {
    const uint32_t first = group_of(StickRing::middle, 0);
    return name.group >= first && name.group - first < sticks.size() ? MapVertexKind::halves : end.kind;
  }

  // The parameter of a point of the view plane on the contour of a body; and the length of the contour per unit of the
  // parameter.
  double landing(uint32_t body, double x, double y) const {
    if (is_ball(body)) return BallScene::landing(body, x, y);
    const Stick &stick = stick_at(body);
    const double dx = x - stick.foot.x;
    const double dy = y - stick.foot.y;
    const double part = (dx * stick.e[0] + dy * stick.e[1]) / (stick.seen * stick.length);
    return dy * stick.e[0] - dx * stick.e[1] > 0.0 ? -part : part;
  }
  double contour_length(uint32_t body) const {
    return is_ball(body) ? BallScene::contour_length(body) : stick_at(body).length;
  }

  // A bound of the area of a body in the view plane, grown by a margin; of a half of a stick the rectangle around the
  // whole stick.
  double silhouette_area(uint32_t body, double margin) const {
    if (is_ball(body)) return BallScene::silhouette_area(body, margin);
    const Stick &stick = stick_at(body);
    const double half = stick.radius + margin;
    return 2 * half * (stick.length * stick.seen + 2 * half);
  }
  bool may_be_seen(uint32_t body, const Vec3 &p, double margin) const;
  double front_at(uint32_t body, double x, double y) const;
  // A lower bound of the distance from a point of the view plane to an edge that names the body first.
  double least_distance(uint32_t body, double x, double y) const {
    if (is_ball(body)) return BallScene::least_distance(body, x, y);
    return -front_of(stick_at(body), x, y).beside;
  }
  // Calls visit(body, x, y) with a point of each body that is seen there unless another one is before it. Ends with
  // false when visit returns false.
  template <class Visit>
  bool all_middles(Visit visit) const {
    if (!BallScene::all_middles(visit)) return false;
    for (uint32_t k = 0; k < sticks.size(); ++k) {
      const Stick &stick = sticks[k];
      for (uint32_t part = 0; part < stick.parts; ++part) {
        const Vec3 middle = stick.on_axis(0.5 * (stick.begin_of(part) + stick.end_of(part)));
        const double back = stick.radius * stick.axis.z;
        if (!visit(body_of(k, part), middle.x - back * stick.e[0], middle.y - back * stick.e[1])) return false;
      }
    }
    return true;
  }
};

// The map of balls and sticks. Its faces come farthest body first; the slot of a body is its number.
struct StickMap : SceneMap<StickScene> {
  bool exist = false;
  Span<uint32_t> first_loop;  // [owners] rank in loop_order of the first loop of each body that is seen

  // The functions of a source of paths (map_paths.hpp): one path for each visible body, with its loops in their order.
  const StickMap &map() const { return *this; }
  uint32_t owner_of(uint32_t path) const { return loops[loop_order[first_loop[path]]].owner; }
  template <class Visit>
  void visit_path(uint32_t path, Visit visit) const {
    const uint32_t owner = owner_of(path);
    for (uint32_t k = first_loop[path]; k < loops.size() && loops[loop_order[k]].owner == owner; ++k) {
      visit(loop_order[k]);
    }
  }
  static bool is_plain(const void *source, uint32_t path) {
    const StickMap &map = *static_cast<const StickMap *>(source);
    return !map.scene.is_ball(map.owner_of(path));
  }
  void carve(Workspace &workspace, const StickLimits &limits) {
    MapRecords::carve(workspace, limits.edges);
    first_loop = workspace.take<uint32_t>(limits.balls + 2 * static_cast<uint64_t>(limits.sticks));
  }
  void clear() {
    MapRecords::clear();
    exist = false;
    perturbation = 0.0;
  }
};

// The paths of a map. Each edge is a line of one path: a contour of its body's, a crease or half circle of the nearer
// body's. Lines between strands (strand_lines.hpp) are added. The map has to outlive the paths.
PaintedPaths paths_of(const StickMap &map);

// The silhouettes of a map, with the parameters of this file. The map has to outlive them.
SeenSilhouettes silhouettes_of(const StickMap &map);

}  // namespace hsp
