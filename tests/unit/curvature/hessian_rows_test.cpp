// Rows of a chain of three balls, as the drawing of the header has them, and their product.
#include "curvature/hessian_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "built_union.hpp"

namespace {

TEST(HessianRows, OfAChainOfThree) {
  const support::BallList balls({0, 0, 0, 1.5, 0.25, 0, 3, 0, 0.5}, {1, 1.25, 0.75});
  const BuiltUnion built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const hsp::CubeGrid &grid = built.grid();
  const hsp::Boundary &boundary = built.boundary();
  hsp::EnergyTerms terms;
  terms.tension = 1;
  terms.pressure = 0.5;

  std::vector<uint32_t> first(4), ball(7), flags(4, 9);
  std::vector<double> block(63, NAN);
  hsp::find_area_row_starts(grid, boundary, first.data());
  EXPECT_EQ(first, (std::vector<uint32_t>{0, 2, 5, 7}));
  ASSERT_TRUE(
      hsp::find_hessian_rows({}, grid, boundary, terms, {first.data(), ball.data(), block.data(), flags.data()}));
  EXPECT_EQ(ball, (std::vector<uint32_t>{0, 1, 0, 1, 2, 1, 2}));
  EXPECT_EQ(flags, (std::vector<uint32_t>{0, 0, 0, 0}));
  const auto entry = [&](uint32_t k, uint32_t p, uint32_t q) { return block[9 * k + 3 * p + q]; };
  for (uint32_t p = 0; p < 3; ++p) {
    for (uint32_t q = 0; q < 3; ++q) {
      EXPECT_NE(entry(1, p, p), 0.0);
      EXPECT_EQ(entry(1, p, q), entry(2, q, p));
      EXPECT_EQ(entry(4, p, q), entry(5, q, p));
      EXPECT_NEAR(entry(0, p, q), -entry(1, p, q), 1e-13);
      EXPECT_NEAR(entry(3, p, q), -entry(2, p, q) - entry(4, p, q), 1e-13);
      EXPECT_NEAR(entry(6, p, q), -entry(5, p, q), 1e-13);
    }
  }

  const std::vector<double> direction{1, 0, 0, 0, -2, 0, 0, 0, 0.5};
  std::vector<double> product(9, NAN);
  ASSERT_TRUE(hsp::multiply_by_hessian({}, grid, boundary, terms, direction.data(), product.data(), nullptr));
  for (uint32_t p = 0; p < 3; ++p) {
    EXPECT_NEAR(product[p], entry(0, p, 0) - 2 * entry(1, p, 1), 1e-12);
    EXPECT_NEAR(product[3 + p], entry(2, p, 0) - 2 * entry(3, p, 1) + 0.5 * entry(4, p, 2), 1e-12);
    EXPECT_NEAR(product[6 + p], -2 * entry(5, p, 1) + 0.5 * entry(6, p, 2), 1e-12);
  }
}

}  // namespace
