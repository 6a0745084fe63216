// The library's areas and volume against quadrature over slices (tests/oracle/slice_quadrature.hpp).
#pragma once

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "library_run.hpp"
#include "slice_quadrature.hpp"
#include "smallest_failing.hpp"

// Text about all differences of more than 1e-12: for totals relative to the total, for the area of a single ball
// relative to the sphere of the largest ball. Empty if there are none.
inline std::string measures_differ(const oracle::Balls &balls) {
  constexpr long double tolerance = 1e-12L;
  const oracle::SliceMeasures expected = oracle::measure_by_slices(oracle::real_balls(balls));
  const LibraryBoundary::Measures found = LibraryBoundary(balls).measure();
  std::ostringstream text;
  text.precision(17);
  const auto compare = [&](const char *name, double value, long double reference, long double scale) {
    if (!(std::abs(static_cast<long double>(value) - reference) <= tolerance * scale))
      text << name << " " << value << " instead of " << reference << "\n";
  };
  long double largest = 0;
  for (const oracle::LatticeBall &ball : balls) largest = std::max(largest, static_cast<long double>(ball.radius));
  compare("area", found.totals.area, expected.area, expected.area);
  compare("volume", found.totals.volume, expected.volume, expected.volume);
  for (size_t i = 0; i < balls.size(); ++i)
    compare("area of a ball", found.area[i], expected.ball_area[i],
            4 * std::numbers::pi_v<long double> * largest * largest);
  return text.str();
}
