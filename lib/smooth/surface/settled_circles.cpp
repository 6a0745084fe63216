#include "surface/settled_circles.hpp"

#include "core/decimal.hpp"
#include "core/elementary.hpp"
#include "core/sorting.hpp"
#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/circles_in_doubles.hpp"
#include "surface/covered_gaps.hpp"

namespace hsp {
namespace {

// The unit sphere as that of the smaller probe on the lattice: y = (2^30 - 2^6) x.
constexpr double steps_of_probe = 0x1p29;
constexpr int64_t twice_smaller_probe = (INT64_C(1) << 30) - (INT64_C(1) << 6);
constexpr int64_t W = twice_smaller_probe * twice_smaller_probe;

// Nearer to the border of a patch than this, in units of p, a corner is on it.
constexpr double border = 1e-6;
// Nearer to each other than this places are the same up to rounding: the smaller probe keeps others farther apart.
constexpr double same_position = 0x1p-28;

// The triangle that a vertex sees, as the numbers of its balls in the record of the vertex have it.
struct SeenTriangle {
  Vec3 inward[3];

  SeenTriangle(const BallSet &balls, const Boundary &boundary, const Position &position, uint32_t vertex) {
    Vec3 to[3];
    for (uint32_t t = 0; t < 3; ++t) {
      to[t] = balls.difference(position.ball, boundary.vertex(vertex).ball[t]) - position.offset;
    }
    for (uint32_t t = 0; t < 3; ++t) {
      const Vec3 normal = cross(to[(t + 1) % 3], to[(t + 2) % 3]);
      const double length = std::sqrt(dot(normal, normal));
      inward[t] = length > 0.0 ? (dot(normal, to[t]) < 0.0 ? -1.0 : 1.0) / length * normal : Vec3{0.0, 0.0, 0.0};
    }
  }
};

// The half-edge that starts at a vertex on the circle of the two balls besides this one.
uint32_t half_edge_opposite(const Boundary &boundary, uint32_t vertex, uint32_t slot) {
  const uint32_t e = boundary.half_edge_at(vertex, (slot + 1) % 3);
  return boundary.half_edge(e).circle != boundary.vertex(vertex).ball[slot]
             ? e
             : boundary.half_edge_at(vertex, (slot + 2) % 3);
}

// The vertex across the covered gap beside this one on the circle with cusps that a side is on; no_id without cusps.
uint32_t across_cusps(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen,
                      const CuspedCircles &cusped, uint32_t vertex, uint32_t slot) {
  const VertexRecord &record = boundary.vertex(vertex);
  const uint32_t a = slot == 0 ? 1 : 0;
  const uint32_t b = slot == 2 ? 1 : 2;
  if (cusped.of_arc(record.ball[a], record.ball[b]) == no_id) return no_id;
  const uint32_t e = half_edge_opposite(boundary, vertex, slot);
  return gap_behind(balls, boundary, chosen, boundary.ball_of(e), e).vertex;
}

}  // namespace

SettledCircles::SettledCircles(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen,
                               const ProbeGrid &grid, const CuspedCircles &cusped, ProbeCaps &probe)
    : balls_(balls),
      boundary_(boundary),
      chosen_(chosen),
      grid_(grid),
      cusped_(cusped),
      probe_(probe),
      caps_(probe.caps()),
      predicates_({W, probe.vertex()}, 0x1p60),
      error_(probe.amplification() * unit_roundoff) {
  const exact::Vector own = on_lattice(probe.vertex());
  probe.caps().set_planes([&](uint32_t k) -> exact::Plane {
    if (is_side(k)) return exact::virtual_plane({1, 0, 0}, 0);
    const exact::Vector other = on_lattice(caps_.ball[k]);
    const exact::Vector v{other.x - own.x, other.y - own.y, other.z - own.z};
    return {v, dot(v, v), 1, caps_.ball[k]};
  });
  for (uint32_t side = 0; side < ProbeCaps::sides; ++side) find_cusps(side);
}

void SettledCircles::find_cusps(uint32_t side) {
  cusp_cap_[side] = mate_[side] = no_id;
  const uint32_t vertex = probe_.vertex();
  const VertexRecord &record = boundary_.vertex(vertex);
  const uint32_t slot = record.slot_of(probe_.ball_opposite(side));
  const uint32_t across = across_cusps(balls_, boundary_, chosen_, cusped_, vertex, slot);
  if (across == no_id) return;
  const double p = smaller_probe(balls_);
  const CirclePosition position =
      position_of_circle(balls_, record.ball[slot == 0 ? 1 : 0], record.ball[slot == 2 ? 1 : 2]);
  const Position at = grid_.position(vertex);
  const Vec3 centre = balls_.difference(at.ball, position.centre.ball) + (position.centre.offset - at.offset);
  const double half = half_way_between_cusps(balls_, position.radius);
  SideCircle &circle = circle_[side];
  circle.cusp[0] = (1.0 / p) * combine(1.0, centre, -half, position.axis);
  circle.cusp[1] = (1.0 / p) * combine(1.0, centre, half, position.axis);
  const double distance = std::sqrt(dot(centre, centre));
  circle.outward = distance > 0.0 ? (-1.0 / distance) * centre : Vec3{0.0, 0.0, 0.0};
  circle.radius = position.radius / p;
  const Vec3 to = grid_.difference(balls_, vertex, across);
  if (dot(to, to) < coincident_distance * coincident_distance * p * p) {
    mate_[side] = across;
    return;
  }
  for (uint32_t k = ProbeCaps::sides; k < caps_.count; ++k) {
    probe_.for_each_in_place(k, [&](uint32_t other) {
      if (other == across) cusp_cap_[side] = k;
    });
  }
}

// Seen from the ball of lowest rank of the component, as sums of volumes are.
exact::Vector SettledCircles::on_lattice(uint32_t vertex) const {
  const Position position = grid_.position(vertex);
  const Vec3 arm = offset_from_origin(balls_, boundary_, position.ball) + position.offset;
  const double scale = steps_of_probe / static_cast<double>(balls_.probe_steps);
  return {nearest(scale * arm.x), nearest(scale * arm.y), nearest(scale * arm.z)};
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
  const exact::Plane &P = caps_.plane(j);
  const exact::Plane &Q = caps_.plane(k);
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
    if (mate_[crossing.first] == no_id || !is_beyond_axis(crossing.first, point)) return Answer::yes;
    const double above = dot(caps_.axis(r), point) - height(r);
    const bool tied = !is_side(r) && !is_point(r) && std::fabs(above) < same_position;
    const bool covered = tied ? is_covered_beside_mate(crossing.first, crossing.second, r, point) : above > 0.0;
    return covered ? Answer::yes : Answer::no;
  }
  if (is_side(r)) return r > 0 || is_in_patches(crossing, sign) ? Answer::no : Answer::yes;
  if (is_point(r)) return Answer::no;
  const double above = dot(caps_.axis(r), point) - height(r);
  if (crossing.error >= 0.0) {
    if (above > crossing.error) return Answer::yes;
    if (above < -crossing.error) return Answer::no;
  }
  const exact::Plane &P = caps_.plane(crossing.first);
  const exact::Plane &Q = caps_.plane(crossing.second);
  if (predicates_.crossing(P, Q).sign < 0) return above > 0.0 ? Answer::yes : Answer::no;
  return predicates_.inside(P, Q, sign, caps_.plane(r)) > 0 ? Answer::yes : Answer::no;
}

// All three patches ask the same questions, in the order of the vertices. Of several vertices in one place that counts
// whose patch the corner is deepest in.
bool SettledCircles::is_in_patches(const Crossing &crossing, int sign) const {
  const double p = smaller_probe(balls_);
  const uint32_t own = probe_.vertex();
  const Vec3 &point = crossing.point[sign > 0 ? 1 : 0];
  uint32_t vertex[3] = {own, vertex_at(crossing.first, point), vertex_at(crossing.second, point)};
  sort_three(vertex[0], vertex[1], vertex[2]);
  const Vec3 from_own = p * point;
  double deepest = 0.0;
  bool at_border = false;
  uint32_t opposite_probe = no_id;
  int answer = -1;
  for (int t = 0; t < 3; ++t) {
    const SeenTriangle triangle(balls_, boundary_, grid_.position(vertex[t]), vertex[t]);
    const Vec3 to = from_own - grid_.difference(balls_, own, vertex[t]);
    double least = 2.0;
    uint32_t met = no_id;
    for (uint32_t slot = 0; slot < 3; ++slot) {
      const double above = dot(to, triangle.inward[slot]) / p;
      if (above < least) least = above;
      if (!(above < border) || above < -border) continue;
      const uint32_t across = across_cusps(balls_, boundary_, chosen_, cusped_, vertex[t], slot);
      const uint32_t b = vertex[(t + 1) % 3];
      const uint32_t c = vertex[(t + 2) % 3];
      if (vertex[t] == own && is_mate(across)) opposite_probe = across;
      if (across != b && across != c) continue;
      // Two sides have their cusps here, and a crease between these: no third probe contains either of them.
      if (across == met) return false;
      met = across;
      if (answer >= 0) continue;
      const Vec3 along = cross(grid_.difference(balls_, vertex[t], across), to);
      const Vec3 third = grid_.difference(balls_, vertex[t], across == b ? c : b);
      answer = (dot(third, along) > 0.0) == (dot(triangle.inward[slot], along) > 0.0) ? 1 : 0;
    }
    if (least < -border) return false;
    if (least < border) at_border = true;
    if (std::fabs(least) > std::fabs(deepest)) deepest = least;
  }
  if (!at_border) return true;
  if (answer < 0 && opposite_probe != no_id) {
    return owner_of_corner(own, opposite_probe, caps_.ball[crossing.first], caps_.ball[crossing.second], point) == own;
  }
  return answer >= 0 ? answer > 0 : deepest > 0.0;
}

// The inward normal of the side between two vertices in one place, seen from the first; 0 if there is none.
Vec3 SettledCircles::normal_towards_mate(uint32_t vertex, uint32_t opposite_probe) const {
  for (uint32_t slot = 0; slot < 3; ++slot) {
    if (across_cusps(balls_, boundary_, chosen_, cusped_, vertex, slot) != opposite_probe) continue;
    return SeenTriangle(balls_, boundary_, grid_.position(vertex), vertex).inward[slot];
  }
  return {0.0, 0.0, 0.0};
}

// In units of the smaller probe.
Vec3 SettledCircles::way(uint32_t from, uint32_t to) const {
  return (1.0 / smaller_probe(balls_)) * grid_.difference(balls_, from, to);
}

// Let two vertices be in one place, with a side between them, and two more probes meet them in a point of this side: of
// which of the two the corner of these two probes is. Seen from the lower one, with the others in their order: all four
// have the same bits.
uint32_t SettledCircles::owner_of_corner(uint32_t vertex, uint32_t opposite_probe, uint32_t a, uint32_t b,
                                         const Vec3 &point) const {
  const uint32_t lower = vertex < opposite_probe ? vertex : opposite_probe;
  const uint32_t upper = vertex < opposite_probe ? opposite_probe : vertex;
  const Vec3 first = way(lower, a < b ? a : b);
  const Vec3 second = way(lower, a < b ? b : a);
  const CircleCrossing<Vec3, double> pair(first, 0.5 * dot(first, first), second, 0.5 * dot(second, second));
  const Vec3 corner = crossing_near(pair, point - way(probe_.vertex(), lower));
  return dot(normal_towards_mate(lower, upper), corner) > 0.0 ? lower : upper;
}

Vec3 SettledCircles::crossing_near(const CircleCrossing<Vec3, double> &pair, const Vec3 &point) {
  const double D = pair.discriminant(1.0);
  const double root = D > 0.0 ? std::sqrt(D) : 0.0;
  return pair.point(dot(pair.n, point) > 0.0 ? root : -root);
}

// Let two pairs of vertices each be in one place, and two of their sides pass through a point where their spheres meet.
// Which one of the second pair has the corner with both of the first. Along the circle in which the two spheres meet
// one of the sides comes first: seen from the pair with the lowest vertex, all four have the same bits.
uint32_t SettledCircles::owner_on_side(uint32_t vertex, uint32_t opposite_probe, uint32_t first, uint32_t second,
                                       const Vec3 &point) const {
  const bool own_is_lower = (vertex < opposite_probe ? vertex : opposite_probe) < (first < second ? first : second);
  const uint32_t a = own_is_lower ? vertex : first;
  const uint32_t b = own_is_lower ? opposite_probe : second;
  const uint32_t c = own_is_lower ? first : vertex;
  const uint32_t d = own_is_lower ? second : opposite_probe;
  const uint32_t lower = a < b ? a : b;
  const uint32_t upper = a < b ? b : a;
  const uint32_t other_lower = c < d ? c : d;
  const uint32_t other_upper = c < d ? d : c;
  const Vec3 normal = normal_towards_mate(lower, upper);
  const Vec3 other_normal = normal_towards_mate(other_lower, other_upper);
  const Vec3 to = way(lower, other_lower);
  const CircleCrossing<Vec3, double> pair(normal, 0.0, to, 0.5 * dot(to, to));
  const Vec3 corner = crossing_near(pair, point - way(probe_.vertex(), lower));
  const bool on_lower_side = dot(other_normal, corner - to) > 0.0;
  if (own_is_lower) return on_lower_side ? other_lower : other_upper;
  const Vec3 along = cross(to, corner);
  const bool same_way = (dot(normal, along) > 0.0) == (dot(other_normal, along) > 0.0);
  return on_lower_side != same_way ? lower : upper;
}

// Where a cap cuts a side with a vertex in the same place behind it: whether another cap that passes through the same
// point, up to rounding, contains it. To first order, in the plane that touches the sphere there, all three are lines.
bool SettledCircles::is_covered_beside_mate(uint32_t side, uint32_t cap, uint32_t other, const Vec3 &point) const {
  const uint32_t own = probe_.vertex();
  const Vec3 border_of_cap = cross(axis(cap), point);
  const bool rises = dot(border_of_cap, axis(other)) > 0.0;
  const bool enters = dot(border_of_cap, axis(side)) > 0.0;
  const bool corner_is_own = owner_of_corner(own, mate_[side], caps_.ball[cap], caps_.ball[other], point) == own;
  return (rises == enters) == corner_is_own;
}

Answer SettledCircles::lies_inside(uint32_t k, uint32_t r) const {
  if (is_point(k)) return Answer::yes;
  if (is_point(r)) return Answer::no;
  const double above = height(k) * dot(caps_.axis(k), caps_.axis(r)) - height(r);
  const double certain = 32 * error_;
  if (above > certain) return Answer::yes;
  if (above < -certain || is_side(k) || is_side(r)) return Answer::no;
  return predicates_.side(caps_.plane(k), caps_.plane(r)).sign > 0 ? Answer::yes : Answer::no;
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

// ---- what arcs consist of ----

namespace {

double angle_between(const Vec3 &a, const Vec3 &b) {
  const Vec3 n = cross(a, b);
  return arc_tangent(std::sqrt(dot(n, n)), dot(a, b));
}

}  // namespace

uint32_t SettledCircles::parts_of(const RegionArc &arc, Span<const RegionCorner> corners,
                                  Part (&parts)[most_parts]) const {
  const uint32_t k = arc.circle;
  if (is_side(k)) return parts_of_side(arc, corners, parts);
  uint32_t in_place = 0;
  probe_.for_each_in_place(k, [&in_place](uint32_t) { ++in_place; });
  if (in_place == 1) {
    parts[0] = {caps_.ball[k], arc.angle};
    return 1;
  }
  // The sides between vertices in one place, where their patches meet in a crease.
  const Vec3 centre = height(k) * caps_.axis(k);
  const double radius = std::sqrt((1.0 - height(k)) * (1.0 + height(k)));
  const bool whole = arc.start == no_id;
  const Vec3 sideways = cross(caps_.axis(k), probe_.corner(0));
  const double length = std::sqrt(dot(sideways, sideways));
  Vec3 x = whole ? (radius / length) * sideways : corners[arc.start].point - centre;
  const Vec3 y = cross(caps_.axis(k), x);
  const auto at = [&](double turn) {
    const SinCos s = sin_cos(turn);
    return centre + combine(s.cosine, x, s.sine, y);
  };
  const uint32_t first = whole ? no_id : owner_of_end(k, corners[arc.start]);
  const uint32_t last = whole ? no_id : owner_of_end(k, corners[arc.end]);
  double cut[most_parts];
  uint32_t cuts = 0;
  probe_.for_each_in_place(k, [&](uint32_t u) {
    const Position place = grid_.position(u);
    const SeenTriangle triangle(balls_, boundary_, place, u);
    const Vec3 from_u = -way(probe_.vertex(), u);
    for (uint32_t slot = 0; slot < 3; ++slot) {
      const uint32_t across = across_cusps(balls_, boundary_, chosen_, cusped_, u, slot);
      bool is_here = false;
      probe_.for_each_in_place(k, [&](uint32_t other) { is_here = is_here || (other == across && other < u); });
      if (!is_here) continue;
      // (centre + x cos + y sin + from_u) . inward = 0
      const Vec3 &n = triangle.inward[slot];
      const double a = dot(x, n);
      const double b = dot(y, n);
      const double c = -dot(centre + from_u, n);
      const double size = std::sqrt(a * a + b * b);
      if (!(std::fabs(c) < size)) continue;
      const double middle = arc_tangent(b, a);
      const double off = arc_tangent(std::sqrt((size - c) * (size + c)), c);
      for (int sign = -1; sign <= 1; sign += 2) {
        double turn = middle + sign * off;
        while (turn < 0.0) turn += 2 * pi;
        while (turn >= 2 * pi) turn -= 2 * pi;
        const bool at_first = first != no_id && (turn < same_position || turn > 2 * pi - same_position);
        if (at_first || (last != no_id && std::fabs(turn - arc.angle) < same_position)) continue;
        if (!(turn < arc.angle) || cuts == most_parts - 3) continue;
        if (depth_in(u, at(turn), slot) > 0.0) cut[cuts++] = turn;
      }
    }
  });
  for (uint32_t i = 1; i < cuts; ++i) {
    for (uint32_t j = i; j > 0 && cut[j] < cut[j - 1]; --j) {
      const double other = cut[j];
      cut[j] = cut[j - 1];
      cut[j - 1] = other;
    }
  }
  uint32_t count = 0;
  double from = 0.0;
  for (uint32_t i = 0; i <= cuts; ++i) {
    const double to = i < cuts ? cut[i] : arc.angle;
    const uint32_t across = vertex_at(k, at(0.5 * from + 0.5 * to));
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

// Of an arc of a cap with several vertices in its place, that ends on the side between two of them, at a corner with
// another probe or on a side with a vertex in the same place behind it: which of the two has this corner. no_id if
// there is no such side.
uint32_t SettledCircles::owner_of_end(uint32_t cap, const RegionCorner &end) const {
  const uint32_t other = end.other(cap);
  const uint32_t own = probe_.vertex();
  if (is_side(other) && (mate_[other] == no_id || !is_beyond_axis(other, end.point))) return no_id;
  uint32_t owner = no_id;
  probe_.for_each_in_place(cap, [&](uint32_t u) {
    const SeenTriangle triangle(balls_, boundary_, grid_.position(u), u);
    const Vec3 seen = end.point - way(own, u);
    for (uint32_t slot = 0; slot < 3; ++slot) {
      const uint32_t across = across_cusps(balls_, boundary_, chosen_, cusped_, u, slot);
      bool is_here = false;
      probe_.for_each_in_place(
          cap, [&](uint32_t opposite_probe) { is_here = is_here || (opposite_probe == across && opposite_probe < u); });
      if (!is_here || !(std::fabs(dot(triangle.inward[slot], seen)) < same_position)) continue;
      if (!(depth_in(u, end.point, slot) > 0.0)) continue;
      owner = is_side(other) ? owner_on_side(own, mate_[other], u, across, end.point)
                             : owner_of_corner(u, across, own, caps_.ball[other], end.point);
    }
  });
  return owner;
}

// How far within the triangle that a vertex sees a point of the own sphere lies; of the sides besides one.
double SettledCircles::depth_in(uint32_t vertex, const Vec3 &point, uint32_t besides) const {
  const SeenTriangle triangle(balls_, boundary_, grid_.position(vertex), vertex);
  const Vec3 to = point - way(probe_.vertex(), vertex);
  double least = 2.0;
  for (uint32_t slot = 0; slot < 3; ++slot) {
    const double above = dot(to, triangle.inward[slot]);
    if (slot != besides && above < least) least = above;
  }
  return least;
}

// Of the vertices in the place of a cap, the one whose patch has a point.
uint32_t SettledCircles::vertex_at(uint32_t cap, const Vec3 &point) const {
  uint32_t best = caps_.ball[cap];
  double deepest = -2.0;
  probe_.for_each_in_place(cap, [&](uint32_t vertex) {
    const double depth = depth_in(vertex, point);
    if (depth > deepest || (depth == deepest && vertex < best)) {
      deepest = depth;
      best = vertex;
    }
  });
  return best;
}

uint32_t SettledCircles::parts_of_side(const RegionArc &arc, Span<const RegionCorner> corners,
                                       Part (&parts)[most_parts]) const {
  const uint32_t side = arc.circle;
  const VertexRecord &record = boundary_.vertex(probe_.vertex());
  const uint32_t slot = record.slot_of(probe_.ball_opposite(side));
  if (mate_[side] == no_id || arc.start == no_id) {
    parts[0] = {PatchArc::side(slot), arc.angle};
    return 1;
  }
  // It runs from one ball's corner to the other's, or from or to a cap beyond the axis.
  const RegionCorner &start = corners[arc.start];
  const RegionCorner &end = corners[arc.end];
  const bool from_ball = is_side(start.other(side));
  const bool to_ball = is_side(end.other(side));
  const SideCircle &circle = circle_[side];
  const auto cusp_near = [&](const Vec3 &point) {
    return dot(point, circle.cusp[0]) > dot(point, circle.cusp[1]) ? circle.cusp[0] : circle.cusp[1];
  };
  const Vec3 first = from_ball ? cusp_near(start.point) : start.point;
  const Vec3 last = to_ball ? cusp_near(end.point) : end.point;
  uint32_t count = 0;
  if (from_ball) parts[count++] = {PatchArc::side(slot), angle_between(start.point, first)};
  parts[count++] = {mate_[side], angle_between(first, last)};
  if (to_ball) parts[count++] = {PatchArc::side(slot), angle_between(last, end.point)};
  return count;
}

}  // namespace hsp
