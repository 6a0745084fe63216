// The quantities of the filter (exact/filter.hpp) at the worst inputs a search finds, against exact values, in units of
// the stated error bounds. The filter tells no values, only whether they are beyond a bound; so its values are found
// by bisection over bounds, and it is the filter's own arithmetic that is measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "exact/filter.hpp"
#include "filter_bounds_search.hpp"

namespace {

using namespace filter_bounds;
using hsp::exact::FilterBounds;
using hsp::exact::Plane;
using hsp::exact::PointStatus;
using hsp::exact::Sphere;
using perturbation::HalfSpace;
using perturbation::Integer;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The number |x| for which sign_beyond(bound) is the sign of x if |x| > bound and 0 if not, with that sign.
template <class SignBeyond>
double value_behind(const SignBeyond &sign_beyond) {
  const int sign = sign_beyond(0.0);
  if (sign == 0) return 0.0;
  uint64_t below = 0;  // |x| is beyond the double with this pattern
  uint64_t not_below = std::bit_cast<uint64_t>(infinity);
  while (not_below - below > 1) {
    const uint64_t middle = below + (not_below - below) / 2;
    (sign_beyond(std::bit_cast<double>(middle)) != 0 ? below : not_below) = middle;
  }
  return sign * std::bit_cast<double>(not_below);
}

double filter_value_D(const Sphere &sphere, const Plane &P, const Plane &Q) {
  return value_behind([&](double bound) {
    FilterBounds bounds{};
    bounds.D = bound;
    return hsp::exact::filter_crossing(bounds, sphere, P, Q);
  });
}

double filter_value_beta(const Plane &P, const Plane &R) {
  return value_behind([&](double bound) {
    FilterBounds bounds{};
    bounds.beta = bound;
    return -hsp::exact::filter_side(bounds, P, R);
  });
}

// Bounds of -1 make every sign certain, so that nothing but the quantity in question decides.
double filter_value_F(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R) {
  return value_behind([&](double bound) {
    const FilterBounds bounds{0.0, -1.0, bound, -1.0, 0.0, 0.0};
    PointStatus status{};
    if (!hsp::exact::filter_point_status(bounds, sphere, P, Q, R, status)) return 0;
    return status.side[0] == status.side[1] ? -1 : 1;
  });
}

double filter_value_B(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R) {
  return value_behind([&](double bound) {
    const FilterBounds bounds{0.0, 0.0, -infinity, bound, 0.0, 0.0};  // F counts as certainly positive
    PointStatus status{};
    return hsp::exact::filter_point_status(bounds, sphere, P, Q, R, status) ? status.side[1] : 0;
  });
}

// Only where F < 0, for the filter asks for A nowhere else.
double filter_value_A(const Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R) {
  return value_behind([&](double bound) {
    const FilterBounds bounds{0.0, bound, 0.0, -1.0, 0.0, 0.0};
    PointStatus status{};
    return hsp::exact::filter_point_status(bounds, sphere, P, Q, R, status) ? status.side[1] : 0;
  });
}

struct Exactly {
  explicit Exactly(const FourBalls &four)
      : balls(as_given(four)),
        origin(balls, 0),
        P(perturbation::half_space(balls, 0, 1)),
        Q(perturbation::half_space(balls, 0, 2)),
        R(perturbation::half_space(balls, 0, 3)) {}
  perturbation::Balls balls;
  perturbation::Origin origin;
  HalfSpace P, Q, R;
};

double error_in_bounds(double computed, const Integer &exact, double bound) {
  const Integer error = Integer::from_double(computed) - exact;
  return static_cast<double>(std::fabs(error.to_long_double())) / bound;
}

FilterBounds bounds_of(const FourBalls &four) {
  return FilterBounds::for_length_squared(four.length_squared());
}

void expect_between(const char *name, double worst) {
  testing::Test::RecordProperty(name, std::to_string(worst));
  std::cout << "  worst error of " << name << ": " << worst << " of its bound\n";
  EXPECT_LT(worst, 1.0) << name << ": the bound does not hold";
  EXPECT_GT(worst, 0.01) << name << ": the bound is so wide that the filter passes on what it could answer";
}

constexpr int starts = 60;
constexpr int changes = 4000;

TEST(FilterBounds, DiscriminantD) {
  oracle::RandomSource random(201);
  expect_between("D", worst(random, starts, changes, [](const FourBalls &four) {
                   const Exactly exactly(four);
                   const double computed = filter_value_D(four.sphere(), four.plane(1), four.plane(2));
                   return error_in_bounds(computed, exactly.origin.D(exactly.P, exactly.Q), bounds_of(four).D);
                 }));
}

TEST(FilterBounds, RadicalCoordinateBeta) {
  oracle::RandomSource random(202);
  expect_between("beta", worst(random, starts, changes, [](const FourBalls &four) {
                   const Exactly exactly(four);
                   const double computed = filter_value_beta(four.plane(1), four.plane(3));
                   return error_in_bounds(computed, exactly.origin.beta(exactly.P, exactly.R), bounds_of(four).beta);
                 }));
}

TEST(FilterBounds, TripleProductB) {
  oracle::RandomSource random(203);
  expect_between("B", worst(random, starts, changes, [](const FourBalls &four) {
                   const Exactly exactly(four);
                   const double computed = filter_value_B(four.sphere(), four.plane(1), four.plane(2), four.plane(3));
                   return error_in_bounds(computed, exactly.origin.B(exactly.P, exactly.Q, exactly.R),
                                          bounds_of(four).B);
                 }));
}

TEST(FilterBounds, AttachmentA) {
  oracle::RandomSource random(204);
  expect_between("A", worst(random, starts, changes, [](const FourBalls &four) {
                   const Exactly exactly(four);
                   if (filter_value_F(four.sphere(), four.plane(1), four.plane(2), four.plane(3)) >= 0.0) {
                     return -1.0;
                   }
                   const double computed = filter_value_A(four.sphere(), four.plane(1), four.plane(2), four.plane(3));
                   return error_in_bounds(computed, exactly.origin.A(exactly.P, exactly.Q, exactly.R),
                                          bounds_of(four).A);
                 }));
}

TEST(FilterBounds, SizeF) {
  oracle::RandomSource random(205);
  expect_between("F", worst(random, starts, changes, [](const FourBalls &four) {
                   const Exactly exactly(four);
                   const double computed = filter_value_F(four.sphere(), four.plane(1), four.plane(2), four.plane(3));
                   return error_in_bounds(computed, exactly.origin.F(exactly.P, exactly.Q, exactly.R),
                                          bounds_of(four).F);
                 }));
}

}  // namespace
