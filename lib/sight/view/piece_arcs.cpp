#include "view/piece_arcs.hpp"

#include "core/elementary.hpp"
#include "exact/filter.hpp"
#include "sphere/arc_geometry.hpp"
#include "view/projected_arcs.hpp"

namespace hsp {
namespace {

// A vertex of a piece.
struct Corner {
  double root_D;
  Vec3 offset;  // from the ball's centre, view coordinates
};

CircleFrame frame_of(const Caps &caps, const ViewFrame &frame, uint32_t cap) {
  return caps.ball[cap] == no_id ? CircleFrame() : CircleFrame(frame, caps.direction(cap));
}

double parameter(const CircleFrame &circle, const Vec3 &offset) {
  return arc_tangent(dot(offset, circle.across), dot(offset, circle.along));
}

// The parameter range of an arc, from the difference of the parameters at its ends, which is known up to whole turns.
// If rounding could turn a point into a whole turn or back, the exact signs behind the arc's angle decide.
double span_of(const Caps &caps, const PieceHalfEdge &half_edge, const Corner &start,
               const PieceHalfEdge &end_half_edge, const Corner &end, double to_view) {
  double span = to_view < 0.0 ? to_view + 2 * pi : to_view;
  if (span >= 2 * pi) span -= 2 * pi;
  if (span > branch_cut_margin && span < 2 * pi - branch_cut_margin) return span;
  const double angle = arc_angle(caps.plane(half_edge.circle), caps.plane(end_half_edge.circle), end.root_D,
                                 caps.plane(half_edge.previous_circle), start.root_D);
  if (angle < pi) return span < pi ? span : 0.0;
  return span > pi ? span : 2 * pi;
}

// The sum may be rounded to more than a whole turn from `from`; the next double towards it is not.
double end_parameter(double from, double turn, double span) {
  const double to = from + turn * span;
  return std::fabs(to - from) <= 2 * pi ? to : to - turn * std::fabs(to) * 0x1p-52;
}

}  // namespace

void add_loops(const BallSet &balls, const VisiblePiece &piece, View &view) {
  const Caps &caps = piece.caps();
  const Vec3 centre = view.frame.centre_of(balls, caps.origin);
  const Span<const PieceHalfEdge> half_edges = piece.half_edges();
  const CrossingPointFinder points(caps.sphere, caps.length_squared);
  // Where a half-edge starts.
  const auto corner_at = [&](const PieceHalfEdge &half_edge) {
    const auto point = points.find(caps.plane(half_edge.previous_circle), caps.plane(half_edge.circle));
    return Corner{point.root_D, view.frame.to_view(point.position)};
  };
  uint32_t loop = 0;
  for (uint32_t first = 0; first < half_edges.size(); ++first) {
    if (half_edges[first].loop != loop) continue;
    ++loop;
    view.loops.push(static_cast<uint32_t>(view.arcs.required()));
    uint32_t u = first;
    Corner start = corner_at(half_edges[first]);
    do {
      const PieceHalfEdge &half_edge = half_edges[u];
      const PieceHalfEdge &end_half_edge = half_edges[half_edge.next];
      const Corner end = corner_at(end_half_edge);
      const CircleFrame circle = frame_of(caps, view.frame, half_edge.circle);
      const double from = parameter(circle, start.offset);
      const double to_view = circle.turn * (parameter(circle, end.offset) - from);
      const double to = end_parameter(from, circle.turn, span_of(caps, half_edge, start, end_half_edge, end, to_view));
      view.arcs.push({from, to, {centre.x + start.offset.x, centre.y + start.offset.y}, caps.ball[half_edge.circle]});
      start = end;
      u = half_edge.next;
    } while (u != first);
  }
  for (const uint32_t cap : piece.circles()) {
    view.loops.push(static_cast<uint32_t>(view.arcs.required()));
    const double turn = frame_of(caps, view.frame, cap).turn;
    const ProjectedEllipse ellipse = ellipse_of(balls, view.frame, caps.origin, caps.ball[cap]);
    view.arcs.push({-turn * pi,
                    turn * pi,
                    {ellipse.centre[0] - ellipse.major[0], ellipse.centre[1] - ellipse.major[1]},
                    caps.ball[cap]});
  }
}

}  // namespace hsp
