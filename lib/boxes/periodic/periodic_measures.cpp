#include "periodic/periodic_measures.hpp"

namespace hsp {

BallMeasure measure_in_box(const PeriodicUnion &periodic, uint32_t i) {
  const uint32_t ball = periodic.grid().grid_index(i);
  return {measure_ball(periodic.balls(), periodic.boundary(), ball).area, periodic.share_volume(ball)};
}

Strain volume_by_strain(const PeriodicUnion &periodic) {
  const BallSet &balls = periodic.balls();
  StrainSum sum;
  for (uint32_t i = 0; i < periodic.images().balls(); ++i) {
    const uint32_t own = periodic.grid().grid_index(i);
    periodic.visit_contacts_of(i, [&](const PeriodicContact &contact) {
      if (!periodic.is_listed(contact) || contact.record->area == 0.0) return;
      const Vec3 v = balls.difference(own, periodic.grid().grid_index(contact.other));
      sum.add(contact.record->area / std::sqrt(dot(v, v)), v, v);
    });
  }
  return sum.total();
}

Strain area_by_strain(const PeriodicUnion &periodic, const AreaWeights &weights) {
  const BallSet &balls = periodic.balls();
  StrainSum sum;
  for (uint32_t i = 0; i < periodic.images().balls(); ++i) {
    const uint32_t own = periodic.grid().grid_index(i);
    if (!periodic.boundary().is_exposed(own)) continue;
    const double weight = weights.of(balls, own);
    static_cast<void>(visit_area_row(balls, periodic.boundary(), own, weights.touching_balls,
                                     [&](uint32_t other, const AreaDerivative &part) {
                                       sum.add(weight, part.centre, balls.difference(own, other));
                                     }));
  }
  return sum.total();
}

// With the vectors as columns h is upper triangular; row p of the result is the y with h y = row p of the strain's.
Strain by_box(const PeriodicBox &box, const Strain &strain) {
  const Vec3 a = to_double(box.given(0));
  const Vec3 b = to_double(box.given(1));
  const Vec3 c = to_double(box.given(2));
  Strain result;
  for (int p = 0; p < 3; ++p) {
    const double *const x = strain.by + 3 * p;
    const double by_c = x[2] / c.z;
    const double by_b = (x[1] - c.y * by_c) / b.y;
    const double by_a = (x[0] - b.x * by_b - c.x * by_c) / a.x;
    result.by[p] = by_a;
    result.by[3 + p] = by_b;
    result.by[6 + p] = by_c;
  }
  return result;
}

BoxGradient differentiate_by_box(const PeriodicUnion &periodic, const EnergyTerms &terms) {
  const exact::Lattice &lattice = periodic.images().lattice();
  const PeriodicBox &box = periodic.images().box();
  const Strain area = area_by_strain(periodic, terms.weights);
  const Strain volume = periodic.has_areas_alone() ? Strain{} : volume_by_strain(periodic);
  const Strain area_by_box = by_box(box, area);
  const Strain volume_by_box = by_box(box, volume);
  Strain strain, vectors;
  for (int k = 0; k < 9; ++k) {
    strain.by[k] = terms.tension * lattice.area(area.by[k]) + terms.pressure * lattice.volume(volume.by[k]);
    vectors.by[k] =
        terms.tension * lattice.length(area_by_box.by[k]) + terms.pressure * lattice.area(volume_by_box.by[k]);
  }
  return {box.frame().strain_turned_back(strain), box.frame().rows_turned_back(vectors)};
}

}  // namespace hsp
