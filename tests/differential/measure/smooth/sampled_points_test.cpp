// The volume of the smooth surface against random points that are in the solid by its definition, over families of sets
// that tie in every way: in units of what chance allows the mean square of the differences is 1.
#include <gtest/gtest.h>
#include <hardsphere_workspace.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "excluded_surface.hpp"
#include "long_reals.hpp"
#include "sweep_length.hpp"
#include "tied_families.hpp"

namespace {

// The balls as the library has them, on its lattice; and inflated a little, but by far less than a step, so that not
// roundings say what becomes of ties: points where balls only touch are no void.
constexpr double inflation = 1e-11;
std::vector<oracle::ProbedBall> balls_of(const support::TiedSet &set, double step) {
  const auto on_lattice = [step](double x) { return std::nearbyint(x / step) * step; };
  std::vector<oracle::ProbedBall> balls;
  for (uint32_t i = 0; i < set.balls.size(); ++i) {
    const double *const centre = &set.balls.xyz[3 * size_t{i}];
    balls.push_back({{on_lattice(centre[0]), on_lattice(centre[1]), on_lattice(centre[2])},
                     on_lattice(set.balls.radius[i]) + on_lattice(set.probe) + inflation});
  }
  return balls;
}

class Surfaces {
 public:
  Surfaces() = default;
  Surfaces(const Surfaces &) = delete;
  Surfaces &operator=(const Surfaces &) = delete;
  ~Surfaces() { hsp_workspace_free(&work_); }

  double volume(const support::TiedSet &set, double &step) {
    hsp_model_options options;
    EXPECT_EQ(hsp_model_options_init(&options, sizeof options), HSP_OK);
    options.probe = set.probe;
    EXPECT_EQ(
        hsp_workspace_set(&work_, set.balls.size(), set.balls.xyz.data(), set.balls.radius.data(), &options, nullptr),
        HSP_OK);
    hsp_model_info info{};
    EXPECT_EQ(hsp_model_get_info(work_.model, &info), HSP_OK);
    step = info.step;
    EXPECT_EQ(hsp_workspace_boundary(&work_), HSP_OK);
    EXPECT_EQ(hsp_workspace_surface(&work_), HSP_OK);
    hsp_surface_totals totals{};
    EXPECT_EQ(hsp_surface_measure(work_.surface, &totals, nullptr, 0, nullptr), HSP_OK);
    return totals.volume;
  }

 private:
  hsp_workspace work_{};
};

TEST(SampledPoints, AreInTheSolidAsOftenAsItsVolumeSays) {
  if (!oracle::has_long_reals) GTEST_SKIP() << "long doubles have no more digits than doubles";
  const int wanted = oracle::rounds(500, 5000);
  const int points = 2000;
  // 5 standard deviations of the mean square of so many.
  const double most = 1 + 5 * std::sqrt(2.0 / wanted);
  Surfaces surfaces;
  int counted = 0;
  double sum = 0, worst = 0;
  for (uint64_t seed = 8000; counted < wanted; ++seed) {
    for (const support::TiedFamily &family : support::tied_families) {
      const support::TiedSet set = family.member(seed);
      double step = 0;
      const double volume = surfaces.volume(set, step);
      const double square = oracle::deviation_by_points(balls_of(set, step), set.probe, volume, points, seed);
      if (square < 0) continue;
      EXPECT_LT(square, 36) << family.name << ' ' << seed << ": volume " << volume;
      ++counted;
      sum += square;
      worst = std::fmax(worst, square);
    }
    ASSERT_LT(seed, 20000U);
  }
  std::cout << counted << " sets, mean square " << sum / counted << ", worst " << std::sqrt(worst) << " deviations\n";
  EXPECT_LT(sum / counted, most);
}

}  // namespace
