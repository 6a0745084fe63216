#include "measure_differences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <tuple>

#include "library_run.hpp"
#include "slice_quadrature.hpp"

using oracle::Balls;
using oracle::LatticeBall;

namespace {

using Real = long double;
using Value = MeasuredValues::Value;

Balls moved(const Balls &balls, Variable variable, int64_t amount) {
  Balls result = balls;
  for (size_t i = 0; i < balls.size(); ++i)
    if (variable.ball == i || variable.ball == Variable::all_balls) {
      LatticeBall &ball = result[i];
      (variable.number == 0   ? ball.x
       : variable.number == 1 ? ball.y
       : variable.number == 2 ? ball.z
                              : ball.radius) += amount;
    }
  return result;
}

// Vertices and circles of the library's boundary by their balls: while they stay the same, areas and volume are
// analytic.
using Structure = std::vector<std::tuple<uint32_t, uint32_t, uint32_t, int32_t>>;

Structure structure_of(const Balls &balls) {
  const LibraryBoundary boundary(balls);
  Structure structure;
  for (const hsp_vertex &v : boundary.vertices()) structure.emplace_back(v.ball[0], v.ball[1], v.ball[2], v.sign);
  for (const hsp_circle &c : boundary.circles()) structure.emplace_back(c.ball[0], c.ball[1], HSP_NONE, 0);
  std::sort(structure.begin(), structure.end());
  return structure;
}

// f(x + h) - f(x - h), value by value.
std::vector<Value> differences_of(const std::vector<Value> &above, const std::vector<Value> &below) {
  std::vector<Value> result;
  for (size_t i = 0; i < above.size(); ++i) {
    const Real difference = above[i].value - below[i].value;
    // A value that does not change to the bit does not depend on the variable: there is no noise either.
    result.push_back({difference, difference == 0 ? 0 : above[i].noise + below[i].noise});
  }
  return result;
}

Value sum_of(const std::vector<Value> &terms) {
  Value sum;
  for (const Value &term : terms) {
    sum.value += term.value;
    sum.noise += term.noise;
  }
  return sum;
}

// One step length: differences of all areas, and behind them that of the volume.
using Level = std::vector<Value>;

void improve(MeasureDerivatives &best, const std::vector<Level> &levels, Real h) {
  const size_t first = levels.size() - quotient_levels;
  for (size_t q = 0; q <= best.area.size(); ++q) {
    std::array<Real, quotient_levels> differences;
    Real noise = 0;
    for (size_t k = 0; k < quotient_levels; ++k) {
      differences[k] = levels[first + k][q].value;
      noise = std::max(noise, levels[first + k][q].noise);
    }
    const DifferenceQuotient quotient = extrapolated_quotient(differences, h, noise);
    DifferenceQuotient &known = q < best.area.size() ? best.area[q] : best.volume;
    if (quotient.error < known.error) known = quotient;
  }
}

}  // namespace

Real largest_radius(const Balls &balls) {
  Real largest = 0;
  for (const LatticeBall &ball : balls) largest = std::max(largest, static_cast<Real>(ball.radius));
  return largest;
}

MeasuredValues measured_by_library(const Balls &balls) {
  const LibraryBoundary boundary(balls);
  const LibraryBoundary::Measures measures = boundary.measure();
  // The area over r^2 is a sum of one or two terms per arc, each at most 2 pi and made by a few operations. The bound
  // grants each term eight roundings, each as large as that of the largest possible partial sum.
  std::vector<Real> arcs(balls.size(), 2);
  for (const hsp_arc &arc : boundary.arcs())
    for (const uint32_t ball : arc.ball) arcs[ball] += 1;
  for (const hsp_circle &circle : boundary.circles())
    for (const uint32_t ball : circle.ball) arcs[ball] += 1;
  // A term of the volume is the area times the radius plus the vector area times an arm, which is at most twice as long
  // as the largest distance from the first centre.
  Real arm = 0;
  for (const LatticeBall &ball : balls) {
    const oracle::Vector v = oracle::centre_difference(balls.front(), ball);
    arm = std::max(arm, 2 * std::sqrt(static_cast<Real>(oracle::dot(v, v))));
  }
  MeasuredValues values;
  for (size_t i = 0; i < balls.size(); ++i) {
    const Real radius = static_cast<Real>(balls[i].radius);
    const Real noise = 8 * std::ldexp(2 * std::numbers::pi_v<Real>, -53) * arcs[i] * radius * radius;
    values.area.push_back({static_cast<Real>(measures.area[i]), noise});
    values.volume.push_back({static_cast<Real>(measures.volume[i]), noise * (radius + arm) / 3});
  }
  return values;
}

MeasuredValues measured_by_slices(const Balls &balls) {
  // A finer step than usual: a ball's top or bottom close to that of a circle costs digits. Whether the noise granted
  // below suffices is seen by turning the set, see tests/differential/gradient/differences_test.cpp.
  const oracle::SliceMeasures measures = oracle::measure_by_slices(oracle::real_balls(balls), 0.07L);
  constexpr Real relative = 2e-15L;
  const Real radius = largest_radius(balls);
  MeasuredValues values;
  for (const Real area : measures.ball_area) values.area.push_back({area, relative * radius * radius});
  values.volume.push_back({measures.volume, relative * measures.volume});
  return values;
}

MeasureDerivatives derivatives_by_differences(const Balls &balls, Variable variable, const Measure &measure,
                                              Real accuracy) {
  MeasureDerivatives best;
  best.area.resize(balls.size());
  for (DifferenceQuotient &quotient : best.area) quotient.error = std::numeric_limits<Real>::infinity();
  best.volume.error = std::numeric_limits<Real>::infinity();

  const Structure structure = structure_of(balls);
  const Real scale = largest_radius(balls);
  int64_t radius = balls[variable.ball == Variable::all_balls ? 0 : variable.ball].radius;
  if (variable.ball == Variable::all_balls)
    for (const LatticeBall &ball : balls) radius = std::min(radius, ball.radius);
  int64_t step = 1;
  while (step * 16 <= radius) step *= 2;

  std::vector<Level> levels;
  for (; step >= 64; step /= 2) {
    const Balls above = moved(balls, variable, step);
    const Balls below = moved(balls, variable, -step);
    if (structure_of(above) != structure || structure_of(below) != structure) {
      levels.clear();
      continue;
    }
    const MeasuredValues high = measure(above);
    const MeasuredValues low = measure(below);
    Level level = differences_of(high.area, low.area);
    level.push_back(sum_of(differences_of(high.volume, low.volume)));
    levels.push_back(level);
    if (levels.size() < quotient_levels) continue;
    improve(best, levels, std::ldexp(static_cast<Real>(step), quotient_levels - 1));

    bool settled = best.volume.error <= accuracy * scale * scale;
    for (const DifferenceQuotient &quotient : best.area) settled = settled && quotient.error <= accuracy * scale;
    // Rounding alone makes an error that doubles with every halving.
    const Real rounding = std::ldexp(1e-15L, 4) * scale / static_cast<Real>(step) * scale;
    if (settled || rounding > 100 * accuracy * scale) break;
  }
  return best;
}
