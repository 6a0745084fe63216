#include <cmath>
#include <numbers>
#include <sstream>

#include "disjoint_sets.hpp"
#include "set_checks.hpp"
#include "slice_quadrature.hpp"

namespace degenerate {
namespace {

using oracle::Balls;
using oracle::Int128;
using oracle::LatticeBall;

bool meet(const LatticeBall &a, const LatticeBall &b) {
  const oracle::Vector between = oracle::centre_difference(a, b);
  const Int128 reach = Int128{a.radius} + b.radius;
  return oracle::dot(between, between) <= reach * reach;
}

// By connected component and about a ball of it, so that distances between components and from the origin cost no
// digits.
oracle::SliceMeasures measure_by_components(const Balls &balls) {
  oracle::DisjointSets sets(balls.size());
  for (size_t i = 0; i < balls.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (meet(balls[i], balls[j])) sets.join(i, j);
  oracle::SliceMeasures all;
  all.ball_area.assign(balls.size(), 0);
  for (size_t first = 0; first < balls.size(); ++first) {
    if (sets.find(first) != first) continue;
    std::vector<size_t> members;
    std::vector<oracle::RealBall> component;
    for (size_t i = first; i < balls.size(); ++i) {
      if (sets.find(i) != first) continue;
      const oracle::Vector centre = oracle::centre_difference(balls[first], balls[i]);
      members.push_back(i);
      component.push_back({static_cast<long double>(centre[0]), static_cast<long double>(centre[1]),
                           static_cast<long double>(centre[2]), static_cast<long double>(balls[i].radius)});
    }
    const oracle::SliceMeasures measures = oracle::measure_by_slices(component);
    all.area += measures.area;
    all.volume += measures.volume;
    for (size_t k = 0; k < members.size(); ++k) all.ball_area[members[k]] = measures.ball_area[k];
  }
  return all;
}

// Where centres are close together for the size of the balls, the oracle's 64-bit numbers lose the height at which one
// sphere takes over from the other: by a rounding error (5e-20) times this.
long double worst_condition(const Balls &balls) {
  long double largest = 0;
  long double nearest2 = 0;
  for (const LatticeBall &a : balls) {
    largest = std::max(largest, static_cast<long double>(a.radius));
    for (const LatticeBall &b : balls) {
      const oracle::Vector between = oracle::centre_difference(a, b);
      const auto distance2 = static_cast<long double>(oracle::dot(between, between));
      if (distance2 > 0 && (nearest2 == 0 || distance2 < nearest2)) nearest2 = distance2;
    }
  }
  return nearest2 == 0 ? 1 : 1 + largest / std::sqrt(nearest2);
}

}  // namespace

std::string slices_disagree(const Balls &balls) {
  constexpr long double tolerance = 1e-12L;
  const long double tolerance_of_a_ball = tolerance + 10 * 5e-20L * worst_condition(balls);
  const oracle::SliceMeasures expected = measure_by_components(balls);
  const LibraryBoundary::Measures found = LibraryBoundary(balls).measure();
  std::ostringstream text;
  text.precision(17);
  const auto compare = [&](const char *name, double value, long double reference, long double allowed) {
    if (!(std::abs(static_cast<long double>(value) - reference) <= allowed))
      text << name << " " << value << " instead of " << reference << "\n";
  };
  long double largest = 0;
  for (const LatticeBall &ball : balls) largest = std::max(largest, static_cast<long double>(ball.radius));
  compare("area", found.totals.area, expected.area, tolerance * expected.area);
  compare("volume", found.totals.volume, expected.volume, tolerance * expected.volume);
  for (size_t i = 0; i < balls.size(); ++i)
    compare("area of a ball", found.area[i], expected.ball_area[i],
            tolerance_of_a_ball * 4 * std::numbers::pi_v<long double> * largest * largest);
  return text.str();
}

}  // namespace degenerate
