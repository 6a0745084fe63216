// The worked example at the head of energy.hpp, by closed forms: two balls of radius 5 whose centres are 8 apart.
#include "measure/energy.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "built_boundary.hpp"
#include "energy_of_all.hpp"

namespace {

TEST(Energy, IsThatOfTheExampleInItsHeader) {
  const BuiltBoundary built({{0, 0, 0, 5}, {8, 0, 0, 5}});
  hsp::EnergyTerms terms;
  terms.tension = 2;
  terms.pressure = 3;
  std::vector<hsp::EnergyGradient> own;
  const hsp::Energy energy =
      support::differentiate_energy(built.grid(), built.boundary(), terms,
                                    [&](uint32_t, const hsp::EnergyGradient &gradient) { own.push_back(gradient); });
  EXPECT_NEAR(energy.area, 180 * hsp::pi, 1e-11);
  EXPECT_NEAR(energy.volume, 324 * hsp::pi, 1e-11);
  EXPECT_NEAR(energy.value, 1332 * hsp::pi, 1e-10);
  ASSERT_EQ(own.size(), 2U);
  for (int k = 0; k < 2; ++k) {
    const hsp::EnergyGradient &gradient = own[static_cast<size_t>(k)];
    EXPECT_NEAR(gradient.centre[0], (k == 0 ? -47 : 47) * hsp::pi, 1e-11);
    EXPECT_NEAR(gradient.centre[1], 0, 1e-11);
    EXPECT_NEAR(gradient.centre[2], 0, 1e-11);
    EXPECT_NEAR(gradient.radius, 326 * hsp::pi, 1e-11);
    EXPECT_NEAR(gradient.area, 90 * hsp::pi, 1e-11);
  }
  EXPECT_NEAR(energy.by_probe, 2 * 326 * hsp::pi, 1e-11);
}

}  // namespace
