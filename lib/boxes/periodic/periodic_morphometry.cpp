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
  BoxGradient result = differentiate_by_box(periodic, {weights, factors.tension, factors.pressure});
  const Strain curvature = curvature_by_strain(periodic, weights);
  const Strain curvature_by_box = by_box(periodic.images().box(), curvature);
  for (int k = 0; k < 9; ++k) {
    result.strain[k] += factors.bending * lattice.length(curvature.by[k]);
    result.box[k] += factors.bending * curvature_by_box.by[k];
  }
  return result;
}

}  // namespace hsp
