#include "view/piece_arcs.hpp"

#include "core/elementary.hpp"
#include "exact/filter.hpp"
#include "sphere/arc_geometry.hpp"
#include "measure/areas.hpp"
#include "view/circle_frame.hpp"
#include "view/projected_arcs.hpp"

namespace hsp {
namespace {

using exact::DoubleVector;
using exact::Plane;

// Where the loops of a piece come by.
class CornerFinder {
 public:
  struct Corner {
    double root_D;
    DoubleVector offset;  // from the ball's centre, view coordinates
  };

  CornerFinder(const Caps &caps, const ViewFrame &frame)
      : caps_(caps),
        frame_(frame),
        well_conditioned_(precise * exact::FilterBounds::for_length_squared(caps.length_squared).D) {}

  // With q and D as in plane.hpp. Doubles have D within the filter's bound and q within 6e L^3. Where D is so far above
  // its bound, at least L^6/128, its relative error is below 2^-40. As D <= W N and |q| <= L |n|, the error of D is at
  // most 12e L^4 |n| + 11e L^2 |n|^2 and that of the offset below 100e L. Elsewhere D and q are taken from the
  // integers.
  Corner at(const PieceUse &use) const {
    const Plane &P = caps_.plane[use.in];
    const Plane &Q = caps_.plane[use.out];
    const DoubleVector n = exact::to_double(exact::cross(P.v, Q.v));
    const double N = exact::dot(n, n);
    const DoubleVector q = exact::combine(static_cast<double>(P.h), exact::to_double(Q.v), -static_cast<double>(Q.h),
                                          exact::to_double(P.v));
    const double D = static_cast<double>(caps_.sphere.W) * N - exact::dot(q, q);
    if (D > well_conditioned_) {
      const double root_D = std::sqrt(D);
      const DoubleVector p = exact::combine(0.5 / N, exact::cross(q, n), 0.5 * root_D / N, n);
      return {root_D, frame_.turned(p)};
    }
    const double root_D = std::sqrt(exact::Exact::discriminant(caps_.sphere, P, Q));
    double place[3];
    vertex_offset(P, Q, +1, root_D, place);
    return {root_D, frame_.turned({place[0], place[1], place[2]})};
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

double parameter(const CircleFrame &circle, const DoubleVector &offset) {
  return arc_tangent(exact::dot(offset, circle.across), exact::dot(offset, circle.along));
}

// The parameter that an arc is walked through from `from` to `to`, which are known up to whole turns. Where rounding
// could turn nothing into a whole turn or back, the exact signs behind the arc's angle decide.
double span_of(const Caps &caps, const PieceUse &use, const Corner &start, const PieceUse &end_use, const Corner &end,
               double walked) {
  constexpr double near_a_turn = 0x1p-20;
  double span = walked < 0.0 ? walked + 2 * pi : walked;
  if (span >= 2 * pi) span -= 2 * pi;
  if (span > near_a_turn && span < 2 * pi - near_a_turn) return span;
  const double angle =
      FreeArc(caps.plane[use.out], caps.plane[end_use.out], end.root_D, caps.plane[use.in], start.root_D).angle();
  if (angle < pi) return span < pi ? span : 0.0;
  return span > pi ? span : 2 * pi;
}

// The sum may be rounded to more than a whole turn from `from`; the next double towards it is not.
double end_parameter(double from, double walk, double span) {
  const double to = from + walk * span;
  return std::fabs(to - from) <= 2 * pi ? to : to - walk * std::fabs(to) * 0x1p-52;
}

}  // namespace

void add_loops(const BallSet &balls, const FrontPiece &piece, ViewStructure &view) {
  const Caps &caps = piece.caps();
  const DoubleVector centre = view.frame.centre_of(balls, caps.origin);
  const Span<PieceUse> uses = piece.uses();
  const CornerFinder corners(caps, view.frame);
  for (uint32_t first = 0; first < uses.size(); ++first) {
    if (uses[first].in_loop) continue;
    view.loops.push(static_cast<uint32_t>(view.arcs.wanted()));
    uint32_t u = first;
    Corner start = corners.at(uses[first]);
    do {
      PieceUse &use = uses[u];
      use.in_loop = true;
      const PieceUse &end_use = uses[use.next];
      const Corner end = corners.at(end_use);
      const CircleFrame circle = frame_of(caps, view.frame, use.out);
      const double from = parameter(circle, start.offset);
      const double walked = circle.walk * (parameter(circle, end.offset) - from);
      const double to = end_parameter(from, circle.walk, span_of(caps, use, start, end_use, end, walked));
      view.arcs.push({from, to, {centre.x + start.offset.x, centre.y + start.offset.y}, caps.ball[use.out]});
      start = end;
      u = use.next;
    } while (u != first);
  }
  for (const uint32_t cap : piece.circles()) {
    view.loops.push(static_cast<uint32_t>(view.arcs.wanted()));
    const double walk = frame_of(caps, view.frame, cap).walk;
    const PlaneEllipse ellipse = ellipse_of(balls, view.frame, caps.origin, caps.ball[cap]);
    view.arcs.push({-walk * pi,
                    walk * pi,
                    {ellipse.centre[0] - ellipse.major[0], ellipse.centre[1] - ellipse.major[1]},
                    caps.ball[cap]});
  }
}

}  // namespace hsp
