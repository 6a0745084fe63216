// The outlines of what is painted, as loops of arcs in the view plane with the painted side on the left.
#pragma once

#include "core/elementary.hpp"
#include "maps/stick_view.hpp"
#include "picture/painted_paths.hpp"

namespace hsp {

// The length by which a part of a stick is painted beyond its upper end, under the other part or the ball, which are
// painted later there. 0 if another stick's bite of the ball is so close that the overlap might show in it.
double overlap_of(const StickView &view, const Stick &stick, uint32_t part);

// A point of the circle across a stick at some position along it: the one whose parameter has the cosine `cosine`,
// which is how far left it is, in radii.
struct StrandEdge {
  double t;
  double at[2];
};
inline StrandEdge strand_edge(const ProjectedEllipse &circle, double cosine) {
  const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  StrandEdge edge{sine > 0.0 ? arc_tangent(sine, cosine) : cosine > 0.0 ? 0.0 : pi, {}};
  for (int k = 0; k < 2; ++k) {
    edge.at[k] = circle.centre[k] + cosine * circle.major[k] + sine * circle.minor[k];
  }
  return edge;
}

// The arc along a circle from one point to another.
inline ProjectedArc strand_end(const ProjectedEllipse &circle, const StrandEdge &from, const StrandEdge &to,
                               uint32_t ball) {
  return {circle, from.t, to.t, {from.at[0], from.at[1]}, {to.at[0], to.at[1]}, ball};
}

// The outline of a ball without the bites, the parts of its disc that sticks cut off. A stick of several strands cuts
// off only what its strands do.
template <class Visit>
class BittenBall {
 public:
  BittenBall(const StickView &view, uint32_t ball, Visit visit) : view_(view), ball_(ball), visit_(visit) {}

  void operator()() {
    const Span<const StickBite> bites = view_.bites_of(ball_);
    for (const StickBite &bite : bites) {
      const Stick &stick = view_.sticks[bite.stick];
      const StrandList list = stick.strand_list();
      for (uint32_t k = 0; k < list.count; ++k) {
        if (!list.strand[k].dashed) add(stick, bite, list.strand[k]);
      }
    }
    if (junctions_ > 0) {
      add_silhouette(first_angle_ + 2 * pi, first_start_, true);
      return;
    }
    const ProjectedEllipse circle = silhouette();
    const double left[2] = {circle.centre[0] - circle.major[0], circle.centre[1]};
    visit_(ProjectedArc{circle, -pi, pi, {left[0], left[1]}, {left[0], left[1]}, no_id}, true, true);
  }

 private:
  ProjectedEllipse silhouette() const {
    const PlacedBall &ball = view_.balls[ball_];
    return {{ball.centre.x, ball.centre.y}, {ball.r, 0.0}, {0.0, ball.r}};
  }

  // A point at which the edge of a strand, or the junction circle of its stick, leaves the disc.
  struct Crossing {
    double angle;
    double at[2];
    bool on_junction;
  };
  Crossing crossing_of(const StickBite &bite, const StrandEdge &edge, double left, bool is_end) const {
    const PlacedBall &ball = view_.balls[ball_];
    const Stick &stick = view_.sticks[bite.stick];
    if (is_end) return {0.0, {edge.at[0], edge.at[1]}, true};
    const double across = left * stick.radius, along = std::sqrt((ball.r - across) * (ball.r + across));
    return {bite.middle - arc_tangent(across, along),
            {ball.centre.x - along * stick.e[0] - across * stick.e[1],
             ball.centre.y - along * stick.e[1] + across * stick.e[0]},
            false};
  }

  void add(const Stick &stick, const StickBite &bite, const Strand &strand) {
    const SinCos at_bite = sin_cos(bite.from);
    const double most = at_bite.cosine;
    const double left = strand.left, right = strand.right;
    if (left <= -most || right >= most) return;
    const ProjectedEllipse circle = stick.circle_at(stick.last);
    const bool whole[2] = {left >= most, right <= -most};
    const StrandEdge from = edge_of(circle, bite, at_bite, left, whole[0], false);
    const StrandEdge to = edge_of(circle, bite, at_bite, right, whole[1], true);
    Crossing out = crossing_of(bite, from, left, whole[0]);
    if (out.on_junction) out.angle = bite.middle - bite.half;
    if (junctions_++ == 0) {
      first_angle_ = out.angle;
      first_start_[0] = out.at[0];
      first_start_[1] = out.at[1];
    } else {
      add_silhouette(out.angle, out.at, false);
    }
    bool first = junctions_ == 1;
    if (!out.on_junction) {
      visit_(line_between(out.at, from.at, ball_), first, false);
      first = false;
    }
    visit_(strand_end(circle, from, to, ball_), first, false);
    Crossing in = crossing_of(bite, to, right, whole[1]);
    if (in.on_junction) in.angle = bite.middle + bite.half;
    if (!in.on_junction) visit_(line_between(to.at, in.at, ball_), false, false);
    angle_ = in.angle;
    start_[0] = in.at[0];
    start_[1] = in.at[1];
  }

  static StrandEdge edge_of(const ProjectedEllipse &circle, const StickBite &bite, const SinCos &at, double left,
                            bool is_end, bool other) {
    if (!is_end) return strand_edge(circle, left);
    StrandEdge edge{other ? pi - bite.from : bite.from, {}};
    for (int k = 0; k < 2; ++k) {
      const double middle = circle.centre[k] + at.sine * circle.minor[k];
      const double across = at.cosine * circle.major[k];
      edge.at[k] = other ? middle - across : middle + across;
    }
    return edge;
  }

  // Goes on along the silhouette to an angle at which the next strand begins.
  void add_silhouette(double angle, const double at[2], bool last) {
    ProjectedArc arc{silhouette(), angle_, angle, {start_[0], start_[1]}, {at[0], at[1]}, no_id};
    if (arc.to < arc.from) arc.to = arc.from;
    if (arc.to > 2 * pi) {
      arc.from -= 2 * pi;
      arc.to -= 2 * pi;
    }
    visit_(arc, false, last);
  }

  const StickView &view_;
  uint32_t ball_;
  Visit visit_;
  uint32_t junctions_ = 0;
  double first_angle_ = 0.0, first_start_[2] = {};
  double angle_ = 0.0, start_[2] = {};  // the point from which the silhouette goes on
};

// Calls visit(arc, first_of_loop, last_of_loop) for the loops of a path: one loop for a ball, one for each strand or
// dash. other_ball of an arc: of a junction or the end of a part the ball that the path belongs to, of a silhouette
// none.
template <class Visit>
void visit_outline(const StickView &view, uint32_t path, Visit visit) {
  const StickPath &record = view.paths[path];
  if (record.stick == no_id) {
    BittenBall<Visit>(view, record.ball, visit)();
    return;
  }
  const Stick &stick = view.sticks[record.stick];
  const double end = stick.end_of(record.part);
  const auto visit_strand = [&](const ProjectedEllipse &low, const ProjectedEllipse &high, double left, double right) {
    const StrandEdge low_left = strand_edge(low, 1.0), low_right = strand_edge(low, -1.0);
    const StrandEdge high_left = strand_edge(high, left), high_right = strand_edge(high, right);
    visit(line_between(low_right.at, high_right.at, record.ball), true, false);
    visit(strand_end(high, high_right, high_left, record.ball), false, false);
    visit(line_between(high_left.at, low_left.at, record.ball), false, false);
    visit(strand_end(low, low_left, low_right, record.ball), false, true);
  };
  const StrandList list = stick.strand_list();
  for (uint32_t k = 0; k < list.count; ++k) {
    const Strand &strand = list.strand[k];
    double begin = stick.begin_of(record.part);
    if (strand.dashed) {
      const uint32_t count = dashes / stick.parts;
      const double step = (end - begin) / count;
      for (uint32_t dash = 0; dash < count; ++dash) {
        const double from = begin + (dash + 0.25) * step;
        visit_strand(stick.circle_of(strand, from), stick.circle_of(strand, from + 0.5 * step), 1.0, -1.0);
      }
      continue;
    }
    if (record.part == 0 && list.count > 1) begin = stick.begin_of(strand, view.balls[stick.ball[0]].r);
    if (begin >= end) continue;
    const ProjectedEllipse low = stick.circle_of(strand, begin);
    const double overlap = overlap_of(view, stick, record.part);
    if (overlap > 0.0) {
      visit_strand(low, stick.circle_of(strand, end + overlap), 1.0, -1.0);
    } else if ((end - begin) * stick.seen > stick.radius * stick.axis.z || list.count == 1) {
      // No farther than the junction circle of the whole stick.
      visit_strand(low, stick.circle_at(end), strand.left, strand.right);
    }
  }
}

// The paths of a view, for pictures. A half of a stick has one colour. The view has to outlive the paths.
PaintedPaths paths_of(const StickView &view);

}  // namespace hsp
