// Derivatives of the smooth surface's area A and volume V by centres c, radii R (probe included) and the offset t: the
// probe's radius p, varied while the radii R stay. Gathered ball by ball.
//
// Let y be the nearest point of the boundary to a point of the surface, m the contacts of y, and n_m the normals of
// their spheres at y. The surface's normal n at the point is a sum of alpha_m n_m, and its normal speed is the sum of
// alpha_m (n_m.c_m' + R_m') - t': the derivatives of circles and vertices do not enter. With H the mean curvature,
//   V' = integral of the normal speed, so dV/dt = -A;   A' = integral of 2H times it + crease terms
// where 2H is 2/r on convex patches, -1/p + cos a/(rho - p cos a) on saddles and -2/p on concave ones. Per feature:
//   face     with N and A of the shrunk face:  dV/dc = N, dV/dR = A;  dA/dc = 2 N/r, dA/dR = 2 A/r, dA/dt = -2 A/r
//   arc      saddle_kernel.hpp
//   vertex   with N the vector area of the patch, seen from the vertex, and a crease's angle gamma = half of that by
//            which its two normals differ, tan gamma = c / sqrt(1 - c^2) for a cap at height c:
//              q_V = -N,   q_A = 2 N/p - p * sum over creases of c * (integral of the direction over the angle)
//              contact k:  z = q.(n_l x n_m) / det(n_k, n_l, n_m);   d/dc_k = z n_k, d/dR_k = z
//              dA/dt = 2 A/p - p * sum over creases of c phi
// Cusps add nothing. On a crease each of the two patches adds its own half. If areas have unequal weights, further
// terms are added (weighted_joints.hpp).
//
// V and A are differentiable if no vertex is degenerate. A vertex is degenerate if more than three spheres pass through
// it, or if the centres of its balls are in one plane with it (D = 0): arcs and vertices come and go there with an
// angle. At a degenerate vertex the derivatives are those of the patches that the symbolic perturbation makes; a vertex
// with D = 0 adds nothing. degenerate_balls.hpp finds degenerate balls that their own vertices do not show.
#pragma once

#include "core/summation.hpp"
#include "measure/energy.hpp"
#include "surface/surface_areas.hpp"
#include "surface/weighted_joints.hpp"

namespace hsp {

// Ball i's part, in lattice steps. The areas that are differentiated are weighted, those of `measure` are not.
struct SurfaceGradient {
  SurfaceMeasure measure;
  Vec3 area_centre{0.0, 0.0, 0.0}, volume_centre{0.0, 0.0, 0.0};
  double area_radius = 0.0, volume_radius = 0.0;
  double area_offset = 0.0;  // this ball's share of dA/dt; that of dV/dt is -measure.area()
  bool degenerate = false;   // one of its vertices is, or a joint between weights (weighted_joints.hpp)

  void weigh(double weight, const AreaDerivatives &joints) {
    area_centre = combine(weight, area_centre, 1.0, joints.centre);
    area_radius = weight * area_radius + joints.radius;
    area_offset = weight * area_offset + joints.offset;
    degenerate = degenerate || joints.one_sided;
  }
  void operator+=(const SurfaceGradient &other) {
    measure += other.measure;
    area_centre = area_centre + other.area_centre;
    volume_centre = volume_centre + other.volume_centre;
    area_radius += other.area_radius;
    volume_radius += other.volume_radius;
    area_offset += other.area_offset;
    degenerate = degenerate || other.degenerate;
  }
};
SurfaceGradient surface_gradient_of_ball(const BallSet &balls, const Boundary &boundary, const Surface &surface,
                                         const AreaWeights &weights, uint32_t i);

// Calls sink(i, gradient) for every ball i of the input, from the tasks of the executor: an EnergyGradient of tension *
// S + pressure * V, S the weighted area, which is one_sided if the ball is degenerate, and whose area is that of the
// surface's parts on the ball. Sums run over the balls in the caller's order; Energy::by_probe is the derivative by the
// probe at constant radii without the probe. False if the executor fails.
template <class Sink>
bool differentiate_surface(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                           const Surface &surface, const EnergyTerms &terms, Energy &energy, Sink sink) {
  const BallSet &balls = grid.balls();
  const exact::Lattice &lattice = balls.lattice;
  // A step of the lattice may be any power of ten, so each term is converted on its own.
  const auto combined = [&](double of_area, double of_volume) {
    return terms.tension * lattice.length(of_area) + terms.pressure * lattice.area(of_volume);
  };
  const auto visit = [&](IdRange range, EnergySum &sum) {
    visit_in_input_order(grid, boundary, range, [&](uint32_t i, uint32_t ball) {
      const SurfaceGradient own = surface_gradient_of_ball(balls, boundary, surface, terms.weights, ball);
      const EnergyGradient gradient{
          {combined(own.area_centre.x, own.volume_centre.x), combined(own.area_centre.y, own.volume_centre.y),
           combined(own.area_centre.z, own.volume_centre.z)},
          combined(own.area_radius, own.volume_radius),
          own.degenerate,
          own.measure.area()};
      sum.add({terms.weights.of(balls, ball) * own.measure.area(), own.measure.volume,
               gradient.radius + combined(own.area_offset, -own.measure.area())});
      sink(i, gradient);
    });
  };
  return sum_energy(executor, balls.n, lattice, terms, visit, energy);
}

}  // namespace hsp
