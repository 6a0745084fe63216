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

}  // namespace hsp
