#include "surface/surface_positions.hpp"

#include "core/sorting.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/actual_balls.hpp"
#include "surface/saddle.hpp"
#include "surface/surface_areas.hpp"

namespace hsp {
namespace {

constexpr Vec3 none{0.0, 0.0, 0.0};

Vec3 towards(const BallSet &balls, const Position &position, uint32_t ball) {
  return unit(balls.difference(position.ball, ball) - position.offset, none);
}

// The cap that another probe cuts out of a probe's sphere, scaled to the unit sphere: axis, a unit vector, and height.
struct ProbeCap {
  Vec3 axis;
  double height;

  // The cap for the vector `to` from one probe's centre to the other's.
  ProbeCap(const Vec3 &to, double p) {
    // Squares of the shortest ways are below the range of doubles.
    constexpr double least = 0x1p-400;
    const double length = std::sqrt(dot(to, to));
    axis = unit(length > least ? to : 1.0 / least * (1.0 / least * to), none);
    height = length / (2 * p);
    if (height > 1.0) height = 1.0;
  }
  // Computes the cap's axis anew if both vertices of a crease are on one circle: at right angles to the circle's axis
  // and to the vector from the circle's middle to that of the vertices. False if they are not on one circle, or if it
  // is not known which vertex is the first counter-clockwise about the circle's axis. order: 1 if it is this one, -1 if
  // the one across, 0 if positions have to tell.
  bool turn(const BallSet &balls, const Boundary &boundary, const Position &from, uint32_t vertex, uint32_t across,
            double order) {
    uint32_t ball[2];
    if (!find_common_circle(boundary, vertex, across, ball)) return false;
    const CirclePosition circle = position_of_circle(balls, ball[0], ball[1]);
    const double p = static_cast<double>(balls.probe_steps);
    const Vec3 out = combine(1.0, difference(balls, circle.centre, from), p * height, axis);
    const Vec3 turned = unit(cross(circle.axis, out), none);
    const double cosine = order == 0.0 ? dot(turned, axis) : order;
    if (!(std::fabs(cosine) > 0.75)) return false;
    axis = cosine > 0.0 ? turned : -turned;
    return true;
  }
  // The point where this cap's circle leaves the other cap.
  Vec3 exit_of(const ProbeCap &other) const {
    const CircleCrossing<Vec3, double> crossing(axis, height, other.axis, other.height);
    const double D = crossing.discriminant(1.0);
    return crossing.nn > 0.0 ? crossing.point(D > 0.0 ? std::sqrt(D) : 0.0) : axis;
  }
};

Position position_of_cusp(const BallSet &balls, const CuspedCircles &cusped, uint32_t cusp) {
  const uint32_t a = cusped.ball(cusp / 2, 0), b = cusped.ball(cusp / 2, 1);
  const CirclePosition position = position_of_circle(balls, a, b);
  const double along = half_way_between_cusps(balls, a, b);
  return {position.centre.ball, position.centre.offset + (cusp % 2 == 0 ? -along : along) * position.axis};
}

// The name of the corner of three creases where an arc of a cut patch begins: of the two points, the one where the
// arc's crease leaves the probe of the arc before.
BorderPoint name_of_start(uint32_t vertex, uint32_t across, uint32_t before) {
  BorderPoint corner{BorderPoint::Kind::corner, 1, {vertex, across, before}};
  sort_three(corner.id[0], corner.id[1], corner.id[2]);
  const bool is_low = vertex < across;
  if (ActualBalls::starts_at_corner(corner, is_low ? vertex : across, is_low ? across : vertex) != is_low)
    corner.sign = -1;
  return corner;
}

// In doubles the corner is where the circle of the arc leaves the cap of the arc before it.
Position position_of_crease_corner(const SurfaceMap &map, uint32_t arc) {
  const BallSet &balls = map.balls();
  const CutPatches &cut = map.surface().cut_patches();
  const uint32_t vertex = cut.vertex_of_arc(arc), across = cut.arc(arc).across,
                 before = cut.arc(cut.previous(arc)).across;
  const Position centre = position_of_vertex(balls, map.boundary(), vertex);
  const double p = static_cast<double>(balls.probe_steps);
  Vec3 way;
  if (!map.surface().is_of_actual_balls() ||
      !ActualBalls(balls, map.boundary()).find_way(vertex, name_of_start(vertex, across, before), way)) {
    const auto cap_of = [&](uint32_t other) {
      return ProbeCap(difference(balls, centre, position_of_vertex(balls, map.boundary(), other)), p);
    };
    way = p * cap_of(across).exit_of(cap_of(before));
  }
  return {centre.ball, centre.offset + way};
}

// The convex patch is the face, shrunk towards the centre of its ball.
ArcPosition position_of_rim(const BallSet &balls, uint32_t own, uint32_t other, double angle) {
  const bool first = balls.given_before(own, other);
  const CirclePosition circle = position_of_circle(balls, first ? own : other, first ? other : own);
  const double shrinkage = shrinkage_of_faces(balls, own);
  const Vec3 from_own = balls.difference(own, circle.centre.ball) + circle.centre.offset;
  return {{own, shrinkage * from_own}, circle.axis, shrinkage * circle.radius, angle};
}

ArcPosition position_of_side(const SurfaceMap &map, const SurfaceEdge &edge) {
  const BallSet &balls = map.balls();
  const Boundary &boundary = map.boundary();
  const Position centre = position_of_vertex(balls, boundary, boundary.half_edge(edge.source).vertex);
  const uint32_t own = boundary.ball_of(edge.source);
  const uint32_t other = boundary.half_edge(edge.source).circle;
  const bool first = map.side_of(edge.element()) == 0;
  const double p = static_cast<double>(balls.probe_steps);
  const Vec3 from = towards(balls, centre, first ? own : other);
  const Vec3 to = towards(balls, centre, first ? other : own);
  const Vec3 normal = cross(from, to);
  double angle = arc_tangent(std::sqrt(dot(normal, normal)), dot(from, to));
  if (map.cusped_circle_of(edge.element()) != no_id) {
    const uint32_t ball = (edge.part == 0) == first ? own : other;
    const CircleGeometry circle(balls, ball, ball == own ? other : own);
    const double to_cusp = half_way_between_cusps(balls, own, other);
    angle = arc_tangent(circle.height, circle.radius) - arc_tangent(to_cusp, circle.radius);
    if (!(angle > 0.0)) angle = 0.0;
  }
  Vec3 axis = unit(normal, none);
  // Where the probe stands between the balls, or all but, a normal of few digits is no longer perpendicular to the
  // side.
  if (dot(normal, normal) < 0x1p-40) axis = unit(normal - dot(normal, from) * from, perpendicular_to(from));
  return {centre, axis, p, angle};
}

}  // namespace

Position position_of_corner(const SurfaceMap &map, uint32_t corner) {
  const BallSet &balls = map.balls();
  if (corner >= map.first_crease_corner()) {
    const RankedBits &arcs = map.surface().cut_patches().crease_corners();
    return position_of_crease_corner(map, arcs.member(corner - map.first_crease_corner()));
  }
  if (corner >= map.first_cusp()) {
    return position_of_cusp(balls, map.surface().cusped_circles(), corner - map.first_cusp());
  }
  const Position vertex = position_of_vertex(balls, map.boundary(), corner / 3);
  const uint32_t ball = map.boundary().vertex(corner / 3).ball[corner % 3];
  return {vertex.ball, vertex.offset + static_cast<double>(balls.probe_steps) * towards(balls, vertex, ball)};
}

ArcPosition position_of_edge(const SurfaceMap &map, uint32_t edge) {
  const BallSet &balls = map.balls();
  const Boundary &boundary = map.boundary();
  const SurfaceEdge record = map.edge(edge);
  if (record.kind == SurfaceEdgeKind::side) return position_of_side(map, record);
  if (record.kind != SurfaceEdgeKind::crease) {
    const LoopElement e = record.element();
    return position_of_rim(balls, boundary.ball_of(e), boundary.neighbour(e),
                           e.is_circle() ? 2 * pi : angle_of_arc(balls, boundary, e.half_edge()));
  }
  const CutPatches &cut = map.surface().cut_patches();
  const PatchArc &arc = cut.arc(record.source);
  const uint32_t vertex = cut.vertex_of_arc(record.source);
  const Position centre = position_of_vertex(balls, boundary, vertex);
  const double p = static_cast<double>(balls.probe_steps);
  Vec3 to = difference(balls, centre, position_of_vertex(balls, boundary, arc.across));
  if (map.surface().is_of_actual_balls()) ActualBalls(balls, boundary).find_way_to_vertex(vertex, arc.across, to);
  const ProbeCap cap(to, p);
  return {{centre.ball, centre.offset + p * cap.height * cap.axis},
          cap.axis,
          p * std::sqrt((1.0 - cap.height) * (1.0 + cap.height)),
          arc.angle};
}

bool find_common_circle(const Boundary &boundary, uint32_t v, uint32_t w, uint32_t (&ball)[2]) {
  uint32_t found = 0;
  for (const uint32_t b : boundary.vertex(v).ball) {
    if (!boundary.vertex(w).has(b)) continue;
    if (found == 2) return false;
    ball[found++] = b;
  }
  return found == 2;
}

// Computed in doubles, as it is called in tasks, which have little stack. If the vertices beside a crease are near each
// other, the vector between them gives half the digits of the crease's axis or fewer. If they are on one circle, the
// plane of the crease contains that circle's axis, which gives more digits. A cusp at an end of the crease is found
// from its circle, too, as the planes of crease and side, which meet there, may nearly coincide.
VertexCrease crease_on_probe(const SurfaceMap &map, uint32_t arc) {
  // Below this height vectors between vertices have too few digits for the axis.
  constexpr double low = 0x1p-12;
  const BallSet &balls = map.balls();
  const Boundary &boundary = map.boundary();
  const CutPatches &cut = map.surface().cut_patches();
  const double p = static_cast<double>(balls.probe_steps);
  const uint32_t vertex = cut.vertex_of_arc(arc), next = cut.arc(arc).next, across = cut.arc(arc).across;
  const Position centre = position_of_vertex(balls, boundary, vertex);
  const auto way_to = [&](const Position &from, uint32_t other) {
    return difference(balls, from, position_of_vertex(balls, boundary, other));
  };
  ProbeCap own(way_to(centre, across), p);
  VertexCrease crease{{own.axis, own.height, cut.arc(arc).angle, none}, true};
  if (next == arc) {
    if (2 * own.height < coincident_distance) crease.arc.height = 0.0;
    return crease;
  }
  const uint32_t start_cusp = map.cusp_of(cut.arc(arc).corner), end_cusp = map.cusp_of(cut.arc(next).corner);
  const bool has_cusps = start_cusp != no_id && end_cusp != no_id;
  if (own.height < low) {
    // A crease between two cusps lies across the circle's axis from its vertices.
    const double order = !has_cusps || start_cusp != (end_cusp ^ 1) ? 0.0 : end_cusp % 2 == 0 ? -1.0 : 1.0;
    const bool is_turned = own.turn(balls, boundary, centre, vertex, across, order);
    crease.is_certain = is_turned || 2 * own.height >= coincident_distance;
    crease.arc.axis = own.axis;
  }
  if (!crease.is_certain) {
    crease.arc.height = 0.0;
    return crease;
  }
  // An end of the crease: a cusp, or the corner with another crease, which comes before it or behind it in the loop.
  const auto end_at = [&](uint32_t cusp, uint32_t other, bool is_start) {
    if (cusp != no_id) {
      return 1.0 / p * difference(balls, centre, position_of_cusp(balls, map.surface().cusped_circles(), cusp));
    }
    const uint32_t third = cut.arc(other).across;
    ProbeCap cap(way_to(centre, third), p);
    if (cap.height < low) {
      cap.turn(balls, boundary, centre, vertex, third, 0.0);
    } else if (own.height >= low) {
      // The two other vertices may be near each other. Then the planes of both creases nearly coincide. The bisector
      // plane of those two vertices meets each of them in the same line, and gives it precisely.
      const Position opposite = position_of_vertex(balls, boundary, across);
      ProbeCap between(way_to(opposite, third), p);
      if (between.height < low && between.turn(balls, boundary, opposite, across, third, 0.0)) {
        cap.height = dot(between.axis, 1.0 / p * difference(balls, centre, opposite)) + between.height;
        cap.axis = between.axis;
      }
    }
    return is_start ? own.exit_of(cap) : cap.exit_of(own);
  };
  const Vec3 start = end_at(start_cusp, cut.previous(arc), true);
  crease.arc.chord = end_at(end_cusp, next, false) - start;
  return crease;
}

}  // namespace hsp
