#include "slice_quadrature.hpp"

#include <cmath>

namespace oracle {

SliceMeasures measure_by_slices(const std::vector<RealBall> &balls, long double step) {
  SliceMeasures measures;
  measures.ball_area.assign(balls.size(), 0);
  measures.ball_vector_area.assign(balls.size(), {0, 0, 0});
  const std::vector<RealBall> moved = around_their_middle(balls);
  for (const Slab &slab : slabs_of(moved))
    visit_tanh_sinh_nodes(slab.low, slab.high, step, [&](long double z, long double weight) {
      for (const SliceCircle &circle : circles_of_slice(moved, slab.active, z)) {
        const RealBall &ball = moved[circle.ball];
        long double angle = 0;
        long double cosine = 0;  // integrals over the free angles
        long double sine = 0;
        for (const FreeSliceArc &arc : circle.arcs) {
          angle += arc.to - arc.from;
          cosine += std::sin(arc.to) - std::sin(arc.from);
          sine += std::cos(arc.from) - std::cos(arc.to);
        }
        std::array<long double, 3> &vector_area = measures.ball_vector_area[circle.ball];
        measures.ball_area[circle.ball] += weight * ball.radius * angle;
        vector_area[0] += weight * circle.radius * cosine;
        vector_area[1] += weight * circle.radius * sine;
        vector_area[2] += weight * (z - ball.z) * angle;
        // Green's formula for the area of the union of the discs.
        measures.volume += weight * circle.radius * (circle.radius * angle + ball.x * cosine + ball.y * sine) / 2;
      }
    });
  for (const long double area : measures.ball_area) measures.area += area;
  return measures;
}

}  // namespace oracle
