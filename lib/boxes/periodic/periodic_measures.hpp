// Measures of a union in a periodic box: areas, volume, the free volume of the box, and derivatives by the balls and by
// the box. Lengths are in steps unless said.
//
// Under a strain x -> x + eps x of box and centres, but not of radii,
//   dV/d eps = sum over contacts of C d u (x) u,  C the area, d the distance of the centres, u the unit vector
//   dS/d eps = sum over balls i and free arcs of (w_i dA_i/dc_j) (x) (c_j - c_i)
// (the divergence theorem in each ball's share; only relative positions count). Let the vectors of the box be the
// columns of h, and hold positions fixed as multiples of these. Then the derivative by h is X h^-T, with X the one by
// the strain.
#pragma once

#include "curvature/strain.hpp"
#include "measure/energy.hpp"
#include "measure/tangency.hpp"
#include "measure/totals.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

struct PeriodicTotals {
  double area = 0.0;
  double volume = 0.0;
  double box_volume = 0.0;
  double free_volume = 0.0;  // 0 exactly if nothing is left free
  double contact_area = 0.0;
};

// The area of ball i of the input, and the volume of its share.
BallMeasure measure_in_box(const PeriodicUnion &periodic, uint32_t i);

// Sums, in the caller's unit. Calls sink(i, measure) for every ball of the input with its area and the volume of its
// share. Without contacts all volumes are 0, except that of the box.
template <class Sink>
PeriodicTotals measure_periodic(const PeriodicUnion &periodic, Sink sink) {
  const exact::Lattice &lattice = periodic.images().lattice();
  MeasureSum sum;
  TreeSum contact_area;
  for (uint32_t i = 0; i < periodic.images().balls(); ++i) {
    const BallMeasure own = measure_in_box(periodic, i);
    sum.add(own);
    sink(i, in_caller_units(lattice, own));
    if (periodic.has_areas_alone()) continue;
    periodic.visit_contacts_of(i, [&](const PeriodicContact &contact) {
      if (periodic.is_listed(contact)) contact_area.add(contact.record->area);
    });
  }
  const BallMeasure total = in_caller_units(lattice, sum.total());
  PeriodicTotals totals;
  totals.area = total.area;
  totals.box_volume = lattice.volume(periodic.images().box().volume());
  if (periodic.has_areas_alone()) return totals;
  // A union without faces is the whole box, or empty.
  const bool is_filled = periodic.images().balls() > 0 && periodic.counts().faces == 0;
  totals.volume = is_filled ? totals.box_volume : total.volume;
  totals.free_volume = totals.box_volume > totals.volume ? totals.box_volume - totals.volume : 0.0;
  totals.contact_area = lattice.area(contact_area.total());
  return totals;
}

// The derivative of the volume by the strain, in cubic steps.
Strain volume_by_strain(const PeriodicUnion &periodic);

// The derivative of the weighted area by the strain, in square steps. weights: weights_in_box().
Strain area_by_strain(const PeriodicUnion &periodic, const AreaWeights &weights);

// Converts derivatives by the strain to derivatives by the vectors of the box: [3 k + p] is by component p of vector k.
// The vectors are the given ones, turned and on the lattice; the result is per step. Both are in the frame of the box.
Strain by_box(const PeriodicBox &box, const Strain &strain);

// Weights for gradient_of_ball(): an image has the weight of its ball.
inline AreaWeights weights_in_box(const PeriodicUnion &periodic, const double *weight, TouchingBalls touching) {
  return {weight, touching, periodic.images().balls_of_all()};
}

// The derivatives by ball i of the input, in steps: by its centre, with which all its images move, and by its radius.
inline BallGradient gradient_in_box(const PeriodicUnion &periodic, const AreaWeights &weights, uint32_t i) {
  return gradient_of_ball(periodic.balls(), periodic.boundary(), weights, periodic.grid().grid_index(i));
}

// Calls sink(i, gradient) for every ball i of the input, from the tasks of the executor, all in the caller's unit and
// frame. The volume is the sum of the shares. terms: with weights_in_box(). False if the executor fails.
template <class Sink>
bool differentiate_in_box(const Executor &executor, const PeriodicUnion &periodic, const EnergyTerms &terms,
                          Energy &energy, Sink sink) {
  const exact::Lattice &lattice = periodic.images().lattice();
  const auto visit = [&](IdRange range, EnergySum &sum) {
    for (uint32_t i = range.first; i < range.last; ++i) {
      const uint32_t ball = periodic.grid().grid_index(i);
      const BallGradient own = gradient_in_box(periodic, terms.weights, i);
      EnergyGradient gradient = gradient_of_energy(lattice, terms, own);
      periodic.images().box().frame().turn_back(gradient.centre);
      sum.add(
          {terms.weights.of(periodic.balls(), ball) * own.measure.area, periodic.share_volume(ball), gradient.radius});
      sink(i, gradient);
    }
  };
  return sum_energy(executor, periodic.images().balls(), lattice, terms, visit, energy);
}

// The derivatives of an energy by the strain and by the vectors of the box, in the caller's unit and frame.
struct BoxGradient {
  Strain strain;
  Strain vectors;  // as of by_box()
};
BoxGradient differentiate_by_box(const PeriodicUnion &periodic, const EnergyTerms &terms);

// Balls that touch others from inside. They are not in the boundary, but derivatives are one-sided there.
//
// Calls visit(i, j) for every ball i of the input that is inside others and every ball j that it, or an image of it,
// touches from inside at a free point, if moving one of them would uncover a part of ball i.
template <class Visit>
void for_each_inner_tangency_in_box(const PeriodicUnion &periodic, Visit visit) {
  const BallSet &balls = periodic.balls();
  const PeriodicImages &images = periodic.images();
  for (uint32_t inner = 0; inner < images.balls(); ++inner) {
    if (!periodic.boundary().is_contained(inner)) continue;
    visit_balls_touched_from_inside(periodic.grid(), inner, [&](uint32_t outer) {
      if (balls.r[inner] == balls.r[outer] && !periodic.is_exposed(outer)) return;
      visit(images.ball_of(balls.caller[inner]), images.ball_of(balls.caller[outer]));
    });
  }
}

// Sets a flag of both balls of each such pair. flags [n].
inline void flag_free_inner_contacts_in_box(const PeriodicUnion &periodic, uint32_t flag, uint32_t *flags) {
  for_each_inner_tangency_in_box(periodic, [&](uint32_t inner, uint32_t outer) {
    flags[inner] |= flag;
    flags[outer] |= flag;
  });
}

}  // namespace hsp
