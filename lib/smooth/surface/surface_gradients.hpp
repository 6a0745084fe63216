// Derivatives of the smooth surface's area A and volume V by centres c, radii R (probe included) and the offset t,
// which is the probe's radius p where it is not part of a radius. Gathered ball by ball.
//
// Where a point of the surface has y as its nearest point of the boundary, with contacts m there and n_m the normals of
// their spheres, its normal n is a sum of alpha_m n_m, and its normal speed is the sum of alpha_m (n_m.c_m' + R_m') -
// t': the derivatives of circles and vertices do not enter. With H the mean curvature,
//   V' = integral of the normal speed, so dV/dt = -A;   A' = integral of 2H times it + crease terms
// where 2H is 2/r on convex patches, -1/p + cos a/(rho - p cos a) on saddles and -2/p on concave ones. Per feature:
//   face     with N and A of the shrunk face:  dV/dc = N, dV/dR = A;  dA/dc = 2 N/r, dA/dR = 2 A/r, dA/dt = -2 A/r
//   arc      saddle_kernel.hpp
//   vertex   with N the vector area of the patch, seen from the vertex, and a crease's angle gamma = half of that by
//            which its two normals differ, tan gamma = c / sqrt(1 - c^2) for a cap at height c:
//              q_V = -N,   q_A = 2 N/p - p * sum over creases of c * (integral of the direction over the angle)
//              contact k:  z = q.(n_l x n_m) / det(n_k, n_l, n_m);   d/dc_k = z n_k, d/dR_k = z
//              dA/dt = 2 A/p - p * sum over creases of c phi
// Cusps add nothing. On a crease each of the two patches adds its own half. Where areas have weights that are not equal
// weighted_joints.hpp has what comes to that.
//
// V and A are differentiable where no vertex is degenerate: of more than three spheres, or with centres in its plane
// (D = 0), so that arcs and vertices come and go there with an angle. There the derivatives are those of the patches
// that the symbolic perturbation makes, without those of vertices with D = 0. degenerate_balls.hpp has what is not seen
// of a ball's own vertices.
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

// Derivatives of tension * S + pressure * V, S the weighted area, by a ball's centre and radius, in the caller's unit.
struct SurfaceEnergyGradient {
  double centre[3];
  double radius;
  bool degenerate;
  double area;  // of the surface's parts on the ball, in lattice steps
};

// Calls sink(i, gradient) for every ball i of the input, from the tasks of the executor. Sums run over the balls in the
// caller's order; Energy::by_probe is with radii that do not contain the probe. False if the executor fails.
template <class Sink>
bool differentiate_surface(const Executor &executor, const CubeGrid &grid, const Boundary &boundary,
                           const Surface &surface, const EnergyTerms &terms, Energy &energy, Sink sink) {
  const BallSet &balls = grid.balls();
  const exact::Lattice &lattice = balls.lattice;
  // A step of the lattice may be any power of ten: each is converted on its own.
  const auto combined = [&](double of_area, double of_volume) {
    return terms.tension * lattice.length(of_area) + terms.pressure * lattice.area(of_volume);
  };
  const auto visit = [&](IdRange range, EnergySum &sum) {
    visit_in_input_order(grid, boundary, range, [&](uint32_t i, uint32_t ball) {
      const SurfaceGradient own = surface_gradient_of_ball(balls, boundary, surface, terms.weights, ball);
      const SurfaceEnergyGradient gradient{
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
