// Morphometric energies in a box: derivatives by the balls, the strain and the box against difference quotients, where
// these agree among themselves; and the laws that tie them together.
#include "periodic/periodic_morphometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "weighted_box.hpp"

namespace {

hsp::MorphometricEnergy energy_of(const BuiltPeriodic &built, const WeightedBox &set,
                                  const hsp::MorphometricFactors &factors,
                                  std::vector<hsp::EnergyGradient> *gradient = nullptr) {
  EXPECT_EQ(built.status(), hsp::Status::ok);
  const hsp::AreaWeights weights = hsp::weights_in_box(built.get(), set.weights.data(), hsp::TouchingBalls::meet);
  hsp::MorphometricEnergy energy;
  EXPECT_TRUE(hsp::differentiate_morphometry_in_box(hsp::Executor(), built.get(), weights, factors, energy,
                                                    [&](uint32_t, const hsp::EnergyGradient &of_ball) {
                                                      if (gradient != nullptr) gradient->push_back(of_ball);
                                                    }));
  return energy;
}

// A derivative, and how far it may be off: difference quotients of fourth order for two steps. Where an arc is born or
// dies between them M has no derivatives, and these differ.
struct Quotient {
  double value, error;
};

template <class Change>
Quotient quotient(const WeightedBox &set, const hsp::MorphometricFactors &factors, Change change) {
  const auto with_step = [&](double e) {
    double sum = 0.0;
    for (const auto &[times, factor] : {std::array{-2.0, 1.0}, {-1.0, -8.0}, {1.0, 8.0}, {2.0, -1.0}}) {
      WeightedBox changed = set;
      change(changed, times * e);
      const BuiltPeriodic built = changed.built();
      sum += factor * energy_of(built, changed, factors).value;
    }
    return sum / (12 * e);
  };
  const double fine = with_step(1e-3);
  return {fine, std::fabs(fine - with_step(2e-3))};
}

class Derivatives {
 public:
  void expect(double derivative, const Quotient &found) {
    ++all_;
    if (found.error > 1e-2) return;
    ++compared_;
    EXPECT_NEAR(derivative, found.value, 2e-4 + 2 * found.error);
  }
  ~Derivatives() { EXPECT_GT(10 * compared_, 9 * all_); }

 private:
  int all_ = 0, compared_ = 0;
};

constexpr hsp::MorphometricFactors bending_alone{0, 0, 1, 0};
constexpr hsp::MorphometricFactors everything{-0.5, 1.5, 0.75, 2};

TEST(PeriodicMorphometry, DerivesByTheStrainAndTheBox) {
  oracle::RandomSource random(341);
  Derivatives derivatives;
  for (int trial = 0; trial < 5; ++trial) {
    const WeightedBox set(random, 6);
    const BuiltPeriodic built = set.built();
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::AreaWeights weights = hsp::weights_in_box(built.get(), set.weights.data(), hsp::TouchingBalls::meet);
    const hsp::Strain strain = hsp::curvature_by_strain(built.get(), weights);
    // Turning changes nothing.
    for (size_t p = 0; p < 3; ++p) {
      for (size_t q = p; q < 3; ++q) {
        derivatives.expect(built->images().lattice().length(strain.by[3 * p + q]),
                           quotient(set, bending_alone, [&](WeightedBox &s, double e) { s.strain(p, q, e); }));
        EXPECT_NEAR(strain.by[3 * p + q], strain.by[3 * q + p], 1e-9 / fine_step);
      }
    }
    const hsp::BoxGradient all = hsp::box_gradient_of_morphometry(built.get(), weights, everything);
    derivatives.expect(all.strain.by[4],
                       quotient(set, everything, [](WeightedBox &s, double e) { s.strain(1, 1, e); }));
    for (const size_t k : {0U, 3U, 4U, 6U, 7U, 8U}) {
      derivatives.expect(all.vectors.by[k],
                         quotient(set, everything, [&](WeightedBox &s, double e) { s.change_box(k, e); }));
    }
  }
}

TEST(PeriodicMorphometry, DerivesByCentresAndRadii) {
  oracle::RandomSource random(342);
  Derivatives derivatives;
  for (int trial = 0; trial < 4; ++trial) {
    const WeightedBox set(random, 5);
    const BuiltPeriodic built = set.built();
    std::vector<hsp::EnergyGradient> gradient;
    const hsp::MorphometricEnergy energy = energy_of(built, set, everything, &gradient);
    EXPECT_NEAR(energy.value,
                everything.pressure * energy.volume + everything.tension * energy.area +
                    everything.bending * energy.mean + everything.gaussian * energy.gauss,
                1e-12);
    EXPECT_NEAR(energy.volume, built.totals().volume, 1e-12);
    double by_probe = 0.0;
    for (uint32_t i = 0; i < built.balls(); ++i) {
      EXPECT_FALSE(gradient[i].one_sided);
      by_probe += gradient[i].radius;
      for (size_t axis = 0; axis < 3; ++axis) {
        derivatives.expect(gradient[i].centre[axis], quotient(set, everything, [&](WeightedBox &s, double e) {
                             s.balls.xyz[3 * i + axis] += e;
                           }));
      }
      derivatives.expect(gradient[i].radius,
                         quotient(set, everything, [&](WeightedBox &s, double e) { s.balls.radius[i] += e; }));
    }
    EXPECT_NEAR(by_probe, energy.by_probe, 1e-11);
  }
}

// Balls that meet images of themselves as well, in larger sets; without weights M is that of the curvatures.
TEST(PeriodicMorphometry, HasTheLawsOfLengths) {
  oracle::RandomSource random(343);
  for (int trial = 0; trial < 40; ++trial) {
    WeightedBox set(random, 1 + static_cast<uint32_t>(trial) % 24);
    if (trial % 4 == 0) set.balls.radius[0] = 2.4;
    if (trial % 5 == 0) set.weights.assign(set.weights.size(), 1.0);
    const BuiltPeriodic built = set.built();
    std::vector<hsp::EnergyGradient> gradient;
    const hsp::MorphometricEnergy energy = energy_of(built, set, bending_alone, &gradient);
    const hsp::AreaWeights weights = hsp::weights_in_box(built.get(), set.weights.data(), hsp::TouchingBalls::meet);
    double by_lengths = built->images().lattice().length(hsp::curvature_by_strain(built.get(), weights).trace());
    double sum[3] = {0.0, 0.0, 0.0}, size = 1.0;
    for (uint32_t i = 0; i < built.balls(); ++i) {
      by_lengths += set.balls.radius[i] * gradient[i].radius;
      for (int axis = 0; axis < 3; ++axis) {
        sum[axis] += gradient[i].centre[axis];
        size += std::fabs(gradient[i].centre[axis]);
      }
    }
    EXPECT_EQ(energy.value, energy.mean);
    EXPECT_NEAR(by_lengths, energy.mean, 1e-9 * size);
    for (const double along : sum) EXPECT_NEAR(along, 0.0, 1e-10 * size);
    if (trial % 5 != 0) continue;
    const hsp::CurvatureTotals totals = hsp::sum_curvatures(built->grid(), built->boundary(), built->images().lattice(),
                                                            [](uint32_t, const hsp::BallCurvature &) {});
    EXPECT_NEAR(totals.mean, energy.mean, 1e-11 * size);
    EXPECT_EQ(totals.gauss, energy.gauss);
  }
}

// Two balls that touch across a face, and a crystal in which more than three spheres meet in a vertex.
TEST(PeriodicMorphometry, SaysWhereItHasNoDerivatives) {
  const BoxVectors cube{4, 0, 0, 0, 4, 0, 0, 0, 4};
  WeightedBox set = [] {
    oracle::RandomSource random(1);
    return WeightedBox(random, 0);
  }();
  set.weights = {1.0, 1.0};
  const auto flags_of = [&](const support::BallList &balls) {
    std::vector<hsp::EnergyGradient> gradient;
    const BuiltPeriodic built(balls, cube);
    static_cast<void>(energy_of(built, set, bending_alone, &gradient));
    const hsp::AreaWeights weights = hsp::weights_in_box(built.get(), nullptr, hsp::TouchingBalls::meet);
    for (const double x : hsp::curvature_by_strain(built.get(), weights).by) EXPECT_TRUE(std::isfinite(x));
    return std::array{gradient[0].one_sided, gradient[1].one_sided};
  };
  support::BallList touching;
  touching.add(0, 0, 0, 1);
  touching.add(0, 0, 2, 1);
  EXPECT_EQ(flags_of(touching), (std::array{true, true}));
  support::BallList apart;
  apart.add(0, 0, 0, 1);
  apart.add(2, 2, 2, 1);
  EXPECT_EQ(flags_of(apart), (std::array{false, false}));
  support::BallList body_centred;
  body_centred.add(0, 0, 0, 2);
  body_centred.add(2, 2, 2, 2);
  EXPECT_EQ(flags_of(body_centred), (std::array{true, true}));
}

}  // namespace
