#include "gradient_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "library_derivatives.hpp"

using oracle::Balls;

namespace {

using Real = long double;

// dA_i/dx_j of the library's rows: entry [i] by ball j.
std::vector<std::map<uint32_t, FourDerivatives>> all_rows(const LibraryBoundary &boundary, size_t n) {
  std::vector<std::map<uint32_t, FourDerivatives>> rows(n);
  for (uint32_t i = 0; i < n; ++i)
    for (const hsp_area_derivative &entry : area_row(boundary, i))
      rows[i][entry.ball] = {entry.centre[0], entry.centre[1], entry.centre[2], entry.radius};
  return rows;
}

class Comparison {
 public:
  Comparison(Real scale, GradientTally &tally) : scale_(scale), tally_(tally) { text_.precision(17); }

  // power: of the largest radius that the derivative is relative to.
  void compare(double found, DifferenceQuotient expected, int power, const std::string &what) {
    const Real scale = power == 1 ? scale_ : scale_ * scale_;
    const Real bound = expected.error / scale;
    const Real difference = std::abs(static_cast<Real>(found) - expected.value) / scale;
    ++tally_.compared;
    tally_.worst_of_bounds = std::max(tally_.worst_of_bounds, bound);
    if (bound > gradient_tolerance)
      ++tally_.beyond;
    else
      tally_.worst = std::max(tally_.worst, difference);
    if (!(difference <= std::max(gradient_tolerance, bound)))
      text_ << what << " is " << found << " instead of " << expected.value << " +- " << expected.error << "\n";
  }

  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  Real scale_;
  GradientTally &tally_;
  std::ostringstream text_;
};

// Weights of both signs, and some zeros.
EnergyTerms weighted_energy(size_t n, Real scale) {
  EnergyTerms terms;
  terms.tension = 0.75;
  terms.pressure = static_cast<double>(-0.5L / scale);
  for (size_t i = 0; i < n; ++i) terms.sigma.push_back(0.25 * static_cast<double>(static_cast<int>(i * 5 % 9) - 4));
  return terms;
}

}  // namespace

void GradientTally::add(const GradientTally &other) {
  compared += other.compared;
  beyond += other.beyond;
  worst = std::max(worst, other.worst);
  worst_of_bounds = std::max(worst_of_bounds, other.worst_of_bounds);
}

bool nearly_all_known(const GradientTally &tally) {
  return tally.compared > 0 && tally.beyond * 50 <= tally.compared && tally.worst_of_bounds <= 1e-4L;
}

std::string to_text(const GradientTally &tally) {
  std::ostringstream text;
  text.precision(2);
  text << tally.compared << " derivatives, worst difference " << tally.worst << ", " << tally.beyond
       << " known less well than that, to " << tally.worst_of_bounds;
  return text.str();
}

std::string gradients_differ(const Balls &balls, const std::vector<size_t> &movers, const Measure &measure,
                             GradientTally &tally) {
  const size_t n = balls.size();
  const Real scale = largest_radius(balls);
  const LibraryBoundary boundary(balls);
  const auto rows = all_rows(boundary, n);
  const EnergyTerms weighted = weighted_energy(n, scale);
  const LibraryGradient of_area = gradient(boundary, {1, 0, {}, HSP_TANGENT_OVERLAP});
  const LibraryGradient of_volume = gradient(boundary, {0, 1, {}, HSP_TANGENT_OVERLAP});
  const LibraryGradient of_energy = gradient(boundary, weighted);

  Comparison comparison(scale, tally);
  for (const size_t j : movers)
    for (size_t number = 0; number < 4; ++number) {
      const MeasureDerivatives expected =
          derivatives_by_differences(balls, {j, number}, measure, gradient_tolerance / 10);
      const auto name = [&](const std::string &quantity) {
        return "d(" + quantity + ")/d(" + (number < 3 ? std::string(1, "xyz"[number]) : "r") + " of " +
               std::to_string(j) + ")";
      };
      DifferenceQuotient area;
      DifferenceQuotient energy = {static_cast<Real>(weighted.pressure) * expected.volume.value,
                                   std::abs(static_cast<Real>(weighted.pressure)) * expected.volume.error};
      for (size_t i = 0; i < n; ++i) {
        const auto entry = rows[i].find(static_cast<uint32_t>(j));
        comparison.compare(entry == rows[i].end() ? 0 : entry->second[number], expected.area[i], 1,
                           name("area of " + std::to_string(i)));
        area.value += expected.area[i].value;
        area.error += expected.area[i].error;
        const Real weight = static_cast<Real>(weighted.tension) * static_cast<Real>(weighted.sigma[i]);
        energy.value += weight * expected.area[i].value;
        energy.error += std::abs(weight) * expected.area[i].error;
      }
      comparison.compare(of_area.by_ball[j][number], area, 1, name("area"));
      comparison.compare(of_volume.by_ball[j][number], expected.volume, 2, name("volume"));
      comparison.compare(of_energy.by_ball[j][number], energy, 1, name("weighted energy"));
    }
  return comparison.text();
}
