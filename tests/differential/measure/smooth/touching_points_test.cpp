// The smooth surface where two balls touch in a point that others pass. Against lines through the definition, against
// the surface of radii that are a little larger, which it tends to with a root of the difference, and two sets whose
// figures are known.
#include <gtest/gtest.h>
#include <hardsphere_workspace.h>

#include <array>
#include <cmath>
#include <vector>

#include "excluded_surface.hpp"
#include "random_numbers.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Point;

struct Set {
  double probe;
  std::vector<Point> centres;  // all radii are 1 with the probe
};

// `larger`: by how much the radii are.
hsp_surface_totals surface_of(const Set &set, double larger = 0) {
  hsp_workspace work{};
  hsp_model_options options;
  EXPECT_EQ(hsp_model_options_init(&options, sizeof options), HSP_OK);
  options.probe = set.probe;
  const auto n = static_cast<uint32_t>(set.centres.size());
  const std::vector<double> radius(n, 1 - set.probe + larger);
  EXPECT_EQ(hsp_workspace_set(&work, n, set.centres[0].data(), radius.data(), &options, nullptr), HSP_OK);
  EXPECT_EQ(hsp_workspace_boundary(&work), HSP_OK);
  EXPECT_EQ(hsp_workspace_surface(&work), HSP_OK);
  hsp_surface_totals totals{};
  EXPECT_EQ(hsp_surface_measure(work.surface, &totals, nullptr, 0, nullptr), HSP_OK);
  hsp_surface_counts counts{};
  EXPECT_EQ(hsp_surface_get_counts(work.surface, &counts), HSP_OK);
  EXPECT_EQ(counts.open_joints, 0U);
  uint32_t invariant = 0, id = 0;
  EXPECT_EQ(hsp_surface_check(work.surface, &invariant, &id), HSP_OK) << invariant << " at " << id;
  hsp_workspace_free(&work);
  return totals;
}

TEST(TouchingPoints, AreRightWhereFiguresAreKnown) {
  const Set sets[] = {{0.25, {{1, 0, 0}, {.6, .8, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}},
                      {0.5, {{1, 0, 0}, {-1, 0, 0}, {0, -.6, .8}, {.64, .48, -.6}, {-.48, .64, .6}, {0, 1, 0}}}};
  const double area[] = {24.2919593, 18.1498757}, volume[] = {7.92070103, 3.7834992};
  for (int k = 0; k < 2; ++k) {
    const hsp_surface_totals totals = surface_of(sets[k]);
    EXPECT_NEAR(totals.area, area[k], 1e-7) << k;
    EXPECT_NEAR(totals.volume, volume[k], 1e-7) << k;
  }
}

// Directions with rational coordinates of up to two decimals.
Set random_set(uint64_t seed) {
  constexpr double direction[13][3] = {{.6, .8, 0},    {-.6, .8, 0},    {.8, 0, .6},    {0, .6, .8},  {0, 1, 0},
                                       {0, -1, 0},     {0, 0, 1},       {0, 0, -1},     {.6, 0, -.8}, {0, -.6, .8},
                                       {.48, .6, .64}, {-.48, .64, .6}, {.64, .48, -.6}};
  constexpr double probes[4] = {0.25, 0.5, 0.125, 1};
  support::RandomNumbers<support::SplitMix64> random(seed);
  Set set{probes[random.below(4)], {{1, 0, 0}, {-1, 0, 0}}};
  for (int64_t more = random.in(2, 6); more > 0; --more) {
    const double *const q = direction[random.below(13)];
    set.centres.push_back({q[0], q[1], q[2]});
  }
  return set;
}

TEST(TouchingPoints, AreRight) {
  const int sets = oracle::rounds(400, 4000);
  for (int k = 0; k < sets; ++k) {
    SCOPED_TRACE(k);
    const Set set = random_set(71 + static_cast<uint64_t>(k));
    const double square = set.probe * set.probe;
    const hsp_surface_totals totals = surface_of(set), beside = surface_of(set, 1e-7);
    // The root is 0.023 p^2 at most; a lune that is missing or too much is some hundredths of p^2 at least.
    EXPECT_NEAR(totals.area, beside.area, 0.03 * square);
    if (k % 50 > 0) continue;
    // Ties would have to be decided by roundings there: of radii that are a little larger.
    std::vector<oracle::ProbedBall> balls;
    for (const Point &centre : set.centres) balls.push_back({centre, 1 + 1e-5});
    const oracle::AreaAndVolume expected = oracle::excluded_surface_by_lines(balls, set.probe, 32);
    EXPECT_NEAR(totals.area, expected.area, 6e-3 * expected.area + 1e-9);
    EXPECT_NEAR(totals.volume, expected.volume, 6e-3 * expected.volume + 1e-9);
  }
}

}  // namespace
