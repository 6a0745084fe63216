// The arcs and circles of a boundary as polygons. Every curve has its points once, by a rule that knows nothing of
// faces, so that all patches that share the curve share its points.
#pragma once

#include "core/patience.hpp"
#include "mesh/mesh_curve.hpp"

namespace hsp {

class BoundaryCurves {
 public:
  // curves: the most arcs and circles. The memory for half-edges is for two of each.
  void carve(Workspace &workspace, uint32_t curves);

  // Numbers all curves and says how many segments of about the given length they have. There must be room for all
  // curves. False if there are more than max_count segments, or if `patience` stops it.
  bool build(const BallSet &balls, const Boundary &boundary, double length, Patience &patience);

  uint32_t count() const { return count_; }
  uint32_t of(LoopElement e) const {
    return e.is_circle() ? first_circle_ + e.closed_half_edge().circle() : curve_of_[e.half_edge()];
  }
  const MeshCurve &curve(uint32_t c) const { return curve_[c]; }
  MeshCurve &curve(uint32_t c) { return curve_[c]; }
  // The memory of all curves, for callers that have others.
  Span<MeshCurve> room() { return curve_; }

 private:
  Span<uint32_t> curve_of_;  // [half-edges]
  Span<MeshCurve> curve_;
  uint32_t first_circle_ = 0;
  uint32_t count_ = 0;
};

// The next three are for an arc, named by its half-edge on the ball of lower rank, or a circle. Length and segments are
// the same for both elements of a circle.

// Its points run clockwise about the axis from the ball of lower rank to the other. A circle smaller than least_radius
// is taken to be so large.
CirclePoints points_of_curve(const BallSet &balls, const Boundary &boundary, LoopElement e, double least_radius = 0.0);
double length_of_curve(const BallSet &balls, const Boundary &boundary, LoopElement e);
// Its segments as in BoundaryCurves::build; in doubles, which may be more than fits.
double segments_of_curve(const BallSet &balls, const Boundary &boundary, LoopElement e, double length);

}  // namespace hsp
