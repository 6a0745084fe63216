#include "topology/positions.hpp"

#include "core/elementary.hpp"
#include "exact/discriminant.hpp"
#include "exact/filter.hpp"
#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

// The point p+ or p- of the circle of `other` and the plane of a cut arc of `cut_ball`, on ball `frame`.
Vec3 point_of_cut(const BallSet &balls, uint32_t frame, uint32_t other, uint32_t cut_ball, uint32_t cap, int sign) {
  const exact::LatticeBall own = balls.ball(frame);
  const exact::Plane circle = exact::plane_of(own, balls.ball(other));
  const exact::Plane cut = plane_of_cut(balls, frame, cut_ball, cap);
  const double root_D = std::sqrt(exact::discriminant(exact::sphere_of(own), circle, cut));
  return crossing_point(circle, cut, sign, root_D);
}

// The balls of a host edge. Its geometry is computed on the ball of lower rank, the frame.
struct HostFrame {
  uint32_t a, b;
  uint32_t frame, other;

  HostFrame(const BallSet &balls, const HostBalls &pair) : a(pair.a), b(pair.b) {
    const bool first_frame = balls.ranks_before(a, b);
    frame = first_frame ? a : b;
    other = first_frame ? b : a;
  }
  Vec3 split(const BallSet &balls, const SubdivisionVertex &point) const {
    // The two balls see the circle from its two sides.
    return point_of_cut(balls, frame, other, point.ball, point.cap, frame == a ? point.sign : -point.sign);
  }
};

// turn_about() for a turn from 0 to `largest`: if rounding puts the angle outside, it becomes the nearer end; so a
// whole turn between two points that coincide up to rounding becomes 0.
double turn_within(const Vec3 &axis, const Vec3 &from, const Vec3 &to, double largest) {
  constexpr double rounding = 0x1p-36;
  const double angle = turn_about(axis, from, to);
  if (2 * pi - angle < rounding) return 0.0;
  if (angle <= largest) return angle;
  return angle - largest < 2 * pi - angle ? largest : 0.0;
}

uint32_t count_subdivision_vertices(const Topology &topology, uint32_t host) {
  return edge_of(topology.chain_end(host)) - edge_of(topology.chain_start(host));
}

// Subdivision vertex number k of a host edge, in the direction of the loop of its ball a. Edge k of the host ends
// there.
SubdivisionVertex subdivision_vertex_on(const Boundary &boundary, const Topology &topology, uint32_t host, uint32_t k) {
  const uint32_t q = topology.chain_start(host) + quarter_edge(k);
  return topology.subdivision_vertex(boundary, topology.quads.origin(sym(q)));
}

// The circle of an arc or of half of a free circle, and the angle of one of the edges into which it is cut.
EdgeGeometry geometry_on_host(const BallSet &balls, const Boundary &boundary, const Topology &topology,
                              uint32_t host_id, uint32_t piece) {
  const HostFrame host(balls, balls_of_host(boundary, host_id));
  const bool frame_is_a = host.frame == host.a;
  const CircleGeometry circle(balls, host.frame, host.other);
  EdgeGeometry edge;
  // The loop of a runs clockwise about the axis towards b.
  edge.centre = {host.frame, circle.centre};
  edge.axis = frame_is_a ? -circle.axis : circle.axis;
  edge.radius = circle.radius;

  const uint32_t half_edges = boundary.half_edge_count();
  const bool on_arc = !Subdivision::is_half_circle(boundary, host_id);
  const uint32_t own_half_edge = on_arc && !frame_is_a ? boundary.twin(host_id) : host_id;
  const double whole = on_arc ? angle_of(balls, boundary, host.frame, own_half_edge) : pi;
  const uint32_t splits = count_subdivision_vertices(topology, host_id);
  if (splits == 0) {
    edge.angle = whole;
    return edge;
  }

  // From point to point in the direction of the loop of the frame. The last piece is the rest of the angle, so that the
  // angles of the pieces sum to that of the arc.
  const Vec3 centre = circle.centre;
  const auto from_centre = [&](const Vec3 &p) { return p - centre; };
  const Vec3 axis = -circle.axis;
  Vec3 from;
  if (on_arc) {
    from = from_centre(start_of(balls, boundary, host.frame, boundary.half_edge(own_half_edge)));
  } else {
    // The loop of a traverses half h of a circle from its point h to the other one.
    const uint32_t start = frame_is_a ? host_id - half_edges : (host_id - half_edges) ^ 1U;
    from = from_centre(host.split(balls, topology.subdivision.vertex(boundary, start)));
  }
  // Vertices and pieces are numbered in the direction of the loop of a.
  const uint32_t wanted = frame_is_a ? piece : splits - piece;
  double left = whole;
  for (uint32_t k = 0; k < splits; ++k) {
    const SubdivisionVertex split = subdivision_vertex_on(boundary, topology, host_id, frame_is_a ? k : splits - 1 - k);
    const Vec3 point = from_centre(host.split(balls, split));
    const double turn = turn_within(axis, from, point, left);
    if (k == wanted) {
      edge.angle = turn;
      return edge;
    }
    left -= turn;
    from = point;
  }
  edge.angle = left;
  return edge;
}

// A piece of a cut arc. The arc is a part of a great circle through both poles: from a point to the next one among
// its ends and the poles on it, it turns by less than half a turn, and from pole to pole by half a turn.
EdgeGeometry geometry_on_cut_arc(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t id,
                                 uint32_t piece) {
  const CutArc &arc = topology.cut_arcs[id];
  const exact::Vector m = plane_of_cut(balls, arc.ball, arc.ball, arc.cap).v;
  const double length = std::sqrt(static_cast<double>(dot(m, m)));
  EdgeGeometry edge;
  edge.centre = {arc.ball, {0.0, 0.0, 0.0}};
  edge.axis = {static_cast<double>(m.x) / length, static_cast<double>(m.y) / length, 0.0};
  edge.radius = balls.r[arc.ball];

  const auto end_point = [&](uint32_t end) {
    return point_of_cut(balls, arc.ball, boundary.neighbour(arc.end[end]), arc.ball, arc.cap, end == 0 ? -1 : +1);
  };
  const bool south_first = (arc.poles & CutArc::south_first) != 0;
  double angle = 0.0;
  uint32_t at_piece = 0;
  Vec3 from = end_point(0);
  for (uint32_t turn = 0; turn < 2; ++turn) {
    const bool south = (turn == 0) == south_first;
    if ((arc.poles & (south ? CutArc::passes_south : CutArc::passes_north)) == 0) continue;
    const Vec3 pole{0.0, 0.0, south ? -edge.radius : edge.radius};
    if (at_piece == piece) angle += turn_within(edge.axis, from, pole, pi);
    from = pole;
    if ((arc.poles & (south ? CutArc::vertex_at_south : CutArc::vertex_at_north)) != 0) ++at_piece;
  }
  if (at_piece == piece) angle += turn_within(edge.axis, from, end_point(1), pi);
  edge.angle = angle;
  return edge;
}

}  // namespace

Position position_of_point(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t vertex) {
  switch (topology.kind_of_vertex(boundary, vertex)) {
    case VertexKind::boundary_vertex:
      return position_of_vertex(balls, boundary, vertex);
    case VertexKind::subdivision_vertex: {
      const SubdivisionVertex point = topology.subdivision_vertex(boundary, vertex);
      const HostFrame frame(balls, balls_of_host(boundary, point.host));
      return {frame.frame, frame.split(balls, point)};
    }
    default: {
      const Pole pole = topology.pole_at(vertex);
      return {pole.ball(), {0.0, 0.0, pole.is_lowest() ? -balls.r[pole.ball()] : balls.r[pole.ball()]}};
    }
  }
}

EdgeGeometry geometry_of_edge(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t edge) {
  const uint32_t source = topology.edge_source[edge];
  switch (topology.kind_of_edge(edge)) {
    case EdgeKind::cut_arc:
      return geometry_on_cut_arc(balls, boundary, topology, source, topology.piece_of_cut_arc(edge));
    case EdgeKind::whole_sphere:
      return {{source, {0.0, 0.0, 0.0}}, {1.0, 0.0, 0.0}, balls.r[source], pi};
    default:
      return geometry_on_host(balls, boundary, topology, topology.host_of_edge(edge), topology.piece_of_host(edge));
  }
}

}  // namespace hsp
