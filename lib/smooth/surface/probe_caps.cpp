#include "surface/probe_caps.hpp"

#include "core/elementary.hpp"
#include "core/sorting.hpp"
#include "measure/boundary_positions.hpp"
#include "surface/covered_gaps.hpp"

namespace hsp {

void ProbeCaps::carve(Workspace &workspace, uint32_t neighbours) {
  caps_.carve(workspace, neighbours + sides);
  others_ = FixedVector(workspace.take<Other>(neighbours));
}

bool ProbeCaps::gather(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, const ProbeGrid &grid,
                       uint32_t vertex) {
  vertex_ = vertex;
  chosen_ = &chosen;
  others_.clear();
  for (bool &known : gap_known_) known = false;
  touches_ = false;
  found_ = 0;
  const double error = vertex_error * static_cast<double>(balls.largest_radius);
  merge_distance_ = 4 * error;
  measure_sides(balls, boundary, grid);
  const bool has_area = triangles_.steradians[lane_] > 0.0;
  doubtful_ = boundary.root_discriminant(vertex) == 0.0 || !has_area;
  if (!has_area) return false;

  ProbeSearch search;
  grid.start_search(balls, vertex, search);
  aim(triangles_, lane_, search);
  for_each_near_probe(boundary.target(), search, [&](uint32_t other) {
    ++found_;
    if (other != vertex) take(balls, boundary, grid, other);
  });
  if (doubtful_ || others_.required() == 0) return false;
  if (others_.overflowed()) return true;

  sort_and_merge();
  store_caps();
  // The errors of axis and height are those of two vertices, divided by their distance. caps.hpp assumes 3.5e for the
  // axis.
  double largest = side_error_;
  for (const Other &other : others_.items().part(0, kept_)) {
    const double own = 2 * error / other.distance;
    if (own > largest) largest = own;
  }
  amplification_ = 1.0 + largest / (3 * unit_roundoff);
  return true;
}

// Decides about a probe that a search has found. It does not rely on what the search has checked.
void ProbeCaps::take(const BallSet &balls, const Boundary &boundary, const ProbeGrid &grid, uint32_t other) {
  const double diameter = 2 * static_cast<double>(balls.probe_steps);
  const double coincident = 0.5 * diameter * coincident_distance;
  const Vec3 to = grid.difference(balls, vertex_, other);
  const double square = dot(to, to);
  const double overlap = diameter * diameter - square;
  const double rounding = 8 * diameter * vertex_error * static_cast<double>(balls.largest_radius);
  if (overlap <= rounding) {
    touches_ = touches_ || (overlap >= -rounding && may_cut(boundary, *chosen_, vertex_, other) &&
                            touches(balls, boundary, other, (1.0 / std::sqrt(square)) * to));
    return;
  }
  if (!may_cut(boundary, *chosen_, vertex_, other)) return;
  if (square < coincident * coincident) {
    doubtful_ = doubtful_ || square > merge_distance_ * merge_distance_ || may_be_pinched(balls, boundary, other);
    return;
  }
  const double distance = std::sqrt(square);
  const Vec3 axis = (1.0 / distance) * to;
  const double height = distance / diameter;
  const double error = 2 * vertex_error * static_cast<double>(balls.largest_radius) / distance;
  if (misses(axis, height, error + side_error_ + 0x1p-30)) return;
  if (!counts_on_circle(balls, boundary, other)) return;
  others_.push({axis, height, distance, other});
}

// For probes whose centres are a diameter apart, up to rounding. They count as not cutting each other, as if the
// probe's radius were less by the rounding. If both touch the same three balls: a vertex of spheres with the radii R is
// at the distance p from the plane of their centres iff its projection is a common point of the spheres with the
// squared radii R^2 - p^2, on one of which two circles then touch. If that does not hold exactly, the patch is
// doubtful.
bool ProbeCaps::touches(const BallSet &balls, const Boundary &boundary, uint32_t other, const Vec3 &axis) {
  const double error =
      vertex_error * static_cast<double>(balls.largest_radius) / static_cast<double>(balls.probe_steps);
  if (misses(axis, 1.0, error + side_error_ + 0x1p-30)) return false;
  const VertexRecord &record = boundary.vertex(vertex_);
  const VertexRecord &mirrored = boundary.vertex(other);
  if (!mirrored.has(record.ball[0]) || !mirrored.has(record.ball[1]) || !mirrored.has(record.ball[2])) {
    return counts_on_circle(balls, boundary, other);
  }
  const exact::LatticeBall own = balls.ball(record.ball[0]);
  const exact::Sphere smaller{4 * (own.radius - balls.probe_steps) * (own.radius + balls.probe_steps), own.index};
  const bool tied = exact::Exact::crossing(smaller, exact::plane_of(own, balls.ball(record.ball[1])),
                                           exact::plane_of(own, balls.ball(record.ball[2])))
                        .tied;
  doubtful_ = doubtful_ || !tied;
  return tied;
}

// Whether the cap leaves the triangle as it is, for certain (near_probes.hpp).
bool ProbeCaps::misses(const Vec3 &axis, double height, double error) const {
  const double above[3] = {dot(axis, inward(0)), dot(axis, inward(1)), dot(axis, inward(2))};
  if (above[0] > -error && above[1] > -error && above[2] > -error) return false;
  const double reach = std::sqrt((1.0 - height) * (1.0 + height)) + error;
  for (uint32_t k = 0; k < 3; ++k) {
    if (above[k] > error || above[k] < -reach) continue;
    const double a = dot(axis, corner((k + 1) % 3));
    const double b = dot(axis, corner((k + 2) % 3));
    const double cosine = triangles_.cosine[k][lane_];
    if (b - cosine * a > -2 * error && a - cosine * b > -2 * error) return false;
  }
  return true;
}

void ProbeCaps::measure_sides(const BallSet &balls, const Boundary &boundary, const ProbeGrid &grid) {
  lane_ = measure_next_triangle(balls, boundary, grid.positions(), vertex_, triangles_);
  side_error_ = vertex_error * static_cast<double>(balls.largest_radius) * triangles_.side_error[lane_];
}

// All bisector planes between vertices of one circle contain its axis. The circles in which they cut the probe's sphere
// share the two cusps, if the circle is smaller than the probe. So of these caps only that of the vertex across the
// covered gap beside this one matters; the others cover less of the patch (PROOFS.md, section 6).
bool ProbeCaps::counts_on_circle(const BallSet &balls, const Boundary &boundary, uint32_t other) {
  bool counts = true;
  for_each_common_circle(boundary, vertex_, other, [&](uint32_t slot, uint32_t half_edge) {
    const uint32_t ball = boundary.vertex(vertex_).ball[slot];
    if (!gap_known_[slot]) across_[slot] = vertex_across_gap(balls, boundary, *chosen_, ball, half_edge);
    gap_known_[slot] = true;
    counts = counts && across_[slot] == other;
  });
  return counts;
}

// Coincident vertices are one corner of several spheres, or ends of an arc of length 0: their patches are the pieces of
// one polygon and do not cut each other. But if the covered gap between them has length 0, the outside has an edge
// there and no corner (PROOFS.md, section 7). The gap certainly has a length if it is the rest of a circle with this
// short arc alone.
bool ProbeCaps::may_be_pinched(const BallSet &balls, const Boundary &boundary, uint32_t other) const {
  bool may_be = false;
  for_each_common_circle(boundary, vertex_, other, [&](uint32_t, uint32_t half_edge) {
    may_be = may_be || boundary.end_vertex(half_edge) != other || angle_of_arc(balls, boundary, half_edge) >= pi;
  });
  return may_be;
}

// Sorts neighbours by position, so that ids have no effect. Of several vertices at one position the first stays; the
// others are moved to the end.
void ProbeCaps::sort_and_merge() {
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
      if (all[k].distance - all[j].distance > merge_distance_) break;
      const Vec3 between = combine(all[k].distance, all[k].axis, -all[j].distance, all[j].axis);
      again = dot(between, between) <= merge_distance_ * merge_distance_;
    }
    if (again) continue;
    const Other kept = all[k];
    all[k] = all[kept_];
    all[kept_++] = kept;
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
  for (uint32_t k = 0; k < sides; ++k) store(-inward(k), 0.0, no_id);
  for (const Other &other : others_.items().part(0, kept_)) store(other.axis, other.height, other.vertex);
  caps_.count = count;
}

}  // namespace hsp
