#include "surface/surface_builder.hpp"

#include "measure/areas.hpp"
#include "surface/circles_in_doubles.hpp"
#include "surface/circles_in_integers.hpp"
#include "surface/saddle.hpp"

namespace hsp {

// The arcs around the union of m caps have at most 6m - 12 corners for m >= 3, as the edges of a planar graph.
void SurfaceBuilder::carve(Workspace &workspace, const SurfaceLimits &limits) {
  limits_ = limits;
  grid_.carve(workspace, limits.vertices);
  probe_.carve(workspace, limits.neighbours);
  surface_.patch_ = workspace.take<ConcavePatch>(limits.vertices);
  corners_ = FixedVector(workspace.take<RegionCorner>(6 * (uint64_t{limits.neighbours} + ProbeCaps::sides)));
}

Status SurfaceBuilder::build(const BallSet &balls, const Boundary &boundary) {
  surface_.counts_ = {};
  needed_ = {boundary.vertex_count(), 0};
  if (needed_.vertices > limits_.vertices) return Status::capacity;
  const double p = static_cast<double>(balls.probe_steps);
  if (balls.probe_steps == 0) {
    for (uint32_t v = 0; v < needed_.vertices; ++v) surface_.patch_[v] = {0.0, 0.0};
    return Status::ok;
  }
  grid_.build(balls, boundary);
  for (uint32_t v = 0; v < needed_.vertices; ++v) {
    const ProbeState state = probe_.gather(balls, boundary, grid_, v);
    needed_.neighbours = larger_count(needed_.neighbours, clamped_count(probe_.met()));
    double steradians = 0.0;
    Vec3 vector_area{0.0, 0.0, 0.0};
    if (state == ProbeState::whole) {
      steradians = probe_.whole_steradians();
      vector_area = probe_.whole_vector_area();
    } else if (state == ProbeState::crossed) {
      if (probe_.overflowed()) continue;
      if (!measure_cut_patch(steradians, vector_area)) return Status::check;
    } else {
      ++surface_.counts_.cut_patches;
      ++surface_.counts_.hidden_patches;
    }
    const Position &position = grid_.position(v);
    const Vec3 arm = offset_from_origin(balls, boundary, position.ball) + position.offset;
    // The outward normal is towards the probe's centre.
    surface_.patch_[v] = {p * p * steradians, -p * p * (p * steradians + dot(arm, vector_area)) / 3};
  }
  if (needed_.neighbours > limits_.neighbours) return Status::capacity;
  count_cusps(balls, boundary);
  return Status::ok;
}

bool SurfaceBuilder::measure_cut_patch(double &steradians, Vec3 &vector_area) {
  FreeRegion region;
  const CirclesInDoubles doubles(probe_.caps(), probe_.amplification());
  if (FreeRegionFinder(doubles, corners_, ProbeCaps::sides).find(region) && accept(region, steradians, vector_area)) {
    return true;
  }
  ++surface_.counts_.rounded_patches;
  const CirclesInIntegers integers(probe_.caps());
  return FreeRegionFinder(integers, corners_, ProbeCaps::sides).find(region) && accept(region, steradians, vector_area);
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

void SurfaceBuilder::count_cusps(const BallSet &balls, const Boundary &boundary) {
  const double p = static_cast<double>(balls.probe_steps);
  const auto count = [&](uint32_t a, uint32_t b) {
    const CircleGeometry circle(balls, a, b);
    const CircleGeometry seen_from_other(balls, b, a);
    const SaddleSide side{p, 0.0, 0.0, circle.height, seen_from_other.height, circle.radius, 0.0, {}, {}};
    if (has_cusps(side)) ++surface_.counts_.cusped_arcs;
  };
  for (uint32_t i = 0; i < balls.n; ++i) {
    for (const uint32_t e : boundary.half_edges(i)) {
      const uint32_t other = boundary.half_edge(e).circle;
      if (i < other) count(i, other);
    }
  }
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) count(boundary.circle(c).ball[0], boundary.circle(c).ball[1]);
}

}  // namespace hsp
