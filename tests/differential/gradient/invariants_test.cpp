// Gradients and rows of the Jacobian over random and awkward sets and molecules: their invariants, which are written in
// C, and what slices and difference quotients say of the volume and of the probe.
#include <gtest/gtest.h>

#include <gradient_invariants.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <tuple>
#include <vector>

#include "computed_balls.hpp"
#include "gradient_sets.hpp"
#include "library_derivatives.hpp"
#include "measure_differences.hpp"
#include "named_balls.hpp"
#include "slice_quadrature.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using oracle::RandomSource;
using Real = long double;

// Of some energy: weights that are multiples of 1/8 between -1 and 1, tension and pressure that make terms of like
// size. Smaller sets are asked about with the same numbers.
struct Energy {
  std::vector<double> sigma;
  double tension = 0;
  double pressure = 0;

  Energy(const Balls &balls, uint64_t seed) {
    RandomSource random(seed);
    for (size_t i = 0; i < balls.size(); ++i) sigma.push_back(static_cast<double>(random.in(-8, 8)) / 8);
    tension = static_cast<double>(random.in(-8, 8)) / 8;
    pressure = static_cast<double>(random.in(-8, 8)) / 8 / std::max(1.0, static_cast<double>(largest_radius(balls)));
  }
};

// The first invariant that does not hold of gradients, weighted and not, and of their flags.
std::string gradient_invariant_broken(const Balls &balls, uint64_t seed) {
  const ComputedBalls set(balls);
  const Energy energy(balls, seed);
  std::string broken = complaint_of(broken_gradient_flags(set.get(), energy.sigma.data()));
  for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT})
    for (const double *const sigma : {static_cast<const double *>(nullptr), energy.sigma.data()})
      broken += complaint_of(broken_gradients(set.get(), sigma, energy.tension, energy.pressure, tangency));
  return broken;
}

std::string area_row_invariant_broken(const Balls &balls, uint64_t seed) {
  const ComputedBalls set(balls);
  const Energy energy(balls, seed);
  std::string broken;
  for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT})
    broken += complaint_of(broken_area_rows(set.get(), energy.sigma.data(), tangency));
  return broken;
}

// Property 3. Equal balls have equal weights, as any of them may be the one that counts.
std::string gradient_orders_disagree(const Balls &balls, uint64_t seed) {
  RandomSource random(seed);
  const Balls mixed = oracle::permuted(balls, random.permutation(balls.size()));
  const auto weights_of = [](const Balls &order) {
    std::vector<double> sigma;
    for (const LatticeBall &b : order)
      sigma.push_back(static_cast<double>((b.x + 3 * b.y + 5 * b.z + 7 * b.radius) % 17) / 8);
    return sigma;
  };
  const ComputedBalls one(balls);
  const ComputedBalls other(mixed);
  std::string broken;
  for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT})
    broken += complaint_of(gradient_difference_after_permutation(one.get(), weights_of(balls).data(), other.get(),
                                                                 weights_of(mixed).data(), tangency));
  return broken;
}

using Invariant = std::string (*)(const Balls &, uint64_t);

void expect_of_any_balls(Invariant invariant, int sets, int64_t most, uint64_t seed) {
  RandomSource random(seed);
  for (int k = 0; k < sets; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(1, most)));
    const auto energy_seed = static_cast<uint64_t>(random.in(0, 1 << 30));
    const auto complaint = [&](const Balls &set) { return invariant(set, energy_seed); };
    ASSERT_EQ(complaint_about_smallest(balls, complaint), "");
  }
}

TEST(GradientInvariants, OfAnyBalls) {
  expect_of_any_balls(gradient_invariant_broken, 3000, 30, 91);
}
TEST(GradientInvariants, OfAnyOrder) {
  expect_of_any_balls(gradient_orders_disagree, 1500, 30, 93);
}
TEST(AreaRowInvariants, OfAnyBalls) {
  expect_of_any_balls(area_row_invariant_broken, 2000, 25, 98);
}

TEST(GradientInvariants, OfMolecules) {
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests()) {
    EXPECT_EQ(gradient_invariant_broken(set.balls, 92), "") << set.name;
    EXPECT_EQ(gradient_orders_disagree(set.balls, 94), "") << set.name;
    EXPECT_EQ(area_row_invariant_broken(set.balls, 99), "") << set.name;
  }
}

// The derivative of the volume by a centre is the vector area of the ball's faces, by a radius the area.
std::string volume_gradient_differs(const Balls &balls) {
  const LibraryBoundary boundary(balls);
  const LibraryGradient found = gradient(boundary, {0, 1, {}, HSP_TANGENT_OVERLAP});
  const oracle::SliceMeasures expected = oracle::measure_by_slices(oracle::real_balls(balls));
  std::ostringstream text;
  for (size_t i = 0; i < balls.size(); ++i) {
    const Real radius = static_cast<Real>(balls[i].radius);
    const Real tolerance = 1e-12L * 4 * std::numbers::pi_v<Real> * radius * radius;
    for (size_t c = 0; c < 4; ++c) {
      const Real value = c < 3 ? expected.ball_vector_area[i][c] : expected.ball_area[i];
      const Real difference = static_cast<Real>(found.by_ball[i][c]) - value;
      if (!(std::abs(difference) <= tolerance))
        text << "number " << c << " of ball " << i << ": " << found.by_ball[i][c] << " instead of " << value << "\n";
    }
  }
  return text.str();
}

TEST(VolumeGradient, IsTheVectorAreaOfSlices) {
  for (const oracle::NamedBalls &set : sets_of_every_kind(95))
    EXPECT_EQ(complaint_about_smallest(set.balls, volume_gradient_differs), "") << set.name;
  RandomSource random(96);
  for (int k = 0; k < oracle::sets(300); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(1, 10)));
    ASSERT_EQ(complaint_about_smallest(balls, volume_gradient_differs), "");
  }
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests())
    EXPECT_EQ(volume_gradient_differs(nearest_to_first(set.balls, 30)), "") << set.name;
}

TEST(ProbeDerivative, IsThatOfAllRadiiTogether) {
  for (const std::vector<oracle::NamedBalls> &sets : {sets_of_every_kind(97), molecules_of_gradient_tests()})
    for (const oracle::NamedBalls &set : sets) {
      const Real scale = largest_radius(set.balls);
      const MeasureDerivatives expected =
          derivatives_by_differences(set.balls, {Variable::all_balls, Variable::radius}, measured_by_library, 1e-9L);
      DifferenceQuotient area;
      for (const DifferenceQuotient &part : expected.area) {
        area.value += part.value;
        area.error += part.error;
      }
      const LibraryBoundary boundary(set.balls);
      for (const auto &[terms, quotient, unit] :
           {std::tuple{EnergyTerms{1, 0, {}, HSP_TANGENT_OVERLAP}, area, scale},
            std::tuple{EnergyTerms{0, 1, {}, HSP_TANGENT_OVERLAP}, expected.volume, scale * scale}}) {
        const LibraryGradient found = gradient(boundary, terms);
        const Real balls = static_cast<Real>(set.balls.size());
        EXPECT_LE(std::abs(static_cast<Real>(found.energy.d_probe) - quotient.value),
                  std::max(1e-8L * unit * balls, quotient.error))
            << set.name;
        EXPECT_LE(quotient.error, 1e-7L * unit * balls) << set.name;
      }
    }
}

}  // namespace
