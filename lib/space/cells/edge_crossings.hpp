// A kernel that finds the points at which a plane crosses edges of a polytope, as far as doubles tell. For registers of
// n doubles; every n gives the same bits. power_cell.kernel.cpp compiles this file.
#pragma once

#include "cells/cube_frame.hpp"
#include "cells/vertex_sides.hpp"
#include "lanes/target.hpp"
#include "lanes/wide.hpp"

namespace hsp {

// An edge that is cut. gone: its vertex beyond the plane; near: the other end, as a link (PolytopeVertex); a, b: the
// planes that it is on.
struct CrossedEdge {
  uint32_t gone, near, a, b;
};
// So many records behind the last one are read: they must name vertices, and a slot behind all vertices for the result.
inline constexpr uint32_t crossings_behind = 3;

// The centre from which squared distances are measured, and error bounds.
struct CrossingBounds {
  Vec3 centre;
  double least_rise, most_error, rounding, plane_error;
};
inline CrossingBounds crossing_bounds(const CubeFrame &frame, const Vec3 &centre) {
  return {centre, 0x1p-12 * frame.side(), 0x1p-27 * frame.side(), 64 * unit_roundoff * frame.side(),
          frame.plane_error()};
}

HSP_KERNEL(void, cross_edges,
           (const VertexArrays &of, const CrossedEdge *edges, const uint32_t *to, uint32_t count,
            const CrossingBounds &bounds),
           (of, edges, to, count, bounds))

namespace {

// A plane crosses the edge from a point p on its near side to q beyond it at y = p + t (q - p) with t = f(p) / (f(p) -
// f(q)), where f = v.y - h is the `value`. Errors: let p and q be off by at most d, so that f is off by e = d + 512 u
// s. The point at t of the true edge differs from y by d, and f there is at most e. Along the true edge f grows by f(q)
// - f(p) - 2 e or more over at most |q - p| + 2 d. So y is off by less than d + 1.01 e |q - p| / (f(q) - f(p)) + 64 u
// s, the last term for rounding, if d < 2^-27 s and f(q) - f(p) > 2^-12 s. Errors add up from cut to cut. If these
// conditions do not hold, `error` becomes no_certainty, and the vertex has to be computed from its three planes.
//
// Edge k makes vertex to[k], which is no end of any later edge.
template <uint32_t n>
inline void cross_edges_in_lanes(const VertexArrays &of, const CrossedEdge *edges, const uint32_t *to, uint32_t count,
                                 const CrossingBounds &bounds) {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  const Real least_rise = L::all(bounds.least_rise), most_error = L::all(bounds.most_error), one = L::all(1.0);
  const Real rounding = L::all(bounds.rounding), plane_error = L::all(bounds.plane_error), more = L::all(1.01);
  const Real never = L::all(no_certainty);
  const VectorOf<Real> centre{L::all(bounds.centre.x), L::all(bounds.centre.y), L::all(bounds.centre.z)};
  for (const CrossedEdge *const end = edges + count; edges < end; edges += n, to += n) {
    uint32_t near[n], gone[n];
    for (uint32_t k = 0; k < n; ++k) {
      near[k] = edges[k].near / 4;
      gone[k] = edges[k].gone;
    }
    const Real near_value = L::gather(of.value, near);
    const Real rise = L::gather(of.value, gone) - near_value;
    const Real scale = one / rise;
    const VectorOf<Real> from{L::gather(of.x, near), L::gather(of.y, near), L::gather(of.z, near)};
    const VectorOf<Real> edge =
        VectorOf<Real>{L::gather(of.x, gone), L::gather(of.y, gone), L::gather(of.z, gone)} - from;
    const Real length = L::absolute(edge.x) + L::absolute(edge.y) + L::absolute(edge.z);
    const Real error = L::larger(L::gather(of.error, near), L::gather(of.error, gone));
    const VectorOf<Real> at = from + (-near_value * scale) * edge;
    const VectorOf<Real> from_centre = at - centre;
    const Real squared = dot(from_centre, from_centre);
    const Real sum = error + rounding + (more * (error + plane_error)) * (length * scale);
    const Real known = L::select(L::both(rise > least_rise, sum < most_error), sum, never);
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t v = to[k];
      of.x[v] = at.x[k];
      of.y[v] = at.y[k];
      of.z[v] = at.z[k];
      of.error[v] = known[k];
      of.squared[v] = squared[k];
    }
  }
}

}  // namespace
}  // namespace hsp
