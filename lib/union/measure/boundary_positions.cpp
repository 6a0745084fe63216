#include "measure/boundary_positions.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {

void to_coordinates(const BallSet &balls, const Position &position, double xyz[3]) {
  xyz[0] = balls.lattice.length(balls.x[position.ball] + position.offset.x);
  xyz[1] = balls.lattice.length(balls.y[position.ball] + position.offset.y);
  xyz[2] = balls.lattice.length(balls.z[position.ball] + position.offset.z);
}

Position position_of_vertex(const BallSet &balls, const Boundary &boundary, uint32_t vertex) {
  const OrderedVertex ordered =
      in_order(boundary.vertex(vertex), [&balls](uint32_t a, uint32_t b) { return balls.ranks_before(a, b); });
  const exact::LatticeBall own = balls.ball(ordered.ball[0]);
  return {ordered.ball[0], crossing_point(exact::plane_of(own, balls.ball(ordered.ball[1])),
                                          exact::plane_of(own, balls.ball(ordered.ball[2])), ordered.sign,
                                          boundary.root_discriminant(vertex))};
}

Vec3 start_of(const BallSet &balls, const Boundary &boundary, uint32_t ball, const HalfEdge &half_edge) {
  const exact::LatticeBall own = balls.ball(ball);
  return crossing_point(exact::plane_of(own, balls.ball(half_edge.circle)),
                        exact::plane_of(own, balls.ball(boundary.previous_circle(ball, half_edge))), -1,
                        boundary.root_discriminant(half_edge.vertex));
}

double angle_of_arc(const BallSet &balls, const Boundary &boundary, uint32_t half_edge) {
  const uint32_t own = boundary.ball_of(half_edge);
  const uint32_t other = boundary.half_edge(half_edge).circle;
  return balls.ranks_before(own, other) ? angle_of(balls, boundary, own, half_edge)
                                        : angle_of(balls, boundary, other, boundary.twin(half_edge));
}

CirclePosition position_of_circle(const BallSet &balls, uint32_t a, uint32_t b) {
  const bool a_first = balls.ranks_before(a, b);
  const uint32_t lower = a_first ? a : b;
  const CircleGeometry geometry(balls, lower, a_first ? b : a);
  return {{lower, geometry.centre}, a_first ? geometry.axis : -geometry.axis, geometry.radius};
}

}  // namespace hsp
