#include "periodic/periodic_morphometry.hpp"

namespace hsp {

Strain curvature_by_strain(const PeriodicUnion &periodic, const AreaWeights &weights) {
  StrainSum sum;
  for (uint32_t i = 0; i < periodic.images().balls(); ++i) {
    add_curvature_strain_of_ball(periodic.balls(), periodic.boundary(), weights, periodic.grid().grid_index(i), sum);
  }
  return sum.total();
}

BoxGradient box_gradient_of_morphometry(const PeriodicUnion &periodic, const AreaWeights &weights,
                                        const MorphometricFactors &factors) {
  const exact::Lattice &lattice = periodic.images().lattice();
  const PeriodicBox &box = periodic.images().box();
  BoxGradient result = differentiate_by_box(periodic, {weights, factors.tension, factors.pressure});
  const Strain own = curvature_by_strain(periodic, weights);
  const Strain strain = box.frame().strain_turned_back(own), vectors = box.frame().rows_turned_back(by_box(box, own));
  for (int k = 0; k < 9; ++k) {
    result.strain.by[k] += factors.bending * lattice.length(strain.by[k]);
    result.vectors.by[k] += factors.bending * vectors.by[k];
  }
  return result;
}

}  // namespace hsp
