#include "view/projected_arcs.hpp"

#include "sphere/arc_geometry.hpp"

namespace hsp {

ProjectedEllipse ellipse_of(const BallSet &balls, const ViewFrame &frame, uint32_t ball, uint32_t other) {
  const Vec3 centre = frame.centre_of(balls, ball);
  const double r = balls.r[ball];
  if (other == no_id) return {{centre.x, centre.y}, {r, 0.0}, {0.0, r}};
  const exact::LatticeBall own = balls.ball(ball);
  const exact::Plane P = exact::plane_of(own, balls.ball(other));
  const CircleFrame circle(frame, P.v);
  const CircleGeometry geometry(exact::sphere_of(own), P);
  return {{centre.x + geometry.height * circle.axis.x, centre.y + geometry.height * circle.axis.y},
          {geometry.radius * circle.along.x, geometry.radius * circle.along.y},
          {geometry.radius * circle.across.x, geometry.radius * circle.across.y}};
}

ViewBox box_of(const BallSet &balls, const View &view) {
  ViewBox box{};
  for (uint32_t p = 0; p < view.pieces.size(); ++p) {
    const Vec3 centre = view.frame.centre_of(balls, view.pieces[p].ball);
    const double r = balls.r[view.pieces[p].ball];
    const auto widen = [p](double low_value, double high_value, double &low, double &high) {
      low = p == 0 || low_value < low ? low_value : low;
      high = p == 0 || high_value > high ? high_value : high;
    };
    widen(centre.x - r, centre.x + r, box.low[0], box.high[0]);
    widen(centre.y - r, centre.y + r, box.low[1], box.high[1]);
    widen(centre.z, centre.z, box.depth_low, box.depth_high);
  }
  return box;
}

}  // namespace hsp
