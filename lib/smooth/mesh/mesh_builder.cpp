#include "mesh/mesh_builder.hpp"

#include "core/sorting.hpp"
#include "mesh/mesh_sizes.hpp"

namespace hsp {

namespace {

// How often points of curves are doubled at most, and the most segments of a curve that is doubled.
constexpr int most_rounds = 12;
constexpr uint32_t most_segments = UINT32_C(1) << 14;
// Borders may be pinched after so many rounds, or where points cannot be nearer each other.
constexpr int rounds_before_pinching = 4;
// There may be so many times the vertices of the first round, and some more. Borders that approach each other would ask
// for ever more.
constexpr uint64_t most_growth = 8;
constexpr uint64_t growth_of_small_meshes = 20000;
// Patches with less area on the unit sphere are made from their loops alone: below no_area at once, below small_area if
// all else has failed.
constexpr double no_area = 2e-7, small_area = 1e-2;

}  // namespace

void MeshBuilder::carve(Workspace &workspace, const MeshLimits &limits) {
  limit(limits);
  mesh_.vertices_ = FixedVector(workspace.take<MeshVertex>(limits.vertices));
  mesh_.triangles_ = FixedVector(workspace.take<MeshTriangle>(limits.triangles));
  vertex_moves_ = workspace.take<uint32_t>(limits.vertices);
  curves_.carve(workspace, limits.curves);
  range_ = workspace.take<PatchRange>(limits.balls);
  patch_.carve(workspace, limits.points);
}

Status MeshBuilder::build(const MeshedSurface &from, double edge, Patience patience) {
  if (from.is_smooth()) {
    SurfaceOutline outline(from.balls, from.boundary, *from.smooth, curves_.room());
    return build_all(outline, edge, patience);
  }
  const ChosenFaces all;
  BoundaryOutline outline(from.balls, from.boundary, curves_, from.smooth == nullptr ? all : from.smooth->chosen());
  return build_all(outline, edge, patience);
}

template <class Outline>
Status MeshBuilder::build_all(Outline &outline, double edge, Patience &patience) {
  needed_ = {outline.sphere_count(), outline.curve_count(), 0, 0, 0};
  if (needed_.balls > limits_.balls || needed_.curves > limits_.curves) return Status::capacity;
  const bool too_many = has_too_many_inside(outline, edge, patience);
  if (!patience.allows(0)) return Status::stopped;
  if (too_many) return Status::range;
  if (!patience.allows(2000 * uint64_t{needed_.curves})) return Status::stopped;
  const Status status = triangulate_all(outline, edge, patience);
  if (status == Status::degenerate || status == Status::range || status == Status::stopped) return status;
  const uint32_t first_of_bands = clamped_count(mesh_.triangles_.required());
  if (!outline.add_bands(edge, patience, mesh_.vertices_, mesh_.triangles_))
    return patience.allows(0) ? Status::range : Status::stopped;
  const uint64_t vertices = mesh_.vertices_.required();
  const uint64_t triangles = mesh_.triangles_.required();
  needed_.vertices = clamped_count(vertices);
  needed_.triangles = clamped_count(triangles);
  if (vertices > max_count || triangles > max_count || needed_.points > max_count) return Status::range;
  if (vertices > limits_.vertices || triangles > limits_.triangles || needed_.points > limits_.points) {
    return Status::capacity;
  }
  remove_outdated(first_of_bands, patience);
  if (!name_balls(outline, patience)) return Status::stopped;
  sort_by_patches(patience);
  return patience.allows(0) ? Status::ok : Status::stopped;
}

// Decided by areas, before any point is made.
template <class Outline>
bool MeshBuilder::has_too_many_inside(const Outline &outline, double edge, Patience &patience) const {
  PointsInside points;
  for (uint32_t s = 0; s < outline.sphere_count() && patience.allows(3000); ++s) {
    const double spacing = outline.spacing(s, edge);
    if (PointsInside::has_many(spacing)) points.add(outline.steradians(s), spacing);
  }
  return points.are_too_many();
}

// Status::capacity if there is no room for the points of a sphere.
template <class Outline>
Status MeshBuilder::triangulate_all(Outline &outline, double edge, Patience &patience) {
  const uint32_t spheres = outline.sphere_count();
  mesh_.vertices_.clear();
  mesh_.triangles_.clear();
  if (!outline.divide_curves(edge, patience)) return patience.allows(0) ? Status::range : Status::stopped;
  mesh_.curves_ = outline.curve_count();
  mesh_.refined_ = 0;
  for (uint32_t v = 0; v < outline.corner_count(); ++v) {
    if (!patience.allows(300)) return Status::stopped;
    mesh_.vertices_.push(outline.corner(v));
  }
  for (uint32_t c = 0; c < outline.curve_count(); ++c) {
    if (!patience.allows(3000)) return Status::stopped;
    add_samples(outline, c);
  }
  for (uint32_t s = 0; s < spheres; ++s) {
    if (!patience.allows(50)) return Status::stopped;
    range_[s] = {0, 0, outline.has_patches(s), false};
  }
  // Patches read nothing that is stored in the mesh, so everything is counted even if there is no room for it.
  uint64_t most_vertices = 0;
  uint64_t before = 0;  // points of the sphere before
  int pinching_from = rounds_before_pinching;
  for (int round = 0; round < most_rounds; ++round) {
    bool complete = true;
    for (uint32_t s = 0; s < spheres; ++s) {
      if (!range_[s].outdated) {
        if (!patience.allows(10)) return Status::stopped;
        continue;
      }
      if (!patience.allows(10000 + 2000 * before)) return Status::stopped;
      range_[s].outdated = false;
      range_[s].unfinished = !triangulate(outline, edge, s, round >= pinching_from);
      complete = complete && !range_[s].unfinished;
      before = patch_.needed_points();
      needed_.points = larger_count(needed_.points, clamped_count(before));
    }
    if (needed_.points > limits_.points) return Status::capacity;
    if (complete) return Status::ok;
    if (round == 0) most_vertices = most_growth * mesh_.vertices_.required() + growth_of_small_meshes;
    const bool refined = refine(outline, patience);
    if (!patience.allows(0)) return Status::stopped;
    if (refined && mesh_.vertices_.required() <= most_vertices) continue;
    if (round >= pinching_from) break;
    pinching_from = round + 1;
    for (uint32_t s = 0; s < spheres; ++s) range_[s].outdated = range_[s].outdated || range_[s].unfinished;
  }
  return triangulate_rest(outline, edge, patience);
}

// Makes all patches that have no triangles yet, or whose curves have other points than before, without any more points.
template <class Outline>
Status MeshBuilder::triangulate_rest(Outline &outline, double edge, Patience &patience) {
  for (uint32_t s = 0; s < outline.sphere_count(); ++s) {
    if (!range_[s].outdated && !range_[s].unfinished) continue;
    if (!patience.allows(10000 + 2000 * patch_.needed_points())) return Status::stopped;
    bool done = range_[s].outdated && triangulate(outline, edge, s, true);
    uint64_t needed = range_[s].outdated ? patch_.needed_points() : 0;
    if (!done && outline.has_next_to_no_area(s, small_area)) {
      done = attempt(outline, edge, s, Borders::without_area) == PatchState::complete;
      needed = needed > patch_.needed_points() ? needed : patch_.needed_points();
    }
    needed_.points = larger_count(needed_.points, clamped_count(needed));
    if (!done && needed_.points <= limits_.points) return Status::degenerate;
  }
  return needed_.points > limits_.points ? Status::capacity : Status::ok;
}

template <class Outline>
void MeshBuilder::add_samples(Outline &outline, uint32_t c) {
  outline.curve(c).first_sample = clamped_count(mesh_.vertices_.required());
  outline.add_samples(c, mesh_.vertices_);
}

// Until name_balls() the `ball` of a triangle is the number of its sphere.
template <class Outline>
PatchState MeshBuilder::attempt(Outline &outline, double edge, uint32_t sphere, Borders borders) {
  patch_.begin(outline.spacing(sphere, edge));
  outline.add_border(sphere, patch_);
  const PatchState state = borders == Borders::without_area ? patch_.triangulate_from_loops()
                                                            : patch_.triangulate(borders == Borders::pinched);
  if (state != PatchState::complete) return state;
  range_[sphere].first = clamped_count(mesh_.triangles_.required());
  const PatchKind kind = outline.kind(sphere);
  patch_.emit(
      [&](const Vec3 &direction) {
        const uint32_t number = clamped_count(mesh_.vertices_.required());
        mesh_.vertices_.push(outline.inner_vertex(sphere, direction));
        return number;
      },
      [&](uint32_t face, const uint32_t *corners) {
        mesh_.triangles_.push({{corners[0], corners[1], corners[2]}, outline.patch(sphere, face), sphere, kind});
      });
  range_[sphere].last = clamped_count(mesh_.triangles_.required());
  return state;
}

template <class Outline>
bool MeshBuilder::triangulate(Outline &outline, double edge, uint32_t sphere, bool pinched) {
  const bool has_no_area = outline.has_next_to_no_area(sphere, no_area);
  PatchState state = attempt(outline, edge, sphere, has_no_area ? Borders::without_area : Borders::apart);
  if (state == PatchState::too_coarse && pinched && !has_no_area) {
    state = attempt(outline, edge, sphere, Borders::pinched);
  }
  if (state == PatchState::too_coarse && !has_no_area) {
    patch_.for_each_coarse_curve([&](uint32_t c) { outline.curve(c).refine = true; });
  }
  return state == PatchState::complete;
}

// Doubles the segments of the curves that want it, and of their partners. The spheres on both sides become outdated.
// False if no curve wants it, or if one has too many segments already; the curves behind that one get no more.
template <class Outline>
bool MeshBuilder::refine(Outline &outline, Patience &patience) {
  bool any = false;
  bool may_go_on = true;
  for (uint32_t c = 0; c < outline.curve_count(); ++c) {
    if (!patience.allows(10)) return false;
    if (outline.curve(c).refine) outline.curve(outline.partner(c)).refine = true;
  }
  for (uint32_t c = 0; c < outline.curve_count(); ++c) {
    MeshCurve &curve = outline.curve(c);
    if (!patience.allows(curve.refine ? 5000 : 10)) return false;
    if (!curve.refine) continue;
    curve.refine = false;
    may_go_on = may_go_on && curve.segments <= most_segments && !outline.is_too_fine(c);
    if (!may_go_on) continue;
    any = true;
    curve.segments *= 2;
    if (!curve.refined) ++mesh_.refined_;
    curve.refined = true;
    add_samples(outline, c);
    outline.for_each_sphere(c, [&](uint32_t sphere) { range_[sphere].outdated = true; });
  }
  return any && may_go_on;
}

// Keeps the latest triangles of every sphere, and the vertices that they have.
void MeshBuilder::remove_outdated(uint32_t first_of_bands, Patience &patience) {
  FixedVector<MeshTriangle> &triangles = mesh_.triangles_;
  FixedVector<MeshVertex> &vertices = mesh_.vertices_;
  const uint32_t old_vertices = vertices.size();
  const uint32_t old_triangles = triangles.size();
  in_parts(patience, IdRange{0, old_vertices}, 2, [&](IdRange some) {
    for (const uint32_t v : some) vertex_moves_[v] = no_id;
  });
  uint32_t kept = 0;
  for (uint32_t t = 0; t < old_triangles; ++t) {
    if (!patience.allows(50)) return;
    if (t < first_of_bands) {
      const PatchRange &range = range_[triangles[t].ball];
      if (t < range.first || t >= range.last) continue;
    }
    triangles[kept++] = triangles[t];
    for (const uint32_t v : triangles[t].vertex) vertex_moves_[v] = 0;
  }
  triangles.shrink(kept);
  kept = 0;
  for (uint32_t v = 0; v < old_vertices; ++v) {
    if (!patience.allows(50)) return;
    if (vertex_moves_[v] == no_id) continue;
    vertices[kept] = vertices[v];
    vertex_moves_[v] = kept++;
  }
  vertices.shrink(kept);
  for (MeshTriangle &triangle : triangles.items()) {
    if (!patience.allows(20)) return;
    for (uint32_t &v : triangle.vertex) v = vertex_moves_[v];
  }
}

template <class Outline>
bool MeshBuilder::name_balls(const Outline &outline, Patience &patience) {
  for (MeshTriangle &triangle : mesh_.triangles_.items()) {
    if (!patience.allows(100)) return false;
    if (triangle.kind != PatchKind::convex && triangle.kind != PatchKind::concave) continue;
    double middle[3] = {0.0, 0.0, 0.0};
    for (const uint32_t v : triangle.vertex) {
      for (uint32_t axis = 0; axis < 3; ++axis) middle[axis] += mesh_.vertices_[v].position[axis] / 3;
    }
    triangle.ball = outline.ball_at(triangle.ball, middle);
  }
  return true;
}

void MeshBuilder::sort_by_patches(Patience &patience) {
  const Span<MeshTriangle> triangles = mesh_.triangles_.items();
  if (triangles.empty()) return;
  bool sorted = true;
  uint32_t last = triangles[0].patch;
  in_parts(patience, IdRange{1, triangles.size()}, 5, [&](IdRange some) {
    for (const uint32_t t : some) {
      sorted &= triangles[t - 1].patch <= triangles[t].patch;
      last = triangles[t].patch > last ? triangles[t].patch : last;
    }
  });
  if (sorted) return;
  // vertex_moves_ is free again. A slot is one patch if there is room for all patches, else some patches that follow
  // each other.
  uint32_t shift = 0;
  while (last >> shift >= (vertex_moves_.size() - 1) / 2) ++shift;
  sort_by_slot(
      triangles, vertex_moves_, (last >> shift) + 1,
      [shift](const MeshTriangle &triangle) { return triangle.patch >> shift; },
      [&](const MeshTriangle &a, const MeshTriangle &b) {
        if (!patience.allows(50)) return false;
        if (a.patch != b.patch) return a.patch < b.patch;
        for (uint32_t k = 0; k < 3; ++k) {
          if (a.vertex[k] != b.vertex[k]) return a.vertex[k] < b.vertex[k];
        }
        return false;
      },
      [&] { return patience.allows(30); });
}

}  // namespace hsp
