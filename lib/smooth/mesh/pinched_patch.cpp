// Patches whose borders may touch or run along each other. No number of points tells such borders apart, but how they
// hang together is known: every border leads from one of its points to the next, with the patch on its left.
//
// Borders may lie on each other. If the straight way to the next point crosses another border, it makes a detour
// through a point of that border. The gaps between borders are then cells without area (pinched_cells.cpp):
//   detour    between the straight way and the detour
//   corridor  between two ways along the same edge, there and back, with the patch between them
//   wedge     the patch at a point, from the way to the next point on counter-clockwise to the next border, which ends
//             at a sample there. If that is another one than the wedge begins with, the samples are joined by an edge,
//             and a triangle with the way that ends there
//   neck      those edges and borders without length at one point, if there are three of them and more
// Two ways along one edge with the patch on both sides of them have nothing between them. The side on which there is
// patch follows from edges along which only one way runs: the patch is on its left.
//
// All triangles and cells together are a surface bounded by the borders, wherever the points are. Three things are
// checked: no two ways claim the same side of an edge, each sample ends just one wedge, and Euler's formula holds.
#include "mesh/spherical_patch.hpp"

namespace hsp {

namespace {

constexpr uint32_t most_detours = 64;  // of one way
// Marks of triangles that have no face yet.
constexpr uint32_t unknown = no_id - 1;
constexpr uint32_t uncovered = no_id - 2;

}  // namespace

// Adds a sample that belongs to no border. If there is no room for it, returns 0.
uint32_t SphericalPatch::add_extra(uint32_t face, const Vec3 &direction) {
  samples_.push({direction, no_id, samples_[0].curve, {no_id, no_id}});
  if (samples_.overflowed()) return 0;
  const uint32_t added = samples_.size() - 1;
  links_[added] = {no_id, no_id, no_id, false, false, face, no_id, no_id};
  return added;
}

// ---- ways ----

// Makes the ways between samples edges of the triangulation. Without detours a way with an obstacle is marked as too
// coarse, and so is the obstacle.
bool SphericalPatch::route_strands(bool with_detours) {
  bool good = true;
  for (uint32_t k = 0; k < border_samples_; ++k) {
    const uint32_t end = links_[k].next;
    uint32_t detours = 0;
    uint32_t at = k;
    while (at != end) {
      const uint32_t next = links_[at].next;
      uint32_t obstacle = no_id;
      if (!has_length(at) || sphere_.fix_edge(links_[at].point, links_[next].point, obstacle)) {
        at = next;
        continue;
      }
      if (with_detours) {
        if (++detours > most_detours || !add_detour(at, obstacle)) return false;
        continue;
      }
      good = false;
      links_[k].coarse = true;
      mark_coarse(obstacle);
      break;
    }
  }
  return good;
}

// Adds a detour through that end of the edge in the way which is nearer to the way, if it lies between the way's ends.
bool SphericalPatch::add_detour(uint32_t sample, uint32_t obstacle) {
  const uint32_t next = links_[sample].next;
  const Vec3 a = to_double(sphere_.point(links_[sample].point));
  const Vec3 b = to_double(sphere_.point(links_[next].point));
  const Vec3 across = cross(a, b);
  uint32_t best = no_id;
  double least = 0.0;
  const uint32_t ends[2] = {obstacle, sphere_.other_obstacle()};
  for (const uint32_t p : ends) {
    if (p == no_id || p == links_[sample].point || p == links_[next].point) continue;
    const Vec3 at = to_double(sphere_.point(p));
    if (!(dot(a, at) > dot(a, b) && dot(b, at) > dot(a, b))) continue;
    const double distance = std::fabs(dot(across, at));
    if (best != no_id && distance >= least) continue;
    best = p;
    least = distance;
  }
  if (best == no_id) return false;
  const uint32_t there = sample_at_[best];
  const uint32_t added =
      add_extra(links_[sample].face, there == no_id ? to_double(sphere_.point(best)) : direction_of(there));
  if (samples_.overflowed()) return false;
  links_[added].next = next;
  links_[added].previous = sample;
  links_[added].point = best;
  links_[sample].next = added;
  links_[next].previous = added;
  if (there == no_id) sample_at_[best] = added;
  return true;
}

bool SphericalPatch::lay_strands() {
  for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) parts_[t] = Part{};
  for (uint32_t k = 0; k < linked_samples_; ++k) {
    if (!has_length(k)) continue;
    TriangleEdge way;
    if (!sphere_.find_edge(links_[k].point, links_[links_[k].next].point, way)) return false;
    uint32_t &strand = parts_[way.triangle].strand[way.edge];
    if (strand != no_id) return false;
    strand = k;
  }
  return true;
}

uint32_t SphericalPatch::strand_back(const TriangleEdge &way) const {
  const uint32_t u = sphere_.triangle(way.triangle).neighbour[way.edge];
  return parts_[u].strand[sphere_.triangle(u).edge_towards(way.triangle)];
}

// ---- what is covered ----

bool SphericalPatch::find_covered() {
  const uint32_t triangles = sphere_.triangle_count();
  bool any = false;
  for (uint32_t k = 0; k < linked_samples_ && !any; ++k) any = has_length(k);
  for (uint32_t t = 0; t < triangles; ++t) parts_[t].face = unknown;
  waiting_ = 0;
  for (uint32_t t = 0; t < triangles; ++t) {
    for (uint32_t e = 0; e < 3; ++e) {
      if (parts_[t].strand[e] == no_id || strand_back({t, e}) != no_id) continue;
      if (!take(t, unknown, uncovered) || !take(sphere_.triangle(t).neighbour[e], unknown, no_id)) return false;
    }
  }
  if (waiting_ == 0) take(0, unknown, !any || has_covered_point() ? no_id : uncovered);
  while (waiting_ > 0) {
    const uint32_t t = queue_[--waiting_];
    for (uint32_t e = 0; e < 3; ++e) {
      const bool balanced =
          !sphere_.triangle(t).fixed[e] || (parts_[t].strand[e] == no_id) == (strand_back({t, e}) == no_id);
      if (balanced && !take(sphere_.triangle(t).neighbour[e], unknown, parts_[t].face)) return false;
    }
  }
  return true;
}

// If all borders run there and back, the sphere is covered as a whole or not at all: whether the middle of a triangle
// is well inside a cap.
bool SphericalPatch::has_covered_point() const {
  for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) {
    Vec3 middle{0.0, 0.0, 0.0};
    for (const uint32_t p : sphere_.triangle(t).point) middle = middle + to_double(sphere_.point(p));
    const double length = std::sqrt(dot(middle, middle));
    for (uint32_t k = 0; k < caps_.size() && length > 0.0; ++k) {
      if (dot(middle, caps_[k].axis) > caps_[k].inside * length) return true;
    }
  }
  return false;
}

bool SphericalPatch::name_faces() {
  if (!lay_strands()) return false;
  if (loops_.size() == 0) {
    for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) parts_[t].face = 0;
    return true;
  }
  if (!find_covered()) return false;
  for (uint32_t first = 0; first < sphere_.triangle_count(); ++first) {
    for (const uint32_t strand : parts_[first].strand) {
      if (strand != no_id && parts_[first].face != no_id && !take(first, uncovered, links_[strand].face)) return false;
    }
    while (waiting_ > 0) {
      const uint32_t t = queue_[--waiting_];
      for (uint32_t e = 0; e < 3; ++e) {
        const SphereTriangle &own = sphere_.triangle(t);
        if (!own.fixed[e] && !take(own.neighbour[e], uncovered, parts_[t].face)) return false;
      }
    }
  }
  for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) {
    if (parts_[t].face == uncovered) return false;
  }
  return true;
}

}  // namespace hsp
