// What gradients obey whatever the balls are: motions, scaling, symmetry, the order of the balls, and the vector areas
// of slices. The numbered properties are those of hsp_boundary_gradient and hsp_boundary_get_area_row.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <tuple>
#include <utility>
#include <vector>

#include "gradient_sets.hpp"
#include "library_derivatives.hpp"
#include "measure_differences.hpp"
#include "named_balls.hpp"
#include "slice_quadrature.hpp"
#include "smallest_failing.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using oracle::RandomSource;
using Real = long double;

constexpr std::array<std::uint32_t, 2> tangencies = {HSP_TANGENT_MEETING, HSP_TANGENT_APART};

std::array<Real, 3> centre_of(const LatticeBall &ball) {
  return {static_cast<Real>(ball.x), static_cast<Real>(ball.y), static_cast<Real>(ball.z)};
}

/// A sum that should be zero, with the sum of the sizes of its terms.
struct Balance {
  Real sum = 0;
  Real size = 0;

  void add(Real term) {
    sum += term;
    size += std::abs(term);
  }
  [[nodiscard]] bool holds() const { return std::abs(sum) <= 1e-12L * size; }
};

/// Weights that are multiples of 1/8 between -1 and 1, tension and pressure that make terms of like size.
EnergyTerms any_energy(RandomSource &random, const Balls &balls, std::uint32_t tangency) {
  EnergyTerms terms;
  terms.tangency = tangency;
  for (std::size_t i = 0; i < balls.size(); ++i) terms.sigma.push_back(static_cast<double>(random.in(-8, 8)) / 8);
  terms.tension = static_cast<double>(random.in(-8, 8)) / 8;
  terms.pressure =
      static_cast<double>(random.in(-8, 8)) / 8 / std::max(1.0, static_cast<double>(largest_radius(balls)));
  return terms;
}

/// Property 1: neither a translation nor a rotation changes an energy.
std::string motions_change_energy(const Balls &balls, const EnergyTerms &terms) {
  const LibraryGradient found = gradient(LibraryBoundary(balls), terms);
  std::array<Balance, 3> forces;
  std::array<Balance, 3> torques;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const std::array<Real, 3> c = centre_of(balls[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      forces[k].add(static_cast<Real>(found.by_ball[i][k]));
      torques[k].add(c[k] * static_cast<Real>(found.by_ball[i][l]));
      torques[k].add(-c[l] * static_cast<Real>(found.by_ball[i][k]));
    }
  }
  // Where everything cancels the terms themselves are rounding: at least a force as one sphere makes it counts.
  const Real radius = largest_radius(balls);
  const Real force =
      radius * (std::abs(static_cast<Real>(terms.tension)) + std::abs(static_cast<Real>(terms.pressure)) * radius);
  Real arm = 0;
  for (const LatticeBall &ball : balls)
    for (const Real coordinate : centre_of(ball)) arm = std::max(arm, std::abs(coordinate));
  std::string text;
  for (const auto &[name, balances, least] : {std::tuple{"force", forces, force}, {"torque", torques, force * arm}}) {
    Real size = least;
    for (const Balance &balance : balances) size = std::max(size, balance.size);
    for (const Balance &balance : balances)
      if (!(std::abs(balance.sum) <= 1e-12L * size)) {
        std::ostringstream line;
        line << name << " " << balance.sum << " of " << size << "\n";
        text += line.str();
      }
  }
  return text;
}

/// Property 2: areas grow with the square, volumes with the cube of all lengths.
std::string scaling_is_wrong(const Balls &balls, double tension, double pressure, std::uint32_t tangency) {
  const LibraryGradient found = gradient(LibraryBoundary(balls), {tension, pressure, {}, tangency});
  Balance balance;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const std::array<Real, 3> c = centre_of(balls[i]);
    for (std::size_t k = 0; k < 3; ++k) balance.add(c[k] * static_cast<Real>(found.by_ball[i][k]));
    balance.add(static_cast<Real>(balls[i].radius) * static_cast<Real>(found.by_ball[i][3]));
  }
  balance.add(-2 * static_cast<Real>(tension) * static_cast<Real>(found.energy.area));
  balance.add(-3 * static_cast<Real>(pressure) * static_cast<Real>(found.energy.volume));
  if (balance.holds()) return "";
  std::ostringstream text;
  text << "scaling: " << balance.sum << " of " << balance.size << "\n";
  return text.str();
}

TEST(GradientLaws, MotionsChangeNoEnergy) {
  RandomSource random(91);
  for (int k = 0; k < 3000; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<std::size_t>(random.in(1, 30)));
    // Smaller sets that fail have to be asked about with the same energy.
    const std::int64_t seed = random.in(0, 1 << 30);
    const auto complaint = [&](const Balls &set) {
      RandomSource again(static_cast<std::uint64_t>(seed));
      std::string text;
      for (const std::uint32_t tangency : tangencies)
        text += motions_change_energy(set, any_energy(again, set, tangency));
      return text;
    };
    ASSERT_EQ(complaint_about_smallest(balls, complaint), "");
  }
  for (const GradientSet &set : molecules_of_gradient_tests())
    EXPECT_EQ(motions_change_energy(set.balls, any_energy(random, set.balls, HSP_TANGENT_MEETING)), "") << set.name;
}

TEST(GradientLaws, AreaAndVolumeScale) {
  RandomSource random(92);
  for (int k = 0; k < 3000; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<std::size_t>(random.in(1, 30)));
    const auto complaint = [&](const Balls &set) {
      std::string text;
      for (const std::uint32_t tangency : tangencies)
        text += scaling_is_wrong(set, 1, 0, tangency) + scaling_is_wrong(set, 0, 1, tangency);
      return text;
    };
    ASSERT_EQ(complaint_about_smallest(balls, complaint), "");
  }
  for (const GradientSet &set : molecules_of_gradient_tests())
    EXPECT_EQ(
        scaling_is_wrong(set.balls, 1, 0, HSP_TANGENT_MEETING) + scaling_is_wrong(set.balls, 0, 1, HSP_TANGENT_MEETING),
        "")
        << set.name;
}

// Property 3.
TEST(GradientLaws, TheOrderOfTheBallsChangesNoBit) {
  RandomSource random(93);
  for (int k = 0; k < 1500; ++k) {
    Balls balls = oracle::any_balls(random, static_cast<std::size_t>(random.in(2, 30)));
    std::sort(balls.begin(), balls.end());
    // Equal balls are told apart by their index only.
    balls.erase(std::unique(balls.begin(), balls.end()), balls.end());
    const std::vector<std::uint32_t> order = random.permutation(balls.size());
    const EnergyTerms terms = any_energy(random, balls, tangencies[static_cast<std::size_t>(k % 2)]);
    EnergyTerms mixed_terms = terms;
    for (std::size_t i = 0; i < order.size(); ++i) mixed_terms.sigma[i] = terms.sigma[order[i]];
    const LibraryGradient sorted = gradient(LibraryBoundary(balls), terms);
    const LibraryGradient mixed = gradient(LibraryBoundary(oracle::permuted(balls, order)), mixed_terms);
    for (std::size_t i = 0; i < order.size(); ++i) {
      ASSERT_EQ(mixed.by_ball[i], sorted.by_ball[order[i]]) << oracle::to_text(balls);
      ASSERT_EQ(mixed.flags[i], sorted.flags[order[i]]) << oracle::to_text(balls);
    }
  }
}

TEST(GradientLaws, StepsThatArePowersOfTwoChangeNoBit) {
  RandomSource random(94);
  for (int k = 0; k < 300; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<std::size_t>(random.in(1, 20)));
    const int exponent = static_cast<int>(random.in(-60, 60));
    const LibraryBoundary unit(balls);
    const LibraryBoundary scaled(balls, std::ldexp(1.0, exponent));
    for (const bool of_volume : {false, true}) {
      const EnergyTerms terms = {of_volume ? 0.0 : 1.0, of_volume ? 1.0 : 0.0, {}, HSP_TANGENT_MEETING};
      const LibraryGradient here = gradient(unit, terms);
      const LibraryGradient there = gradient(scaled, terms);
      for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_EQ(std::ldexp(here.by_ball[i][c], of_volume ? 2 * exponent : exponent), there.by_ball[i][c])
              << oracle::to_text(balls);
    }
  }
}

/// The derivative of the volume by a centre is the vector area of the ball's faces, by a radius the area.
std::string volume_gradient_differs(const Balls &balls) {
  const LibraryBoundary boundary(balls);
  const LibraryGradient found = gradient(boundary, {0, 1, {}, HSP_TANGENT_MEETING});
  const oracle::SliceMeasures expected = oracle::measure_by_slices(oracle::real_balls(balls));
  std::ostringstream text;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Real radius = static_cast<Real>(balls[i].radius);
    const Real tolerance = 1e-12L * 4 * std::numbers::pi_v<Real> * radius * radius;
    for (std::size_t c = 0; c < 4; ++c) {
      const Real value = c < 3 ? expected.ball_vector_area[i][c] : expected.ball_area[i];
      const Real difference = static_cast<Real>(found.by_ball[i][c]) - value;
      if (!(std::abs(difference) <= tolerance))
        text << "number " << c << " of ball " << i << ": " << found.by_ball[i][c] << " instead of " << value << "\n";
    }
  }
  return text.str();
}

TEST(GradientLaws, TheVolumesGradientIsTheVectorAreaOfSlices) {
  for (const GradientSet &set : sets_of_every_kind(95))
    EXPECT_EQ(complaint_about_smallest(set.balls, volume_gradient_differs), "") << set.name;
  RandomSource random(96);
  for (int k = 0; k < 300; ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<std::size_t>(random.in(1, 10)));
    ASSERT_EQ(complaint_about_smallest(balls, volume_gradient_differs), "");
  }
  for (const GradientSet &set : molecules_of_gradient_tests())
    EXPECT_EQ(volume_gradient_differs(nearest_to_first(set.balls, 30)), "") << set.name;
}

TEST(GradientLaws, TheProbeIsAllRadiiTogether) {
  for (const std::vector<GradientSet> &sets : {sets_of_every_kind(97), molecules_of_gradient_tests()})
    for (const GradientSet &set : sets) {
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
           {std::tuple{EnergyTerms{1, 0, {}, HSP_TANGENT_MEETING}, area, scale},
            std::tuple{EnergyTerms{0, 1, {}, HSP_TANGENT_MEETING}, expected.volume, scale * scale}}) {
        const LibraryGradient found = gradient(boundary, terms);
        const Real balls = static_cast<Real>(set.balls.size());
        EXPECT_LE(std::abs(static_cast<Real>(found.energy.probe) - quotient.value),
                  std::max(1e-8L * unit * balls, quotient.error))
            << set.name;
        EXPECT_LE(quotient.error, 1e-7L * unit * balls) << set.name;
        Balance sum;
        for (const FourDerivatives &ball : found.by_ball) sum.add(static_cast<Real>(ball[3]));
        EXPECT_NEAR(found.energy.probe, static_cast<double>(sum.sum), 1e-14 * static_cast<double>(sum.size))
            << set.name;
      }
    }
}

TEST(GradientLaws, RadiiIncludeTheProbe) {
  RandomSource random(100);
  for (const GradientSet &set : sets_of_every_kind(100)) {
    std::int64_t probe = set.balls.front().radius;
    for (const LatticeBall &ball : set.balls) probe = std::min(probe, ball.radius);
    probe /= 2;
    Balls smaller = set.balls;
    for (LatticeBall &ball : smaller) ball.radius -= probe;
    const EnergyTerms terms = any_energy(random, set.balls, HSP_TANGENT_MEETING);
    const LibraryGradient grown = gradient(LibraryBoundary(smaller, 1, static_cast<double>(probe)), terms);
    const LibraryGradient as_given = gradient(LibraryBoundary(set.balls), terms);
    EXPECT_EQ(grown.by_ball, as_given.by_ball) << set.name;
    EXPECT_EQ(grown.energy.probe, as_given.energy.probe) << set.name;
  }
}

/// Properties of rows: their sums, their symmetry, the arcs' angles, and that they are the gradient's parts.
std::string rows_are_wrong(const Balls &balls, std::uint32_t tangency) {
  const LibraryBoundary boundary(balls);
  const std::size_t n = balls.size();
  std::ostringstream text;
  std::vector<std::map<std::uint32_t, hsp_area_derivative>> rows(n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (const hsp_area_derivative &entry : area_row(boundary, i, tangency)) {
      if (!rows[i].empty() && rows[i].rbegin()->first >= entry.ball) text << "row " << i << " is not ascending\n";
      rows[i][entry.ball] = entry;
    }

  std::map<std::pair<std::uint32_t, std::uint32_t>, Real> angles;
  for (const hsp_arc &arc : boundary.arcs()) angles[{arc.ball[0], arc.ball[1]}] += static_cast<Real>(arc.angle);
  for (const hsp_circle &circle : boundary.circles())
    angles[{circle.ball[0], circle.ball[1]}] += 2 * std::numbers::pi_v<Real>;

  const LibraryGradient whole = gradient(boundary, {1, 0, {}, tangency});
  std::vector<std::array<Balance, 4>> parts(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    std::array<Balance, 3> sums;
    for (const auto &[j, entry] : rows[i]) {
      for (std::size_t c = 0; c < 3; ++c) {
        sums[c].add(static_cast<Real>(entry.centre[c]));
        parts[j][c].add(static_cast<Real>(entry.centre[c]));
      }
      parts[j][3].add(static_cast<Real>(entry.radius));
      if (i == j) continue;
      const auto mirrored = rows[j].find(i);
      if (mirrored == rows[j].end()) {
        text << "row " << i << " has " << j << ", but not the other way round\n";
        continue;
      }
      const oracle::Vector v = oracle::centre_difference(balls[i], balls[j]);
      const Real by_angle = static_cast<Real>(balls[i].radius) * static_cast<Real>(balls[j].radius) /
                            std::sqrt(static_cast<Real>(oracle::dot(v, v)));
      if (!(std::abs(static_cast<Real>(entry.radius) - static_cast<Real>(mirrored->second.radius)) <=
            1e-14L * by_angle))
        text << "rows " << i << ", " << j << " are not symmetric\n";
      if (!(std::abs(static_cast<Real>(entry.radius) + by_angle * static_cast<Real>(entry.angle)) <= 1e-14L * by_angle))
        text << "row " << i << ": the angle of " << j << " is not that of the derivative by its radius\n";
      // Where spheres touch, the angle that counts can be 0.
      const Real angle = angles[{std::min(i, j), std::max(i, j)}];
      if ((entry.flags & HSP_GRADIENT_ONE_SIDED) == 0 && !(std::abs(static_cast<Real>(entry.angle) - angle) <= 1e-14L))
        text << "angle " << entry.angle << " of " << i << " and " << j << " instead of " << angle << "\n";
    }
    Real size = 0;
    for (const Balance &sum : sums) size = std::max(size, sum.size);
    for (const Balance &sum : sums)
      if (!(std::abs(sum.sum) <= 1e-14L * size))
        text << "row " << i << " sums to " << sum.sum << " of " << size << "\n";
    if (rows[i].empty() != (boundary.balls()[i].faces == 0)) text << "row " << i << " should be empty or should not\n";
  }
  for (std::size_t j = 0; j < n; ++j) {
    Real size = static_cast<Real>(balls[j].radius);
    for (const Balance &part : parts[j]) size = std::max(size, part.size);
    for (std::size_t c = 0; c < 4; ++c)
      if (!(std::abs(static_cast<Real>(whole.by_ball[j][c]) - parts[j][c].sum) <= 1e-13L * size))
        text << "number " << c << " of ball " << j << " is " << whole.by_ball[j][c] << ", its parts sum to "
             << parts[j][c].sum << "\n";
  }
  return text.str();
}

TEST(GradientLaws, RowsAreSymmetricAndSumToTheGradient) {
  RandomSource random(98);
  for (int k = 0; k < 2000; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<std::size_t>(random.in(1, 25)));
    for (const std::uint32_t tangency : tangencies)
      ASSERT_EQ(complaint_about_smallest(balls, [&](const Balls &set) { return rows_are_wrong(set, tangency); }), "");
  }
  for (const GradientSet &set : molecules_of_gradient_tests())
    EXPECT_EQ(rows_are_wrong(set.balls, HSP_TANGENT_MEETING), "") << set.name;
}

TEST(GradientLaws, TheEnergyIsMadeOfAreasAndVolume) {
  RandomSource random(99);
  for (int k = 0; k < 500; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<std::size_t>(random.in(1, 25)));
    const EnergyTerms terms = any_energy(random, balls, HSP_TANGENT_APART);
    const LibraryBoundary boundary(balls);
    const hsp_energy energy = gradient(boundary, terms).energy;
    const LibraryBoundary::Measures measures = boundary.measure();
    Balance area;
    for (std::size_t i = 0; i < balls.size(); ++i)
      area.add(static_cast<Real>(terms.sigma[i]) * static_cast<Real>(measures.area[i]));
    const double size = static_cast<double>(area.size);
    EXPECT_NEAR(energy.area, static_cast<double>(area.sum), 1e-13 * size) << oracle::to_text(balls);
    EXPECT_NEAR(energy.volume, measures.totals.volume, 1e-13 * measures.totals.volume) << oracle::to_text(balls);
    EXPECT_EQ(energy.value, terms.tension * energy.area + terms.pressure * energy.volume);
  }
}

}  // namespace
