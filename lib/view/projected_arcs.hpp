// Circles of spheres as ellipses in the view plane. Source of the basis: on the circle of ball j with a ball in the
// unit direction n (view coordinates), b = (-n_y, n_x, 0)/s with s = sqrt(n_x^2 + n_y^2) is horizontal and is seen in
// its full length, the direction across b is seen shortened by |n_z|.
#pragma once

#include "view/view.hpp"

namespace hsp {

// The points centre + cos t major + sin t minor; minor points a quarter turn counter-clockwise from major.
struct ProjectedEllipse {
  double centre[2];
  double major[2];
  double minor[2];
};

// The silhouette of a ball (other = no_id), or its circle with another ball.
ProjectedEllipse ellipse_of(const BallSet &balls, const ViewFrame &frame, uint32_t ball, uint32_t other);

// What the silhouettes of all pieces take of the view plane, and the depths of their centres; zeros without pieces.
struct ViewBox {
  double low[2];
  double high[2];
  double depth_low, depth_high;
};
ViewBox box_of(const BallSet &balls, const View &view);

struct ProjectedArc {
  ProjectedEllipse ellipse;
  double from, to;  // to > from: counter-clockwise
  double start[2], end[2];
  uint32_t across;  // grid order, no_id on the silhouette
};

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
      visit(ProjectedArc{ellipse_of(balls, view.frame, record.ball, arc.across),
                         arc.from,
                         arc.to,
                         {arc.start[0], arc.start[1]},
                         {next.start[0], next.start[1]},
                         arc.across},
            a == first, a + 1 == last);
    }
  }
}

}  // namespace hsp
