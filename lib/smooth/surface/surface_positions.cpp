#include "surface/surface_positions.hpp"

#include "core/sorting.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/actual_balls.hpp"
#include "surface/saddle.hpp"
#include "surface/surface_areas.hpp"

namespace hsp {
namespace {

Vec3 difference(const BallSet &balls, const Position &from, const Position &to) {
  return balls.difference(from.ball, to.ball) + (to.offset - from.offset);
}

// 0 if it has no direction.
Vec3 unit(const Vec3 &v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0.0 ? (1.0 / length) * v : Vec3{0.0, 0.0, 0.0};
}

Vec3 towards(const BallSet &balls, const Position &position, uint32_t ball) {
  return unit(balls.difference(position.ball, ball) - position.offset);
}

// The unit normal of the side that is opposite to a ball, away from this.
Vec3 beyond_side(const BallSet &balls, const VertexRecord &vertex, const Position &from, uint32_t slot) {
  const Vec3 normal =
      unit(cross(towards(balls, from, vertex.ball[(slot + 1) % 3]), towards(balls, from, vertex.ball[(slot + 2) % 3])));
  return dot(normal, towards(balls, from, vertex.ball[slot])) > 0.0 ? -normal : normal;
}

// The cap that another probe cuts out of the one at a position: unit vector and height on the unit sphere.
struct ProbeCap {
  Vec3 axis;
  double height;

  // That of the way to another probe.
  ProbeCap(const Vec3 &to, double p) {
    // Squares of the shortest ways are below the range of doubles.
    constexpr double least = 0x1p-400;
    const double length = std::sqrt(dot(to, to));
    axis = length > least ? unit(to) : unit(1.0 / least * (1.0 / least * to));
    height = length / (2 * p);
    if (height > 1.0) height = 1.0;
  }
  // That of an arc of the patch of a vertex at a position; a side's is the half of the sphere beyond it.
  ProbeCap(const BallSet &balls, const Boundary &boundary, const Position &from, uint32_t vertex, const PatchArc &arc) {
    if (!arc.is_side()) {
      const Vec3 to = difference(balls, from, position_of_vertex(balls, boundary, arc.across));
      *this = ProbeCap(to, static_cast<double>(balls.probe_steps));
      return;
    }
    axis = beyond_side(balls, boundary.vertex(vertex), from, arc.slot());
    height = 0.0;
  }
  // If both vertices of a crease are on one circle: its axis is at right angles to that circle's and to the way from
  // there to the middle of the vertices. False if they are not, or if nothing tells which vertex is the first of them
  // counter-clockwise about the circle's axis: `order` is 1 if it is this one, -1 if the one across, 0 if positions
  // have to say.
  bool turn(const BallSet &balls, const Boundary &boundary, const Position &from, uint32_t vertex, uint32_t across,
            double order) {
    uint32_t ball[2];
    if (!find_common_circle(boundary, vertex, across, ball)) return false;
    const CirclePosition circle = position_of_circle(balls, ball[0], ball[1]);
    const double p = static_cast<double>(balls.probe_steps);
    const Vec3 out = combine(1.0, difference(balls, circle.centre, from), p * height, axis);
    const Vec3 turned = unit(cross(circle.axis, out));
    const double cosine = order == 0.0 ? dot(turned, axis) : order;
    if (!(std::fabs(cosine) > 0.75)) return false;
    axis = cosine > 0.0 ? turned : -turned;
    return true;
  }
  // Where its circle leaves the other cap.
  Vec3 exit_of(const ProbeCap &other) const {
    const CircleCrossing<Vec3, double> crossing(axis, height, other.axis, other.height);
    const double D = crossing.discriminant(1.0);
    return crossing.nn > 0.0 ? crossing.point(D > 0.0 ? std::sqrt(D) : 0.0) : axis;
  }
};

Position position_of_cusp(const BallSet &balls, const CuspedCircles &cusped, uint32_t circle, uint32_t side) {
  const uint32_t a = cusped.ball(circle, 0), b = cusped.ball(circle, 1);
  const CirclePosition position = position_of_circle(balls, a, b);
  const double along = half_way_between_cusps(balls, a, b);
  return {position.centre.ball, position.centre.offset + (side == 0 ? -along : along) * position.axis};
}

// The number 2 k + s of the cusp that is this corner of a cut patch; no_id if it is none.
uint32_t cusp_of_corner(const Boundary &boundary, const Surface &surface, uint32_t corner) {
  const uint32_t first = 3 * boundary.vertex_count();
  return corner >= first && corner - first < 2 * surface.cusped_circles().count() ? corner - first : no_id;
}

// The name of the corner of three creases where an arc of a cut patch begins. Of two points the one where its crease
// leaves the probe of the arc before.
BorderPoint name_of_start(const Surface &surface, uint32_t vertex, uint32_t arc) {
  const CutPatches &cut = surface.cut_patches();
  const uint32_t across = cut.arc(arc).across;
  BorderPoint corner{BorderPoint::Kind::corner, 1, {vertex, across, cut.arc(cut.previous(arc)).across}};
  sort_three(corner.id[0], corner.id[1], corner.id[2], [](uint32_t a, uint32_t b) { return a < b; });
  const bool is_low = vertex < across;
  if (ActualBalls::starts_at_corner(corner, is_low ? vertex : across, is_low ? across : vertex) != is_low)
    corner.sign = -1;
  return corner;
}

// Where an arc of a cut patch begins, seen from the vertex on the unit sphere: there its circle leaves the cap of the
// arc before it.
Vec3 start_of_arc(const BallSet &balls, const Boundary &boundary, const CutPatches &cut, const Position &centre,
                  uint32_t vertex, uint32_t arc) {
  return ProbeCap(balls, boundary, centre, vertex, cut.arc(arc))
      .exit_of(ProbeCap(balls, boundary, centre, vertex, cut.arc(cut.previous(arc))));
}

Position position_of_crease_corner(const BallSet &balls, const Boundary &boundary, const Surface &surface,
                                   uint32_t arc) {
  const CutPatches &cut = surface.cut_patches();
  const uint32_t vertex = cut.piece(cut.piece_of_arc(arc)).vertex;
  const Position centre = position_of_vertex(balls, boundary, vertex);
  if (surface.is_of_actual_balls()) {
    Vec3 way;
    if (ActualBalls(balls, boundary).find_way(vertex, name_of_start(surface, vertex, arc), way))
      return {centre.ball, centre.offset + way};
  }
  return {centre.ball, centre.offset + static_cast<double>(balls.probe_steps) *
                                           start_of_arc(balls, boundary, cut, centre, vertex, arc)};
}

// The convex patch is the face, shrunk towards the centre of its ball.
ArcPosition position_of_rim(const BallSet &balls, uint32_t own, uint32_t other, double angle) {
  const bool first = balls.given_before(own, other);
  const CirclePosition circle = position_of_circle(balls, first ? own : other, first ? other : own);
  const double shrinkage = shrinkage_of_faces(balls, own);
  const Vec3 from_own = balls.difference(own, circle.centre.ball) + circle.centre.offset;
  return {{own, shrinkage * from_own}, circle.axis, shrinkage * circle.radius, angle};
}

ArcPosition position_of_side(const BallSet &balls, const Boundary &boundary, const SurfaceMap &map,
                             const SurfaceEdge &edge) {
  const Position centre = position_of_vertex(balls, boundary, boundary.half_edge(edge.source).vertex);
  const uint32_t own = boundary.ball_of(edge.source);
  const uint32_t other = boundary.half_edge(edge.source).circle;
  const bool first = map.side_of(edge.source) == 0;
  const double p = static_cast<double>(balls.probe_steps);
  const Vec3 from = towards(balls, centre, first ? own : other);
  const Vec3 to = towards(balls, centre, first ? other : own);
  const Vec3 normal = cross(from, to);
  double angle = arc_tangent(std::sqrt(dot(normal, normal)), dot(from, to));
  if (map.cusped_circle_of(edge.source) != no_id) {
    const uint32_t ball = (edge.part == 0) == first ? own : other;
    const CircleGeometry circle(balls, ball, ball == own ? other : own);
    const double to_cusp = half_way_between_cusps(balls, own, other);
    angle = arc_tangent(circle.height, circle.radius) - arc_tangent(to_cusp, circle.radius);
    if (!(angle > 0.0)) angle = 0.0;
  }
  return {centre, unit(normal), p, angle};
}

}  // namespace

Position position_of_corner(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t corner) {
  const SurfaceMap map(balls, boundary, surface);
  if (corner >= map.first_crease_corner()) {
    const CutPatches &cut = surface.cut_patches();
    return position_of_crease_corner(balls, boundary, surface,
                                     cut.crease_corners().member(corner - map.first_crease_corner()));
  }
  if (corner >= map.first_cusp()) {
    const uint32_t cusp = corner - map.first_cusp();
    return position_of_cusp(balls, surface.cusped_circles(), cusp / 2, cusp % 2);
  }
  const Position vertex = position_of_vertex(balls, boundary, corner / 3);
  const uint32_t ball = boundary.vertex(corner / 3).ball[corner % 3];
  return {vertex.ball, vertex.offset + static_cast<double>(balls.probe_steps) * towards(balls, vertex, ball)};
}

ArcPosition position_of_edge(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t edge) {
  const SurfaceMap map(balls, boundary, surface);
  const SurfaceEdge record = map.edge(edge);
  if (record.kind == SurfaceEdgeKind::rim) {
    return position_of_rim(balls, boundary.ball_of(record.source), boundary.half_edge(record.source).circle,
                           angle_of_arc(balls, boundary, record.source));
  }
  if (record.kind == SurfaceEdgeKind::circle_rim) {
    const ClosedHalfEdge circle = ClosedHalfEdge::from_id(record.source);
    return position_of_rim(balls, boundary.ball_of(circle), boundary.neighbour(circle), 2 * pi);
  }
  if (record.kind == SurfaceEdgeKind::side) return position_of_side(balls, boundary, map, record);
  const CutPatches &cut = surface.cut_patches();
  const PatchArc &arc = cut.arc(record.source);
  const uint32_t vertex = cut.piece(cut.piece_of_arc(record.source)).vertex;
  const Position centre = position_of_vertex(balls, boundary, vertex);
  const double p = static_cast<double>(balls.probe_steps);
  Vec3 to = difference(balls, centre, position_of_vertex(balls, boundary, arc.across));
  if (surface.is_of_actual_balls()) ActualBalls(balls, boundary).find_way_to_vertex(vertex, arc.across, to);
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

// In doubles, as it is asked by tasks, which have little stack. Where the vertices beside a crease are near each other
// the way from one to the other tells of the axis by half the digits or fewer. If they are on one circle the plane of
// the crease contains that circle's axis, which tells better. A cusp at an end of it is found from its circle, too, as
// the planes of crease and side, which meet there, may be nearly one.
VertexCrease crease_on_probe(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t arc) {
  // From this height down ways between vertices have too few digits for the axis.
  constexpr double low = 0x1p-12;
  const CutPatches &cut = surface.cut_patches();
  const uint32_t vertex = cut.piece(cut.piece_of_arc(arc)).vertex;
  const Position centre = position_of_vertex(balls, boundary, vertex);
  ProbeCap own(balls, boundary, centre, vertex, cut.arc(arc));
  VertexCrease crease{{own.axis, own.height, cut.arc(arc).angle, {0.0, 0.0, 0.0}}, true};
  const double p = static_cast<double>(balls.probe_steps);
  const uint32_t next = cut.arc(arc).next, across = cut.arc(arc).across;
  if (next == arc) {
    if (2 * own.height < coincident_distance) crease.arc.height = 0.0;
    return crease;
  }
  const uint32_t start_cusp = cusp_of_corner(boundary, surface, cut.arc(arc).corner);
  const uint32_t end_cusp = cusp_of_corner(boundary, surface, cut.arc(next).corner);
  const bool has_cusps = start_cusp != no_id && end_cusp != no_id;
  if (own.height < low) {
    // Between cusps a crease lies on the other side of the circle's axis than its vertices.
    const double order = !has_cusps || start_cusp != (end_cusp ^ 1) ? 0.0 : end_cusp % 2 == 0 ? -1.0 : 1.0;
    const bool is_turned = own.turn(balls, boundary, centre, vertex, across, order);
    crease.is_certain = is_turned || 2 * own.height >= coincident_distance;
    crease.arc.axis = own.axis;
  }
  if (!crease.is_certain) {
    crease.arc.height = 0.0;
    return crease;
  }
  // Where the crease meets another arc, of which it may be the one before.
  const auto end_at = [&](uint32_t cusp, uint32_t other, bool is_start) {
    if (cusp != no_id) {
      const Position position = position_of_cusp(balls, surface.cusped_circles(), cusp / 2, cusp % 2);
      return 1.0 / p * difference(balls, centre, position);
    }
    ProbeCap cap(balls, boundary, centre, vertex, cut.arc(other));
    if (!cut.arc(other).is_side()) {
      const uint32_t third = cut.arc(other).across;
      if (cap.height < low) {
        cap.turn(balls, boundary, centre, vertex, third, 0.0);
      } else if (own.height >= low) {
        // Of three vertices the two others may be near each other. Then both planes are nearly one, and theirs, which
        // has the same line with each, tells where it is.
        const Position opposite = position_of_vertex(balls, boundary, across);
        ProbeCap between(difference(balls, opposite, position_of_vertex(balls, boundary, third)), p);
        if (between.height < low && between.turn(balls, boundary, opposite, across, third, 0.0)) {
          cap.height = dot(between.axis, 1.0 / p * difference(balls, centre, opposite)) + between.height;
          cap.axis = between.axis;
        }
      }
    }
    return is_start ? own.exit_of(cap) : cap.exit_of(own);
  };
  const Vec3 start = end_at(start_cusp, cut.previous(arc), true);
  crease.arc.chord = end_at(end_cusp, next, false) - start;
  return crease;
}

}  // namespace hsp
