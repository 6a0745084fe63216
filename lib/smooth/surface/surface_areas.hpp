// Areas and volume of the solvent-excluded surface, ball by ball.
//
// A ball's share of the surface is its convex patches; of every saddle patch the part on its side of its
// waist, where the probe's profile turns (saddle.hpp); and a third of every concave patch at one of its vertices.
#pragma once

#include "core/executor.hpp"
#include "core/summation.hpp"
#include "measure/input_order.hpp"
#include "surface/surface.hpp"

namespace hsp {

struct SurfaceMeasure {
  double convex = 0.0, saddle = 0.0, concave = 0.0;  // areas
  double volume = 0.0;                               // term of the divergence theorem

  double area() const { return convex + saddle + concave; }
  void operator+=(const SurfaceMeasure &other) {
    convex += other.convex;
    saddle += other.saddle;
    concave += other.concave;
    volume += other.volume;
  }
};

// With R the radius with probe and r without, the convex patches are the faces, shrunk by r / R; areas and vector areas
// by its square.
inline double shrinkage_of_faces(const BallSet &balls, uint32_t i) {
  const double R = balls.r[i];
  return R > 0.0 ? (R - static_cast<double>(balls.probe_steps)) / R : 0.0;
}

// Calls visit(face) for the chosen faces of a ball, or visit(no_id) once if all its faces are chosen.
template <class Visit>
void for_each_chosen_part(const Boundary &boundary, const ChosenFaces &chosen, uint32_t ball, Visit visit) {
  bool all = true;
  for (const uint32_t face : boundary.faces(ball)) all = all && chosen.has(face);
  if (all) return visit(no_id);
  for (const uint32_t face : boundary.faces(ball)) {
    if (chosen.has(face)) visit(face);
  }
}

// Ball i of the grid's order, in lattice steps. Sums run in the order of its half-edges and circles.
SurfaceMeasure measure_surface_of_ball(const BallSet &balls, const Boundary &boundary, const Surface &surface,
                                       uint32_t i);

// Calls sink(i, measure) for every ball i of the input, in the caller's unit, and returns the sums over the balls in
// the caller's order. If the executor stops it, some balls are left out.
template <class Sink>
SurfaceMeasure measure_surface(const CubeGrid &grid, const Boundary &boundary, const Surface &surface, Sink sink,
                               const Executor &executor = Executor()) {
  const BallSet &balls = grid.balls();
  const auto in_caller_units = [&balls](const SurfaceMeasure &m) {
    return SurfaceMeasure{balls.lattice.area(m.convex), balls.lattice.area(m.saddle), balls.lattice.area(m.concave),
                          balls.lattice.volume(m.volume)};
  };
  TreeSum convex;
  TreeSum saddle;
  TreeSum concave;
  TreeSum volume;
  const uint32_t at_once = executor.may_stop() ? 32 : balls.n;
  for (IdRange part{0, 0}; part.last < balls.n && executor.goes_on();) {
    part = {part.last, balls.n - part.last < at_once ? balls.n : part.last + at_once};
    visit_in_input_order(grid, boundary, part, [&](uint32_t i, uint32_t ball) {
      const SurfaceMeasure measure = measure_surface_of_ball(balls, boundary, surface, ball);
      convex.add(measure.convex);
      saddle.add(measure.saddle);
      concave.add(measure.concave);
      volume.add(measure.volume);
      sink(i, in_caller_units(measure));
    });
  }
  return in_caller_units({convex.total(), saddle.total(), concave.total(), volume.total()});
}

}  // namespace hsp
