#include "mesh/mesh_builder.hpp"

#include "measure/areas.hpp"
#include "mesh/ring_points.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {

namespace {

// How often points of curves are doubled, how many one may have then, and how near each other they may be, as a share
// of the balls' radius.
constexpr int most_rounds = 12;
constexpr uint32_t most_segments = UINT32_C(1) << 14;
// No more vertices than so many times those of the first round, and some. Borders that come together would ask for ever
// more of them.
constexpr uint64_t most_growth = 8;
constexpr uint64_t growth_of_small_meshes = 20000;
constexpr double least_segment = 0x1p-24;

// A circle smaller than this, as a share of the ball's radius, is triangulated as if it were so large: where balls
// touch in a point it has no length at all.
constexpr double least_circle = 0x1p-18;

Vec3 direction_from(const BallSet &balls, uint32_t ball, const Position &position) {
  return balls.difference(ball, position.ball) + position.offset;
}

double spacing_on(const BallSet &balls, uint32_t i, double edge) {
  return balls.r[i] > 0.0 ? edge / balls.r[i] : largest_ring_spacing;
}

}  // namespace

// Triangles with sides of one length have two vertices for each triangle's area; those of a mesh are a little smaller.
Status expected_mesh_limits(const BallSet &balls, const Boundary &boundary, double edge, MeshLimits &limits) {
  double vertices = boundary.vertex_count();
  double most_points = 0.0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    if (!boundary.is_exposed(i)) continue;
    const double r = balls.r[i];
    const double spacing = spacing_on(balls, i, edge);
    double border = 0.0;
    double own = 0.0;
    for (const uint32_t e : boundary.half_edges(i)) {
      const bool lower = balls.ranks_before(i, boundary.half_edge(e).circle);
      const double segments =
          lower ? segments_of_arc(balls, boundary, e, edge) : segments_of_arc(balls, boundary, boundary.twin(e), edge);
      border += segments;
      if (lower) own += segments;
    }
    for (const ClosedHalfEdge e : boundary.circles(i)) {
      const double segments = segments_of_circle(balls, boundary, e.circle(), edge);
      border += segments;
      if (e.side() == 0) own += segments;
    }
    const double everywhere = expected_ring_points(spacing < largest_ring_spacing ? spacing : largest_ring_spacing);
    const double steradians = r > 0.0 ? measure_ball(balls, boundary, i).area / (r * r) : 4 * pi;
    // Borders of many short arcs leave triangles that are divided.
    vertices += own + 0.75 * border + 1.2 * everywhere * steradians / (4 * pi) + SphereTriangulation::octahedron_points;
    const double points = border + 1.2 * everywhere + 2.0 * SphereTriangulation::octahedron_points + 8.0;
    if (points > most_points) most_points = points;
  }
  if (!(vertices < max_count / 2.5) || !(most_points < max_count)) return Status::range;
  limits.balls = balls.n;
  limits.curves = boundary.arc_count() + boundary.circle_count();
  limits.vertices = static_cast<uint32_t>(vertices) + 16;
  limits.triangles = 2 * limits.vertices;
  limits.points = static_cast<uint32_t>(most_points);
  return Status::ok;
}

void MeshBuilder::carve(Workspace &workspace, const MeshLimits &limits) {
  limits_ = limits;
  mesh_.vertices_ = FixedVector(workspace.take<MeshVertex>(limits.vertices));
  mesh_.triangles_ = FixedVector(workspace.take<MeshTriangle>(limits.triangles));
  vertex_moves_ = workspace.take<uint32_t>(limits.vertices);
  curves_.carve(workspace, limits.curves);
  range_ = workspace.take<PatchRange>(limits.balls);
  patch_.carve(workspace, limits.points);
}

Status MeshBuilder::build(const BallSet &balls, const Boundary &boundary, double edge) {
  needed_ = {balls.n, boundary.arc_count() + boundary.circle_count(), 0, 0, 0};
  if (needed_.balls > limits_.balls || needed_.curves > limits_.curves) return Status::capacity;
  mesh_.vertices_.clear();
  mesh_.triangles_.clear();
  if (!curves_.build(balls, boundary, edge)) return Status::range;
  mesh_.curves_ = curves_.count();
  mesh_.refined_ = 0;
  add_boundary_vertices(balls, boundary);
  for (uint32_t c = 0; c < curves_.count(); ++c) add_samples(balls, boundary, c);
  for (uint32_t i = 0; i < balls.n; ++i) range_[i] = {0, 0, boundary.is_exposed(i)};
  // Patches need none of what is stored, so that everything is counted even if there is no room for it.
  bool complete = false;
  uint64_t most_vertices = 0;
  for (int round = 0; round < most_rounds && !complete && needed_.points <= limits_.points; ++round) {
    complete = true;
    for (uint32_t i = 0; i < balls.n; ++i) {
      if (!range_[i].outdated) continue;
      range_[i].outdated = false;
      if (!triangulate_ball(balls, boundary, edge, i)) complete = false;
      needed_.points = larger_count(needed_.points, clamped_count(patch_.needed_points()));
    }
    if (complete || needed_.points > limits_.points) break;
    if (round == 0) most_vertices = most_growth * mesh_.vertices_.required() + growth_of_small_meshes;
    if (!refine(balls, boundary) || mesh_.vertices_.required() > most_vertices) return Status::check;
  }
  const uint64_t vertices = mesh_.vertices_.required();
  const uint64_t triangles = mesh_.triangles_.required();
  needed_.vertices = clamped_count(vertices);
  needed_.triangles = clamped_count(triangles);
  if (vertices > max_count || triangles > max_count || needed_.points > max_count) return Status::range;
  if (vertices > limits_.vertices || triangles > limits_.triangles || needed_.points > limits_.points) {
    return Status::capacity;
  }
  if (!complete) return Status::check;
  remove_outdated();
  return Status::ok;
}

void MeshBuilder::add_boundary_vertices(const BallSet &balls, const Boundary &boundary) {
  for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
    add_vertex(balls, position_of_vertex(balls, boundary, v), boundary.vertex(v).ball, 3);
  }
}

void MeshBuilder::add_samples(const BallSet &balls, const Boundary &boundary, uint32_t c) {
  BoundaryCurve &curve = curves_.curve(c);
  const bool is_circle = curves_.is_circle(c);
  const CurvePoints points(balls, boundary, curve, is_circle);
  curve.first_sample = clamped_count(mesh_.vertices_.required());
  uint32_t owners[2];
  if (is_circle) {
    owners[0] = boundary.circle(curve.element).ball[0];
    owners[1] = boundary.circle(curve.element).ball[1];
  } else {
    owners[0] = boundary.ball_of(curve.element);
    owners[1] = boundary.half_edge(curve.element).circle;
  }
  for (uint32_t k = is_circle ? 0 : 1; k < curve.segments; ++k) add_vertex(balls, points.at(k), owners, 2);
}

void MeshBuilder::add_vertex(const BallSet &balls, const Position &position, const uint32_t *owners, uint32_t count) {
  MeshVertex vertex;
  to_coordinates(balls, position, vertex.position);
  vertex.ball = owners[0];
  Vec3 sum{0.0, 0.0, 0.0};
  for (uint32_t k = 0; k < count; ++k) {
    const Vec3 arm = direction_from(balls, owners[k], position);
    const double length = std::sqrt(dot(arm, arm));
    if (length > 0.0) sum = combine(1.0, sum, 1.0 / length, arm);
    if (balls.given_before(owners[k], vertex.ball)) vertex.ball = owners[k];
  }
  const double length = std::sqrt(dot(sum, sum));
  const Vec3 normal = length > 0.0 ? 1.0 / length * sum : Vec3{0.0, 0.0, 1.0};
  vertex.normal[0] = normal.x;
  vertex.normal[1] = normal.y;
  vertex.normal[2] = normal.z;
  mesh_.vertices_.push(vertex);
}

// The centres of caps whose circles bound the ball's faces.
void MeshBuilder::keep_off_neighbours(const BallSet &balls, const Boundary &boundary, uint32_t i) {
  uint32_t latest = no_id;
  const auto keep_off = [&](uint32_t other) {
    if (other == latest) return;
    latest = other;
    const CircleGeometry circle(balls, i, other);
    patch_.keep_off(circle.axis, circle.height / balls.r[i]);
  };
  // Half-edges of a ball are in the order of their circles.
  for (const uint32_t e : boundary.half_edges(i)) keep_off(boundary.half_edge(e).circle);
  for (const ClosedHalfEdge e : boundary.circles(i)) keep_off(boundary.neighbour(e));
}

void MeshBuilder::add_loop(const BallSet &balls, const Boundary &boundary, uint32_t i, uint32_t loop) {
  const LoopElement start = boundary.loop_start(loop);
  if (start.is_circle()) {
    const ClosedHalfEdge e = start.closed_half_edge();
    const uint32_t c = curves_.of_circle(e.circle());
    const BoundaryCurve &curve = curves_.curve(c);
    const CurvePoints points(balls, boundary, curve, true, least_circle * balls.r[i]);
    const bool forwards = balls.ranks_before(i, boundary.neighbour(e));
    for (uint32_t k = 0; k < curve.segments; ++k) {
      const uint32_t at = forwards ? k : curve.segments - 1 - k;
      patch_.add({direction_from(balls, i, points.at(at)), curve.first_sample + at, c, {boundary.neighbour(e), no_id}});
    }
    return;
  }
  uint32_t e = start.half_edge();
  do {
    const HalfEdge &half_edge = boundary.half_edge(e);
    const uint32_t c = curves_.of_half_edge(e);
    const BoundaryCurve &curve = curves_.curve(c);
    const Position at_start = position_of_vertex(balls, boundary, half_edge.vertex);
    patch_.add({direction_from(balls, i, at_start),
                half_edge.vertex,
                c,
                {boundary.previous_circle(i, half_edge), half_edge.circle}});
    if (curve.segments > 1) {
      const CurvePoints points(balls, boundary, curve, false);
      const bool forwards = curve.element == e;
      for (uint32_t k = 1; k < curve.segments; ++k) {
        const uint32_t at = forwards ? k : curve.segments - k;
        patch_.add(
            {direction_from(balls, i, points.at(at)), curve.first_sample + at - 1, c, {half_edge.circle, no_id}});
      }
    }
    e = half_edge.next;
  } while (e != start.half_edge());
}

bool MeshBuilder::triangulate_ball(const BallSet &balls, const Boundary &boundary, double edge, uint32_t i) {
  patch_.begin(spacing_on(balls, i, edge));
  keep_off_neighbours(balls, boundary, i);
  const IdRange faces = boundary.faces(i);
  for (const uint32_t loop : boundary.loops(i)) {
    patch_.begin_loop(boundary.face_of_loop(loop) - faces.first);
    add_loop(balls, boundary, i, loop);
  }
  const PatchState state = patch_.triangulate();
  if (state == PatchState::too_coarse) {
    patch_.for_each_coarse_curve([this](uint32_t curve) { curves_.curve(curve).refine = true; });
  }
  if (state != PatchState::complete) return false;
  range_[i].first = clamped_count(mesh_.triangles_.required());
  patch_.emit(
      [&](const Vec3 &direction) {
        const uint32_t number = clamped_count(mesh_.vertices_.required());
        const double scale = balls.r[i] / std::sqrt(dot(direction, direction));
        const Position position{i, scale * direction};
        const Vec3 normal = 1.0 / std::sqrt(dot(direction, direction)) * direction;
        MeshVertex vertex{{}, {normal.x, normal.y, normal.z}, i};
        to_coordinates(balls, position, vertex.position);
        mesh_.vertices_.push(vertex);
        return number;
      },
      [&](uint32_t face, const uint32_t *corners) {
        mesh_.triangles_.push({{corners[0], corners[1], corners[2]}, faces.first + face, i, PatchKind::convex});
      });
  range_[i].last = clamped_count(mesh_.triangles_.required());
  return true;
}

// Whether more points on the curve would lie too near each other to tell anything apart.
bool MeshBuilder::is_too_fine(const BallSet &balls, const Boundary &boundary, uint32_t c) const {
  const BoundaryCurve &curve = curves_.curve(c);
  if (curves_.is_circle(c)) return false;
  const uint32_t own = boundary.ball_of(curve.element);
  const double length = angle_of(balls, boundary, own, curve.element) *
                        CircleGeometry(balls, own, boundary.half_edge(curve.element).circle).radius;
  return length < least_segment * balls.r[own] * curve.segments;
}

// Twice as many points on the curves that want them; the balls on both sides are triangulated again. False if there is
// no such curve, or one has too many points already.
bool MeshBuilder::refine(const BallSet &balls, const Boundary &boundary) {
  bool any = false;
  for (uint32_t c = 0; c < curves_.count(); ++c) {
    BoundaryCurve &curve = curves_.curve(c);
    if (!curve.refine) continue;
    if (curve.segments > most_segments || is_too_fine(balls, boundary, c)) return false;
    any = true;
    curve.refine = false;
    curve.segments *= 2;
    if (!curve.refined) ++mesh_.refined_;
    curve.refined = true;
    add_samples(balls, boundary, c);
    if (curves_.is_circle(c)) {
      for (const uint32_t ball : boundary.circle(curve.element).ball) range_[ball].outdated = true;
    } else {
      range_[boundary.ball_of(curve.element)].outdated = true;
      range_[boundary.half_edge(curve.element).circle].outdated = true;
    }
  }
  return any;
}

// Keeps the latest triangles of every ball, and the vertices that they have.
void MeshBuilder::remove_outdated() {
  FixedVector<MeshTriangle> &triangles = mesh_.triangles_;
  FixedVector<MeshVertex> &vertices = mesh_.vertices_;
  const uint32_t old_vertices = vertices.size();
  const uint32_t old_triangles = triangles.size();
  for (uint32_t v = 0; v < old_vertices; ++v) vertex_moves_[v] = no_id;
  uint32_t kept = 0;
  for (uint32_t t = 0; t < old_triangles; ++t) {
    const PatchRange &range = range_[triangles[t].ball];
    if (t < range.first || t >= range.last) continue;
    triangles[kept++] = triangles[t];
    for (const uint32_t v : triangles[t].vertex) vertex_moves_[v] = 0;
  }
  triangles.shrink(kept);
  kept = 0;
  for (uint32_t v = 0; v < old_vertices; ++v) {
    if (vertex_moves_[v] == no_id) continue;
    vertices[kept] = vertices[v];
    vertex_moves_[v] = kept++;
  }
  vertices.shrink(kept);
  for (MeshTriangle &triangle : triangles.items()) {
    for (uint32_t &v : triangle.vertex) v = vertex_moves_[v];
  }
}

}  // namespace hsp
