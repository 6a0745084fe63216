// A kernel that finds which edges of a polytope are outside a sphere, as far as doubles tell. For registers of n
// doubles; every n gives the same bits. power_cell.kernel.cpp compiles this file.
#pragma once

#include "cells/vertex_sides.hpp"
#include "lanes/target.hpp"
#include "lanes/wide.hpp"

namespace hsp {

// An edge by its two ends. An end is 4 vertex + k, if the edge is opposite to plane k of the vertex.
struct EdgeEnds {
  uint32_t from, to;
};
// A bit for each of up to 64 edges, the first one lowest: whether it is outside a sphere as a whole by more than a
// margin, and whether that is within the margin. The ends of edges are outside, or within a margin.
struct EdgeSides {
  uint64_t outside, unsure;
};
// So many records behind the last one are read; they must name vertices.
inline constexpr uint32_t edges_behind = 3;

HSP_KERNEL(EdgeSides, compare_edges,
           (const VertexArrays &of, const EdgeEnds *edges, uint32_t count, double limit, double error),
           (of, edges, count, limit, error))

namespace {

// The positions of n vertices.
template <uint32_t n>
inline VectorOf<typename Wide<double, n>::Real> positions(const VertexArrays &of, const uint32_t *v) {
  using L = Wide<double, n>;
  return {L::gather(of.x, v), L::gather(of.y, v), L::gather(of.z, v)};
}

// Let A and B be the squared distances from the centre to the ends, and L the squared length of the edge. The line is
// nearest to the centre at the fraction t / L with t = (A - B + L) / 2; at a fraction t / L the squared distance is A -
// t (2 (A - B + L) / 2 - t) / L. Errors: positions and centre are less than 3 s apart along each axis. So A, B and L
// are below 27 s^2 and off by less than 135 u s^2 by rounding, t by less than 230 u s^2, and L times the excess, as t
// <= L, by less than 800 u s^2 L, besides the error of positions. CubeFrame::sphere_error() has 1024.
template <uint32_t n>
inline EdgeSides compare_edges_in_lanes(const VertexArrays &of, const EdgeEnds *edges, uint32_t count, double limit,
                                        double error) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const Real bound = L::all(limit), most = L::all(error), zero = L::all(0.0), half = L::all(0.5), two = L::all(2.0);
  uint64_t outside = 0, inside = 0;
  for (uint32_t first = 0; first < count; first += n) {
    uint32_t from[n], to[n];
    for (uint32_t k = 0; k < n; ++k) {
      from[k] = edges[first + k].from / 4;
      to[k] = edges[first + k].to / 4;
    }
    const VectorOf<Real> edge = positions<n>(of, to) - positions<n>(of, from);
    const Real from_squared = L::gather(of.squared, from);
    const Real to_squared = L::gather(of.squared, to);
    const Real length = dot(edge, edge);
    const Real middle = half * ((from_squared - to_squared) + length);
    const Real nearest = L::smaller(L::larger(middle, zero), length);
    const Real excess = (from_squared - bound) * length - nearest * (two * middle - nearest);
    const Real margin = most * length;
    outside |= L::set_lanes(excess > margin) << first;
    inside |= L::set_lanes(excess < -margin) << first;
  }
  const uint64_t all = ~UINT64_C(0) >> (64 - count);
  return {outside & all, ~(outside | inside) & all};
}

}  // namespace
}  // namespace hsp
