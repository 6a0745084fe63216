// The kernels over arcs for registers of one, two and four doubles: the same bits from each, in every slot and sum.
#include "measure/arc_kernel.hpp"
#include "runnable_targets.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <random>
#include <vector>

namespace {

using hsp::ArcBatch;

// A ball and others around it, some too far away or too close for a proper circle, and a batch of half-edges at random,
// which need not be any that a boundary has.
class RandomArcs {
 public:
  explicit RandomArcs(std::mt19937 &random) {
    std::uniform_real_distribution<double> fraction(0.0, 1.0);
    const auto below = [&random](uint32_t n) { return static_cast<uint32_t>(random() % n); };
    for (uint32_t j = 0; j < 12; ++j) {
      xs_.push_back(std::floor(4000 * fraction(random)));
      ys_.push_back(std::floor(4000 * fraction(random)));
      zs_.push_back(std::floor(4000 * fraction(random)));
      rs_.push_back(std::floor(3000 * fraction(random)));
    }
    batch_.count = 1 + below(ArcBatch::capacity);
    batch_.has_weights = below(2) == 0;
    for (uint32_t s = 0; s < ArcBatch::room; ++s) {
      // Slots behind the last are read, too.
      const uint32_t behind = s >= batch_.count ? batch_.count - 1 : s;
      batch_.other[s] = behind < s ? batch_.other[behind] : 1 + below(11);
      batch_.previous[s] = below(batch_.count);
      batch_.next[s] = below(batch_.count);
      batch_.arc[s] = behind < s || below(8) == 0 ? 0 : -1;
      batch_.root_discriminant[s] = std::floor(4e9 * fraction(random) * fraction(random));
      batch_.other_weight[s] = fraction(random);
    }
  }
  [[nodiscard]] hsp::BallOfSet ball() const {
    return {xs_.data(), ys_.data(), zs_.data(), rs_.data(), xs_[0], ys_[0], zs_[0], rs_[0]};
  }
  [[nodiscard]] const ArcBatch &batch() const { return batch_; }

 private:
  std::vector<double> xs_, ys_, zs_, rs_;
  ArcBatch batch_;
};

struct Results {
  bool complete = false;
  ArcBatch batch, completed;
  hsp::AreaSums areas{};
  hsp::GradientSums gradient{};
};

struct Kernel {
  std::function<bool(const hsp::BallOfSet &, ArcBatch &)> evaluate;
  std::function<hsp::AreaSums(const ArcBatch &, double)> sum_areas;
  std::function<hsp::GradientSums(const ArcBatch &, double, double)> sum_gradient;
  std::function<void(ArcBatch &)> complete_arcs;

  [[nodiscard]] Results run(const RandomArcs &arcs) const {
    Results results;
    results.batch = arcs.batch();
    const hsp::BallOfSet ball = arcs.ball();
    results.complete = evaluate(ball, results.batch);
    // Vertices that doubles did not serve are found elsewhere; here they become anything.
    results.completed = results.batch;
    for (uint32_t s = 0; s < results.batch.count; ++s) {
      double &x = results.completed.px[s];
      if (x != x) {
        x = 500.0 + s;
        results.completed.py[s] = -100.0;
        results.completed.pz[s] = 7.0 * s;
      }
    }
    complete_arcs(results.completed);
    // And so does all the rest.
    ArcBatch found = results.batch;
    for (uint32_t s = 0; s < ArcBatch::room; ++s) {
      for (double *field : {&found.twice_height[s], &found.angle[s]}) {
        if (s >= found.count || *field != *field) *field = s < found.count ? 0.75 : found.twice_height[found.count - 1];
      }
      if (s >= found.count) found.angle[s] = found.Xx[s] = found.Xy[s] = found.Xz[s] = 0.0;
      if (s >= found.count) found.ux[s] = found.uy[s] = found.uz[s] = found.inverse_distance[s] = 0.5;
    }
    results.areas = sum_areas(found, ball.r);
    results.gradient = sum_gradient(found, ball.r, 0.375);
    return results;
  }
};

template <uint32_t n>
Kernel kernel() {
  using K = hsp::ArcKernel<n>;
  return {K::evaluate, K::sum_areas, K::sum_gradient, K::complete_arcs};
}
Kernel kernel_of(hsp::Target target) {
  return {[=](const hsp::BallOfSet &ball, ArcBatch &batch) { return hsp::evaluate_arcs(target, ball, batch); },
          [=](const ArcBatch &batch, double radius) { return hsp::sum_areas(target, batch, radius); },
          [=](const ArcBatch &batch, double radius, double weight) {
            return hsp::sum_gradient(target, batch, radius, weight);
          },
          [=](ArcBatch &batch) { hsp::complete_arcs(target, batch); }};
}

// Any NaN is the same: which of two a sum takes is up to the compiler.
void expect_same(double a, double b, const char *what) {
  if (a != a && b != b) return;
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0) << what << ": " << a << " " << b;
}

void expect_same(const ArcBatch &a, const ArcBatch &b) {
  expect_same(a.exterior_angles, b.exterior_angles, "exterior angles");
  expect_same(a.exterior_turns, b.exterior_turns, "whole turns");
  for (uint32_t s = 0; s < a.count; ++s) {
    const auto fields = [s](const ArcBatch &x) {
      return std::array{x.ux[s],           x.uy[s], x.uz[s], x.inverse_distance[s],
                        x.twice_height[s], x.px[s], x.py[s], x.pz[s],
                        x.angle[s],        x.Xx[s], x.Xy[s], x.Xz[s]};
    };
    for (size_t k = 0; k < fields(a).size(); ++k) expect_same(fields(a)[k], fields(b)[k], "slot");
  }
}

void expect_same(const hsp::AreaSums &a, const hsp::AreaSums &b) {
  expect_same(a.cosines, b.cosines, "cosines");
  for (size_t axis = 0; axis < 3; ++axis) expect_same(a.vector_area[axis], b.vector_area[axis], "vector area");
}

void expect_same(const Results &a, const Results &b) {
  EXPECT_EQ(a.complete, b.complete);
  expect_same(a.batch, b.batch);
  expect_same(a.completed, b.completed);
  expect_same(a.areas, b.areas);
  expect_same(a.gradient.areas, b.areas);
  expect_same(a.gradient.weighted.radius, b.gradient.weighted.radius, "by radius");
  for (size_t axis = 0; axis < 3; ++axis) {
    expect_same(a.gradient.weighted.centre[axis], b.gradient.weighted.centre[axis], "by centre");
  }
}

// Arcs that have an angle only in the second batch, those that have one in both, which is the same, and those that have
// one in neither.
struct Completed {
  uint32_t now = 0, before = 0, never = 0;

  void count(const Results &results) {
    for (uint32_t s = 0; s < results.batch.count; ++s) {
      const double angle = results.batch.angle[s], completed = results.completed.angle[s];
      if (angle == angle) {
        EXPECT_EQ(angle, completed);
        EXPECT_EQ(results.batch.Xx[s], results.completed.Xx[s]);
        ++before;
      } else if (completed == completed) {
        // Not on a circle that doubles do not serve.
        EXPECT_EQ(results.batch.twice_height[s], results.batch.twice_height[s]);
        ++now;
      } else {
        ++never;
      }
    }
  }
};

TEST(ArcKernel, GivesTheSameBitsForEveryWidth) {
  std::mt19937 random(5);
  uint32_t complete = 0;
  uint32_t arcs_served = 0;
  Completed completed;
  for (int round = 0; round < 3000; ++round) {
    const RandomArcs arcs(random);
    const Results two = kernel<2>().run(arcs);
    expect_same(kernel<1>().run(arcs), two);
    for (const hsp::Target target : runnable_targets()) expect_same(kernel_of(target).run(arcs), two);
    complete += two.complete ? 1U : 0U;
    completed.count(two);
    for (uint32_t s = 0; s < two.batch.count; ++s) arcs_served += two.batch.angle[s] > 0.0 ? 1U : 0U;
    if (HasFailure()) FAIL() << "round " << round;
  }
  EXPECT_GT(arcs_served, 3000U);
  EXPECT_LT(complete, 3000U);
  EXPECT_GT(completed.now, 3000U);
  EXPECT_GT(completed.before, 3000U);
  EXPECT_GT(completed.never, 3000U);
}

}  // namespace
