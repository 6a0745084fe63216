// Sums over all balls against those of single balls, and derivatives of the energy against differences.
#include "measure/totals.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "built_boundary.hpp"

namespace {

constexpr double pi = std::numbers::pi;

// A lens and a ball apart, in an order that is not that of the grid.
const oracle::Balls scene = {{9000, 0, 0, 1000}, {600, 0, 0, 500}, {0, 0, 0, 500}, {0, 0, 0, 100}};
// Each cap of the lens has height 200.
constexpr double lens_area = 2 * (4 * pi * 500 * 500 - 2 * pi * 500 * 200);
constexpr double lens_volume = 2 * (4.0 / 3 * pi * 500 * 500 * 500 - pi * 200 * 200 * (3 * 500 - 200) / 3);

TEST(MeasureUnion, SumsBallByBallInTheInputsOrder) {
  BuiltBoundary built(scene);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  std::vector<hsp::BallMeasure> measures;
  const hsp::BallMeasure total =
      hsp::measure_union(built.grid(), built.boundary(), nullptr, [&](uint32_t i, const hsp::BallMeasure &measure) {
        EXPECT_EQ(i, measures.size());
        measures.push_back(measure);
      });
  ASSERT_EQ(measures.size(), 4U);
  for (uint32_t i = 0; i < 4; ++i) {
    const hsp::BallMeasure own = hsp::measure_ball(built.balls(), built.boundary(), built.grid_index(i));
    EXPECT_EQ(measures[i].area, own.area);
    EXPECT_EQ(measures[i].volume, own.volume);
  }
  EXPECT_EQ(measures[3].area, 0.0);
  EXPECT_NEAR(total.area, 4 * pi * 1e6 + lens_area, 1e-7);
  EXPECT_NEAR(total.volume, 4.0 / 3 * pi * 1e9 + lens_volume, 1e-4);
}

TEST(MeasureUnion, LeavesOutWhatIsNotSelected) {
  BuiltBoundary built(scene);
  const uint8_t selected[4] = {0, 1, 0, 1};
  double areas = 0.0;
  const hsp::BallMeasure total =
      hsp::measure_union(built.grid(), built.boundary(), selected, [&](uint32_t i, const hsp::BallMeasure &measure) {
        EXPECT_EQ(measure.area > 0.0, i == 1);
        areas += measure.area;
      });
  EXPECT_EQ(total.area, areas);
  EXPECT_NEAR(total.area, lens_area / 2, 1e-8);
}

class Energies {
 public:
  hsp::Energy of(const oracle::Balls &balls) {
    BuiltBoundary built(balls);
    EXPECT_EQ(built.status(), hsp::Status::ok);
    gradients.clear();
    return hsp::differentiate_energy(built.grid(), built.boundary(), terms,
                                     [this](uint32_t i, const hsp::EnergyGradient &gradient) {
                                       EXPECT_EQ(i, gradients.size());
                                       gradients.push_back(gradient);
                                     });
  }

  hsp::EnergyTerms terms;
  std::vector<hsp::EnergyGradient> gradients;
};

TEST(DifferentiateEnergy, ValueOfWeightedAreasAndVolume) {
  const double weight[4] = {2.0, 3.0, 5.0, 7.0};
  Energies energies;
  energies.terms = {{weight, hsp::TouchingBalls::meet}, 0.5, -0.25};
  const hsp::Energy energy = energies.of(scene);
  EXPECT_NEAR(energy.area, 2 * 4 * pi * 1e6 + (3 + 5) * lens_area / 2, 1e-6);
  EXPECT_NEAR(energy.volume, 4.0 / 3 * pi * 1e9 + lens_volume, 1e-4);
  EXPECT_EQ(energy.value, 0.5 * energy.area - 0.25 * energy.volume);
  double by_probe = 0.0;
  for (const hsp::EnergyGradient &gradient : energies.gradients) by_probe += gradient.radius;
  EXPECT_NEAR(energy.by_probe, by_probe, 1e-12 * std::fabs(by_probe));
}

TEST(DifferentiateEnergy, AgreesWithDifferences) {
  const double weight[3] = {1.5, 1.0, 2.5};
  const oracle::Balls balls = {
      {0, 0, 0, 5000000}, {6000000, 1000000, 0, 4500000}, {2000000, 5500000, 1000000, 4000000}};
  Energies energies;
  energies.terms = {{weight, hsp::TouchingBalls::meet}, 1.25, 1e-7};
  energies.of(balls);
  const std::vector<hsp::EnergyGradient> gradients = energies.gradients;
  constexpr int64_t h = 100;  // steps
  double shift_sum[3] = {0, 0, 0};
  for (uint32_t i = 0; i < 3; ++i) {
    for (uint32_t k = 0; k < 4; ++k) {
      const auto value_at = [&](int64_t by) {
        oracle::Balls moved = balls;
        (k == 0 ? moved[i].x : k == 1 ? moved[i].y : k == 2 ? moved[i].z : moved[i].radius) += by;
        return energies.of(moved).value;
      };
      const double difference = (value_at(h) - value_at(-h)) / static_cast<double>(2 * h);
      const double derivative = k < 3 ? gradients[i].centre[k] : gradients[i].radius;
      EXPECT_NEAR(derivative, difference, 1e-6 * (std::fabs(derivative) + 1e7)) << i << " " << k;
      if (k < 3) shift_sum[k] += derivative;
    }
    EXPECT_FALSE(gradients[i].one_sided);
  }
  // A shift of all balls changes nothing.
  for (const double sum : shift_sum) EXPECT_NEAR(sum, 0.0, 1e-6);
}

TEST(DifferentiateEnergy, TouchingIsOneSided) {
  Energies energies;
  energies.terms.tension = 1.0;
  energies.of({{0, 0, 0, 500}, {1000, 0, 0, 500}, {5000, 0, 0, 500}});
  ASSERT_EQ(energies.gradients.size(), 3U);
  EXPECT_TRUE(energies.gradients[0].one_sided);
  EXPECT_TRUE(energies.gradients[1].one_sided);
  EXPECT_FALSE(energies.gradients[2].one_sided);
}

}  // namespace
