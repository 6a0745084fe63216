#include "surface/surface_builder.hpp"

#include "surface/arc_parts.hpp"
#include "surface/circles_in_doubles.hpp"
#include "surface/circles_in_integers.hpp"
#include "surface/crease_lengths.hpp"
#include "surface/probe_positions.hpp"
#include "surface/settled_circles.hpp"

namespace hsp {
namespace {

// Areas on the unit sphere that differ by less are the same up to rounding.
constexpr double least_steradians = 1e-6;

// An angle between two vertices on the circle of balls that touch. Areas are off by twice as much if they count as one.
constexpr double least_turn = 0x1p-26;

}  // namespace

// The arcs around the union of m caps have at most 6m - 12 corners for m >= 3, as the edges of a planar graph; so many
// arcs, and circles without corners.
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
  corners_ = FixedVector(workspace.take<RegionCorner>(6 * caps));
  arcs_ = FixedVector(workspace.take<RegionArc>(6 * caps));
}

Status SurfaceBuilder::build(const BallSet &balls, const Boundary &boundary, Patience patience) {
  return build(balls, boundary, nullptr, patience);
}

Status SurfaceBuilder::build(const BallSet &balls, const Boundary &boundary, Span<const uint32_t> shells,
                             Patience patience) {
  return build(balls, boundary, &shells, patience);
}

Status SurfaceBuilder::build(const BallSet &balls, const Boundary &boundary, const Span<const uint32_t> *shells,
                             Patience &patience) {
  CutPatches &cut = surface_.cut_patches_;
  CuspedCircles &cusped = surface_.cusped_circles_;
  surface_.counts_ = {};
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
    surface_.touching_.count();
    surface_.concave_.clear(needed_.vertices);
    surface_.shells_.find(boundary, cusped, cut, patience);
    return patience.allows(0) ? Status::ok : Status::stopped;
  }
  if (!grid_.build(balls, boundary, patience) || !cusped.find(balls, boundary, patience)) return Status::stopped;
  needed_.cusped_circles = clamped_count(cusped.required());
  Status status = cut_patches(balls, boundary, Decisions::of_each_patch, patience);
  if (status != Status::ok) return status;
  // Where joints are open, once more with decisions that patches share, if that helps.
  if (const uint32_t open = surface_.counts_.joints.open; open > 0) {
    status = cut_patches(balls, boundary, Decisions::shared, patience);
    if (status == Status::ok && surface_.counts_.joints.open >= open) {
      status = cut_patches(balls, boundary, Decisions::of_each_patch, patience);
    }
    if (status != Status::ok) return status;
  }
  surface_.counts_.joints.open += surface_.counts_.crowded_points;
  surface_.touching_.count();
  if (!surface_.concave_.measure(balls, boundary, grid_.positions(), cut, patience)) return Status::stopped;
  surface_.counts_.cusped_arcs = cusped.arcs() + cusped.whole_circles();
  surface_.shells_.find(boundary, cusped, cut, patience);
  return patience.allows(0) ? Status::ok : Status::stopped;
}

// All concave patches, and the joints of those that are cut.
Status SurfaceBuilder::cut_patches(const BallSet &balls, const Boundary &boundary, Decisions decisions,
                                   Patience &patience) {
  CutPatches &cut = surface_.cut_patches_;
  const CuspedCircles &cusped = surface_.cusped_circles_;
  const ChosenFaces &chosen = surface_.chosen_;
  FlatPatches flat(balls, boundary, chosen, grid_, cusped);
  surface_.counts_ = {};
  uncertain_pieces_ = 0;
  cut.clear();
  for (uint32_t v = 0; v < needed_.vertices; ++v) {
    // As the vertex before.
    const uint64_t met = v > 0 ? probe_.met() : 0;
    if (!patience.allows((decisions == Decisions::shared ? 100000 : 3000) + (500 + met) * met)) return Status::stopped;
    cut.begin_vertex(v);
    const ProbeState state = probe_.gather(balls, boundary, chosen, grid_, v);
    if (probe_.touches()) surface_.touching_.set(v);
    if (boundary.root_discriminant(v) == 0.0 && is_crowded(balls, boundary, v)) ++surface_.counts_.crowded_points;
    needed_.neighbours = larger_count(needed_.neighbours, clamped_count(probe_.met()));
    if (state == ProbeState::crossed) {
      if (probe_.overflowed()) continue;
      const SurfaceCounts before = surface_.counts_;
      double steradians = 0.0;
      Vec3 vector_area{0.0, 0.0, 0.0};
      if (!measure_cut_patch(steradians, vector_area)) return Status::degenerate;
      if (decisions == Decisions::shared) {
        if (steradians < least_steradians && store_flat_patch(flat, v)) {
          surface_.counts_ = before;
          ++surface_.counts_.cut_patches;
          continue;
        }
        const SettledCircles settled(balls, boundary, chosen, grid_, cusped, probe_);
        if (settle(settled, steradians, vector_area, before)) {
          if (surface_.counts_.cut_patches == before.cut_patches) continue;
          const ConcaveScale scale(balls, boundary, grid_.position(v));
          cut.begin_patch(scale.patch(steradians, vector_area));
          store_pieces(boundary, v, scale, steradians, &settled);
          continue;
        }
        surface_.counts_ = before;
        measure_cut_patch(steradians, vector_area);
      }
      if (surface_.counts_.cut_patches == before.cut_patches) continue;
      const ConcaveScale scale(balls, boundary, grid_.position(v));
      cut.begin_patch(scale.patch(steradians, vector_area));
      store_pieces(boundary, v, scale, steradians, nullptr);
    } else if (decisions == Decisions::shared &&
               (state == ProbeState::hidden || probe_.whole_steradians() < least_steradians) &&
               store_flat_patch(flat, v)) {
      ++surface_.counts_.cut_patches;
    } else if (decisions == Decisions::shared && state == ProbeState::whole && has_opposite_probes(balls, boundary)) {
      const SurfaceCounts before = surface_.counts_;
      const SettledCircles settled(balls, boundary, chosen, grid_, cusped, probe_);
      if (!settle(settled, probe_.whole_steradians(), probe_.whole_vector_area(), before)) continue;
      const ConcaveScale scale(balls, boundary, grid_.position(v));
      surface_.counts_.cut_patches = before.cut_patches + 1;
      cut.begin_patch(scale.patch(probe_.whole_steradians(), probe_.whole_vector_area()));
      store_pieces(boundary, v, scale, probe_.whole_steradians(), &settled);
    } else if (state == ProbeState::hidden) {
      ++surface_.counts_.cut_patches;
      ++surface_.counts_.hidden_patches;
      cut.begin_patch({});
      cut.begin_piece(v, 0.0, 0.0);
    }
  }
  cut.finish(needed_.vertices);
  needed_.pieces = larger_count(needed_.pieces, clamped_count(cut.required_pieces()));
  needed_.arcs = larger_count(needed_.arcs, clamped_count(cut.required_arcs()));
  if (needed_.neighbours > limits_.neighbours || cut.overflowed() || needed_.cusped_circles > limits_.cusped_circles) {
    return Status::capacity;
  }
  surface_.counts_.joints = join_patches(boundary, cusped, patience, cut);
  // A hidden patch lacks even its corners, which convex patches and saddles have.
  surface_.counts_.joints.open += uncertain_pieces_ + surface_.counts_.hidden_patches;
  if (surface_.counts_.joints.uneven > 0) {
    const CreaseLengths lengths(balls, boundary, cut);
    for (uint32_t k = 0; k < cut.creases().size() && patience.allows(1000); ++k) {
      surface_.counts_.joints.open += lengths.agree(cut.creases().member(k)) ? 0 : 1;
    }
  }
  return patience.allows(0) ? Status::ok : Status::stopped;
}

// Of a vertex in which two balls touch: whether in that point there are vertices of others, not of both, or one of both
// in a direction so near to its own that they count as one vertex.
bool SurfaceBuilder::is_crowded(const BallSet &balls, const Boundary &boundary, uint32_t vertex) const {
  const uint32_t third = third_of_touching(balls, boundary, vertex);
  if (third == 3) return false;
  const VertexRecord &record = boundary.vertex(vertex);
  const uint32_t a = record.ball[(third + 1) % 3], b = record.ball[(third + 2) % 3];
  const Position here = position_of_vertex(balls, boundary, vertex);
  const double most = coincident_distance * static_cast<double>(balls.probe_steps);
  const double least = least_turn * radius_of_touching * static_cast<double>(balls.probe_steps);
  ProbeSearch search;
  grid_.start_search(balls, vertex, search);
  for (uint32_t r = 0; r < search.ranges; ++r) {
    for (uint32_t k = search.range[r].first; k < search.range[r].last; ++k) {
      const uint32_t other = search.vertex[k];
      const VertexRecord &others = boundary.vertex(other);
      if (others.has(a) && others.has(b)) {
        const Vec3 between = grid_.difference(balls, vertex, other);
        const double square = dot(between, between);
        if (square < most * most && square > least * least) return true;
        continue;
      }
      const Position there = position_of_vertex(balls, boundary, other);
      const Vec3 apart = balls.difference(here.ball, there.ball) + (there.offset - here.offset);
      if (dot(apart, apart) < most * most) return true;
    }
  }
  return false;
}

// Of a whole patch: whether some side has a crease with a vertex at the same position.
bool SurfaceBuilder::has_opposite_probes(const BallSet &balls, const Boundary &boundary) {
  probe_.keep_sides();
  return SettledCircles(balls, boundary, surface_.chosen_, grid_, surface_.cusped_circles_, probe_)
      .has_opposite_probes();
}

bool SurfaceBuilder::store_flat_patch(FlatPatches &flat, uint32_t vertex) {
  if (!flat.find(vertex)) return false;
  surface_.cut_patches_.begin_patch({});
  flat.store(surface_.cut_patches_);
  return true;
}

// The arcs of the patch as decisions that patches share have them. False if area or vector area, which are right as
// they are, show that these leave another part of the sphere: neither differs by more than what lies between the two.
bool SurfaceBuilder::settle(const SettledCircles &circles, double steradians, const Vec3 &vector_area,
                            const SurfaceCounts &before) {
  FreeRegion region;
  if (!FreeRegionFinder(circles, corners_, arcs_, ProbeCaps::sides).find(region) || region.arcs == 0) return false;
  const double more = region.steradians() - steradians;
  const double off = more > pi ? more - 2 * pi : more < -pi ? more + 2 * pi : more;
  if (!(off < least_steradians && -off < least_steradians)) return false;
  const Vec3 aside = region.vector_area - vector_area;
  if (!(dot(aside, aside) < least_steradians * least_steradians)) return false;
  surface_.counts_.cut_patches =
      before.cut_patches + (region.cutting_arcs > 0 || circles.has_opposite_probes() ? 1 : 0);
  surface_.counts_.hidden_patches = before.hidden_patches;
  return true;
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

// Loops that bound one piece one after the other, that around the piece first. If it is uncertain which piece has a
// hole, all loops bound one: then the surface is not closed. Nor is it if the pieces are not the whole patch.
void SurfaceBuilder::store_pieces(const Boundary &boundary, uint32_t vertex, const ConcaveScale &scale, double whole,
                                  const SettledCircles *settled) {
  CutPatches &cut = surface_.cut_patches_;
  const Span<RegionArc> arcs = arcs_.items();
  if (arcs.empty()) cut.begin_piece(vertex, 0.0, 0.0);
  if (!find_pieces(probe_.caps(), corners_.items(), arcs)) {
    for (RegionArc &arc : arcs) arc.piece = 0;
    ++uncertain_pieces_;
  }
  double left = whole;
  double terms = 2 * pi;
  for (uint32_t piece = 0; piece < arcs.size(); ++piece) {
    if (arcs[piece].piece != piece) continue;
    double steradians = 0.0;
    Vec3 vector_area{0.0, 0.0, 0.0};
    CreaseSums creases;
    for (uint32_t loop = 0; loop < arcs.size(); ++loop) {
      if (arcs[loop].piece != piece) continue;
      add_crease(arcs[loop], creases);
      steradians += arcs[loop].curvature;
      terms += std::fabs(arcs[loop].curvature) + 2 * pi;
      if (arcs[loop].loop == loop) steradians += loop == piece ? 2 * pi : -2 * pi;
      vector_area = vector_area + arcs[loop].vector_area;
    }
    if (!(steradians > 0.0)) steradians = 0.0;
    left -= steradians;
    const ConcavePatch measured = scale.patch(steradians, vector_area);
    cut.begin_piece(vertex, measured.area, measured.volume, creases);
    for (uint32_t loop = 0; loop < arcs.size(); ++loop) {
      if (arcs[loop].piece != piece || arcs[loop].loop != loop) continue;
      uint32_t a = loop;
      do {
        const uint32_t circle = arcs[a].circle;
        const bool last = arcs[a].next == loop;
        if (settled != nullptr) {
          ArcParts::Part parts[ArcParts::most];
          const uint32_t count = ArcParts(*settled).find(arcs[a], corners_.items(), parts);
          for (uint32_t k = 0; k < count; ++k) cut.add_arc(parts[k].across, parts[k].angle, last && k + 1 == count);
        } else {
          const uint32_t across = circle < ProbeCaps::sides
                                      ? PatchArc::side(boundary.vertex(vertex).slot_of(probe_.ball_opposite(circle)))
                                      : probe_.caps().ball[circle];
          cut.add_arc(across, arcs[a].angle, last);
        }
        a = arcs[a].next;
      } while (a != loop);
    }
  }
  // Sums of one set of terms in two orders: the arcs', each a sum of two, and a whole turn for each loop. Each of the
  // additions, with those that reduce the whole modulo 2 pi, rounds by no more than all terms together.
  const double rounding = (4 * arcs.size() + 8) * unit_roundoff * (terms + 2 * pi * arcs.size());
  const double most = settled != nullptr ? rounding + least_steradians : rounding;
  if (!(left <= most && -left <= most)) ++uncertain_pieces_;
  if (settled != nullptr) cut.fit_pieces(vertex);
}

void SurfaceBuilder::add_crease(const RegionArc &arc, CreaseSums &creases) const {
  if (arc.circle < ProbeCaps::sides) return;
  const Caps &caps = probe_.caps();
  const double height = caps.b[arc.circle];
  const Vec3 axis = caps.axis(arc.circle);
  Vec3 chord{0.0, 0.0, 0.0};
  if (arc.end != no_id) chord = corners_[arc.end].point - corners_[arc.start].point;
  creases.directions = combine(1.0, creases.directions, height * height * arc.angle, axis);
  creases.directions = combine(1.0, creases.directions, height, cross(chord, axis));
  creases.angle += height * arc.angle;
}

bool SurfaceBuilder::measure_cut_patch(double &steradians, Vec3 &vector_area) {
  FreeRegion region;
  const CirclesInDoubles doubles(probe_.caps(), probe_.amplification());
  if (FreeRegionFinder(doubles, corners_, arcs_, ProbeCaps::sides).find(region) &&
      accept(region, steradians, vector_area)) {
    return true;
  }
  ++surface_.counts_.rounded_patches;
  const CirclesInIntegers integers(probe_.caps());
  return FreeRegionFinder(integers, corners_, arcs_, ProbeCaps::sides).find(region) &&
         accept(region, steradians, vector_area);
}

// The area is known modulo 2 pi, and it is between 0 and that of the whole triangle.
bool SurfaceBuilder::accept(const FreeRegion &region, double &steradians, Vec3 &vector_area) {
  constexpr double tolerance = 1e-7;
  SurfaceCounts &counts = surface_.counts_;
  if (region.arcs == 0) {
    steradians = 0.0;
    vector_area = {0.0, 0.0, 0.0};
    ++counts.cut_patches;
    ++counts.hidden_patches;
    return true;
  }
  double area = region.steradians();
  if (area > probe_.whole_steradians() + tolerance && area > 2 * pi - tolerance) area = 0.0;
  if (!(area <= probe_.whole_steradians() + tolerance)) return false;
  steradians = area;
  vector_area = region.vector_area;
  if (region.cutting_arcs > 0) ++counts.cut_patches;
  return true;
}

}  // namespace hsp
