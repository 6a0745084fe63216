// Kernels that find the next plane to cut a power cell, and on which side of a plane, or of the lines around a facet,
// up to 64 points lie, as far as doubles tell. For registers of n doubles; every n gives the same bits.
// power_cell.kernel.cpp compiles this file.
#pragma once

#include "cells/cube_members.hpp"
#include "core/status.hpp"
#include "lanes/target.hpp"
#include "lanes/wide.hpp"

namespace hsp {

// The vertices of a polytope: their positions, bounds of the errors of these, their squared distances from the centre
// of the ball, and the value v.y - h of the plane with which they were compared last. Behind the last vertex there is
// room up to a multiple of eight; squares there are 0.
struct VertexArrays {
  double *x, *y, *z, *error, *squared, *value;
};
// The vertices, at least four, compared with a plane. A bit for each, the first one lowest: whether it is beyond the
// plane by more than a margin, and whether it is within the margin.
struct CutVertices {
  VertexArrays at;
  uint64_t *beyond, *unsure;
  uint32_t count;
};
struct CutMargins {
  double side;     // the margin of v.y - h
  double reach;    // the margin of the squared distance of the farthest vertex from the centre
  double covered;  // find_cut() returns is_covered if that squared distance is smaller
};
// Results of find_cut() that are no plane. wants_more: the planes that have been sorted are done with, and there may be
// more.
inline constexpr uint32_t none_cuts = no_id, is_covered = no_id - 1, wants_more = no_id - 2;

// A line u a + w b = h in the plane of a facet; its near side is u a + w b <= h. In floats, as facets are many.
struct FlatLine {
  float u, w, h;
};
// Points in that plane compared with lines, all by more than a margin. inside: bits of the points on the near side of
// all lines; apart: whether all points are beyond one line; reached: whether each line has a point on its near side.
struct FacetSides {
  uint64_t inside;
  bool apart, reached;
};
// A bit for each of up to 64 vertices, the first one lowest: whether its squared distance is larger than a limit by
// more than a margin, and whether it is within the margin.
struct SquareSides {
  uint64_t above, unsure;
};

HSP_KERNEL(uint32_t, find_cut,
           (const CutVertices &vertices, const PlaneArrays &planes, uint32_t plane_count, const CutMargins &margins),
           (vertices, planes, plane_count, margins))
HSP_KERNEL(SquareSides, compare_squares, (const double *squared, uint32_t count, double limit, double margin),
           (squared, count, limit, margin))
HSP_KERNEL(FacetSides, compare_facets,
           (const double *u, const double *w, uint32_t count, const FlatLine *lines, uint32_t line_count,
            double margin),
           (u, w, count, lines, line_count, margin))

namespace {

// The nearest plane, of which there is one; of equally near ones the first.
template <uint32_t n>
inline uint32_t nearest_plane(const double *distances, uint32_t plane_count) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  Real nearest = L::all(done_with);
  for (uint32_t k = 0; k < plane_count; k += 8) {
    for (uint32_t l = 0; l < 8; l += n) nearest = L::smaller(L::load(distances + k + l), nearest);
  }
  double distance = nearest[0];
  for (uint32_t k = 1; k < n; ++k) distance = nearest[k] < distance ? nearest[k] : distance;
  const Real wanted = L::all(distance);
  for (uint32_t plane = 0;; plane += 8) {
    uint64_t hits = 0;
    for (uint32_t l = 0; l < 8; l += n) hits |= L::set_lanes(L::load(distances + plane + l) == wanted) << l;
    if (hits != 0) return plane + static_cast<uint32_t>(__builtin_ctzll(hits));
  }
}

// Returns the nearest plane that is no farther than the farthest vertex and has vertices that are, or may be, beyond
// it. This plane and nearer ones are done with then. none_cuts if there is no such plane. is_covered, before any plane
// is done with, if there are planes but no vertex is as far away as `covered`.
template <uint32_t n>
inline uint32_t find_cut_in_lanes(const CutVertices &vertices, const PlaneArrays &planes, uint32_t plane_count,
                                  const CutMargins &margins) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const VertexArrays of = vertices.at;
  double *const distances = planes.distance;
  PlaneOrder &order = *planes.order;
  const uint32_t count = vertices.count;
  const Real margin = L::all(margins.side), least = L::all(-margins.side);
  Real farthest = L::all(0.0);
  for (uint32_t v = 0; v < count; v += 8) {
    for (uint32_t k = 0; k < 8; k += n) farthest = L::larger(L::load(of.squared + v + k), farthest);
  }
  double most = farthest[0];
  for (uint32_t k = 1; k < n; ++k) most = farthest[k] > most ? farthest[k] : most;
  for (;;) {
    if (order.next == order.count && plane_count > most_sought) return wants_more;
    if (order.next == order.count && order.count != 0) return none_cuts;
    const uint32_t plane = order.count != 0 ? planes.nearest[order.next] : nearest_plane<n>(distances, plane_count);
    const double distance = distances[plane];
    if (!(distance < done_with)) return none_cuts;
    if (most + margins.reach < margins.covered) return is_covered;
    if (distance > most + margins.reach) return none_cuts;
    distances[plane] = done_with;
    ++order.next;

    const Real a = L::all(planes.x[plane]), b = L::all(planes.y[plane]), c = L::all(planes.z[plane]);
    const Real h = L::all(planes.h[plane]);
    uint64_t found = 0;
    for (uint32_t first = 0; first < count; first += 64) {
      const uint32_t points = count - first < 64 ? count - first : 64;
      uint64_t beyond = 0, near = 0;
      for (uint32_t eight = 0; eight < points; eight += 8) {
        uint64_t eight_beyond = 0, eight_near = 0;
        for (uint32_t k = 0; k < 8; k += n) {
          const uint32_t v = first + eight + k;
          const Real value = a * L::load(of.x + v) + b * L::load(of.y + v) + c * L::load(of.z + v) - h;
          L::store(of.value + v, value);
          eight_beyond |= L::set_lanes(value > margin) << k;
          eight_near |= L::set_lanes(value <= least) << k;
        }
        beyond |= eight_beyond << eight;
        near |= eight_near << eight;
      }
      const uint64_t all = ~UINT64_C(0) >> (64 - points);
      vertices.beyond[first / 64] = beyond & all;
      vertices.unsure[first / 64] = ~(beyond | near) & all;
      found |= ~near & all;
    }
    if (found != 0) return plane;
  }
}

template <uint32_t n>
inline SquareSides compare_squares_in_lanes(const double *squared, uint32_t count, double limit, double margin) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const Real bound = L::all(limit), most = L::all(margin), least = L::all(-margin);
  uint64_t above = 0, below = 0;
  for (uint32_t k = 0; k < count; k += n) {
    const Real excess = L::load(squared + k) - bound;
    above |= L::set_lanes(excess > most) << k;
    below |= L::set_lanes(excess < least) << k;
  }
  const uint64_t all = ~UINT64_C(0) >> (64 - count);
  return {above & all, ~(above | below) & all};
}

template <uint32_t n>
inline FacetSides compare_facets_in_lanes(const double *u, const double *w, uint32_t count, const FlatLine *lines,
                                          uint32_t line_count, double margin) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const uint64_t all = ~UINT64_C(0) >> (64 - count);
  const Real most = L::all(margin), least = L::all(-margin);
  uint64_t inside = all;
  bool reached = true;
  for (uint32_t line = 0; line < line_count; ++line) {
    const Real a = L::all(lines[line].u), b = L::all(lines[line].w), h = L::all(lines[line].h);
    uint64_t beyond = 0, near = 0;
    for (uint32_t k = 0; k < count; k += n) {
      const Real value = a * L::load(u + k) + b * L::load(w + k) - h;
      beyond |= L::set_lanes(value > most) << k;
      near |= L::set_lanes(value < least) << k;
    }
    if ((~beyond & all) == 0) return {0, true, false};
    inside &= near;
    reached = reached && (near & all) != 0;
  }
  return {inside, false, reached};
}

}  // namespace
}  // namespace hsp
