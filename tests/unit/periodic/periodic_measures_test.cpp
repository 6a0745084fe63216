// Derivatives by the balls and by the box against difference quotients, and the laws that tie them together; balls that
// touch others from inside, across the faces of a box.
#include "periodic/periodic_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "built_periodic.hpp"
#include "slice_quadrature.hpp"
#include "weighted_box.hpp"

namespace {

constexpr double tolerance = 2e-4;

double weighted_area(const WeightedBox &set, const BuiltPeriodic &periodic) {
  double sum = 0.0;
  for (uint32_t i = 0; i < periodic.balls(); ++i) sum += set.weights[i] * periodic.of_ball(i).area;
  return sum;
}

struct Values {
  double area, volume;
};

Values values_of(const WeightedBox &set) {
  const BuiltPeriodic built = set.built();
  EXPECT_EQ(built.status(), hsp::Status::ok);
  return {weighted_area(set, built), built.totals().volume};
}

// A difference quotient of fourth order, for a set that is changed by e. Places are rounded, so that e must be large.
template <class Change>
Values quotient(const WeightedBox &set, Change change) {
  constexpr double e = 1e-3;
  Values sum{0, 0};
  for (const auto &[times, factor] : {std::array{-2.0, 1.0}, {-1.0, -8.0}, {1.0, 8.0}, {2.0, -1.0}}) {
    WeightedBox changed = set;
    change(changed, times * e);
    const Values values = values_of(changed);
    sum.area += factor * values.area;
    sum.volume += factor * values.volume;
  }
  return {sum.area / (12 * e), sum.volume / (12 * e)};
}

TEST(PeriodicMeasures, DeriveByTheStrainAndTheBox) {
  oracle::RandomSource random(331);
  for (int trial = 0; trial < 6; ++trial) {
    const WeightedBox set(random, 6);
    const BuiltPeriodic built = set.built();
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::AreaWeights weights = hsp::weights_in_box(built.get(), set.weights.data(), hsp::TouchingBalls::meet);
    const hsp::Strain area = hsp::area_by_strain(built.get(), weights);
    const hsp::Strain volume = hsp::volume_by_strain(built.get());
    const hsp::exact::Lattice &lattice = built->images().lattice();
    for (size_t p = 0; p < 3; ++p) {
      for (size_t q = p; q < 3; ++q) {
        const Values found = quotient(set, [&](WeightedBox &s, double e) { s.strain(p, q, e); });
        EXPECT_NEAR(lattice.area(area.by[3 * p + q]), found.area, tolerance);
        EXPECT_NEAR(lattice.volume(volume.by[3 * p + q]), found.volume, tolerance);
      }
    }
    // By the vectors of the box, at fixed multiples.
    const hsp::Strain area_by_box = hsp::by_box(built->images().box(), area);
    const hsp::Strain volume_by_box = hsp::by_box(built->images().box(), volume);
    for (const size_t k : {0U, 3U, 4U, 6U, 7U, 8U}) {
      const Values found = quotient(set, [&](WeightedBox &s, double e) { s.change_box(k, e); });
      EXPECT_NEAR(lattice.length(area_by_box.by[k]), found.area, tolerance);
      EXPECT_NEAR(lattice.area(volume_by_box.by[k]), found.volume, tolerance);
    }
  }
}

TEST(PeriodicMeasures, DeriveByCentresAndRadii) {
  oracle::RandomSource random(332);
  for (int trial = 0; trial < 6; ++trial) {
    const WeightedBox set(random, 5);
    const BuiltPeriodic built = set.built();
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::AreaWeights weights = hsp::weights_in_box(built.get(), set.weights.data(), hsp::TouchingBalls::meet);
    const hsp::exact::Lattice &lattice = built->images().lattice();
    hsp::Vec3 sum{0.0, 0.0, 0.0};
    double by_radii = 0.0, volume_by_radii = 0.0;
    for (uint32_t i = 0; i < built.balls(); ++i) {
      const hsp::BallGradient own = hsp::gradient_in_box(built.get(), weights, i);
      const double centre[3] = {own.centre.x, own.centre.y, own.centre.z};
      const double vector_area[3] = {own.vector_area.x, own.vector_area.y, own.vector_area.z};
      sum = sum + own.vector_area;
      by_radii += set.balls.radius[i] * lattice.length(own.radius);
      volume_by_radii += set.balls.radius[i] * lattice.area(own.measure.area);
      for (size_t axis = 0; axis < 3; ++axis) {
        const Values found = quotient(set, [&](WeightedBox &s, double e) { s.balls.xyz[3 * i + axis] += e; });
        EXPECT_NEAR(lattice.length(centre[axis]), found.area, tolerance);
        EXPECT_NEAR(lattice.area(vector_area[axis]), found.volume, tolerance);
      }
      const Values found = quotient(set, [&](WeightedBox &s, double e) { s.balls.radius[i] += e; });
      EXPECT_NEAR(lattice.length(own.radius), found.area, tolerance);
      EXPECT_NEAR(lattice.area(own.measure.area), found.volume, tolerance);
    }
    // The torus moved as a whole; everything grown alike.
    EXPECT_NEAR(std::sqrt(lattice.area(lattice.area(dot(sum, sum)))), 0.0, 1e-11);
    const double area = weighted_area(set, built);
    const double volume = built.totals().volume;
    EXPECT_NEAR(lattice.area(hsp::area_by_strain(built.get(), weights).trace()) + by_radii, 2 * area, 1e-10);
    EXPECT_NEAR(lattice.volume(hsp::volume_by_strain(built.get()).trace()) + volume_by_radii, 3 * volume, 1e-10);
  }
}

// Derivatives that another program computed with 113 bits: of the volume along the axes, and the trace of the area's.
TEST(PeriodicMeasures, HaveTheReferenceStrains) {
  constexpr BoxVectors cube{4, 0, 0, 0, 4, 0, 0, 0, 4}, skew{4, 0, 0, 1.25, 4.5, 0, -1.5, 0.75, 3.75};
  struct {
    std::vector<std::array<double, 4>> balls;
    BoxVectors box;
    double volume[3], area;
  } const references[] = {
      {{{1, 2, 3, 1.5}}, cube, {0, 0, 0}, 0},
      {{{1, 2, 3, 2.25}}, cube, {13.351768777757, 13.351768777757, 13.351768777757}, 169.64600329385},
      {{{0, 0, 0, 1.25}, {2, 0, 0, 1.25}}, cube, {7.068583470577, 0, 0}, 31.415926535898},
      {{{0, 0, 0, 1.5}, {2, 1.25, 0.5, 1.75}},
       skew,
       {12.246073841633, 4.783622594388, 0.76537961510208},
       48.702313403074},
      {{{0, 0, 0, 1.75}, {2, 2, 0, 1.25}}, cube, {4.3040428463409, 4.3040428463409, 0}, 103.29702831218}};
  for (const auto &reference : references) {
    support::BallList balls;
    for (const auto &b : reference.balls) balls.add(b[0], b[1], b[2], b[3]);
    const BuiltPeriodic built(balls, reference.box, 0.0, 0.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::exact::Lattice &lattice = built->images().lattice();
    const hsp::Strain volume = hsp::volume_by_strain(built.get());
    const hsp::AreaWeights weights = hsp::weights_in_box(built.get(), nullptr, hsp::TouchingBalls::meet);
    const hsp::Strain area = hsp::area_by_strain(built.get(), weights);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(lattice.volume(volume.by[4 * k]), reference.volume[k], 1e-11);
    EXPECT_NEAR(lattice.area(area.trace()), reference.area, 1e-10);
  }
}

// Areas of balls and the volume of their union by slices, from explicit copies around a box in which nothing wraps.
TEST(PeriodicMeasures, AreThoseOfSlices) {
  oracle::RandomSource random(333);
  for (int trial = 0; trial < 3; ++trial) {
    const WeightedBox set(random, 2);
    const BuiltPeriodic built = set.built();
    ASSERT_EQ(built.status(), hsp::Status::ok);
    std::vector<oracle::RealBall> copies;
    const hsp::exact::Lattice &lattice = built->images().lattice();
    // In the box first, then what surrounds them.
    for (int layer = 0; layer < 2; ++layer) {
      for (int a = -2; a <= 2; ++a) {
        for (int b = -2; b <= 2; ++b) {
          for (int c = -2; c <= 2; ++c) {
            if ((a == 0 && b == 0 && c == 0) != (layer == 0)) continue;
            for (uint32_t i = 0; i < built.balls(); ++i) {
              const hsp::exact::LatticeBall ball = built->balls().ball(built->grid().grid_index(i));
              const double times[3] = {static_cast<double>(a), static_cast<double>(b), static_cast<double>(c)};
              long double at[3] = {lattice.length(static_cast<double>(ball.centre.x)),
                                   lattice.length(static_cast<double>(ball.centre.y)),
                                   lattice.length(static_cast<double>(ball.centre.z))};
              for (size_t row = 0; row < 3; ++row) {
                for (size_t k = 0; k < 3; ++k) at[k] += times[row] * set.box[3 * row + k];
              }
              const long double r = lattice.length(static_cast<double>(ball.radius));
              bool near = layer == 0;
              for (uint32_t k = 0; k < built.balls() && !near; ++k) {
                const oracle::RealBall &own = copies[k];
                near = std::hypot(at[0] - own.x, at[1] - own.y, at[2] - own.z) <= r + own.radius;
              }
              if (near) copies.push_back({at[0], at[1], at[2], r});
            }
          }
        }
      }
    }
    const oracle::SliceMeasures slices = oracle::measure_by_slices(copies);
    for (uint32_t i = 0; i < built.balls(); ++i) {
      EXPECT_NEAR(built.of_ball(i).area, static_cast<double>(slices.ball_area[i]), 2e-7);  // the box is on the lattice
    }
  }
}

using Pairs = std::set<std::pair<uint32_t, uint32_t>>;

Pairs pairs_of(const support::BallList &balls) {
  const BuiltPeriodic built(balls, {16, 0, 0, 4, 16, 0, 0, -4, 16});
  EXPECT_EQ(built.status(), hsp::Status::ok);
  Pairs pairs;
  hsp::for_each_inner_tangency_in_box(built.get(), [&](uint32_t inner, uint32_t outer) {
    EXPECT_TRUE(pairs.insert({inner, outer}).second);
  });
  return pairs;
}

// The inner ball is one box away, and reaches the border of the outer one at x = 4; a third ball may cover that point.
TEST(PeriodicTangency, IsThatOfImages) {
  support::BallList balls;
  balls.add(0, 0, 0, 4);
  balls.add(18, 0, 0, 2);
  EXPECT_EQ(pairs_of(balls), (Pairs{{1, 0}}));
  balls.add(8, 12, 16, 1);  // at 4, 0, 0 and b and c from there
  EXPECT_EQ(pairs_of(balls), Pairs{});
  support::BallList deep;
  deep.add(0, 0, 0, 4);
  deep.add(17, 0, 0, 2);
  EXPECT_EQ(pairs_of(deep), Pairs{});
}

// Of equal balls the one without faces is named, once: if the other has some.
TEST(PeriodicTangency, OfEqualBallsIsThatOfOne) {
  support::BallList balls;
  balls.add(1, 1, 1, 3);
  balls.add(17, 1, 1, 3);
  const Pairs pairs = pairs_of(balls);
  EXPECT_EQ(pairs.size(), 1U);
  EXPECT_TRUE((pairs == Pairs{{0, 1}} || pairs == Pairs{{1, 0}}));
  balls.add(1, 1, 1, 5);
  EXPECT_EQ(pairs_of(balls), Pairs{});
}

}  // namespace
