#include "view/piece_arcs.hpp"

#include "core/elementary.hpp"
#include "exact/filter.hpp"
#include "sphere/arc_geometry.hpp"
#include "view/circle_frame.hpp"
#include "view/projected_arcs.hpp"

namespace hsp {
namespace {

using exact::Plane;

// Where the loops of a piece come by.
class CornerFinder {
 public:
  struct Corner {
    double root_D;
    Vec3 offset;  // from the ball's centre, view coordinates
  };

  CornerFinder(const Caps &caps, const ViewFrame &frame)
      : caps_(caps),
        frame_(frame),
        well_conditioned_(precise * exact::FilterBounds::for_length_squared(caps.length_squared).D) {}

  // With q and D as in plane.hpp. Doubles have D within the filter's bound and q within 6e L^3. Where D is so far above
  // its bound, at least L^6/128, its relative error is below 2^-40. As D <= W N and |q| <= L |n|, the error of D is at
  // most 12e L^4 |n| + 11e L^2 |n|^2 and that of the offset below 100e L. Elsewhere D and q are taken from the
  // integers.
  Corner at(const HalfEdge &half_edge) const {
    const Plane &P = caps_.plane[half_edge.previous_circle];
    const Plane &Q = caps_.plane[half_edge.circle];
    const Vec3 n = exact::to_double(cross(P.v, Q.v));
    const double N = dot(n, n);
    const Vec3 q =
        combine(static_cast<double>(P.h), exact::to_double(Q.v), -static_cast<double>(Q.h), exact::to_double(P.v));
    const double D = static_cast<double>(caps_.sphere.W) * N - dot(q, q);
    if (D > well_conditioned_) {
      const double root_D = std::sqrt(D);
      const Vec3 p = combine(0.5 / N, cross(q, n), 0.5 * root_D / N, n);
      return {root_D, frame_.to_view(p)};
    }
    const double root_D = std::sqrt(exact::Exact::discriminant(caps_.sphere, P, Q));
    double place[3];
    vertex_offset(P, Q, +1, root_D, place);
    return {root_D, frame_.to_view({place[0], place[1], place[2]})};
  }

 private:
  static constexpr double precise = 0x1p40;

  const Caps &caps_;
  const ViewFrame &frame_;
  const double well_conditioned_;
};
using Corner = CornerFinder::Corner;

CircleFrame frame_of(const Caps &caps, const ViewFrame &frame, uint32_t cap) {
  return caps.ball[cap] == no_id ? CircleFrame() : CircleFrame(frame, caps.plane[cap].v);
}

double parameter(const CircleFrame &circle, const Vec3 &offset) {
  return arc_tangent(dot(offset, circle.across), dot(offset, circle.along));
}

// The parameter that an arc is walked through from `from` to `to`, which are known up to whole turns. Where rounding
// could turn nothing into a whole turn or back, the exact signs behind the arc's angle decide.
double span_of(const Caps &caps, const HalfEdge &half_edge, const Corner &start, const HalfEdge &end_half_edge,
               const Corner &end, double walked) {
  constexpr double branch_cut_margin = 0x1p-20;
  double span = walked < 0.0 ? walked + 2 * pi : walked;
  if (span >= 2 * pi) span -= 2 * pi;
  if (span > branch_cut_margin && span < 2 * pi - branch_cut_margin) return span;
  const double angle = FreeArc(caps.plane[half_edge.circle], caps.plane[end_half_edge.circle], end.root_D,
                               caps.plane[half_edge.previous_circle], start.root_D)
                           .angle();
  if (angle < pi) return span < pi ? span : 0.0;
  return span > pi ? span : 2 * pi;
}

// The sum may be rounded to more than a whole turn from `from`; the next double towards it is not.
double end_parameter(double from, double walk, double span) {
  const double to = from + walk * span;
  return std::fabs(to - from) <= 2 * pi ? to : to - walk * std::fabs(to) * 0x1p-52;
}

}  // namespace

void add_loops(const BallSet &balls, const VisiblePiece &piece, View &view) {
  const Caps &caps = piece.caps();
  const Vec3 centre = view.frame.centre_of(balls, caps.origin);
  const Span<const HalfEdge> half_edges = piece.half_edges();
  const CornerFinder corners(caps, view.frame);
  uint32_t loop = 0;
  for (uint32_t first = 0; first < half_edges.size(); ++first) {
    if (half_edges[first].loop != loop) continue;
    ++loop;
    view.loops.push(static_cast<uint32_t>(view.arcs.required()));
    uint32_t u = first;
    Corner start = corners.at(half_edges[first]);
    do {
      const HalfEdge &half_edge = half_edges[u];
      const HalfEdge &end_half_edge = half_edges[half_edge.next];
      const Corner end = corners.at(end_half_edge);
      const CircleFrame circle = frame_of(caps, view.frame, half_edge.circle);
      const double from = parameter(circle, start.offset);
      const double walked = circle.walk * (parameter(circle, end.offset) - from);
      const double to = end_parameter(from, circle.walk, span_of(caps, half_edge, start, end_half_edge, end, walked));
      view.arcs.push({from, to, {centre.x + start.offset.x, centre.y + start.offset.y}, caps.ball[half_edge.circle]});
      start = end;
      u = half_edge.next;
    } while (u != first);
  }
  for (const uint32_t cap : piece.circles()) {
    view.loops.push(static_cast<uint32_t>(view.arcs.required()));
    const double walk = frame_of(caps, view.frame, cap).walk;
    const ProjectedEllipse ellipse = ellipse_of(balls, view.frame, caps.origin, caps.ball[cap]);
    view.arcs.push({-walk * pi,
                    walk * pi,
                    {ellipse.centre[0] - ellipse.major[0], ellipse.centre[1] - ellipse.major[1]},
                    caps.ball[cap]});
  }
}

}  // namespace hsp
