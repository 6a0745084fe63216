#include "surface/surface_builder.hpp"

#include "core/begin_array.hpp"
#include "surface/patch_corners.hpp"

namespace hsp {
namespace {

// For so many arcs there is room for one crease, and for one corner of three creases. A crease is two arcs, and three
// creases start or end in a corner; the other arcs are sides, and a reserve.
constexpr uint32_t arcs_for_crease = 4, arcs_for_corner = 8;

// Arcs and pieces for each vertex that suffice for most small sets in which doubles do not decide, and the most of them
// that are asked for at once, rather than after all corners are found.
constexpr uint32_t tied_arcs = 24, most_tied_arcs = 1024, tied_pieces = 4, most_tied_pieces = 192;

// Words of memory for each arc that there may be around a patch: in doubles, and for either way of cutting.
constexpr uint32_t words_in_doubles = words_of<RegionCorner>(1) + words_of<RegionArc>(1);
constexpr uint32_t words_for_arc =
    words_in_doubles < CreasedPatches::words_of_arc ? CreasedPatches::words_of_arc : words_in_doubles;

}  // namespace

// The union of m >= 3 caps has at most 6m - 12 corners, as a planar graph has at most 3m - 6 edges. There are at most
// as many arcs, and circles without corners.
void SurfaceBuilder::carve(Workspace &workspace, const SurfaceLimits &limits) {
  limit(limits);
  const uint64_t nodes = uint64_t{limits.faces} + limits.pieces;
  grid_.carve(workspace, limits.vertices, nodes);
  surface_.concave_.use(grid_);
  probe_.carve(workspace, limits.neighbours);
  surface_.cut_patches_.carve(workspace, limits.vertices, limits.pieces, limits.arcs);
  surface_.cusped_circles_.carve(workspace, limits.cusped_circles);
  surface_.chosen_.carve(workspace, limits.faces);
  surface_.shells_.use(grid_.first_shared());
  surface_.scratch_ = grid_.second_shared();
  surface_.first_half_edges_.carve(workspace, 3 * uint64_t{limits.vertices});
  surface_.touching_.carve(workspace, limits.vertices);
  const uint64_t caps = uint64_t{limits.neighbours} + ProbeCaps::sides;
  border_room_ = workspace.take<uint64_t>(6 * caps * words_for_arc);
  use_for_doubles();
  creases_.carve(workspace, limits.neighbours, limits.arcs / arcs_for_crease, limits.arcs / arcs_for_corner);
}

Status SurfaceBuilder::build(const BallSet &balls, const Boundary &boundary, Patience patience,
                             const Span<const uint32_t> *shells) {
  CutPatches &cut = surface_.cut_patches_;
  CuspedCircles &cusped = surface_.cusped_circles_;
  surface_.of_actual_balls_ = false;
  cut.clear();
  cusped.clear();
  needed_ = {boundary.vertex_count(), boundary.face_count()};
  if (needed_.vertices > limits_.vertices || needed_.faces > limits_.faces) return Status::capacity;
  if (shells == nullptr) {
    surface_.chosen_.choose_all();
  } else {
    surface_.chosen_.choose(boundary, *shells, surface_.scratch_);
  }
  number_arcs(boundary);
  if (!patience.allows(50 * uint64_t{boundary.ball_count()})) return Status::stopped;
  surface_.touching_.clear(needed_.vertices);
  if (balls.probe_steps == 0) {
    for (uint32_t v = 0; v < needed_.vertices; ++v) cut.begin_vertex(v);
    cut.finish(needed_.vertices);
    surface_.concave_.clear(needed_.vertices);
  } else {
    if (!grid_.build(balls, boundary, patience)) return Status::stopped;
    const Status status = find_patches(ActualBalls(balls, boundary), patience);
    if (status != Status::ok) return status;
    if (!surface_.concave_.measure(balls, boundary, grid_.positions(), cut, patience)) return Status::stopped;
  }
  surface_.touching_.count();
  surface_.shells_.find(boundary, cusped, cut, patience);
  return patience.allows(0) ? Status::ok : Status::stopped;
}

Status SurfaceBuilder::find_patches(const ActualBalls &actual, Patience &patience) {
  if (!surface_.cusped_circles_.find(actual, patience)) return Status::stopped;
  needed_.cusped_circles = clamped_count(surface_.cusped_circles_.required());
  if (!cut_patches(actual.balls(), actual.boundary(), patience)) return Status::stopped;
  if (!fits()) return Status::capacity;
  if (certain_ && join_patches(actual.boundary(), surface_.cusped_circles_, patience, surface_.cut_patches_) == 0) {
    return Status::ok;
  }
  return cut_actual_patches(actual, patience);
}

// Whether there is room for all that is needed, as far as that is known.
bool SurfaceBuilder::fits() const {
  return needed_.neighbours <= limits_.neighbours && needed_.cusped_circles <= limits_.cusped_circles &&
         needed_.pieces <= limits_.pieces && needed_.arcs <= limits_.arcs;
}

// Cuts each patch on its own, in doubles. False if `patience` stops it.
bool SurfaceBuilder::cut_patches(const BallSet &balls, const Boundary &boundary, Patience &patience) {
  CutPatches &cut = surface_.cut_patches_;
  certain_ = true;
  uint32_t most_found = 0;
  for (uint32_t v = 0; v < needed_.vertices; ++v) {
    // About as many as at the vertex before.
    const uint64_t met = v > 0 ? probe_.met() : 0;
    if (!patience.allows(3000 + (500 + met) * met)) return false;
    cut.begin_vertex(v);
    const bool is_crossed = probe_.gather(balls, boundary, surface_.chosen_, grid_, v);
    if (probe_.touches()) surface_.touching_.set(v);
    needed_.neighbours = larger_count(needed_.neighbours, clamped_count(probe_.met()));
    most_found = larger_count(most_found, probe_.found());
    if (probe_.is_doubtful()) certain_ = false;
    if (!is_crossed || probe_.overflowed()) continue;
    if (!cut_in_doubles(balls, boundary, v)) certain_ = false;
  }
  cut.finish(needed_.vertices);
  // Decisions about the actual set need more room, and may find other pieces.
  if (!certain_) {
    const uint64_t v = needed_.vertices;
    need_arcs(tied_arcs * v < most_tied_arcs ? tied_arcs * v : most_tied_arcs);
    needed_.pieces = clamped_count(tied_pieces * v < most_tied_pieces ? tied_pieces * v : most_tied_pieces);
    needed_.neighbours = larger_count(needed_.neighbours, most_found);
    return true;
  }
  needed_.pieces = clamped_count(cut.required_pieces());
  needed_.arcs = clamped_count(cut.required_arcs());
  return true;
}

void SurfaceBuilder::use_for_doubles() {
  const uint32_t n = border_room_.size() / words_for_arc, corners = words_of<RegionCorner>(n);
  corners_ = FixedVector(begin_array<RegionCorner>(border_room_.part(0, corners)).part(0, n));
  arcs_ = FixedVector(begin_array<RegionArc>(border_room_.part(corners, border_room_.size())).part(0, n));
}

Status SurfaceBuilder::cut_actual_patches(const ActualBalls &actual, Patience &patience) {
  CutPatches &cut = surface_.cut_patches_;
  surface_.of_actual_balls_ = true;
  // The memory of patches that are cut on their own is free.
  actual.keep_vertices(begin_array<uint64_t>(border_room_));
  Status status =
      creases_.build(actual, surface_.chosen_, grid_, surface_.cusped_circles_, probe_.triangles(), patience);
  needed_.neighbours = larger_count(needed_.neighbours, creases_.most_near());
  need_arcs(arcs_for_corner * uint64_t{creases_.required_corners()});
  need_arcs(arcs_for_crease * uint64_t{creases_.required_creases()});
  if (status == Status::capacity && fits()) return Status::degenerate;
  if (status == Status::capacity && creases_.most_near() <= limits_.neighbours) {
    // Creases end in corners and cusps, and few are whole circles. Each is an arc in two patches, and a patch has at
    // most six arcs of sides.
    const uint64_t ends = 3 * uint64_t{creases_.required_corners()} + 2 * uint64_t{surface_.cusped_circles_.arcs()};
    const uint64_t creases = larger_count(clamped_count(ends / 2 + needed_.vertices), creases_.required_creases());
    need_arcs(arcs_for_crease * creases);
    need_arcs(2 * creases + 6 * uint64_t{needed_.vertices});
    needed_.pieces = larger_count(needed_.pieces, clamped_count(creases + needed_.vertices));
  }
  if (status != Status::ok) return status;
  creased_.use(begin_array<uint64_t>(border_room_));
  status = creased_.fill({actual, grid_, surface_.cusped_circles_, creases_}, cut, patience);
  actual.keep_vertices({});
  use_for_doubles();
  if (status != Status::ok) return status;
  needed_.pieces = larger_count(needed_.pieces, clamped_count(cut.required_pieces()));
  need_arcs(cut.required_arcs());
  if (cut.overflowed()) return Status::capacity;
  return Status::ok;
}

void SurfaceBuilder::number_arcs(const Boundary &boundary) {
  RankedBits &first = surface_.first_half_edges_;
  first.clear(boundary.half_edge_count());
  for (uint32_t i = 0; i < boundary.ball_count(); ++i) {
    for (const uint32_t e : boundary.half_edges(i)) {
      first.set_if(e, i < boundary.half_edge(e).circle);
    }
  }
  first.count();
}

// Stores the loops of a piece one after the other, the one around the piece first.
void SurfaceBuilder::store_pieces(const Boundary &boundary, uint32_t vertex, const ConcaveScale &scale) {
  CutPatches &cut = surface_.cut_patches_;
  const Caps &caps = probe_.caps();
  const Span<const RegionArc> arcs = arcs_.items();
  for (uint32_t piece = 0; piece < arcs.size(); ++piece) {
    if (arcs[piece].piece != piece) continue;
    double steradians = 0.0;
    Vec3 vector_area{0.0, 0.0, 0.0};
    CreaseSums creases;
    for (uint32_t k = 0; k < arcs.size(); ++k) {
      const RegionArc &arc = arcs[k];
      if (arc.piece != piece) continue;
      Vec3 chord{0.0, 0.0, 0.0};
      if (arc.end != no_id) chord = corners_[arc.end].point - corners_[arc.start].point;
      if (arc.circle >= ProbeCaps::sides) creases.add({caps.axis(arc.circle), caps.b[arc.circle], arc.angle, chord});
      steradians += arc.curvature;
      if (arc.loop == k) steradians += k == piece ? 2 * pi : -2 * pi;
      vector_area = vector_area + arc.vector_area;
    }
    const ConcavePatch measured = scale.patch(steradians > 0.0 ? steradians : 0.0, vector_area);
    cut.begin_piece(vertex, measured.area, measured.volume, creases);
    for (uint32_t loop = 0; loop < arcs.size(); ++loop) {
      if (arcs[loop].piece != piece || arcs[loop].loop != loop) continue;
      for_each_of_loop(arcs, loop, [&](uint32_t k) {
        const uint32_t circle = arcs[k].circle;
        const uint32_t across = circle < ProbeCaps::sides
                                    ? PatchArc::side(boundary.vertex(vertex).slot_of(probe_.ball_opposite(circle)))
                                    : caps.ball[circle];
        cut.add_arc(across, arcs[k].angle, arcs[k].next == loop);
      });
    }
  }
}

// False if doubles are not certain.
bool SurfaceBuilder::cut_in_doubles(const BallSet &balls, const Boundary &boundary, uint32_t vertex) {
  FreeRegion region;
  int32_t characteristic = 0;
  FreeRegionFinder finder(probe_.caps(), probe_.amplification(), corners_, arcs_);
  if (!finder.find(region) || arcs_.items().empty()) return false;
  const Span<RegionArc> arcs = arcs_.items();
  bool is_cut = false;
  for (const RegionArc &arc : arcs) is_cut = is_cut || arc.circle >= ProbeCaps::sides;
  if (!is_cut) return true;
  if (!find_pieces(arcs, characteristic)) return false;
  const ConcaveScale scale(balls, boundary, grid_.position(vertex));
  const double steradians = region.curvature + 2 * pi * characteristic;
  store_pieces(boundary, vertex, scale);
  surface_.cut_patches_.set_patch(vertex, scale.patch(steradians > 0.0 ? steradians : 0.0, region.vector_area));
  return true;
}

}  // namespace hsp
