// Areas and volume of the solvent-excluded surface, ball by ball.
//
// A ball's share of the surface is its convex patches; of every saddle patch the part on its side of its
// waist, where the probe's profile turns (saddle.hpp); and a third of every concave patch at one of its vertices.
#pragma once

#include "core/summation.hpp"
#include "measure/areas.hpp"
#include "measure/input_order.hpp"
#include "measure/sums_in_parts.hpp"
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

// The convex patches on one of a ball's faces, or on all if `face` is no_id.
struct ConvexPatches {
  double steradians, area;
  double triple_volume;  // three times their term of the volume
  Vec3 vector_area;      // of the faces

  // sums: of the arcs of these faces.
  ConvexPatches(const BallSet &balls, const Boundary &boundary, uint32_t i, uint32_t face, const FreeSurface &sums)
      : vector_area(sums.vector_area()) {
    const IdRange loops = face == no_id ? boundary.loops(i) : boundary.loops_of_face(face);
    steradians = sums.steradians(face == no_id ? boundary.faces(i).size() : 1, loops.size());
    const double r = balls.r[i] - static_cast<double>(balls.probe_steps), shrinkage = shrinkage_of_faces(balls, i);
    area = r * r * steradians;
    triple_volume = r * area + shrinkage * shrinkage * dot(offset_from_origin(balls, boundary, i), vector_area);
  }
};

// Calls visit(face) for the chosen faces of a ball, or visit(no_id) once if all its faces are chosen and it has any.
template <class Visit>
void for_each_chosen_part(const Boundary &boundary, const ChosenFaces &chosen, uint32_t ball, Visit visit) {
  if (!boundary.is_exposed(ball)) return;
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
  visit_patiently(executor, IdRange{0, balls.n}, [&](IdRange part) {
    visit_in_input_order(grid, boundary, part, [&](uint32_t i, uint32_t ball) {
      const SurfaceMeasure measure = measure_surface_of_ball(balls, boundary, surface, ball);
      convex.add(measure.convex);
      saddle.add(measure.saddle);
      concave.add(measure.concave);
      volume.add(measure.volume);
      sink(i, in_caller_units(measure));
    });
  });
  return in_caller_units({convex.total(), saddle.total(), concave.total(), volume.total()});
}

}  // namespace hsp
