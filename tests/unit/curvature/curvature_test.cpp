// Integrated curvatures against reference values that another program computed with 113 bits, closed forms, the Euler
// characteristic, difference quotients, and laws.
#include "curvature/curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_union.hpp"
#include "lattice_lengths.hpp"
#include "measure/input_order.hpp"
#include "molecule_file.hpp"
#include "random_balls.hpp"
#include "sweep_length.hpp"

namespace {

constexpr double step = 1e-8;

class Built : public BuiltUnion {
 public:
  using BuiltUnion::BuiltUnion;

  double mean() const {
    double sum = 0.0;
    for (uint32_t i = 0; i < balls().n; ++i) sum += hsp::curvature_of_ball(balls(), boundary(), i).mean;
    return balls().lattice.length(sum);
  }
  int64_t gauss() const {
    int64_t sum = 0;
    for (uint32_t i = 0; i < balls().n; ++i) sum += hsp::curvature_of_ball(balls(), boundary(), i).gauss;
    return sum;
  }
  hsp::CurvedSet set() const { return hsp::curved_set(balls(), boundary()); }
  hsp::MeanCurvatureGradient gradient(uint32_t i, const hsp::AreaWeights &weights) const {
    return gradient(i, weights, set());
  }
  hsp::MeanCurvatureGradient gradient(uint32_t i, const hsp::AreaWeights &weights, const hsp::CurvedSet &of) const {
    return hsp::curved_gradient_of_ball(balls(), boundary(), weights, ball(i), of).curvature;
  }
  double weighted_mean(const hsp::AreaWeights &weights) const {
    double sum = 0.0;
    for (uint32_t i = 0; i < balls().n; ++i) sum += gradient(i, weights).mean;
    return balls().lattice.length(sum);
  }
};

support::BallList list_of(const std::vector<std::array<double, 4>> &given) {
  support::BallList balls;
  for (const auto &[x, y, z, r] : given) balls.add(x, y, z, r);
  return balls;
}

TEST(Curvature, HasTheReferenceValues) {
  const struct {
    support::BallList balls;
    double mean;
    int64_t gauss;  // over 4 pi
  } references[] = {
      {list_of({{0, 0, 0, 1}, {1, 0, 0, 1}}), 16.0004465426567, 1},
      {list_of({{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}), 18.6848279234850, 1},
      {list_of({{0, 0, 0, 1}, {1, 0, 0, 1}, {0.3, 0.9, 0, 1}, {0.2, 0.4, 0.8, 1.1}}), 19.3887479300771, 1},
      {list_of({{0, 0, 0, 1}, {0, 0, 0, 1}, {0.25, 0, 0, 0.75}, {1, 0, 0, 1}, {3, 0, 0, 1}}), 28.5668171570158, 1},
      {list_of({{0, 0, 0, 2}, {10, 0, 0, 0}}), 8 * hsp::pi, 2},
  };
  for (const auto &reference : references) {
    const Built built(reference.balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_NEAR(built.mean(), reference.mean, 2e-13);
    EXPECT_EQ(built.gauss(), 12 * reference.gauss);
    EXPECT_NEAR(built.weighted_mean({}), reference.mean, 2e-13);
  }
  support::BallList cube, centred;
  for (int k = 0; k < 8; ++k) {
    const double x = k & 1, y = (k >> 1) & 1, z = (k >> 2) & 1;
    cube.add(x, y, z, 0.9);
    centred.add(2 * x - 1, 2 * y - 1, 2 * z - 1, 1.5);
  }
  centred.add(0, 0, 0, 1);
  EXPECT_NEAR(Built(cube).mean(), 21.6752371415072, 2e-13);
  EXPECT_NEAR(Built(centred).mean(), 39.2518845725923, 3e-13);
}

TEST(Curvature, OfCrambinHasTheReferenceValues) {
  const support::BallList balls =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  const struct {
    double probe, mean, length, by_probe;
    int64_t gauss;
  } references[] = {{0.0, 1075.92293580892, 184.271935563057, -1981.00371176851, -34},
                    {1.4, 250.028140463776, 19.0380208186020, 6.71925911667347, 2}};
  for (const auto &reference : references) {
    const Built built(balls, reference.probe, 0.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_NEAR(built.mean(), reference.mean, 5e-11);
    EXPECT_EQ(built.gauss(), 12 * reference.gauss);
    double square = 0.0, by_probe = 0.0;
    hsp::Vec3 sum{0.0, 0.0, 0.0};
    for (uint32_t i = 0; i < balls.size(); ++i) {
      const hsp::MeanCurvatureGradient gradient = built.gradient(i, {});
      square += dot(gradient.centre, gradient.centre);
      by_probe += gradient.radius;
      sum = sum + gradient.centre;
      EXPECT_FALSE(gradient.one_sided);
    }
    EXPECT_NEAR(std::sqrt(square), reference.length, 1e-11);
    EXPECT_NEAR(by_probe, reference.by_probe, 1e-9);
    EXPECT_NEAR(std::sqrt(dot(sum, sum)), 0.0, 1e-11);
  }
}

// Plain squares are taken where they are exact: the bits are those of exact ones.
TEST(Curvature, TakesPlainSquaresOfFewDecimals) {
  support::BallList balls =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  for (const double probe : {0.0, 1.4}) {
    const Built built(balls, probe, 0.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_TRUE(built.set().has_plain_squares);
    for (uint32_t i = 0; i < balls.size(); ++i) {
      const hsp::MeanCurvatureGradient plain = built.gradient(i, {}, {false, true});
      const hsp::MeanCurvatureGradient exact = built.gradient(i, {}, {false, false});
      ASSERT_EQ(plain.mean, exact.mean);
      ASSERT_EQ(plain.radius, exact.radius);
      ASSERT_EQ(plain.centre.x, exact.centre.x);
      ASSERT_EQ(plain.centre.y, exact.centre.y);
      ASSERT_EQ(plain.centre.z, exact.centre.z);
    }
  }
  for (const size_t k : {size_t{0}, balls.xyz.size() / 2, balls.xyz.size() - 1}) {
    const double x = balls.xyz[k];
    balls.xyz[k] += 1e-8;
    EXPECT_FALSE(Built(balls, 0.0, 0.0).set().has_plain_squares);
    balls.xyz[k] = x;
  }
  balls.radius.back() += 1e-8;
  EXPECT_FALSE(Built(balls, 0.0, 0.0).set().has_plain_squares);
  EXPECT_TRUE(Built(balls, 0.0, 1e-6).set().has_plain_squares);  // of small integers all squares are exact
}

TEST(Curvature, IsTwiceTheEulerCharacteristicForEverySet) {
  oracle::RandomSource random(31);
  for (int k = 0; k < 300; ++k) {
    const oracle::Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(1, 12)));
    const Built built(oracle::in_lengths(balls, 1), 0.0, 1.0);
    if (built.status() != hsp::Status::ok) continue;
    EXPECT_EQ(built.gauss(), 6 * built.boundary().euler());
    EXPECT_TRUE(std::isfinite(built.mean()));
    EXPECT_TRUE(std::isfinite(built.weighted_mean({})));
  }
}

// Not even where vertices have no derivative, four spheres or circles that touch meeting there.
TEST(Curvature, DoesNotChangeWhenAllBallsMoveTogether) {
  oracle::RandomSource random(34);
  uint32_t without_derivative = 0;
  const int sets = oracle::sets(2000);
  for (int k = 0; k < sets; ++k) {
    std::vector<std::array<double, 4>> balls(3 + random.below(10));
    for (auto &ball : balls) {
      for (size_t axis = 0; axis < 3; ++axis) ball[axis] = random.below(4);
      ball[3] = 1 + random.below(2);
    }
    const Built built(list_of(balls), 0.0, 1.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::Boundary &boundary = built.boundary();
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      without_derivative += boundary.root_discriminant(v) > 0.0 ? 0U : 1U;
    }
    double largest = 1.0;
    hsp::Vec3 sum{0.0, 0.0, 0.0};
    for (uint32_t i = 0; i < balls.size(); ++i) {
      const hsp::Vec3 centre = built.gradient(i, {}).centre;
      largest = std::max(largest, std::sqrt(dot(centre, centre)));
      sum = sum + centre;
    }
    EXPECT_NEAR(std::sqrt(dot(sum, sum)), 0.0, 1e-11 * largest) << "set " << k;
  }
  EXPECT_GT(without_derivative, static_cast<uint32_t>(sets / 40));
}

TEST(Curvature, HasTheDerivativesOfDifferenceQuotients) {
  oracle::RandomSource random(32);
  uint32_t compared = 0;
  for (int set = 0; set < 12; ++set) {
    const uint32_t n = 2 + random.below(6);
    std::vector<std::array<double, 4>> given(n);
    std::vector<double> sigma(n);
    for (uint32_t i = 0; i < n; ++i) {
      for (size_t axis = 0; axis < 3; ++axis) given[i][axis] = 1.8 * random.fraction();
      given[i][3] = 0.7 + 0.6 * random.fraction();
      sigma[i] = set % 3 == 0 ? 1.0 : random.fraction();
    }
    const hsp::AreaWeights weights{sigma.data(), hsp::TouchingBalls::meet};
    const Built built(list_of(given));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    // Not next to where an arc is born, as slopes are unbounded there.
    double least = 1.0;
    for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
      least = std::min(least, built.boundary().root_discriminant(v) * step * step * step);
    }
    if (least < 0.05) continue;
    hsp::Vec3 sum{0.0, 0.0, 0.0};
    double homogeneity = 0.0;
    for (uint32_t i = 0; i < n; ++i) {
      const hsp::MeanCurvatureGradient gradient = built.gradient(i, weights);
      const double found[4] = {gradient.centre.x, gradient.centre.y, gradient.centre.z, gradient.radius};
      for (size_t axis = 0; axis < 4; ++axis) {
        constexpr double h = 4e-6;
        double mean[2];
        for (int side = 0; side < 2; ++side) {
          std::vector<std::array<double, 4>> moved = given;
          moved[i][axis] += side == 0 ? -h : h;
          mean[side] = Built(list_of(moved)).weighted_mean(weights);
        }
        EXPECT_NEAR(found[axis], (mean[1] - mean[0]) / (2 * h), 3e-5 * (1.0 + std::fabs(found[axis])))
            << "set " << set << " ball " << i << " axis " << axis;
        ++compared;
        homogeneity += found[axis] * given[i][axis];
      }
      sum = sum + gradient.centre;
    }
    EXPECT_NEAR(std::sqrt(dot(sum, sum)), 0.0, 1e-11);
    EXPECT_NEAR(homogeneity, built.weighted_mean(weights), 1e-6);  // the lattice moves what is given by 1e-8
  }
  EXPECT_GT(compared, 60U);
}

// A ball's share is M with a weight of 1 for it alone.
TEST(Curvature, IsSharedAsItIsWeighted) {
  oracle::RandomSource random(33);
  for (int set = 0; set < 20; ++set) {
    const oracle::Balls balls = oracle::loose_balls(random, 8);
    const Built built(oracle::in_lengths(balls, 1), 0.0, 1.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    for (uint32_t i = 0; i < balls.size(); ++i) {
      std::vector<double> weight(balls.size(), 0.0);
      weight[i] = 1.0;
      const double share = hsp::curvature_of_ball(built.balls(), built.boundary(), built.ball(i)).mean;
      EXPECT_NEAR(built.weighted_mean({weight.data(), hsp::TouchingBalls::meet}), share, 1e-10);
    }
  }
}

TEST(Curvature, FlagsWhereItHasKinks) {
  const Built touching(list_of({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 5, 0, 1}}));
  EXPECT_TRUE(touching.gradient(0, {}).one_sided);
  EXPECT_TRUE(touching.gradient(1, {}).one_sided);
  EXPECT_FALSE(touching.gradient(2, {}).one_sided);
  // Four equal balls about a square: four spheres through one point.
  const Built square(list_of({{1, 1, 0, 1.5}, {1, -1, 0, 1.5}, {-1, 1, 0, 1.5}, {-1, -1, 0, 1.5}, {9, 0, 0, 1}}));
  EXPECT_TRUE(square.gradient(0, {}).one_sided);
  EXPECT_FALSE(square.gradient(4, {}).one_sided);
}

}  // namespace
