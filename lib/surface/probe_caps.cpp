#include "surface/probe_caps.hpp"

#include "core/elementary.hpp"
#include "core/sorting.hpp"
#include "surface/covered_gaps.hpp"

namespace hsp {
namespace {

bool lies_on(const VertexRecord &vertex, uint32_t ball) {
  return vertex.ball[0] == ball || vertex.ball[1] == ball || vertex.ball[2] == ball;
}

double squared(const Vec3 &a) {
  return dot(a, a);
}

}  // namespace

void ProbeCaps::carve(Workspace &workspace, uint32_t neighbours) {
  caps_.carve(workspace, neighbours + sides);
  others_ = FixedVector(workspace.take<Other>(neighbours));
}

ProbeState ProbeCaps::gather(const BallSet &balls, const Boundary &boundary, const ProbeGrid &grid, uint32_t vertex) {
  vertex_ = vertex;
  others_.clear();
  for (bool &known : gap_known_) known = false;
  find_sides(balls, boundary, grid);
  if (whole_steradians_ == 0.0) return ProbeState::hidden;

  const double diameter = 2 * static_cast<double>(balls.probe_steps);
  const double coincident = 0.5 * diameter * coincident_distance;
  const uint32_t component = boundary.component(ball_[0]);
  bool hidden = false;
  grid.visit_around(balls, vertex, [&](uint32_t other) {
    if (other == vertex) return;
    const Vec3 to = grid.difference(balls, vertex, other);
    const double square = squared(to);
    if (square >= diameter * diameter) return;
    const VertexRecord &record = boundary.vertex(other);
    // Vertices of other components cut nothing that those of this one do not (PROOFS.md, section 5).
    if (boundary.component(record.ball[0]) != component) return;
    const bool is_coincident = square < coincident * coincident;
    const Rule rule = same_circle_rule(balls, boundary, other, is_coincident);
    if (rule == Rule::hide) hidden = true;
    if (rule != Rule::keep || is_coincident) return;
    const double distance = std::sqrt(square);
    const Vec3 axis = (1.0 / distance) * to;
    const double height = distance / diameter;
    // The cap may lie outside of one side, which leaves the triangle as it is.
    const double reach = std::sqrt((1.0 - height) * (1.0 + height)) + 0x1p-30;
    for (const Vec3 &inward : inward_) {
      if (dot(axis, inward) < -reach) return;
    }
    others_.push({axis, height, distance, other});
  });
  if (hidden) return ProbeState::hidden;
  if (others_.required() == 0) return ProbeState::whole;
  if (others_.overflowed()) return ProbeState::crossed;

  const double error = vertex_error * static_cast<double>(balls.largest_radius);
  sort_and_merge(4 * error);
  store_caps();
  // Errors of axis and height: of two vertices, over their distance; caps.hpp has 3.5e for the axis.
  double largest = side_error_;
  for (const Other &other : others_.items().part(0, kept_)) {
    const double own = 2 * error / other.distance;
    if (own > largest) largest = own;
  }
  amplification_ = 1.0 + largest / (3 * unit_roundoff);
  return ProbeState::crossed;
}

// The directions d of the three balls, and with their cosines, which are exact but for rounding, and the discriminant
//   tan(area / 2) = det(d1, d2, d3) / (1 + d1.d2 + d2.d3 + d3.d1)        (Van Oosterom, Strackee 1983)
// where 2 R1 R2 R3 det = sqrt(D). A circle of radius 0 leaves no area: two directions are opposite.
void ProbeCaps::find_sides(const BallSet &balls, const Boundary &boundary, const ProbeGrid &grid) {
  const OrderedVertex ordered =
      in_order(boundary.vertex(vertex_), [&balls](uint32_t a, uint32_t b) { return balls.ranks_before(a, b); });
  const Position &position = grid.position(vertex_);
  Vec3 d[3];
  double R[3];
  for (int k = 0; k < 3; ++k) {
    ball_[k] = ordered.ball[k];
    R[k] = balls.r[ball_[k]];
    d[k] = (1.0 / R[k]) * (balls.difference(position.ball, ball_[k]) - position.offset);
  }
  const double root = boundary.root_discriminant(vertex_);
  double denominator = 2 * R[0] * R[1] * R[2];
  whole_steradians_ = 0.0;
  whole_vector_area_ = {0.0, 0.0, 0.0};
  side_error_ = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3;
    const int b = (k + 2) % 3;
    const double twice_cosine = R[a] * R[a] + R[b] * R[b] - squared(balls.difference(ball_[a], ball_[b]));
    denominator += R[k] * twice_cosine;
    // The vertex lies on the side of the balls' plane that its sign gives, so the triple product has the opposite sign.
    const Vec3 normal = ordered.sign > 0 ? cross(d[b], d[a]) : cross(d[a], d[b]);
    const double sine = std::sqrt(squared(normal));
    if (sine == 0.0) return;
    inward_[k] = (1.0 / sine) * normal;
    const double error = vertex_error * static_cast<double>(balls.largest_radius) * (1.0 / R[a] + 1.0 / R[b]) / sine;
    if (error > side_error_) side_error_ = error;
    const double angle = arc_tangent(sine, dot(d[a], d[b]));
    whole_vector_area_ = combine(1.0, whole_vector_area_, 0.5 * angle, inward_[k]);
  }
  const double half = arc_tangent(root, denominator);
  whole_steradians_ = 2 * half;
}

// All bisector planes between vertices of one circle contain its axis, and the circles in which they cut the probe's
// sphere share the two cusps if the circle is smaller than the probe: of these caps only that of the vertex across the
// covered gap next to this one matters, the others cover less of the patch (PROOFS.md, section 6).
//
// Coincident vertices are one corner of several spheres, or ends of an arc of length 0: their patches are the pieces of
// one polygon and do not cut each other. But if the gap between them is closed the outside has an edge there and no
// corner, and nothing is left of the patch (PROOFS.md, section 7).
ProbeCaps::Rule ProbeCaps::same_circle_rule(const BallSet &balls, const Boundary &boundary, uint32_t other,
                                            bool coincident) {
  const VertexRecord &own = boundary.vertex(vertex_);
  const VertexRecord &record = boundary.vertex(other);
  bool hides = false;
  for (uint32_t slot = 0; slot < 3; ++slot) {
    // Every half-edge that starts here lies on another one of the vertex's three circles.
    const uint32_t half_edge = boundary.half_edge_at(vertex_, slot);
    const uint32_t ball = own.ball[slot];
    if (!lies_on(record, ball) || !lies_on(record, boundary.half_edge(half_edge).circle)) continue;
    if (!gap_known_[slot]) find_gap(balls, boundary, slot);
    if (across_[slot] != other) return Rule::drop;
    if (coincident && angle_of_gap(balls, boundary, ball, half_edge, {other, gap_edge_[slot]}) <= pi) hides = true;
  }
  return hides ? Rule::hide : Rule::keep;
}

void ProbeCaps::find_gap(const BallSet &balls, const Boundary &boundary, uint32_t slot) {
  const CoveredGap gap =
      gap_behind(balls, boundary, boundary.vertex(vertex_).ball[slot], boundary.half_edge_at(vertex_, slot));
  across_[slot] = gap.vertex;
  gap_edge_[slot] = gap.half_edge;
  gap_known_[slot] = true;
}

// By position, so that ids have no effect; of several vertices in one place the first stays.
void ProbeCaps::sort_and_merge(double merge_distance) {
  sort_in_place(others_.items(), [](const Other &a, const Other &b) {
    if (a.height != b.height) return a.height < b.height;
    if (a.axis.x != b.axis.x) return a.axis.x < b.axis.x;
    if (a.axis.y != b.axis.y) return a.axis.y < b.axis.y;
    return a.axis.z < b.axis.z;
  });
  const Span<Other> all = others_.items();
  kept_ = 0;
  for (uint32_t k = 0; k < all.size(); ++k) {
    bool again = false;
    for (uint32_t j = kept_; j-- > 0 && !again;) {
      if (all[k].distance - all[j].distance > merge_distance) break;
      again = squared(combine(all[k].distance, all[k].axis, -all[j].distance, all[j].axis)) <=
              merge_distance * merge_distance;
    }
    if (!again) all[kept_++] = all[k];
  }
}

void ProbeCaps::store_caps() {
  uint32_t count = 0;
  const auto store = [&](const Vec3 &axis, double height, uint32_t vertex) {
    caps_.ux[count] = axis.x;
    caps_.uy[count] = axis.y;
    caps_.uz[count] = axis.z;
    caps_.b[count] = height;
    caps_.ball[count++] = vertex;
  };
  for (const Vec3 &inward : inward_) store(-inward, 0.0, no_id);
  for (const Other &other : others_.items().part(0, kept_)) store(other.axis, other.height, other.vertex);
  caps_.count = count;
}

}  // namespace hsp
