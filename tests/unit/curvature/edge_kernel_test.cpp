// The kernels over edges: angles of edges against integers and the C library, and the same bits from registers of one,
// two and four doubles.
#include "curvature/edge_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "built_boundary.hpp"
#include "measure/arc_batches.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"

namespace {

using hsp::ArcBatch;
using hsp::EdgeBatch;

// (s^2 - U) (U - t^2) and s^2 + t^2 - 2 U need no more than 64 bits for spheres that meet.
TEST(EdgeKernel, RoundsIntegersOnce) {
  std::mt19937_64 random(3);
  const auto up_to = [&random](int64_t n) { return static_cast<int64_t>(random() % static_cast<uint64_t>(n + 1)); };
  uint32_t proper = 0, cancelled = 0;
  for (int round = 0; round < 100000; ++round) {
    const int64_t most = INT64_C(1) << (2 + random() % 28);
    const int64_t a = 1 + up_to(most), b = 1 + up_to(most);
    int64_t v[3];
    for (int64_t &x : v) x = up_to(a + b) - (a + b) / 2;
    // Often nearly touching: then most bits cancel.
    if (round % 2 == 0) {
      v[0] = round % 4 == 0 ? a + b - up_to(3) : (a > b ? a - b : b - a) + up_to(3);
      v[1] = up_to(4);
      v[2] = up_to(4);
    }
    const int64_t U = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const int64_t outer = (a + b) * (a + b) - U;
    const int64_t inner = U - (a - b) * (a - b);
    if (outer < 0 || inner < 0) continue;
    using Real = hsp::Wide<double, 1>::Real;
    const auto lane = [](int64_t x) { return Real{static_cast<double>(x)}; };
    const hsp::EdgeLengths<hsp::Wide<double, 1>> lengths(lane(a), lane(b), {lane(v[0]), lane(v[1]), lane(v[2])});
    const hsp::EdgeAngle<hsp::Wide<double, 1>> edge = lengths.angle();
    const double product = 0.5 * std::sqrt(static_cast<double>(outer) * static_cast<double>(inner));
    const double cosine = 0.25 * static_cast<double>(outer - inner);
    ASSERT_EQ(lengths.square_of_distance[0], static_cast<double>(U));
    ASSERT_EQ(edge.product[0], product);
    ASSERT_EQ(edge.cosine[0], cosine);
    ASSERT_EQ(edge.is_proper[0] != 0, product > 0.0);
    if (product > 0.0) {
      const double beta = std::atan2(product, cosine);
      ASSERT_NEAR(edge.beta[0], beta, 8 * 0x1p-53 * beta);
    } else {
      ASSERT_EQ(edge.beta[0], 0.0);
    }
    proper += product > 0.0 ? 1U : 0U;
    cancelled += static_cast<double>(outer) < 0x1p-20 * static_cast<double>(U) ? 1U : 0U;
  }
  EXPECT_GT(proper, 50000U);
  EXPECT_GT(cancelled, 1000U);
}

TEST(EdgeKernel, FindsWhatIsNoMultiple) {
  std::mt19937_64 random(5);
  const auto expect = [](const std::vector<double> &numbers, double unit, bool expected) {
    const auto count = static_cast<uint32_t>(numbers.size());
    ASSERT_EQ(hsp::EdgeKernel<1>::are_multiples(numbers.data(), count, unit), expected);
    for (const hsp::Target target : runnable_targets()) {
      ASSERT_EQ(hsp::are_multiples(target, numbers.data(), count, unit), expected);
    }
  };
  for (int round = 0; round < 500; ++round) {
    const int64_t unit = INT64_C(1) << (round % 6);
    const int64_t most = ((INT64_C(1) << (1 + random() % 50)) + unit - 1) / unit;
    std::vector<double> numbers(random() % 11);
    for (double &x : numbers) {
      x = static_cast<double>(unit * (static_cast<int64_t>(random() % static_cast<uint64_t>(2 * most + 1)) - most));
    }
    expect(numbers, static_cast<double>(unit), true);
    if (numbers.empty() || unit == 1) continue;
    const auto off = static_cast<double>(1 + random() % static_cast<uint64_t>(unit - 1));
    numbers[random() % numbers.size()] += random() % 2 == 0 ? off : -off;
    expect(numbers, static_cast<double>(unit), false);
  }
}

struct Results {
  double mean;
  hsp::EdgeSums sums;
  EdgeBatch edges;
};

struct Kernel {
  std::function<double(const hsp::BallOfSet &, const ArcBatch &)> sum;
  std::function<hsp::EdgeSums(double, const ArcBatch &, double, EdgeBatch &)> differentiate;

  [[nodiscard]] Results run(const hsp::BallOfSet &ball, const ArcBatch &arcs, const EdgeBatch &weights) const {
    Results results{sum(ball, arcs), {}, weights};
    results.sums = differentiate(ball.r, arcs, 0.375, results.edges);
    return results;
  }
};

template <uint32_t n>
Kernel kernel() {
  using K = hsp::EdgeKernel<n>;
  return {K::sum_edges, K::differentiate};
}
Kernel kernel_of(hsp::Target target) {
  return {[=](const hsp::BallOfSet &ball, const ArcBatch &arcs) { return hsp::sum_edges(target, ball, arcs); },
          [=](double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges) {
            return hsp::differentiate_edges(target, radius, arcs, weight, edges);
          }};
}

void expect_same(const Results &a, const Results &b, uint32_t slots) {
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.sums.mean, b.sums.mean);
  EXPECT_EQ(a.sums.radius, b.sums.radius);
  for (size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(a.sums.centre[axis], b.sums.centre[axis]);
  for (uint32_t s = 0; s < slots; ++s) {
    EXPECT_EQ(a.edges.pull[s], b.edges.pull[s]);
    EXPECT_EQ(a.edges.force[s], b.edges.force[s]);
    EXPECT_EQ(a.edges.force_by_previous[s], b.edges.force_by_previous[s]);
  }
}

TEST(EdgeKernel, GivesTheSameBitsForEveryWidth) {
  oracle::RandomSource random(17);
  uint32_t arcs_seen = 0;
  for (int set = 0; set < 300; ++set) {
    const size_t n = static_cast<size_t>(random.in(2, 16));
    BuiltBoundary built(set % 2 == 0 ? oracle::loose_balls(random, n) : oracle::any_balls(random, n));
    if (built.status() != hsp::Status::ok) continue;
    for (uint32_t i = 0; i < built.balls().n; ++i) {
      const hsp::BallOfSet ball = ball_of_set(built.balls(), i);
      hsp::ArcBatches batches(built.balls(), built.boundary(), i);
      while (batches.next()) {
        const ArcBatch &arcs = batches.batch();
        EdgeBatch weights{};
        weights.has_weights = set % 4 < 2;
        for (uint32_t s = 0; s < arcs.count; ++s) weights.weight[s] = 0.25 + 0.125 * (arcs.other[s] % 8);
        // Slots behind the last arc are filled for as many lanes as the target has.
        const Results own = kernel<hsp::register_lanes>().run(ball, arcs, weights);
        EXPECT_TRUE(std::isfinite(own.mean));
        EXPECT_TRUE(std::isfinite(own.sums.mean));
        EXPECT_TRUE(std::isfinite(own.sums.radius));
        for (const double x : own.sums.centre) EXPECT_TRUE(std::isfinite(x));
        expect_same(kernel<1>().run(ball, arcs, weights), own, arcs.count);
        for (const hsp::Target target : runnable_targets()) {
          expect_same(kernel_of(target).run(ball, arcs, weights), own, arcs.count);
        }
        arcs_seen += arcs.count;
      }
    }
    if (HasFailure()) FAIL() << "set " << set;
  }
  EXPECT_GT(arcs_seen, 2000U);
}

}  // namespace
