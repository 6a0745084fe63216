// The outlines of what is painted, as loops of arcs in the view plane with the painted side on the left.
#pragma once

#include "core/elementary.hpp"
#include "maps/stick_view.hpp"
#include "picture/painted_paths.hpp"

namespace hsp {

// How much longer than it is a part is painted at its upper end, under what is painted later there: the other part, or
// the ball, unless another stick's bite of the ball is so close that it might show there.
double overlap_of(const StickView &view, const Stick &stick, uint32_t part);

// Calls visit(arc, first_of_loop, last_of_loop) for the one loop of a path. A junction or the end of a part names the
// ball that the path belongs to as its other ball, a silhouette none.
template <class Visit>
void visit_outline(const StickView &view, uint32_t path, Visit visit) {
  const StickPath &record = view.paths[path];
  if (record.stick == no_id) {
    const PlacedBall &ball = view.balls[record.ball];
    const ProjectedEllipse circle{{ball.centre.x, ball.centre.y}, {ball.r, 0.0}, {0.0, ball.r}};
    const Span<const StickBite> bites = view.bites_of(record.ball);
    if (bites.empty()) {
      const double x = ball.centre.x - ball.r;
      visit(ProjectedArc{circle, -pi, pi, {x, ball.centre.y}, {x, ball.centre.y}, no_id}, true, true);
      return;
    }
    const uint32_t n = bites.size();
    ProjectedArc junction{};
    const auto set_junction = [&](const StickBite &bite) {
      const Stick &stick = view.sticks[bite.stick];
      junction.ellipse = stick.circle_at(stick.last);
      junction.from = bite.from;
      junction.to = pi - bite.from;
      junction.other_ball = record.ball;
      const SinCos at = sin_cos(bite.from);
      for (int k = 0; k < 2; ++k) {
        const double middle = junction.ellipse.centre[k] + at.sine * junction.ellipse.minor[k];
        junction.start[k] = middle + at.cosine * junction.ellipse.major[k];
        junction.end[k] = middle - at.cosine * junction.ellipse.major[k];
      }
    };
    set_junction(bites[0]);
    for (uint32_t k = 0; k < n; ++k) {
      visit(junction, k == 0, false);
      const StickBite &next = bites[k + 1 < n ? k + 1 : 0];
      ProjectedArc silhouette{circle,
                              bites[k].middle + bites[k].half,
                              next.middle - next.half + (k + 1 < n ? 0.0 : 2 * pi),
                              {junction.end[0], junction.end[1]},
                              {},
                              no_id};
      if (silhouette.to < silhouette.from) silhouette.to = silhouette.from;
      if (silhouette.to > 2 * pi) {
        silhouette.from -= 2 * pi;
        silhouette.to -= 2 * pi;
      }
      set_junction(next);
      silhouette.end[0] = junction.start[0];
      silhouette.end[1] = junction.start[1];
      visit(silhouette, false, k + 1 == n);
    }
    return;
  }
  const Stick &stick = view.sticks[record.stick];
  const ProjectedEllipse low = stick.circle_at(stick.begin_of(record.part));
  const ProjectedEllipse high = stick.circle_at(stick.end_of(record.part) + overlap_of(view, stick, record.part));
  double low_left[2], low_right[2], high_left[2], high_right[2];
  for (int k = 0; k < 2; ++k) {
    low_left[k] = low.centre[k] + low.major[k];
    low_right[k] = low.centre[k] - low.major[k];
    high_left[k] = high.centre[k] + high.major[k];
    high_right[k] = high.centre[k] - high.major[k];
  }
  visit(line_between(low_right, high_right, record.ball), true, false);
  visit(ProjectedArc{high, pi, 0.0, {high_right[0], high_right[1]}, {high_left[0], high_left[1]}, record.ball}, false,
        false);
  visit(line_between(high_left, low_left, record.ball), false, false);
  visit(ProjectedArc{low, 0.0, pi, {low_left[0], low_left[1]}, {low_right[0], low_right[1]}, record.ball}, false, true);
}

// For pictures. Halves of sticks have one colour. The view has to outlive them.
PaintedPaths paths_of(const StickView &view);

}  // namespace hsp
