// Circles of spheres as ellipses in the view plane.
#pragma once

#include "view/view.hpp"

namespace hsp {

// The basis of a circle of a sphere in a view: `along` is horizontal, and the major axis of the ellipse; `across` lies
// in the circle's plane, a quarter turn counter-clockwise from `along`, and appears shortened. For the circle of a ball
// with another one in the unit direction n, along = (-n_y, n_x, 0)/s with s = sqrt(n_x^2 + n_y^2), and across appears
// shortened by |n_z|. In three dimensions nothing is ill-conditioned when the circle is seen edge on.
struct CircleFrame {
  // Unit vectors in view coordinates.
  Vec3 axis, along, across;
  // A half-edge runs clockwise about the axis, with the outside of the half-space on its left. In the view plane it
  // appears counter-clockwise (+1) or clockwise (-1).
  double turn;

  // A silhouette: the axis points away from the viewer.
  CircleFrame() : axis{0.0, 0.0, -1.0}, along{1.0, 0.0, 0.0}, across{0.0, 1.0, 0.0}, turn(1.0) {}
  // v: the normal of the circle's plane, of any length.
  CircleFrame(const ViewFrame &frame, const exact::Vector &v) {
    const Vec3 n = frame.to_view(exact::to_double(v));
    const double length = std::sqrt(dot(n, n));
    axis = {n.x / length, n.y / length, n.z / length};
    const double s = std::sqrt(axis.x * axis.x + axis.y * axis.y);
    turn = axis.z < 0.0 ? 1.0 : -1.0;
    if (s == 0.0) {
      along = {1.0, 0.0, 0.0};
      across = {0.0, 1.0, 0.0};
      return;
    }
    along = {-axis.y / s, axis.x / s, 0.0};
    const double steep = axis.z / s;
    across = {turn * steep * axis.x, turn * steep * axis.y, -turn * s};
  }
};

// The points centre + cos t major + sin t minor; minor points a quarter turn counter-clockwise from major.
struct ProjectedEllipse {
  double centre[2];
  double major[2];
  double minor[2];
};

// The silhouette of a ball (other = no_id), or its circle with another ball.
ProjectedEllipse ellipse_of(const BallSet &balls, const ViewFrame &frame, uint32_t ball, uint32_t other);

struct ProjectedArc {
  ProjectedEllipse ellipse;
  double from, to;  // parameters; counter-clockwise if to > from
  double start[2], end[2];
  uint32_t other_ball;  // in grid order; no_id on a silhouette
};

// A line as a flat ellipse, walked from one end of its major axis to the other.
inline ProjectedArc line_between(const double from[2], const double to[2], uint32_t other_ball) {
  ProjectedArc arc{};
  for (int k = 0; k < 2; ++k) {
    arc.ellipse.centre[k] = 0.5 * (from[k] + to[k]);
    arc.ellipse.major[k] = 0.5 * (to[k] - from[k]);
    arc.start[k] = from[k];
    arc.end[k] = to[k];
  }
  arc.from = -pi;
  arc.to = 0.0;
  arc.other_ball = other_ball;
  return arc;
}

// Calls visit(arc, first_of_loop, last_of_loop) for the arcs of a piece, loop after loop.
template <class Visit>
void visit_arcs(const BallSet &balls, const View &view, uint32_t piece, Visit visit) {
  const PieceRecord &record = view.pieces[piece];
  for (uint32_t loop = record.first_loop; loop < view.end_of_loops(piece); ++loop) {
    const uint32_t first = view.loops[loop];
    const uint32_t last = view.end_of_arcs(loop);
    for (uint32_t a = first; a < last; ++a) {
      const ArcRecord &arc = view.arcs[a];
      const ArcRecord &next = view.arcs[a + 1 < last ? a + 1 : first];
      visit(ProjectedArc{ellipse_of(balls, view.frame, record.ball, arc.other_ball),
                         arc.from,
                         arc.to,
                         {arc.start[0], arc.start[1]},
                         {next.start[0], next.start[1]},
                         arc.other_ball},
            a == first, a + 1 == last);
    }
  }
}

}  // namespace hsp
