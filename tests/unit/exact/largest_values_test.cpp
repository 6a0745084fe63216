// The exact stage where its values are largest: a search drives D, A and F towards the bounds of exact/plane.hpp, on
// which the widths of the integers rest, and the signs must stay right on the way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "exact/exact_predicates.hpp"
#include "filter_bounds_search.hpp"

namespace {

using namespace filter_bounds;
using perturbation::Integer;
namespace exact = hsp::exact;

struct Values {
  Integer D, A, F;
  bool right = true;
};

template <class Predicates>
void compare(const FourBalls &four, const Values &values, const Integer &B, Values &result) {
  const exact::Sign crossing = Predicates::crossing(four.sphere(), four.plane(1), four.plane(2));
  if (values.D.sign() != 0 && crossing.sign != values.D.sign()) result.right = false;
  if (values.D.sign() <= 0) return;
  const exact::PointStatus status =
      Predicates::point_status(four.sphere(), four.plane(1), four.plane(2), four.plane(3));
  for (int point = 0; point < 2; ++point) {
    const int side = perturbation::Origin::point_sign(values.D, values.A, B, point == 1 ? 1 : -1);
    if (side != 0 && status.side[point] != side) result.right = false;
  }
}

Values values_at(const FourBalls &four) {
  const perturbation::Balls balls = as_given(four);
  const perturbation::Origin origin(balls, 0);
  const perturbation::HalfSpace P = perturbation::half_space(balls, 0, 1);
  const perturbation::HalfSpace Q = perturbation::half_space(balls, 0, 2);
  const perturbation::HalfSpace R = perturbation::half_space(balls, 0, 3);
  Values values{origin.D(P, Q), origin.A(P, Q, R), origin.F(P, Q, R)};
  const Integer B = origin.B(P, Q, R);
  compare<exact::ExactPredicates<uint32_t>>(four, values, B, values);
#if defined(__SIZEOF_INT128__)
  compare<exact::ExactPredicates<uint64_t>>(four, values, B, values);
#endif
  return values;
}

// In units of the power of 2^31 that the bound is a multiple of. Only values that predicates look at count, so that A
// and F are driven up where the circles cross.
void drive_up(const char *name, uint64_t seed, Integer Values::*value, int degree, double bound, double reached) {
  oracle::RandomSource random(seed);
  int wrong = 0;
  const double largest = worst(random, 200, 5000, [&](const FourBalls &four) {
    const Values values = values_at(four);
    wrong += !values.right;
    if (degree > 6 && values.D.sign() <= 0) return -1.0;
    return static_cast<double>(std::fabs(std::ldexp((values.*value).to_long_double(), -31 * degree)));
  });
  testing::Test::RecordProperty(name, std::to_string(largest));
  std::cout << "  largest |" << name << "|: " << largest << " of at most " << bound << '\n';
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(largest, bound);
  EXPECT_GT(largest, reached) << "the search stays far from the bound";
}

TEST(LargestValues, DiscriminantD) {
  drive_up("D", 501, &Values::D, 6, 4.0, 1.0);
}
TEST(LargestValues, AttachmentA) {
  drive_up("A", 502, &Values::A, 6, 3.0, 0.5);
}
TEST(LargestValues, SizeF) {
  drive_up("F", 503, &Values::F, 8, 9.0, 0.5);
}

}  // namespace
