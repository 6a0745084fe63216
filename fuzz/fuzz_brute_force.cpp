// The whole boundary against the oracle's brute force, for a set and for its image under one of the 48 symmetries of
// the axes and a translation; and what such a motion must not change.
#include <algorithm>
#include <cmath>

#include "boundary_record.hpp"
#include "brute_boundary.hpp"
#include "fuzz_input.hpp"
#include "library_run.hpp"

namespace {

// One of the 48 symmetries of the axes, then a lattice vector.
oracle::Balls moved(const oracle::Balls &balls, uint32_t symmetry, int64_t shift) {
  return oracle::moved(oracle::axis_symmetries(balls)[symmetry], {shift, 2 * shift, 3 * shift});
}

LibraryBoundary::Measures require_brute_force(const oracle::Balls &balls, oracle::BoundaryRecord &record) {
  record = oracle::brute_boundary(balls);
  const LibraryBoundary library(balls);
  const auto ranks = oracle::tie_ranks(balls);
  FUZZ_REQUIRE(oracle::canonical(library.record(), ranks) == oracle::canonical(record, ranks),
               oracle::to_text(balls).c_str());
  return library.measure();
}

bool close(double a, double b, double scale) {
  return std::fabs(a - b) <= 1e-9 * scale;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const uint32_t symmetry = bytes.below(48);
  const int64_t shift = bytes.byte() * int64_t{1000003};
  const fuzz::ScaledBalls set = fuzz::ball_set(bytes, 8);
  if (set.n() > 10) return 0;  // brute force takes the fourth power
  const oracle::Balls balls = set.with_probe();
  oracle::BoundaryRecord here;
  oracle::BoundaryRecord there;
  const auto measured_here = require_brute_force(balls, here);
  const auto measured_there = require_brute_force(moved(balls, symmetry, shift), there);
  // The perturbation depends on the coordinates, so infinitesimally small parts may differ after a motion. Numbers that
  // belong to the closed balls may not.
  FUZZ_REQUIRE(here.counts.components == there.counts.components, "components after a motion");
  FUZZ_REQUIRE(here.counts.voids == there.counts.voids, "voids after a motion");
  FUZZ_REQUIRE(here.counts.shells == there.counts.shells, "shells after a motion");
  FUZZ_REQUIRE(here.counts.euler == there.counts.euler, "Euler characteristic after a motion");
  double area_scale = 1.0;
  double volume_scale = 1.0;
  for (const oracle::LatticeBall &ball : balls) {
    const double r = static_cast<double>(ball.radius);
    area_scale += 12 * r * r;
    volume_scale += 12 * r * r * r;
  }
  FUZZ_REQUIRE(close(measured_here.totals.area, measured_there.totals.area, area_scale), "area after a motion");
  FUZZ_REQUIRE(close(measured_here.totals.volume, measured_there.totals.volume, volume_scale), "volume after a motion");
  return 0;
}
