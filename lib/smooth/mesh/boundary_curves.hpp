// The arcs and circles of a boundary as polygons. Every curve has its points once, by a rule that knows nothing of
// faces, so that all patches that share the curve share its points.
#pragma once

#include "core/elementary.hpp"
#include "core/patience.hpp"
#include "mesh/mesh_curve.hpp"

namespace hsp {

// The element of a curve is an arc, named by its half-edge on the ball of lower rank, or a circle.
//
// A curve's points are those on a circle at equal angles, clockwise about the axis from the ball of lower rank to the
// other.
class CurvePoints {
 public:
  // A circle smaller than least_radius is taken to be so large.
  CurvePoints(const BallSet &balls, const Boundary &boundary, const MeshCurve &curve, bool is_circle,
              double least_radius = 0.0);

  // Point k of 0 .. segments.
  Position at(uint32_t k) const {
    const SinCos turn = sin_cos(angle_ * k / segments_);
    return {ball_, centre_ + combine(turn.cosine, x_, turn.sine, y_)};
  }

 private:
  uint32_t ball_;
  uint32_t segments_;
  double angle_;
  Vec3 centre_, x_, y_;  // y_ is a quarter turn clockwise from x_
};

class BoundaryCurves {
 public:
  // curves: the most arcs and circles. The memory for half-edges is for two of each.
  void carve(Workspace &workspace, uint32_t curves);

  // Numbers all curves and says how many segments of about the given length they have. There must be room for all
  // curves. False if there are more than max_count segments, or if `patience` stops it.
  bool build(const BallSet &balls, const Boundary &boundary, double length, Patience &patience);

  uint32_t count() const { return count_; }
  uint32_t of_half_edge(uint32_t e) const { return curve_of_[e]; }
  uint32_t of_circle(uint32_t circle) const { return first_circle_ + circle; }
  bool is_circle(uint32_t curve) const { return curve >= first_circle_; }
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

// The length of an arc, named by its half-edge on the ball of lower rank.
double length_of_arc(const BallSet &balls, const Boundary &boundary, uint32_t half_edge);
// The segments of such an arc, and of a circle, as in BoundaryCurves::build; in doubles, which may be more than fits.
double segments_of_arc(const BallSet &balls, const Boundary &boundary, uint32_t half_edge, double length);
double segments_of_circle(const BallSet &balls, const Boundary &boundary, uint32_t circle, double length);

}  // namespace hsp
