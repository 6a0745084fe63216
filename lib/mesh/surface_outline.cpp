#include "mesh/surface_outline.hpp"

#include "measure/areas.hpp"
#include "mesh/mesh_sizes.hpp"
#include "surface/surface_positions.hpp"

namespace hsp {

namespace {

// How near each other points of a curve may be, as a share of the probe's radius.
constexpr double least_segment = 0x1p-24;

// The points of a crease at equal angles, from its start.
class CreasePoints {
 public:
  CreasePoints(const BallSet &balls, const Boundary &boundary, const Surface &surface, uint32_t edge, uint32_t start)
      : arc_(position_of_edge(balls, boundary, surface, edge)) {
    x_ = arc_.radius * perpendicular_to(arc_.axis);
    if (start != no_id) {
      const Position from = position_of_corner(balls, boundary, surface, start);
      x_ = direction_from(balls, arc_.centre.ball, from) - arc_.centre.offset;
    }
  }
  Position at(uint32_t k, uint32_t segments) const {
    const SinCos turn = sin_cos(arc_.angle * k / segments);
    const Vec3 arm = combine(turn.cosine, x_, turn.sine, cross(arc_.axis, x_));
    return {arc_.centre.ball, arc_.centre.offset + arm};
  }

 private:
  ArcPosition arc_;
  Vec3 x_;
};

// Of the diagonals a b and c d, where there are positions.
bool is_shorter(const FixedVector<MeshVertex> &vertices, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  if (vertices.overflowed()) return true;
  const auto square = [&](uint32_t from, uint32_t to) {
    double sum = 0.0;
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const double step = vertices[to].position[axis] - vertices[from].position[axis];
      sum += step * step;
    }
    return sum;
  };
  return square(a, b) <= square(c, d);
}

}  // namespace

// ---- corners and curves ----

SaddleBand SurfaceOutline::band_of_arc(uint32_t half_edge) const {
  const uint32_t on_ball_1 = map_.side_of(half_edge) == 1 ? half_edge : boundary_.twin(half_edge);
  return {balls_, boundary_, on_ball_1, map_.cusped_circle_of(half_edge) != no_id};
}

ClosedHalfEdge SurfaceOutline::on_ball(uint32_t circle, uint32_t side) const {
  const CircleRecord &record = boundary_.circle(circle);
  return {circle, balls_.given_before(record.ball[0], record.ball[1]) ? side : 1 - side};
}

SaddleBand SurfaceOutline::band_of_circle(uint32_t circle) const {
  return {balls_, boundary_, on_ball(circle, 1), surface_.cusped_circles().of_circle(circle) != no_id};
}

SaddleBand SurfaceOutline::band_of_saddle(uint32_t k) const {
  const uint32_t arcs = boundary_.arc_count();
  return k < arcs ? band_of_arc(map_.half_edge_of(k, 1)) : band_of_circle(k - arcs);
}

double SurfaceOutline::segments_of_edge(uint32_t c, double length) const {
  const SurfaceEdge edge = map_.edge(c);
  if (edge.kind == EdgeKind::rim) {
    return segments_of(band_of_arc(edge.source).width(), length,
                       has_ends_of_same_balls(boundary_, edge.source) ? 2.0 : 1.0);
  }
  if (edge.kind == EdgeKind::circle_rim) {
    return segments_of(band_of_circle(ClosedHalfEdge::from_id(edge.source).circle()).width(), length, fewest_of_circle);
  }
  if (edge.kind == EdgeKind::side) return segments_of(band_of_arc(edge.source).length(edge.part), length, 1.0);
  // Several creases may join the same two corners.
  const ArcPosition arc = position_of_edge(balls_, boundary_, surface_, c);
  return segments_of(arc.radius * arc.angle, length, is_closed(c) ? fewest_of_circle : 2.0);
}

bool SurfaceOutline::divide_curves(double length) {
  double all = 0.0;
  for (uint32_t c = 0; c < curve_count(); ++c) {
    const double segments = segments_of_edge(c, length);
    all += segments;
    if (!(all < max_count)) return false;
    curve_[c] = {c, static_cast<uint32_t>(segments), 0, false, false};
  }
  return true;
}

uint32_t SurfaceOutline::partner(uint32_t c) const {
  return map_.edge(c).kind == EdgeKind::crease ? c : c ^ 1;
}

bool SurfaceOutline::is_too_fine(uint32_t c) const {
  if (is_closed(c)) return false;
  const SurfaceEdge edge = map_.edge(c);
  double length = 0.0;
  if (edge.kind == EdgeKind::crease) {
    const ArcPosition arc = position_of_edge(balls_, boundary_, surface_, c);
    length = arc.radius * arc.angle;
  } else {
    const SaddleBand band = band_of_arc(edge.source);
    length = edge.kind == EdgeKind::rim ? band.way_of_probe() : band.length(edge.part);
  }
  return length < least_segment * probe() * curve_[c].segments;
}

Vec3 SurfaceOutline::towards_vertex(const Position &position, uint32_t v) const {
  const Position centre = probe_at(v);
  return balls_.difference(position.ball, centre.ball) + (centre.offset - position.offset);
}

// The first one in the caller's order of several.
uint32_t SurfaceOutline::nearest_ball(uint32_t v, const Vec3 &from_probe) const {
  const Position centre = probe_at(v);
  uint32_t nearest = no_id;
  double most = 0.0;
  for (const uint32_t b : boundary_.vertex(v).ball) {
    const Vec3 arm = balls_.difference(centre.ball, b) - centre.offset;
    const double along = dot(from_probe, arm) / balls_.r[b];
    if (nearest != no_id && (along < most || (along == most && balls_.given_before(nearest, b)))) continue;
    nearest = b;
    most = along;
  }
  return nearest;
}

MeshVertex SurfaceOutline::crease_vertex(const Position &position, const uint32_t *vertices, uint32_t count) const {
  Vec3 sum{0.0, 0.0, 0.0};
  for (uint32_t k = 0; k < count; ++k) sum = sum + towards_vertex(position, vertices[k]);
  const uint32_t ball = nearest_ball(vertices[0], -towards_vertex(position, vertices[0]));
  return mesh_vertex(balls_, position, unit(sum, {0.0, 0.0, 1.0}), ball);
}

// The patches there are those of the probes at the ends of the circle's arcs; around a whole circle they turn about the
// axis. The half-edges of a circle on one ball are neighbours.
Vec3 SurfaceOutline::normal_at_cusp(uint32_t k, uint32_t side, const Position &position) const {
  const CuspedCircles &cusped = surface_.cusped_circles();
  const CirclePosition circle = position_of_circle(balls_, cusped.ball(k, side), cusped.ball(k, 1 - side));
  if (cusped.element(k).is_circle()) return circle.axis;
  Vec3 sum{0.0, 0.0, 0.0};
  for (uint32_t e = cusped.element(k).half_edge(); e < boundary_.half_edges(cusped.ball(k, 0)).last; ++e) {
    if (boundary_.half_edge(e).circle != cusped.ball(k, 1)) break;
    if (!faces_.has(boundary_.face_of(e))) continue;
    const uint32_t ends[2] = {boundary_.half_edge(e).vertex, boundary_.end_vertex(e)};
    for (const uint32_t v : ends) sum = sum + towards_vertex(position, v);
  }
  return unit(sum, circle.axis);
}

MeshVertex SurfaceOutline::corner(uint32_t id) const {
  if (id < map_.first_cusp()) {
    const uint32_t ball = boundary_.vertex(id / 3).ball[id % 3];
    const Vec3 arm = direction_from(balls_, ball, probe_at(id / 3));
    const double R = balls_.r[ball];
    return mesh_vertex(balls_, {ball, (R - probe()) / R * arm}, unit(arm, {0.0, 0.0, 1.0}), ball);
  }
  const Position position = position_of_corner(balls_, boundary_, surface_, id);
  if (id < map_.first_crease_corner()) {
    const uint32_t k = (id - map_.first_cusp()) / 2;
    const uint32_t side = (id - map_.first_cusp()) % 2;
    const CuspedCircles &cusped = surface_.cusped_circles();
    return mesh_vertex(balls_, position, normal_at_cusp(k, side, position), cusped.ball(k, side));
  }
  const CutPatches &cut = surface_.cut_patches();
  const uint32_t arc = cut.crease_corners().member(id - map_.first_crease_corner());
  const uint32_t vertices[3] = {cut.piece(cut.piece_of_arc(arc)).vertex, cut.arc(arc).across,
                                cut.arc(cut.previous(arc)).across};
  return crease_vertex(position, vertices, 3);
}

void SurfaceOutline::add_samples(uint32_t c, FixedVector<MeshVertex> &vertices) const {
  const SurfaceEdge edge = map_.edge(c);
  const uint32_t segments = curve_[c].segments;
  if (edge.kind == EdgeKind::circle_rim) {
    const ClosedHalfEdge circle = ClosedHalfEdge::from_id(edge.source);
    const SaddleBand band = band_of_circle(circle.circle());
    const uint32_t side = band.ball(0) == boundary_.ball_of(circle) ? 0 : 1;
    for (uint32_t k = 0; k < segments; ++k) vertices.push(vertex_of(band.on_ball(side, band.outward(k, segments))));
  } else if (edge.kind == EdgeKind::rim) {
    const SaddleBand band = band_of_arc(edge.source);
    const uint32_t side = map_.side_of(edge.source);
    for (uint32_t k = 1; k < segments; ++k) vertices.push(vertex_of(band.on_ball(side, band.outward(k, segments))));
  } else if (edge.kind == EdgeKind::side) {
    const SaddleBand band = band_of_arc(edge.source);
    const Vec3 outward = band.outward_at_end(1 - map_.side_of(edge.source));
    for (uint32_t l = 1; l < segments; ++l) vertices.push(vertex_of(band.at(outward, edge.part, l, segments)));
  } else {
    const CutPatches &cut = surface_.cut_patches();
    const uint32_t start = map_.origin(2 * c);
    const CreasePoints points(balls_, boundary_, surface_, c, start);
    const uint32_t both[2] = {cut.piece(cut.piece_of_arc(edge.source)).vertex, cut.arc(edge.source).across};
    for (uint32_t k = start == no_id ? 0 : 1; k < segments; ++k) {
      vertices.push(crease_vertex(points.at(k, segments), both, 2));
    }
  }
}

// ---- patches on spheres ----

double SurfaceOutline::spacing(uint32_t sphere, double edge) const {
  return spacing_on(sphere < balls_.n ? balls_.r[sphere] - probe() : probe(), edge);
}

uint32_t SurfaceOutline::patch(uint32_t sphere, uint32_t face) const {
  if (sphere < balls_.n) return faces_.face(sphere, face);
  const uint32_t v = sphere - balls_.n;
  return map_.concave_patch(v, surface_.cut_patches().pieces(v).first + face);
}

MeshVertex SurfaceOutline::inner_vertex(uint32_t sphere, const Vec3 &direction) const {
  const Vec3 normal = 1.0 / std::sqrt(dot(direction, direction)) * direction;
  if (sphere < balls_.n) {
    return mesh_vertex(balls_, {sphere, (balls_.r[sphere] - probe()) * normal}, normal, sphere);
  }
  const uint32_t v = sphere - balls_.n;
  const Position centre = probe_at(v);
  return mesh_vertex(balls_, {centre.ball, centre.offset - probe() * normal}, normal, nearest_ball(v, -normal));
}

uint32_t SurfaceOutline::ball_at(uint32_t sphere, const double (&middle)[3]) const {
  if (sphere < balls_.n) return sphere;
  double centre[3];
  to_coordinates(balls_, probe_at(sphere - balls_.n), centre);
  return nearest_ball(sphere - balls_.n, {middle[0] - centre[0], middle[1] - centre[1], middle[2] - centre[2]});
}

void SurfaceOutline::add_border(uint32_t sphere, SphericalPatch &patch) const {
  if (sphere < balls_.n) {
    keep_off_neighbours(balls_, boundary_, sphere, patch);
    uint32_t number = 0;
    for (const uint32_t face : boundary_.faces(sphere)) {
      if (!faces_.has(face)) continue;
      map_.for_each_loop(face, [&](uint32_t loop) {
        patch.begin_loop(number);
        add_ball_loop(sphere, loop, patch);
      });
      ++number;
    }
    return;
  }
  const uint32_t v = sphere - balls_.n;
  keep_off_sides(v, patch);
  keep_off_probes(v, patch);
  const IdRange pieces = surface_.cut_patches().pieces(v);
  const uint32_t count = pieces.empty() ? 1 : pieces.size();
  for (uint32_t face = 0; face < count; ++face) {
    map_.for_each_loop(map_.concave_patch(v, pieces.first + face), [&](uint32_t loop) {
      patch.begin_loop(face);
      add_probe_loop(v, loop, patch);
    });
  }
}

// Directions are those of the probe's centre, seen from the ball: a ball that is nothing but a point has its patches,
// too.
void SurfaceOutline::add_ball_loop(uint32_t ball, uint32_t loop, SphericalPatch &patch) const {
  map_.for_each_edge(loop, [&](uint32_t h) {
    const uint32_t c = h / 2;
    const MeshCurve &curve = curve_[c];
    const bool forwards = h % 2 == 0;
    const SurfaceEdge edge = map_.edge(c);
    const uint32_t corner = map_.origin(h);
    if (corner == no_id) {
      const SaddleBand band = band_of_circle(ClosedHalfEdge::from_id(edge.source).circle());
      for (uint32_t k = 0; k < curve.segments; ++k) {
        const uint32_t at = forwards ? k : curve.segments - 1 - k;
        const Position probe = band.probe(band.outward(at, curve.segments), least_circle * balls_.r[ball]);
        patch.add({direction_from(balls_, ball, probe), curve.first_sample + at, c, {no_id, no_id}});
      }
      return;
    }
    patch.add({direction_from(balls_, ball, probe_at(corner / 3)), corner, c, {no_id, no_id}});
    if (curve.segments == 1) return;
    const SaddleBand band = band_of_arc(edge.source);
    for (uint32_t k = 1; k < curve.segments; ++k) {
      const uint32_t at = forwards ? k : curve.segments - k;
      const Position probe = band.probe(band.outward(at, curve.segments));
      patch.add({direction_from(balls_, ball, probe), curve.first_sample + at - 1, c, {no_id, no_id}});
    }
  });
}

// Other pieces share points of creases, and cusps with those of all probes on the circle.
void SurfaceOutline::add_probe_loop(uint32_t v, uint32_t loop, SphericalPatch &patch) const {
  const CutPatches &cut = surface_.cut_patches();
  map_.for_each_edge(loop, [&](uint32_t h) {
    const uint32_t c = h / 2;
    const MeshCurve &curve = curve_[c];
    const bool forwards = h % 2 == 0;
    const SurfaceEdge edge = map_.edge(c);
    const bool is_crease = edge.kind == EdgeKind::crease;
    uint32_t across = no_id;
    if (is_crease) across = cut.arc(forwards ? edge.source : cut.arc(edge.source).twin).across;
    const uint32_t corner = map_.origin(h);
    if (corner != no_id) {
      BorderSample start{{}, corner, c, {no_id, no_id}};
      if (corner < map_.first_cusp()) {
        const uint32_t ball = boundary_.vertex(v).ball[corner % 3];
        start.direction = direction_from(balls_, ball, probe_at(v));
      } else {
        start.direction = towards_vertex(position_of_corner(balls_, boundary_, surface_, corner), v);
        start.other_patch[0] = BorderSample::any_patch;
      }
      patch.add(start);
    }
    const uint32_t first = corner == no_id ? 0 : 1;
    if (curve.segments == first) return;
    if (is_crease) {
      const CreasePoints points(balls_, boundary_, surface_, c, map_.origin(2 * c));
      for (uint32_t k = first; k < curve.segments; ++k) {
        const uint32_t at = forwards ? k : curve.segments - 1 - k + first;
        patch.add(
            {towards_vertex(points.at(at, curve.segments), v), curve.first_sample + at - first, c, {across, no_id}});
      }
      return;
    }
    const SaddleBand band = band_of_arc(edge.source);
    const Vec3 outward = band.outward_at_end(1 - map_.side_of(edge.source));
    for (uint32_t k = 1; k < curve.segments; ++k) {
      const uint32_t at = forwards ? k : curve.segments - k;
      patch.add(
          {band.at(outward, edge.part, at, curve.segments).normal, curve.first_sample + at - 1, c, {no_id, no_id}});
    }
  });
}

// Outward normals point from the patch towards the probe's centre: they lie within the cone of the ways from the three
// balls.
void SurfaceOutline::keep_off_sides(uint32_t v, SphericalPatch &patch) const {
  const uint32_t *const ball = boundary_.vertex(v).ball;
  Vec3 from[3];
  for (uint32_t t = 0; t < 3; ++t) from[t] = direction_from(balls_, ball[t], probe_at(v));
  for (uint32_t t = 0; t < 3; ++t) {
    const Vec3 across = cross(from[(t + 1) % 3], from[(t + 2) % 3]);
    const double along = dot(across, from[t]);
    const double length = std::sqrt(dot(across, across));
    if (along != 0.0 && length > 0.0) patch.keep_off((along > 0.0 ? -1.0 : 1.0) / length * across, 0.0);
  }
}

void SurfaceOutline::keep_off_probes(uint32_t v, SphericalPatch &patch) const {
  const CutPatches &cut = surface_.cut_patches();
  for (const uint32_t a : cut.arcs_of_vertex(v)) {
    if (cut.arc(a).is_side()) continue;
    const Vec3 away = -towards_vertex(probe_at(v), cut.arc(a).across);
    const double distance = std::sqrt(dot(away, away));
    if (distance > 0.0) patch.keep_off(1.0 / distance * away, distance / (2 * probe()));
  }
}

// ---- bands ----

// A part of a band: how many points its edges have, and their numbers.
struct SurfaceOutline::Grid {
  uint32_t part, patch;
  uint32_t turns, rows;   // segments of rims and sides
  bool closed;            // a whole circle
  uint32_t rim[2];        // first samples; of a rim that is a cusp, no_id
  uint32_t side[2];       // first samples, by ends of the arc
  uint32_t corner[2][2];  // by ends and balls; cusps are corners, too
  uint32_t inner;         // first point inside

  uint32_t at(uint32_t k, uint32_t l) const {
    const uint32_t turn = closed && k == turns ? 0 : k;
    const bool at_end = !closed && (k == 0 || k == turns);
    const uint32_t end = k == 0 ? 0 : 1;
    const uint32_t before = closed ? 0 : 1;  // points of a rim before its first sample
    if (l == 0 || l == rows) {
      const uint32_t ball = l == 0 ? 0 : 1;
      return at_end || rim[ball] == no_id ? corner[end][ball] : rim[ball] + (turn - before);
    }
    return at_end ? side[end] + (l - 1) : inner + (turn - before) * (rows - 1) + (l - 1);
  }
};

SurfaceOutline::Grid SurfaceOutline::grid_of_arc(uint32_t arc, uint32_t part, bool has_cusps) const {
  const uint32_t rim[2] = {2 * arc, 2 * arc + 1};
  const uint32_t h = 2 * rim[part] + part;  // with the saddle on its left
  // The sides at the ends of the arc, from ball 0 to ball 1.
  const uint32_t side[2] = {(part == 0 ? map_.previous(h) : map_.next(h)) & ~UINT32_C(1),
                            (part == 0 ? map_.next(h) : map_.previous(h)) & ~UINT32_C(1)};
  Grid grid{};
  grid.part = part;
  grid.patch = map_.left(h);
  grid.turns = curve_[rim[0]].segments;
  grid.rows = curve_[side[0] / 2].segments;
  for (uint32_t k = 0; k < 2; ++k) {
    grid.rim[k] = has_cusps && k != part ? no_id : curve_[rim[k]].first_sample;
    grid.side[k] = curve_[side[k] / 2].first_sample;
    grid.corner[k][0] = map_.origin(side[k]);
    grid.corner[k][1] = map_.origin(SurfaceMap::twin(side[k]));
  }
  return grid;
}

SurfaceOutline::Grid SurfaceOutline::grid_of_circle(uint32_t circle, uint32_t part, const SaddleBand &band,
                                                    double length) const {
  const uint32_t first_rim = 2 * boundary_.arc_count() + 2 * circle;
  Grid grid{};
  grid.part = part;
  grid.patch = map_.left(2 * (first_rim + part) + part);
  grid.closed = true;
  grid.turns = curve_[first_rim].segments;
  const double rows = segments_of(band.length(part), length, 1.0);
  grid.rows = rows < max_count ? static_cast<uint32_t>(rows) : max_count;
  const uint32_t cusped = surface_.cusped_circles().of_circle(circle);
  for (uint32_t k = 0; k < 2; ++k) {
    const bool is_cusp = band.has_cusps() && k != part;
    grid.rim[k] = is_cusp ? no_id : curve_[first_rim + k].first_sample;
    if (!is_cusp) continue;
    const uint32_t s = surface_.cusped_circles().ball(cusped, 0) == band.ball(part) ? 0 : 1;
    grid.corner[0][k] = grid.corner[1][k] = map_.first_cusp() + 2 * cusped + s;
  }
  return grid;
}

bool SurfaceOutline::add_bands(double length, FixedVector<MeshVertex> &vertices,
                               FixedVector<MeshTriangle> &triangles) const {
  const uint32_t arcs = boundary_.arc_count();
  for (uint32_t k = 0; k < arcs + boundary_.circle_count(); ++k) {
    const bool is_arc = k < arcs;
    const SaddleBand band = band_of_saddle(k);
    for (uint32_t part = 0; part < band.parts(); ++part) {
      Grid grid = is_arc ? grid_of_arc(k, part, band.has_cusps()) : grid_of_circle(k - arcs, part, band, length);
      if (!map_.is_chosen(grid.patch)) continue;
      if (2.0 * grid.turns * grid.rows + static_cast<double>(triangles.required()) > max_count) return false;
      add_grid(band, grid, vertices, triangles);
    }
  }
  return true;
}

void SurfaceOutline::add_grid(const SaddleBand &band, Grid &grid, FixedVector<MeshVertex> &vertices,
                              FixedVector<MeshTriangle> &triangles) const {
  grid.inner = clamped_count(vertices.required());
  for (uint32_t k = grid.closed ? 0 : 1; k < grid.turns; ++k) {
    const Vec3 outward = band.outward(k, grid.turns);
    for (uint32_t l = 1; l < grid.rows; ++l) vertices.push(vertex_of(band.at(outward, grid.part, l, grid.rows)));
  }
  for (uint32_t l = 0; l < grid.rows; ++l) {
    const uint32_t ball = band.ball_of_row(grid.part, l, grid.rows);
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
      triangles.push({{a, b, c}, grid.patch, ball, grid.closed ? PatchKind::circle_saddle : PatchKind::saddle});
    };
    for (uint32_t k = 0; k < grid.turns; ++k) {
      const uint32_t corner[4] = {grid.at(k, l), grid.at(k + 1, l), grid.at(k + 1, l + 1), grid.at(k, l + 1)};
      if (l == 0 && grid.rim[0] == no_id) {
        add(corner[0], corner[2], corner[3]);
      } else if (l + 1 == grid.rows && grid.rim[1] == no_id) {
        add(corner[0], corner[1], corner[2]);
      } else if (is_shorter(vertices, corner[0], corner[2], corner[1], corner[3])) {
        add(corner[0], corner[1], corner[2]);
        add(corner[0], corner[2], corner[3]);
      } else {
        add(corner[1], corner[2], corner[3]);
        add(corner[1], corner[3], corner[0]);
      }
    }
  }
}

// ---- limits ----

// As in mesh_builder.cpp for a boundary.
Status expected_mesh_limits(const BallSet &balls, const Boundary &boundary, const Surface &surface, double edge,
                            MeshLimits &limits) {
  if (balls.probe_steps == 0) return expected_mesh_limits(balls, boundary, edge, limits);
  if (!surface.is_closed()) return Status::check;
  const SurfaceOutline outline(balls, boundary, surface, {});
  return outline.expected_limits(edge, limits);
}

Status SurfaceOutline::expected_limits(double edge, MeshLimits &limits) const {
  MeshSizes sizes;
  sizes.add_points(map_.corner_count());
  for (uint32_t c = 0; c < curve_count(); ++c) sizes.add_points(segments_of_edge(c, edge));
  for (uint32_t s = 0; s < sphere_count(); ++s) {
    if (!has_patches(s)) continue;
    double border = 0.0;
    double steradians = 0.0;
    const auto add_edges = [&](uint32_t patch) {
      map_.for_each_loop(patch, [&](uint32_t loop) {
        map_.for_each_edge(loop, [&](uint32_t h) { border += segments_of_edge(h / 2, edge); });
      });
    };
    if (s < balls_.n) {
      for (const uint32_t face : boundary_.faces(s)) add_edges(face);
      const double R = balls_.r[s];
      steradians = measure_ball(balls_, boundary_, s).area / (R * R);
    } else {
      const uint32_t v = s - balls_.n;
      const IdRange pieces = surface_.cut_patches().pieces(v);
      const uint32_t count = pieces.empty() ? 1 : pieces.size();
      for (uint32_t face = 0; face < count; ++face) add_edges(map_.concave_patch(v, pieces.first + face));
      steradians = surface_.patch(v).area / (probe() * probe());
    }
    sizes.add_sphere(border, steradians, spacing(s, edge));
  }
  for (uint32_t k = 0; k < boundary_.arc_count() + boundary_.circle_count(); ++k) {
    const SaddleBand band = band_of_saddle(k);
    const double turns = segments_of(band.width(), edge, fewest_of_circle);
    for (uint32_t part = 0; part < band.parts(); ++part)
      sizes.add_points(turns * segments_of(band.length(part), edge, 1.0));
  }
  return sizes.limits(sphere_count(), curve_count(), limits);
}

}  // namespace hsp
