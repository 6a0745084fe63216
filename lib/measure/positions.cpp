#include "measure/positions.hpp"

#include "boundary/half_edge_links.hpp"
#include "core/elementary.hpp"
#include "exact/filter.hpp"
#include "measure/areas.hpp"

namespace hsp {
namespace {

using exact::cross;
using exact::dot;
using exact::DoubleVector;

DoubleVector to_vector(const double offset[3]) {
  return {offset[0], offset[1], offset[2]};
}

bool ranks_first(const BallSet &balls, uint32_t a, uint32_t b) {
  return exact::ranks_before(balls.ball(a), balls.ball(b));
}

// The point p+ or p- of the circle of `other` and the plane of an extra arc of `cut_ball`, on ball `frame`.
DoubleVector point_of_cut(const BallSet &balls, uint32_t frame, uint32_t other, uint32_t cut_ball, uint32_t cap,
                          int sign) {
  const exact::LatticeBall own = balls.ball(frame);
  const exact::Plane circle = exact::plane_of(own, balls.ball(other));
  const exact::Plane cut = plane_of_cut(balls, frame, cut_ball, cap);
  const double root_D = std::sqrt(exact::Exact::discriminant(exact::sphere_of(own), circle, cut));
  double offset[3];
  vertex_offset(circle, cut, sign, root_D, offset);
  return to_vector(offset);
}

// The balls of a carrier and what is told about it from the one of lower rank, the frame.
struct CarrierFrame {
  uint32_t a, b;
  uint32_t frame, other;

  CarrierFrame(const BallSet &balls, const CarrierBalls &pair) : a(pair.a), b(pair.b) {
    const bool first_frame = ranks_first(balls, a, b);
    frame = first_frame ? a : b;
    other = first_frame ? b : a;
  }
  DoubleVector split(const BallSet &balls, const SplitPoint &point) const {
    // The two balls see the circle from its two sides.
    return point_of_cut(balls, frame, other, point.ball, point.cap, frame == a ? point.sign : -point.sign);
  }
};

// The angle from one direction across an axis to another, in [0, 2 pi].
double turn_about(const DoubleVector &axis, const DoubleVector &from, const DoubleVector &to) {
  const double angle = arc_tangent(dot(axis, cross(from, to)), dot(from, to));
  return angle < 0.0 ? angle + 2 * pi : angle;
}

// The same for a turn that is known to be at most `largest`: what rounding puts beyond goes to the nearer end, and a
// whole turn between two points that rounding cannot tell apart counts as none.
double turn_within(const DoubleVector &axis, const DoubleVector &from, const DoubleVector &to, double largest) {
  constexpr double rounding = 0x1p-36;
  const double angle = turn_about(axis, from, to);
  if (2 * pi - angle < rounding) return 0.0;
  if (angle <= largest) return angle;
  return angle - largest < 2 * pi - angle ? largest : 0.0;
}

uint32_t count_splits(const TopologyStructure &topology, uint32_t carrier) {
  uint32_t count = 0;
  for (uint32_t s = topology.split_points.first(carrier); s != no_id; s = topology.split_points[s].next) ++count;
  return count;
}

// A carrier's split number k, as the loop of its ball a walks it.
const SplitPoint &split_on(const TopologyStructure &topology, uint32_t carrier, uint32_t k) {
  uint32_t split = topology.split_points.first(carrier);
  for (; k > 0; --k) split = topology.split_points[split].next;
  return topology.split_points[split];
}

// An arc or half of a free circle: its circle, and the angle of one of the edges it is cut into.
EdgePlace place_on_carrier(const BallSet &balls, const BoundaryStructure &boundary, const TopologyStructure &topology,
                           uint32_t carrier_id, uint32_t piece) {
  const CarrierFrame carrier(balls, balls_of_carrier(boundary, carrier_id));
  const bool frame_is_a = carrier.frame == carrier.a;
  const CirclePlace circle = circle_place(balls, carrier.frame, carrier.other);
  EdgePlace place;
  // The loop of a runs clockwise about the axis towards b.
  place.centre.ball = carrier.frame;
  for (int k = 0; k < 3; ++k) {
    place.centre.offset[k] = circle.centre[k];
    place.axis[k] = frame_is_a ? -circle.axis[k] : circle.axis[k];
  }
  place.radius = circle.radius;

  const uint32_t uses = 3 * boundary.vertices.size();
  const bool on_arc = carrier_id < uses;
  const uint32_t own_use = on_arc && !frame_is_a ? twin_use(boundary, carrier_id) : carrier_id;
  const double whole = on_arc ? arc_angle(balls, boundary, carrier.frame, own_use) : pi;
  const uint32_t splits = count_splits(topology, carrier_id);
  if (splits == 0) {
    place.angle = whole;
    return place;
  }

  // From point to point as the loop of the frame walks; the last piece has what is left, so that they sum to the arc.
  const DoubleVector centre = to_vector(circle.centre);
  const auto from_centre = [&](const DoubleVector &p) { return exact::combine(1.0, p, -1.0, centre); };
  const DoubleVector axis{-circle.axis[0], -circle.axis[1], -circle.axis[2]};
  DoubleVector from;
  if (on_arc) {
    const VertexUse &walk = boundary.uses[own_use];
    const exact::LatticeBall own = balls.ball(carrier.frame);
    double offset[3];
    vertex_offset(exact::plane_of(own, balls.ball(walk.out)), exact::plane_of(own, balls.ball(walk.in)), -1,
                  boundary.root_discriminant[walk.vertex], offset);
    from = from_centre(to_vector(offset));
  } else {
    // The loop of a walks half h of a circle from its point h to the other one.
    const uint32_t start = frame_is_a ? carrier_id - uses : (carrier_id - uses) ^ 1U;
    from = from_centre(carrier.split(balls, topology.split_points[start]));
  }
  // Splits and pieces are numbered as the loop of a walks them.
  const uint32_t wanted = frame_is_a ? piece : splits - piece;
  double left = whole;
  for (uint32_t k = 0; k < splits; ++k) {
    const SplitPoint &split = split_on(topology, carrier_id, frame_is_a ? k : splits - 1 - k);
    const DoubleVector point = from_centre(carrier.split(balls, split));
    const double turn = turn_within(axis, from, point, left);
    if (k == wanted) {
      place.angle = turn;
      return place;
    }
    left -= turn;
    from = point;
  }
  place.angle = left;
  return place;
}

// A piece of an extra arc. The arc is a part of a great circle through both poles: from a point to the next one among
// its ends and the poles on it, it turns by less than half a turn, and from pole to pole by half a turn.
EdgePlace place_on_extra_arc(const BallSet &balls, const BoundaryStructure &boundary, const TopologyStructure &topology,
                             uint32_t id, uint32_t piece) {
  const ExtraArc &arc = topology.extra_arcs[id];
  const exact::Vector m = plane_of_cut(balls, arc.ball, arc.ball, arc.cap).v;
  const double length = std::sqrt(static_cast<double>(exact::dot(m, m)));
  EdgePlace place;
  place.centre = {arc.ball, {0.0, 0.0, 0.0}};
  place.axis[0] = static_cast<double>(m.x) / length;
  place.axis[1] = static_cast<double>(m.y) / length;
  place.axis[2] = 0.0;
  place.radius = balls.r[arc.ball];

  const auto end_point = [&](uint32_t end) {
    uint32_t other = 0;
    if ((arc.end[end] & ExtraArc::circle_bit) != 0) {
      const uint32_t circle_side = arc.end[end] & ~ExtraArc::circle_bit;
      other = boundary.circles[circle_side / 2].ball[1 - circle_side % 2];
    } else {
      other = boundary.uses[arc.end[end]].out;
    }
    return point_of_cut(balls, arc.ball, other, arc.ball, arc.cap, end == 0 ? -1 : +1);
  };
  const DoubleVector axis = to_vector(place.axis);
  const bool south_first = (arc.poles & ExtraArc::south_first) != 0;
  double angle = 0.0;
  uint32_t at_piece = 0;
  DoubleVector from = end_point(0);
  for (uint32_t turn = 0; turn < 2; ++turn) {
    const bool south = (turn == 0) == south_first;
    if ((arc.poles & (south ? ExtraArc::passes_south : ExtraArc::passes_north)) == 0) continue;
    const DoubleVector pole{0.0, 0.0, south ? -place.radius : place.radius};
    if (at_piece == piece) angle += turn_within(axis, from, pole, pi);
    from = pole;
    if ((arc.poles & (south ? ExtraArc::vertex_at_south : ExtraArc::vertex_at_north)) != 0) ++at_piece;
  }
  if (at_piece == piece) angle += turn_within(axis, from, end_point(1), pi);
  place.angle = angle;
  return place;
}

}  // namespace

Place place_of_vertex(const BallSet &balls, const BoundaryStructure &boundary, uint32_t vertex) {
  const VertexRecord &record = boundary.vertices[vertex];
  uint32_t first = 0;
  for (uint32_t t = 1; t < 3; ++t) {
    if (ranks_first(balls, record.ball[t], record.ball[first])) first = t;
  }
  uint32_t second = record.ball[(first + 1) % 3];
  uint32_t third = record.ball[(first + 2) % 3];
  int sign = record.positive() ? 1 : -1;
  if (ranks_first(balls, third, second)) {
    const uint32_t exchanged = second;
    second = third;
    third = exchanged;
    sign = -sign;
  }
  Place place;
  place.ball = record.ball[first];
  const exact::LatticeBall own = balls.ball(place.ball);
  vertex_offset(exact::plane_of(own, balls.ball(second)), exact::plane_of(own, balls.ball(third)), sign,
                boundary.root_discriminant[vertex], place.offset);
  return place;
}

Place place_of_point(const BallSet &balls, const BoundaryStructure &boundary, const TopologyStructure &topology,
                     uint32_t vertex) {
  if (vertex < boundary.vertices.size()) return place_of_vertex(balls, boundary, vertex);
  if (vertex >= topology.first_pole) {
    const uint32_t pole = topology.pole[vertex - topology.first_pole];
    return {pole / 2, {0.0, 0.0, pole % 2 == 0 ? balls.r[pole / 2] : -balls.r[pole / 2]}};
  }
  const SplitPoint &point = topology.split_points[vertex - boundary.vertices.size()];
  const CarrierFrame frame(balls, balls_of_carrier(boundary, point.carrier));
  const DoubleVector offset = frame.split(balls, point);
  return {frame.frame, {offset.x, offset.y, offset.z}};
}

EdgePlace place_of_edge(const BallSet &balls, const BoundaryStructure &boundary, const TopologyStructure &topology,
                        uint32_t edge) {
  const uint32_t source = topology.edge_source[edge];
  if (edge < topology.first_extra_edge) {
    const uint32_t carrier = topology.carrier_of_edge(edge);
    return place_on_carrier(balls, boundary, topology, carrier, edge - edge_of(topology.walk_start[carrier]));
  }
  if (edge < topology.first_sphere_edge) {
    return place_on_extra_arc(balls, boundary, topology, source, edge - topology.extra_first_edge[source]);
  }
  return {{source, {0.0, 0.0, 0.0}}, {1.0, 0.0, 0.0}, balls.r[source], pi};
}

}  // namespace hsp
