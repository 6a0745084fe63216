// The points where cut arcs end, in their order along the arcs and free circles they end on.
//
// A host is an arc of the boundary, or one half of a free circle. It is described on one of its two balls, a, the
// first in grid order, as part of the circle P of the other, b: counter-clockwise from the exit of a plane Q, its
// anchor, to the entry of another. The halves of a free circle are what the plane through both centres that contains
// the direction z leaves out and what it covers, so that this plane and its complement are their anchors.
//
// A subdivision vertex is where the plane of a cut arc crosses P. That plane contains the direction z and the centre
// of a or of b. Points of a and b coincide only if their planes are the same; then they are one point, at which a cut
// arc may end on either side. (Two different planes through one point of the sphere of a: only before the symbolic
// inflation, which moves the circle.)
#pragma once

#include "core/fixed_vector.hpp"
#include "core/workspace.hpp"
#include "topology/cut_arcs.hpp"

namespace hsp {

struct SubdivisionVertex {
  uint32_t host;       // of the two points of a free circle: its half 0
  uint32_t ball, cap;  // the plane: that of a cut arc of `ball` through the axis of the circle of `cap`
  int32_t sign;        // p+ or p- of the host's circle and the plane, on the host's ball a
  uint32_t extra[2];   // on the side of a and of b: 2 * cut arc + end, or no_id
  uint32_t next;       // the next one as the loop of ball a walks the host; no_id at the last
};

// The balls a and b of a host; hosts are named as in Subdivision.
struct HostBalls {
  uint32_t a, b;
};
HostBalls balls_of_host(const Boundary &boundary, uint32_t host);

// The plane of a cut arc of `ball` through the axis of the circle of `cap`, as ball `origin` sees it.
exact::Plane plane_of_cut(const BallSet &balls, uint32_t origin, uint32_t ball, uint32_t cap);

class Subdivision {
 public:
  void carve(Workspace &workspace, uint32_t edges, uint32_t cut_arcs);

  // Splits the hosts at the ends of the cut arcs, and stores in these where they end. Every free circle is split
  // in its two points in the plane of its halves, whether or not a cut arc ends there.
  void insert(const BallSet &balls, const Boundary &boundary, Span<CutArc> arcs);

  // Host edges of arcs are named by the use that walks them on ball a, those of circles by their number and half: the
  // loop of ball a walks half 0 from point 2 circle to point 2 circle + 1, and half 1 back to the first.
  static uint32_t half_circle(const Boundary &boundary, uint32_t circle, uint32_t half) {
    return boundary.half_edge_count() + 2 * circle + half;
  }
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
