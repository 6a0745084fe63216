// The points where cut arcs end, in their order along the arcs and free circles they end on.
//
// A host edge is an arc of the boundary or one half of a free circle. It is described on one of its two balls, a, the
// first in grid order, as part of the circle P of the other, b: counter-clockwise from the exit of a plane Q, its
// reference plane, to the entry of another. The plane through both centres that contains the direction z divides a free
// circle into its halves; this plane and its complement are their reference planes.
//
// A subdivision vertex is where the plane of a cut arc crosses P. That plane contains the direction z and the centre
// of a or of b. Points of a and b coincide only if their planes are the same; then they are one point, at which a cut
// arc may end on either side. (Two different planes pass through one point of the circle only before the symbolic
// perturbation, which moves the circle.)
#pragma once

#include "core/fixed_vector.hpp"
#include "core/workspace.hpp"
#include "topology/cut_arcs.hpp"

namespace hsp {

// An end of a cut arc.
class CutArcEnd {
 public:
  constexpr CutArcEnd() = default;
  constexpr CutArcEnd(uint32_t arc, uint32_t end) : code_(2 * arc + end) {}

  constexpr bool exists() const { return code_ != no_id; }
  constexpr uint32_t arc() const { return code_ / 2; }
  constexpr uint32_t end() const { return code_ % 2; }

 private:
  uint32_t code_ = no_id;
};

struct SubdivisionVertex {
  uint32_t host;         // of the two points of a free circle: its half 0
  uint32_t ball, cap;    // the plane: that of a cut arc of `ball` through the axis of the circle of `cap`
  int32_t sign;          // p+ or p- of the host's circle and the plane, on the host's ball a
  CutArcEnd cut_end[2];  // on the side of a and of b
  uint32_t next;         // the next one in the direction of the loop of ball a; no_id at the last
};

// The balls a and b of a host edge; ids of host edges are those of Subdivision.
struct HostBalls {
  uint32_t a, b;
};
HostBalls balls_of_host(const Boundary &boundary, uint32_t host);

// The plane of a cut arc of `ball` through the axis of the circle of `cap`, in the coordinates of ball `origin`.
exact::Plane plane_of_cut(const BallSet &balls, uint32_t origin, uint32_t ball, uint32_t cap);

class Subdivision {
 public:
  void carve(Workspace &workspace, uint32_t edges, uint32_t cut_arcs);

  // Subdivides the host edges at the ends of the cut arcs, and stores the vertices in these. Every free circle is
  // subdivided at its two points in the plane of its halves, whether or not a cut arc ends there.
  void insert(const BallSet &balls, const Boundary &boundary, Span<CutArc> arcs);

  // The id of a host edge is that of the half-edge on ball a, or for half a circle half_circle(): the loop of ball a
  // traverses half 0 from point 2 circle to point 2 circle + 1, and half 1 back to the first.
  static uint32_t half_circle(const Boundary &boundary, uint32_t circle, uint32_t half) {
    return boundary.half_edge_count() + 2 * circle + half;
  }
  // Whether a host edge is half of a free circle, and of which.
  static bool is_half_circle(const Boundary &boundary, uint32_t host) { return host >= boundary.half_edge_count(); }
  static uint32_t circle_of(const Boundary &boundary, uint32_t host) { return (host - boundary.half_edge_count()) / 2; }
  uint32_t first(uint32_t host) const { return first_[host]; }
  const SubdivisionVertex &operator[](uint32_t k) const { return points_[k]; }
  // Points 0 .. 2 circles - 1 are those of the free circles.
  uint32_t size() const { return points_.size(); }

 private:
  // The number of the subdivision vertex at one end of a cut arc.
  uint32_t insert_end(const BallSet &balls, const Boundary &boundary, const CutArc &arc, uint32_t arc_id, uint32_t end);

  Span<uint32_t> first_;  // [hosts] first subdivision vertex inside it
  FixedVector<SubdivisionVertex> points_;
};

}  // namespace hsp
