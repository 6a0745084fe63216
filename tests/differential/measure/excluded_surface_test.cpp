// Area and volume of the solvent-excluded surface against lines through its definition, for sets whose surface meets
// itself in every way.
#include <gtest/gtest.h>

#include <vector>

#include "excluded_surface.hpp"
#include "owned_handle.hpp"
#include "random_numbers.hpp"

namespace {

using oracle::ProbedBall;

hsp_surface_totals library_surface(const std::vector<ProbedBall> &balls, double probe, hsp_surface_counts &counts) {
  support::BallList list;
  for (const ProbedBall &ball : balls) {
    list.add(ball.centre[0], ball.centre[1], ball.centre[2], ball.radius - probe);
  }
  hsp_model_options options;
  support::expect_ok(hsp_model_options_init(&options, sizeof options), "hsp_model_options_init");
  options.probe = probe;
  support::OwnedModel model(list.size());
  support::expect_ok(model.set(list, &options), "hsp_model_set");
  support::OwnedBoundary boundary;
  boundary.take(support::default_boundary_limits(list.size()));
  boundary.compute([&](hsp_boundary *handle, hsp_boundary_limits *limits) {
    return hsp_boundary_compute(handle, model.get(), limits);
  });
  support::OwnedSurface surface;
  surface.take(support::surface_limits_for(boundary.get()));
  surface.compute([&](hsp_surface *handle, hsp_surface_limits *limits) {
    return hsp_surface_compute(handle, boundary.get(), limits);
  });
  hsp_surface_totals totals;
  support::expect_ok(hsp_surface_measure(surface.get(), &totals, nullptr, 0, nullptr), "hsp_surface_measure");
  support::expect_ok(hsp_surface_get_counts(surface.get(), &counts), "hsp_surface_get_counts");
  return totals;
}

void expect_as_by_lines(const std::vector<ProbedBall> &balls, double probe, int lines, double tolerance,
                        hsp_surface_counts &counts) {
  const hsp_surface_totals found = library_surface(balls, probe, counts);
  const oracle::AreaAndVolume expected = oracle::excluded_surface_by_lines(balls, probe, lines);
  EXPECT_NEAR(found.volume, expected.volume, tolerance * found.volume);
  EXPECT_NEAR(found.area, expected.area, tolerance * found.area);
}

TEST(ExcludedSurface, WhereItMeetsItself) {
  const double a = 1.79555934;
  struct Set {
    std::vector<ProbedBall> balls;
    uint32_t cusped, cut;
  };
  const Set sets[] = {{{{{0, 0, 0}, 3.1}, {{6.1, 0, 0}, 3.1}}, 1, 0},
                      {{{{2.9, 0, 0}, 3.1}, {{-1.45, 2.51147367, 0}, 3.1}, {{-1.45, -2.51147367, 0}, 3.1}}, 0, 2},
                      {{{{a, a, a}, 3.1}, {{a, -a, -a}, 3.1}, {{-a, a, -a}, 3.1}, {{-a, -a, a}, 3.1}}, 0, 8}};
  for (const Set &set : sets) {
    hsp_surface_counts counts;
    expect_as_by_lines(set.balls, 1.4, 64, 2e-3, counts);
    EXPECT_EQ(counts.cusped_patches, set.cusped);
    EXPECT_EQ(counts.cut_patches, set.cut);
  }
}

TEST(ExcludedSurface, OfRandomSets) {
  support::Random random(20261121);
  uint32_t cut = 0, cusped = 0;
  for (int k = 0; k < 20; ++k) {
    const double probe = 1 + 0.5 * random.below(4);
    std::vector<ProbedBall> balls(6);
    for (ProbedBall &ball : balls) {
      for (double &coordinate : ball.centre) coordinate = static_cast<double>(random.below(600)) / 100;
      ball.radius = probe + 0.8 + static_cast<double>(random.below(80)) / 100;
    }
    hsp_surface_counts counts;
    SCOPED_TRACE(k);
    expect_as_by_lines(balls, probe, 56, 3e-3, counts);
    cut += counts.cut_patches;
    cusped += counts.cusped_patches;
  }
  EXPECT_GT(cut, 25U);
  EXPECT_GT(cusped, 5U);
}

}  // namespace
