// The kernels over saddle patches for registers of one and two doubles, and of every target: the same bits from each.
#include "surface/saddle_kernel.hpp"
#include "runnable_targets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <random>
#include <vector>

namespace {

using hsp::ArcBatch;

// A ball among others and a batch of circles with arcs, some of them small, cusped or beyond the ball's centre.
struct RandomSaddles {
  ArcBatch batch{};
  std::vector<double> radii;
  hsp::RolledBall ball{};

  explicit RandomSaddles(std::mt19937 &random) {
    std::uniform_real_distribution<double> fraction(0.0, 1.0);
    for (int j = 0; j < 12; ++j) radii.push_back(1000 + 1000 * fraction(random));
    ball = {radii.data(), radii[0], 900 * fraction(random), {5000 * fraction(random), -300, 20}};
    batch.count = 1 + static_cast<uint32_t>(random() % ArcBatch::capacity);
    for (uint32_t s = 0; s < batch.count; ++s) {
      batch.other[s] = 1 + static_cast<uint32_t>(random() % 11);
      const double other = radii[batch.other[s]];
      const double least = std::fabs(radii[0] - other);
      const double distance = least + (radii[0] + other - least) * fraction(random);
      batch.inverse_distance[s] = 1 / distance;
      batch.twice_height[s] = distance + (radii[0] - other) * (radii[0] + other) / distance;
      batch.angle[s] = 6 * fraction(random);
      batch.ux[s] = 0.6;
      batch.uy[s] = -0.48;
      batch.uz[s] = 0.64;
      batch.Xx[s] = 1000 * fraction(random);
      batch.Xy[s] = 1000 * fraction(random);
      batch.Xz[s] = -1000 * fraction(random);
    }
    // Slots behind the last repeat its circle, without an arc.
    for (uint32_t s = batch.count; s < batch.count + hsp::sum_lanes - 1; ++s) {
      batch.other[s] = batch.other[batch.count - 1];
      batch.inverse_distance[s] = batch.inverse_distance[batch.count - 1];
      batch.twice_height[s] = batch.twice_height[batch.count - 1];
    }
  }
};

struct Results {
  bool served = false;
  hsp::SaddleCircles circles{};
  hsp::SaddleMeasures measures{};
  hsp::SaddleDerivatives derivatives{};
};

struct Kernel {
  using Circles = hsp::SaddleCircles;
  std::function<bool(const ArcBatch &, const hsp::RolledBall &, Circles &)> find_circles;
  std::function<hsp::SaddleMeasures(const ArcBatch &, const Circles &, const hsp::RolledBall &)> measure;
  std::function<hsp::SaddleDerivatives(const ArcBatch &, const Circles &, const hsp::RolledBall &)> differentiate;

  [[nodiscard]] Results run(const RandomSaddles &saddles) const {
    Results results;
    const ArcBatch &batch = saddles.batch;
    results.served = find_circles(batch, saddles.ball, results.circles);
    // Patches that doubles did not serve are found elsewhere, slots after the last included.
    for (uint32_t s = 0; s < batch.count + hsp::sum_lanes - 1; ++s) {
      double &rho = results.circles.radius[s];
      if (s >= batch.count || rho != rho) rho = 50;
      if (s >= batch.count) results.circles.half_way[s] = 0;
    }
    results.measures = measure(batch, results.circles, saddles.ball);
    results.derivatives = differentiate(batch, results.circles, saddles.ball);
    return results;
  }
};

template <uint32_t n>
Kernel kernel() {
  using K = hsp::SaddleKernel<n>;
  return {K::find_circles, K::measure, K::differentiate};
}
Kernel kernel_of(hsp::Target target) {
  return {[=](const ArcBatch &batch, const hsp::RolledBall &ball, Kernel::Circles &circles) {
            return hsp::find_saddle_circles(target, batch, ball, circles);
          },
          [=](const ArcBatch &batch, const Kernel::Circles &circles, const hsp::RolledBall &ball) {
            return hsp::measure_saddles(target, batch, circles, ball);
          },
          [=](const ArcBatch &batch, const Kernel::Circles &circles, const hsp::RolledBall &ball) {
            return hsp::differentiate_saddles(target, batch, circles, ball);
          }};
}

void expect_same(const Results &a, const Results &b) {
  EXPECT_EQ(a.served, b.served);
  EXPECT_EQ(std::memcmp(&a.circles, &b.circles, sizeof a.circles), 0);
  EXPECT_EQ(std::memcmp(&a.measures, &b.measures, sizeof a.measures), 0);
  EXPECT_EQ(std::memcmp(&a.derivatives, &b.derivatives, sizeof a.derivatives), 0);
}

TEST(SaddleKernel, GivesTheSameBitsForEveryWidth) {
  std::mt19937 random(9);
  uint32_t unserved = 0;
  for (int round = 0; round < 2000; ++round) {
    const RandomSaddles saddles(random);
    const Results two = kernel<2>().run(saddles);
    unserved += two.served ? 0 : 1;
    expect_same(kernel<1>().run(saddles), two);
    for (const hsp::Target target : runnable_targets()) expect_same(kernel_of(target).run(saddles), two);
    EXPECT_EQ(std::memcmp(&two.measures, &two.derivatives.measures, sizeof two.measures), 0);
    EXPECT_TRUE(std::isfinite(two.derivatives.area[0] + two.derivatives.volume[3]));
    if (HasFailure()) return;
  }
  EXPECT_GT(unserved, 100U);
  EXPECT_LT(unserved, 1900U);
}

}  // namespace
