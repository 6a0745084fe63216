// The points where cut arcs end, in their order along the arcs and free circles on which they end.
//
// A host edge is an arc of the boundary or one half of a free circle. It is described on the first of its two balls in
// grid order, a, as a part of the circle P of the other ball, b: counter-clockwise from the exit of a plane Q, its
// reference plane, to the entry of another plane. A free circle is divided into halves by the plane through both
// centres that contains the direction z; this plane and its complement are the reference planes of the two halves.
//
// A subdivision vertex is a point where the plane of a cut arc crosses P. The plane contains the direction z and the
// centre of a or of b. Two such points, one of a cut arc of a and one of a cut arc of b, coincide only if their planes
// are the same. Then they are one vertex, at which cut arcs may end on both sides. (Two different planes can pass
// through one point of the circle only before the symbolic perturbation, which moves the circle.)
#pragma once

#include "core/fixed_vector.hpp"
#include "core/patience.hpp"
#include "core/workspace.hpp"
#include "topology/cut_arcs.hpp"

namespace hsp {

struct SubdivisionVertex {
  uint32_t host;       // for the two points between the halves of a free circle: half 0
  uint32_t ball, cap;  // its plane is that of a cut arc of `ball` through the axis of the circle of `cap`
  int32_t sign;        // whether it is p+ or p- of the host's circle and the plane, on the host's ball a
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
  void carve(Workspace &workspace, uint32_t cut_arcs);

  // Subdivides the host edges at the ends of the cut arcs, and stores the vertices in CutArc::ends. Every free circle
  // is subdivided at its two points in the plane of its halves, whether or not a cut arc ends there. first [hosts]:
  // memory for first(), which nothing else may use as long as first() is called.
  void insert(const BallSet &balls, const Boundary &boundary, Span<CutArc> arcs, Span<uint32_t> first,
              Patience &patience);

  // The id of a host edge: for an arc, that of its half-edge on ball a; for half a circle, half_circle(). The loop of
  // ball a traverses half 0 from point 2 circle to point 2 circle + 1, and half 1 back to the first point.
  static uint32_t half_circle(const Boundary &boundary, uint32_t circle, uint32_t half) {
    return boundary.half_edge_count() + 2 * circle + half;
  }
  // Whether a host edge is half of a free circle, and the number of this circle.
  static bool is_half_circle(const Boundary &boundary, uint32_t host) { return host >= boundary.half_edge_count(); }
  static uint32_t circle_of(const Boundary &boundary, uint32_t host) { return (host - boundary.half_edge_count()) / 2; }
  // Points 0 .. first_inner() - 1 are the two points between the halves of each free circle; they need no memory. The
  // others lie inside host edges. Those of a host are a list, which begins at first(host) and goes on with next() in
  // the direction of the loop of ball a; the last one has next() = no_id.
  uint32_t size() const { return first_inner_ + points_.size(); }
  uint32_t first_inner() const { return first_inner_; }
  uint32_t first(uint32_t host) const { return first_[host]; }
  uint32_t next(uint32_t k) const { return points_[k - first_inner_].next; }
  uint32_t host(uint32_t k) const { return points_[k - first_inner_].vertex.host; }
  SubdivisionVertex vertex(const Boundary &boundary, uint32_t k) const {
    return k < first_inner_ ? point_of_circle(boundary, k) : points_[k - first_inner_].vertex;
  }

 private:
  struct InnerPoint {
    SubdivisionVertex vertex;
    uint32_t next;
  };

  static SubdivisionVertex point_of_circle(const Boundary &boundary, uint32_t k);
  CutArcEnd insert_end(const BallSet &balls, const Boundary &boundary, const CutArc &arc, uint32_t end);

  Span<uint32_t> first_;  // [hosts] the first subdivision vertex inside each
  uint32_t first_inner_ = 0;
  FixedVector<InnerPoint> points_;
};

}  // namespace hsp
