#include "surface/settled_circles.hpp"

#include "core/decimal.hpp"
#include "core/elementary.hpp"
#include "core/sorting.hpp"
#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/circles_in_doubles.hpp"

namespace hsp {
namespace {

// The unit sphere as that of the smaller probe on the lattice: y = (2^30 - 2^6) x.
constexpr double steps_of_probe = 0x1p29;
constexpr int64_t twice_smaller_probe = (INT64_C(1) << 30) - (INT64_C(1) << 6);
constexpr int64_t W = twice_smaller_probe * twice_smaller_probe;

// Nearer to the border of a patch than this, in units of p, a corner is on it.
constexpr double border = 1e-6;

}  // namespace

SettledCircles::SettledCircles(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen,
                               const ProbeGrid &grid, const CuspedCircles &cusped, const ProbeCaps &probe)
    : balls_(balls),
      probe_(probe),
      caps_(probe.caps()),
      patches_(balls, boundary, chosen, grid, cusped, probe),
      predicates_({W, probe.vertex()}, 0x1p60),
      error_(probe.amplification() * unit_roundoff),
      own_(on_lattice(probe.vertex())) {
  for (uint32_t side = 0; side < ProbeCaps::sides; ++side) find_cusps(side);
}

void SettledCircles::find_cusps(uint32_t side) {
  cusp_cap_[side] = opposite_probe_[side] = no_id;
  const uint32_t vertex = probe_.vertex();
  const VertexRecord &record = patches_.boundary().vertex(vertex);
  const uint32_t slot = record.slot_of(probe_.ball_opposite(side));
  const uint32_t across = patches_.across_cusps(vertex, slot);
  if (across == no_id) return;
  const double p = smaller_probe(balls_);
  const CirclePosition position =
      position_of_circle(balls_, record.ball[slot == 0 ? 1 : 0], record.ball[slot == 2 ? 1 : 2]);
  const Position at = patches_.grid().position(vertex);
  const Vec3 centre = balls_.difference(at.ball, position.centre.ball) + (position.centre.offset - at.offset);
  const double half = half_way_between_cusps(balls_, position.radius);
  SideCircle &circle = circle_[side];
  circle.cusp[0] = (1.0 / p) * combine(1.0, centre, -half, position.axis);
  circle.cusp[1] = (1.0 / p) * combine(1.0, centre, half, position.axis);
  const double distance = std::sqrt(dot(centre, centre));
  circle.outward = distance > 0.0 ? (-1.0 / distance) * centre : Vec3{0.0, 0.0, 0.0};
  circle.radius = position.radius / p;
  const Vec3 to = patches_.grid().difference(balls_, vertex, across);
  if (dot(to, to) < coincident_distance * coincident_distance * p * p) {
    opposite_probe_[side] = across;
    return;
  }
  for (uint32_t k = ProbeCaps::sides; k < caps_.count; ++k) {
    probe_.for_each_at_position(k, [&](uint32_t other) {
      if (other == across) cusp_cap_[side] = k;
    });
  }
}

// Seen from the ball of lowest rank of the component, as sums of volumes are.
exact::Vector SettledCircles::on_lattice(uint32_t vertex) const {
  const Position position = patches_.grid().position(vertex);
  const Vec3 arm = offset_from_origin(balls_, patches_.boundary(), position.ball) + position.offset;
  const double scale = steps_of_probe / static_cast<double>(balls_.probe_steps);
  return {nearest(scale * arm.x), nearest(scale * arm.y), nearest(scale * arm.z)};
}

exact::Plane SettledCircles::plane(uint32_t k) const {
  const exact::Vector v = on_lattice(caps_.ball[k]) - own_;
  return {v, dot(v, v), 1, caps_.ball[k]};
}

Answer SettledCircles::crossing(uint32_t j, uint32_t k, Crossing &crossing) const {
  if (is_point(j) || is_point(k)) return Answer::no;
  if (!is_side(k)) {
    if (!is_side(j)) return crossing_of_probes(j, k, crossing);
    const CircleCrossing<Vec3, double> pair(caps_.axis(j), height(j), caps_.axis(k), height(k));
    const double D = pair.discriminant(1.0);
    if (!has_cusps(j, k) && !(D > 0x1p-40)) return Answer::no;
    const double root = D > 0.0 ? std::sqrt(D) : 0.0;
    crossing = {j, k, root, {pair.point(-root), pair.point(root)}, 0.0};
    return Answer::yes;
  }
  // Two sides meet at the corner on the ball that neither is opposite to. n = u x v with the outward normals u and v:
  // the vertex's sign tells on which side that is.
  const uint32_t third = 3 - j - k;
  const Vec3 n = cross(caps_.axis(j), caps_.axis(k));
  const bool positive = (k - j == 1) == probe_.is_counter_clockwise();
  const Vec3 at = probe_.corner(third);
  crossing = {j, k, std::sqrt(dot(n, n)), {positive ? -at : at, positive ? at : -at}, 0.0};
  return Answer::yes;
}

Answer SettledCircles::crossing_of_probes(uint32_t j, uint32_t k, Crossing &crossing) const {
  const CircleCrossing<Vec3, double> pair(caps_.axis(j), height(j), caps_.axis(k), height(k));
  if (const Answer answer = certain_crossing(pair, j, k, error_, crossing); answer != Answer::unknown) return answer;
  const exact::Plane P = plane(j);
  const exact::Plane Q = plane(k);
  if (predicates_.crossing(P, Q).sign < 0) return Answer::no;
  const double D = pair.discriminant(1.0);
  const double exact_D = exact::Exact::discriminant(predicates_.sphere(), P, Q);
  const double root = std::sqrt(exact_D > 0.0 ? exact_D : 0.0);
  constexpr double to_unit = 2.0 / static_cast<double>(twice_smaller_probe);
  crossing = {j,
              k,
              std::sqrt(D > 0.0 ? D : 0.0),
              {to_unit * crossing_point(P, Q, -1, root), to_unit * crossing_point(P, Q, 1, root)},
              -1.0};
  return Answer::yes;
}

Answer SettledCircles::contains(const Crossing &crossing, int sign, uint32_t r) const {
  const Vec3 &point = crossing.point[sign > 0 ? 1 : 0];
  if (is_side(crossing.second)) {
    const uint32_t third = 3 - crossing.first - crossing.second;
    return dot(point, probe_.corner(third)) > 0.0 ? Answer::no : Answer::yes;
  }
  if (is_side(crossing.first)) {
    if (has_cusps(crossing.first, crossing.second)) return Answer::no;
    if (!is_beyond_opposite_probe(crossing.first, point)) return Answer::yes;
    const double above = dot(caps_.axis(r), point) - height(r);
    const bool tied = !is_side(r) && !is_point(r) && std::fabs(above) < same_position;
    const bool covered = tied ? is_covered_beside(crossing.first, crossing.second, r, point) : above > 0.0;
    return covered ? Answer::yes : Answer::no;
  }
  if (is_side(r)) return r > 0 || is_in_patches(crossing, sign) ? Answer::no : Answer::yes;
  if (is_point(r)) return Answer::no;
  const double above = dot(caps_.axis(r), point) - height(r);
  if (crossing.error >= 0.0) {
    if (above > crossing.error) return Answer::yes;
    if (above < -crossing.error) return Answer::no;
  }
  const exact::Plane P = plane(crossing.first);
  const exact::Plane Q = plane(crossing.second);
  if (predicates_.crossing(P, Q).sign < 0) return above > 0.0 ? Answer::yes : Answer::no;
  return predicates_.inside(P, Q, sign, plane(r)) > 0 ? Answer::yes : Answer::no;
}

// All three patches ask the same questions, in the order of the vertices. Of several vertices at one position that
// counts whose patch the corner is deepest in.
bool SettledCircles::is_in_patches(const Crossing &crossing, int sign) const {
  const double p = smaller_probe(balls_);
  const ProbeGrid &grid = patches_.grid();
  const uint32_t own = probe_.vertex();
  const Vec3 &point = crossing.point[sign > 0 ? 1 : 0];
  uint32_t vertex[3] = {own, patches_.vertex_at(crossing.first, point), patches_.vertex_at(crossing.second, point)};
  sort_three(vertex[0], vertex[1], vertex[2]);
  const Vec3 from_own = p * point;
  double deepest = 0.0;
  bool at_border = false;
  uint32_t opposite_probe = no_id;
  int answer = -1;
  for (int t = 0; t < 3; ++t) {
    const SeenTriangle triangle = patches_.triangle(vertex[t]);
    const Vec3 to = from_own - grid.difference(balls_, own, vertex[t]);
    double least = 2.0;
    uint32_t met = no_id;
    for (uint32_t slot = 0; slot < 3; ++slot) {
      const double above = dot(to, triangle.inward[slot]) / p;
      if (above < least) least = above;
      if (!(above < border) || above < -border) continue;
      const uint32_t across = patches_.across_cusps(vertex[t], slot);
      const uint32_t b = vertex[(t + 1) % 3];
      const uint32_t c = vertex[(t + 2) % 3];
      if (vertex[t] == own && is_opposite_probe(across)) opposite_probe = across;
      if (across != b && across != c) continue;
      // Two sides have their cusps here, and a crease between these: no third probe contains either of them.
      if (across == met) return false;
      met = across;
      if (answer >= 0) continue;
      const Vec3 along = cross(grid.difference(balls_, vertex[t], across), to);
      const Vec3 third = grid.difference(balls_, vertex[t], across == b ? c : b);
      answer = (dot(third, along) > 0.0) == (dot(triangle.inward[slot], along) > 0.0) ? 1 : 0;
    }
    if (least < -border) return false;
    if (least < border) at_border = true;
    if (std::fabs(least) > std::fabs(deepest)) deepest = least;
  }
  if (!at_border) return true;
  if (answer < 0 && opposite_probe != no_id) {
    return patches_.owner_of_corner(own, opposite_probe, caps_.ball[crossing.first], caps_.ball[crossing.second],
                                    point) == own;
  }
  return answer >= 0 ? answer > 0 : deepest > 0.0;
}

// Where a cap cuts a side with a vertex at the same position behind it: whether another cap that passes through the
// same point, up to rounding, contains it. To first order, in the plane that touches the sphere there, all three are
// lines.
bool SettledCircles::is_covered_beside(uint32_t side, uint32_t cap, uint32_t other, const Vec3 &point) const {
  const uint32_t own = probe_.vertex();
  const Vec3 border_of_cap = cross(axis(cap), point);
  const bool rises = dot(border_of_cap, axis(other)) > 0.0;
  const bool enters = dot(border_of_cap, axis(side)) > 0.0;
  const bool corner_is_own =
      patches_.owner_of_corner(own, opposite_probe_[side], caps_.ball[cap], caps_.ball[other], point) == own;
  return (rises == enters) == corner_is_own;
}

Answer SettledCircles::lies_inside(uint32_t k, uint32_t r) const {
  if (is_point(k)) return Answer::yes;
  if (is_point(r)) return Answer::no;
  const double above = height(k) * dot(caps_.axis(k), caps_.axis(r)) - height(r);
  const double certain = 32 * error_;
  if (above > certain) return Answer::yes;
  if (above < -certain || is_side(k) || is_side(r)) return Answer::no;
  return predicates_.side(plane(k), plane(r)).sign > 0 ? Answer::yes : Answer::no;
}

double SettledCircles::turn_between(uint32_t k, uint32_t from, uint32_t to) const {
  return turn_about(axis(k), across_axis(k, axis(from)), across_axis(k, axis(to)));
}

// The order of the mid-points of what the other caps cover (exact/PROOFS.md, section 4); that of the exit's own cap is
// a whole turn away.
bool SettledCircles::ends_sooner(uint32_t k, const RegionCorner &exit, const RegionCorner &a,
                                 const RegionCorner &b) const {
  const uint32_t from = exit.other(k);
  if (a.other(k) == from || b.other(k) == from) return a.other(k) != from;
  return turn_between(k, from, a.other(k)) < turn_between(k, from, b.other(k));
}

// From the middle of what the first cap covers to that of the second, less half of what each of them covers.
double SettledCircles::arc_angle(uint32_t k, const RegionCorner &exit, const RegionCorner &entry) const {
  const auto half = [this, k](uint32_t cap, const Vec3 &end) {
    const Vec3 middle = across_axis(k, axis(cap));
    const double angle = turn_about(axis(k), middle, end - height(k) * axis(k));
    return angle > pi ? 2 * pi - angle : angle;
  };
  const uint32_t from = exit.other(k);
  const uint32_t to = entry.other(k);
  const double whole = from == to ? 2 * pi : turn_between(k, from, to);
  const double angle = whole - half(from, exit.point) - half(to, entry.point);
  return angle > 0.0 ? angle : 0.0;
}

double SettledCircles::exterior_angle(const RegionCorner &corner) const {
  const double g = dot(caps_.axis(corner.first), caps_.axis(corner.second));
  return arc_tangent(corner.root, g - height(corner.first) * height(corner.second));
}

}  // namespace hsp
