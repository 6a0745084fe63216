// The points where extra arcs end, in their order along the arcs and free circles they end on.
//
// A carrier is an arc of the boundary, or one half of a free circle. It is described on one of its two balls, a, the
// first in grid order, as part of the circle P of the other, b: counter-clockwise from the exit of a plane Q, its
// anchor, to the entry of another. The halves of a free circle are what the plane through both centres that contains
// the direction z leaves out and what it covers, so that this plane and its complement are their anchors.
//
// A split point is where the plane of an extra arc crosses P. That plane contains the direction z and the centre of a
// or of b. Points of a and b coincide only if their planes are the same; then they are one point, at which an extra arc
// may end on either side. (Two different planes through one point of the sphere of a: only before the symbolic
// inflation, which moves the circle.)
#pragma once

#include "core/fixed_vector.hpp"
#include "core/workspace.hpp"
#include "topology/cut_arcs.hpp"

namespace hsp {

struct SplitPoint {
  uint32_t carrier;    // of the two points of a free circle: its half 0
  uint32_t ball, cap;  // the plane: that of an extra arc of `ball` through the axis of the circle of `cap`
  int32_t sign;        // p+ or p- of the carrier's circle and the plane, on the carrier's ball a
  uint32_t extra[2];   // on the side of a and of b: 2 * extra arc + end, or no_id
  uint32_t next;       // the next one as the loop of ball a walks the carrier; no_id at the last
};

// The balls a and b of a carrier; carriers are named as in SplitPoints.
struct CarrierBalls {
  uint32_t a, b;
};
CarrierBalls balls_of_carrier(const BoundaryStructure &boundary, uint32_t carrier);

// The plane of an extra arc of `ball` through the axis of the circle of `cap`, as ball `origin` sees it.
exact::Plane plane_of_cut(const BallSet &balls, uint32_t origin, uint32_t ball, uint32_t cap);

class SplitPoints {
 public:
  void carve(Workspace &workspace, uint32_t edges, uint32_t extra_arcs);

  // Splits the carriers at the ends of the extra arcs, and stores in these where they end. Every free circle is split
  // in its two points in the plane of its halves, whether or not an extra arc ends there.
  void insert(const BallSet &balls, const BoundaryStructure &boundary, Span<ExtraArc> arcs);

  // Carriers of arcs are named by the use that walks them on ball a, those of circles by their number and half: the
  // loop of ball a walks half 0 from point 2 circle to point 2 circle + 1, and half 1 back to the first.
  static uint32_t half_circle(const BoundaryStructure &boundary, uint32_t circle, uint32_t half) {
    return 3 * boundary.vertices.size() + 2 * circle + half;
  }
  uint32_t first(uint32_t carrier) const { return first_[carrier]; }
  const SplitPoint &operator[](uint32_t k) const { return points_[k]; }
  // Points 0 .. 2 circles - 1 are those of the free circles.
  uint32_t size() const { return points_.size(); }

 private:
  // The number of the split point at one end of an extra arc.
  uint32_t insert_end(const BallSet &balls, const BoundaryStructure &boundary, const ExtraArc &arc, uint32_t arc_id,
                      uint32_t end);

  Span<uint32_t> first_;  // [carriers] first split point inside it
  FixedVector<SplitPoint> points_;
};

}  // namespace hsp
