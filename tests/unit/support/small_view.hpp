// A view of a few balls, in memory of fixed size, for cases that run without a heap; and two measures to compare it
// with: depths of fronts over all balls, in the view's own frame, and winding numbers of its loops.
#pragma once

#include "small_union.hpp"
#include "view/projected_arcs.hpp"
#include "view/view_builder.hpp"

namespace cases {

class SmallView {
 public:
  static constexpr hsp::ViewLimits roomy{SmallUnion::most_balls, SmallUnion::most_balls, 200};

  // The balls go into small_union(). False if they do not fit; the view's own status is status().
  bool build(const SmallBall *balls, uint32_t n, const hsp::ViewRequest &request = {},
             const hsp::ViewLimits &limits = roomy) {
    const auto carve = [&](hsp::Workspace &workspace) {
      builder_.carve(workspace, limits);
      piece_.carve(workspace, limits.neighbours);
    };
    hsp::Workspace measured;
    carve(measured);
    if (measured.bytes() > sizeof memory_ || !small_union().build(balls, n)) return false;
    hsp::Workspace workspace(memory_, sizeof memory_);
    carve(workspace);
    again(request, &small_union().boundary());
    return true;
  }
  // Another view of the same balls in the same memory.
  bool again(const hsp::ViewRequest &request, const hsp::Boundary *boundary) {
    status_ = builder_.build(small_union().grid(), boundary, request);
    return status_ == hsp::Status::ok;
  }
  bool succeeds(const SmallBall *balls, uint32_t n, const hsp::ViewRequest &request = {}) {
    return build(balls, n, request) && status_ == hsp::Status::ok;
  }

  hsp::Status status() const { return status_; }
  const hsp::ViewBuilder &builder() const { return builder_; }
  const hsp::View &view() const { return builder_.structure(); }
  const hsp::BallSet &balls() const { return small_union().balls(); }
  hsp::Span<uint32_t> scratch() { return builder_.scratch(); }
  // For pieces that are cut one by one.
  hsp::VisiblePiece &piece() { return piece_; }

 private:
  hsp::ViewBuilder builder_;
  hsp::VisiblePiece piece_;
  hsp::Status status_ = hsp::Status::ok;
  alignas(64) unsigned char memory_[64 * 1024];
};

// One for all cases, as it is large for a stack.
inline SmallView &small_view() {
  static SmallView one;
  return one;
}

// Seen with the z axis upwards in the picture.
constexpr hsp::ViewRequest seen_from(double x, double y, double z,
                                     hsp::PieceKind kind = hsp::PieceKind::outside_farther, bool all_balls = false) {
  return {{{x, y, z}, {0, 0, 1}}, kind, all_balls};
}

// Far below everything.
constexpr double no_front = -1e300;

// The depth of a ball's front at a point of the view plane, no_front beside the ball.
inline double front_of(const hsp::BallSet &balls, const hsp::ViewFrame &frame, uint32_t i, double x, double y) {
  const hsp::Vec3 centre = frame.centre_of(balls, i);
  const double dx = x - centre.x, dy = y - centre.y;
  const double squared = balls.r[i] * balls.r[i] - dx * dx - dy * dy;
  return squared < 0.0 ? no_front : centre.z + std::sqrt(squared);
}

// How often the loops of a piece run counter-clockwise around a point: every arc as 64 chords, which stay within .0013
// of the larger semi-axis.
inline int winding_number(const hsp::BallSet &balls, const hsp::View &view, uint32_t piece, double x, double y) {
  int times = 0;
  hsp::visit_arcs(balls, view, piece, [&](const hsp::ProjectedArc &arc, bool, bool) {
    constexpr int chords = 64;
    const hsp::ProjectedEllipse &e = arc.ellipse;
    double from[2] = {arc.start[0], arc.start[1]};
    for (int k = 1; k <= chords; ++k) {
      const double t = arc.from + (arc.to - arc.from) * k / chords;
      double to[2] = {arc.end[0], arc.end[1]};
      for (int axis = 0; axis < 2 && k < chords; ++axis) {
        to[axis] = e.centre[axis] + std::cos(t) * e.major[axis] + std::sin(t) * e.minor[axis];
      }
      if ((from[1] <= y) != (to[1] <= y)) {
        const double crossing = from[0] + (to[0] - from[0]) * (y - from[1]) / (to[1] - from[1]);
        if (crossing > x) times += from[1] <= y ? 1 : -1;
      }
      from[0] = to[0];
      from[1] = to[1];
    }
  });
  return times;
}

}  // namespace cases
