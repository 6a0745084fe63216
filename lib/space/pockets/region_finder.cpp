#include "pockets/region_finder.hpp"

#include <initializer_list>
#include <limits>

#include "boundary/point_location.hpp"
#include "measure/boundary_positions.hpp"
#include "periodic/surface_volume.hpp"
#include "pockets/class_tree.hpp"

namespace hsp {
namespace {

// So many lattice steps above the boundary are more than the rounding of a point.
constexpr double certain_level = 3.0;

exact::Vector rounded(const BallSet &balls, const Position &position) {
  const exact::Vector centre = balls.ball(position.ball).centre;
  const Vec3 &offset = position.offset;
  return {centre.x + nearest(offset.x), centre.y + nearest(offset.y), centre.z + nearest(offset.z)};
}

// Calls is_enough(position) for points of a face until it returns true: its vertices and a point of each circle, or one
// point of a whole sphere; then points with no other ball near to them, for spheres that touch others. Returns the last
// answer.
template <class IsEnough>
bool visit_points(const BallsAround &around, const Boundary &boundary, uint32_t face, IsEnough is_enough) {
  const BallSet &balls = around.set();
  const uint32_t ball = boundary.face(face).ball;
  const double r = balls.r[ball];
  if (boundary.loops_of_face(face).empty() && is_enough(Position{ball, {r, 0.0, 0.0}})) return true;
  for (const uint32_t e : boundary.half_edges(ball)) {
    if (boundary.face_of(e) != face) continue;
    if (is_enough(position_of_vertex(balls, boundary, boundary.half_edge(e).vertex))) return true;
  }
  for (const ClosedHalfEdge e : boundary.circles(ball)) {
    if (boundary.face_of_loop(boundary.loop_of(e)) != face) continue;
    const CirclePosition circle = position_of_circle(balls, ball, boundary.neighbour(e));
    const Vec3 &u = circle.axis;
    const Vec3 across = std::fabs(u.x) < 0.6 ? Vec3{0.0, u.z, -u.y} : Vec3{-u.z, 0.0, u.x};
    const Vec3 radius = (circle.radius / std::sqrt(dot(across, across))) * across;
    if (is_enough(Position{circle.centre.ball, circle.centre.offset + radius})) return true;
  }
  const exact::Vector centre = balls.ball(ball).centre;
  for (int k = 0; k < 25 && r > 64.0; ++k) {
    const int64_t x = nearest(0.3 * r * (k % 5 - 2)), y = nearest(0.3 * r * (k / 5 - 2));
    const Vec3 level{static_cast<double>(x), static_cast<double>(y), 0.0};
    const Position entry{ball, {level.x, level.y, -std::sqrt(r * r - dot(level, level))}};
    // If the search finds this ball alone, the point on its sphere is free.
    if (around.find({rounded(balls, entry), 4}, nullptr, 0) != 1) continue;
    if (face_of_entry(balls, boundary, ball, centre.x + x, centre.y + y) == face && is_enough(entry)) return true;
  }
  return false;
}

}  // namespace

// The room for shells: a shell is between one component of the union and one region. The graph with components and
// regions as nodes and shells as links is a tree without a box; in a box it has one cycle at most, as all ways round a
// box commute.
void RegionFinder::carve(Workspace &workspace, const PoreLimits &limits) {
  regions_ = FixedVector<PoreRegion>(workspace.take<PoreRegion>(static_cast<uint64_t>(limits.maxima) + 1));
  region_of_shell_ = workspace.take<uint32_t>(static_cast<uint64_t>(limits.maxima) + limits.balls + 1);
}

Status RegionFinder::find(PoresBuilder &pores, const BallsAround &balls, const Boundary &boundary,
                          const PeriodicUnion *periodic, int64_t floor, uint32_t first_plug, Patience patience) {
  regions_.clear();
  if (boundary.shell_count() > region_of_shell_.size()) return Status::check;
  has_outside_ = periodic == nullptr || balls.are_none();
  const uint32_t count = pores.join_above(0.0, patience);
  if (!patience.allows(100 * uint64_t{pores.joined().size()})) return Status::stopped;
  const Windings &joined = pores.joined();
  for (uint32_t k = has_outside_ ? 0 : 1; k < count; ++k) {
    const uint32_t node = joined.first_ball(k);
    PoreRegion region{node == 0 ? pore_outside : node - 1};
    region.lattice = joined.lattice(k);
    regions_.push(region);
  }
  const uint32_t first = has_outside_ ? 0 : 1;
  for (uint32_t node = 1; node < joined.size(); ++node) ++regions_[joined.component(node) - first].maxima;
  Status status = find_shells(pores, balls, boundary, floor, patience);
  if (status == Status::ok) {
    const bool all = periodic != nullptr ? measure_in_box(*periodic, first_plug, patience)
                                         : measure(balls.set(), boundary, first_plug, patience);
    if (!all) status = Status::stopped;
  }
  if (status != Status::ok) regions_.clear();
  return status;
}

Status RegionFinder::find_shells(const PoresBuilder &pores, const BallsAround &balls, const Boundary &boundary,
                                 int64_t floor, Patience &patience) {
  for (uint32_t &region : region_of_shell_) region = no_id;
  uint32_t left = boundary.shell_count();
  Status status = Status::ok;
  for (uint32_t face = 0; face < boundary.face_count() && left > 0; ++face) {
    uint32_t &region = region_of_shell_[boundary.face(face).shell];
    if (region != no_id) continue;
    PoreLocation location{};
    location.maximum = no_id;
    const bool found = visit_points(balls, boundary, face, [&](const Position &position) {
      if (!patience.allows(20000)) {
        status = Status::stopped;
        return true;
      }
      const exact::Vector start = rounded(balls.set(), position);
      Ascent way(balls, start);
      const bool certain = way.is_outside() ||
                           (way.step() && !way.has_left_saddle() && (way.is_outside() || way.level() > certain_level));
      if (!certain) return false;
      status = follow_up(pores, balls, way, start, floor, location);
      return status != Status::ok || location.maximum != no_id;
    });
    if (!found) continue;
    if (status != Status::ok) return status;
    region = region_of(pores, location.maximum);
    if (region == no_id) return Status::check;
    if (regions_[region].shells++ == 0) regions_[region].origin = boundary.face(face).ball;
    --left;
  }
  return left == 0 ? Status::ok : Status::range;
}

bool RegionFinder::measure_in_box(const PeriodicUnion &periodic, uint32_t first_plug, Patience &patience) {
  const Boundary &boundary = periodic.boundary();
  const SurfaceVolume surface(periodic);
  for (uint32_t face = 0; face < boundary.face_count(); ++face) {
    const uint64_t half_edges = boundary.half_edges(boundary.face(face).ball).size();
    if (!patience.allows(2000 + 200 * half_edges)) return false;
    PoreRegion &region = regions_[region_of_shell_[boundary.face(face).shell]];
    const BallMeasure term = surface.measure(face, region.origin);
    region.area += term.area;
    if (periodic.images().ball_of(periodic.balls().caller[boundary.face(face).ball]) >= first_plug)
      region.plug_area += term.area;
    region.volume += term.volume;
  }
  double filled = 0.0;
  for (uint32_t i = 0; i < periodic.images().balls(); ++i) {
    filled += periodic.share_volume(periodic.grid().grid_index(i));
  }
  for (PoreRegion &region : regions_.items()) {
    region.volume = surface.reduced(region.volume, surface.box_volume() - filled);
    if (region.maximum == pore_outside) {
      for (const int64_t k : {0, 1, 2}) static_cast<void>(region.lattice.add({k == 0, k == 1, k == 2}));
    }
  }
  return true;
}

bool RegionFinder::measure(const BallSet &balls, const Boundary &boundary, uint32_t first_plug, Patience &patience) {
  for (uint32_t face = 0; face < boundary.face_count(); ++face) {
    const uint32_t ball = boundary.face(face).ball;
    if (!patience.allows(2000 + 200 * uint64_t{boundary.half_edges(ball).size()})) return false;
    PoreRegion &region = regions_[region_of_shell_[boundary.face(face).shell]];
    const double r = balls.r[ball];
    FreeSurface surface(boundary, r);
    ArcBatches arcs(balls, boundary, ball, face);
    while (arcs.next()) surface.add(arcs.batch());
    const double area = r * r * surface.steradians(1, boundary.loops_of_face(face).size());
    region.area += area;
    if (balls.caller[ball] >= first_plug) region.plug_area += area;
    region.volume -= volume_term(r, area, balls.difference(region.origin, ball), surface.vector_area());
  }
  for (PoreRegion &region : regions_.items()) {
    region.volume = region.maximum == pore_outside ? std::numeric_limits<double>::infinity()
                    : region.volume > 0.0          ? region.volume
                                                   : 0.0;
  }
  return true;
}

}  // namespace hsp
