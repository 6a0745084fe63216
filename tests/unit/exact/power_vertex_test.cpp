// Predicate near: a power vertex of four balls against a fifth. The exact stage, of one question and of a vertex of
// which many are asked, against a naive determinant for balls that are really inflated by tiny amounts, with both limb
// widths; the filter against the exact stage; the filter's error and the largest value at the worst inputs that a
// search finds, in units of their bounds.
//
// G is linear in the weights. They become w + sum of a_k 2^-192k with the amounts w, 1, the centre's coordinates, a
// quadratic form of them, and 1 at k = 7 + rank: with coefficients below 2^97 and amounts below 2^76 the first sum that
// is not 0 outweighs all later ones, and the value as given, an integer, all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>

#include "exact/chord_line.hpp"
#include "exact/filter.hpp"
#include "exact/power_vertex.hpp"
#include "filter_bounds_search.hpp"

namespace {

namespace exact = hsp::exact;
using exact::LatticeBall;
using exact::Plane;
using perturbation::Int128;
using perturbation::Integer;
using Narrow = exact::ExactPredicates<uint32_t>;
using NarrowLine = exact::ChordLine<uint32_t>;
using NarrowVertex = exact::PowerVertexOf<uint32_t>;
#if defined(__SIZEOF_INT128__)
using Wide = exact::ExactPredicates<uint64_t>;
using WideLine = exact::ChordLine<uint64_t>;
using WideVertex = exact::PowerVertexOf<uint64_t>;
#else
using Wide = Narrow;
using WideLine = NarrowLine;
using WideVertex = NarrowVertex;
#endif

using FiveBalls = std::array<LatticeBall, 5>;

constexpr int gap = 192;
constexpr int unit_bits = 11 * gap;

Integer weight(const FiveBalls &balls, size_t k, bool inflated) {
  const Integer given(static_cast<Int128>(balls[k].radius) * balls[k].radius);
  const auto scaled = [](const Integer &amount, int level) {
    return amount.times_power_of_two(unit_bits - gap * level);
  };
  if (!inflated) return scaled(given, 0);
  const Int128 x = balls[k].centre.x, y = balls[k].centre.y, z = balls[k].centre.z;
  const Int128 form = 1009 * x * x + 757 * x * y + 499 * x * z + 331 * y * y + 211 * y * z + 113 * z * z;
  int rank = 0;
  for (const LatticeBall &other : balls) rank += exact::ranks_before(other, balls[k]) ? 1 : 0;
  return scaled(given, 0) + scaled(given, 1) + scaled(Integer(1), 2) + scaled(Integer(x), 3) + scaled(Integer(y), 4) +
         scaled(Integer(z), 5) + scaled(Integer(form), 6) + scaled(Integer(1), 7 + rank);
}

// The determinant of the rows (v, h), by its last column, and that of the first three v.
struct Determinants {
  Integer G, B;
};
Determinants determinants(const FiveBalls &balls, bool inflated) {
  std::array<std::array<Integer, 3>, 4> v;
  std::array<Integer, 4> h;
  for (size_t k = 0; k < 4; ++k) {
    const exact::Vector &a = balls[0].centre;
    const exact::Vector &b = balls[k + 1].centre;
    const int64_t d[3] = {b.x - a.x, b.y - a.y, b.z - a.z};
    Integer square;
    for (size_t axis = 0; axis < 3; ++axis) {
      v[k][axis] = Integer(d[axis]);
      square = square + Integer(d[axis]) * Integer(d[axis]);
    }
    h[k] = square.times_power_of_two(unit_bits) + weight(balls, 0, inflated) - weight(balls, k + 1, inflated);
  }
  const auto minor = [&v](size_t a, size_t b, size_t c) {
    return v[a][0] * (v[b][1] * v[c][2] - v[b][2] * v[c][1]) - v[a][1] * (v[b][0] * v[c][2] - v[b][2] * v[c][0]) +
           v[a][2] * (v[b][0] * v[c][1] - v[b][1] * v[c][0]);
  };
  return {h[3] * minor(0, 1, 2) - h[2] * minor(0, 1, 3) + h[1] * minor(0, 2, 3) - h[0] * minor(1, 2, 3),
          minor(0, 1, 2)};
}

Plane plane(const FiveBalls &balls, size_t k) {
  return exact::plane_of(balls[0], balls[k]);
}

bool all_meet_the_first(const FiveBalls &balls) {
  return std::all_of(balls.begin() + 1, balls.end(), [&balls](const LatticeBall &other) {
    return other.radius > 0 && other.radius < int64_t{1} << 30 &&
           exact::pair_relation(balls[0], other) == exact::PairRelation::circle;
  });
}

double length_squared(const FiveBalls &balls) {
  double largest = static_cast<double>(exact::sphere_of(balls[0]).W);
  for (size_t k = 1; k < 5; ++k) {
    largest = std::max(largest, static_cast<double>(dot(plane(balls, k).v, plane(balls, k).v)));
  }
  return largest;
}

// A vertex of which many questions are asked answers as one question does.
void expect_same(const exact::Sphere &sphere, const Plane &P, const Plane &Q, const Plane &R, const Plane &S,
                 const exact::Sign &expected) {
  const Plane planes[3] = {P, Q, R};
  for (const exact::Sign &sign : {WideVertex(sphere, planes).near(S), NarrowVertex(sphere, planes).near(S)}) {
    EXPECT_EQ(sign.sign, expected.sign);
    EXPECT_EQ(sign.tied, expected.tied);
  }
}

struct Tally {
  uint32_t asked = 0, tied = 0, sure = 0;
};

void compare(const FiveBalls &balls, Tally &tally) {
  const auto [given, B] = determinants(balls, false);
  if (B.sign() == 0) return;
  ++tally.asked;
  const int expected = determinants(balls, true).G.sign() * B.sign();
  const exact::Sphere sphere = exact::sphere_of(balls[0]);
  const Plane P = plane(balls, 1), Q = plane(balls, 2), R = plane(balls, 3), S = plane(balls, 4);
  const exact::Sign wide = Wide::near(sphere, P, Q, R, S);
  const exact::Sign narrow = Narrow::near(sphere, P, Q, R, S);
  EXPECT_EQ(wide.sign, expected);
  EXPECT_EQ(wide.tied, given.sign() == 0);
  EXPECT_EQ(narrow.sign, wide.sign);
  EXPECT_EQ(narrow.tied, wide.tied);
  expect_same(sphere, P, Q, R, S, wide);
  tally.tied += wide.tied ? 1 : 0;
  const exact::FilterBounds bounds = exact::FilterBounds::for_length_squared(length_squared(balls));
  const int filtered = exact::filter_near(bounds, P, Q, R, S);
  tally.sure += filtered != 0 ? 1 : 0;
  EXPECT_TRUE(filtered == 0 || (filtered == wide.sign && !wide.tied));
}

// From few integers, so that ties abound, in any order.
FiveBalls tied_balls(oracle::RandomSource &random, int64_t scale) {
  for (;;) {
    FiveBalls balls;
    const int64_t side = random.in(1, 3);
    for (uint32_t k = 0; k < 5; ++k) {
      const int64_t x = random.in(0, side);
      const int64_t y = random.in(0, side);
      const int64_t z = random.in(0, side);
      balls[k] = {{scale * x, scale * y, scale * z}, scale * random.in(1, 3), k};
    }
    const std::vector<uint32_t> order = random.permutation(5);
    for (size_t k = 0; k < 5; ++k) balls[k].index = order[k];
    if (all_meet_the_first(balls)) return balls;
  }
}

TEST(PowerVertex, IsNearAsAfterATinyInflation) {
  oracle::RandomSource random(601);
  Tally tally;
  for (int k = 0; k < 20000; ++k) compare(tied_balls(random, 1), tally);
  // One step off a tie near the limit of the contract.
  for (int k = 0; k < 10000; ++k) {
    FiveBalls balls = tied_balls(random, int64_t{1} << 28);
    LatticeBall &moved = balls[random.below(5)];
    moved.centre.x += random.in(-1, 1);
    moved.radius -= random.in(0, 1);
    if (all_meet_the_first(balls)) compare(balls, tally);
  }
  std::cout << "  asked " << tally.asked << ", tied " << tally.tied << ", filter sure " << tally.sure << '\n';
  EXPECT_GT(tally.asked, 8000U);
  EXPECT_GT(tally.tied, 1000U);
  EXPECT_GT(tally.sure, 2000U);
}

// Four equal balls at the corners of a rectangle that no level of the tie rule tells apart, and one beside them.
TEST(PowerVertex, RanksDecideWhatNoLevelDoes) {
  oracle::RandomSource random(605);
  Tally tally;
  for (int k = 0; k < 500; ++k) {
    const int64_t x = random.in(1, 900);
    const std::vector<uint32_t> corner = random.permutation(4), index = random.permutation(5);
    FiveBalls balls;
    for (size_t b = 0; b < 4; ++b) {
      const int64_t across = corner[b] < 2 ? 0 : 1;
      balls[b < 3 ? b : 4] = {{corner[b] % 2 == 0 ? 0 : x, -499 * across, 757 * across}, 1000, 0};
    }
    balls[3] = {{random.in(0, x), random.in(1, 500), random.in(1, 500)}, 1000, 0};
    for (size_t b = 0; b < 5; ++b) balls[b].index = index[b];
    if (all_meet_the_first(balls)) compare(balls, tally);
  }
  EXPECT_GT(tally.tied, 300U);
}

// One or two of the planes are sides of a cube, which do not grow; balls are of one size around points of a circle, so
// that the planes of all go through its axis, or any.
TEST(PowerVertex, IsNearAsOneQuestionSaysBesidePlanesThatDoNotGrow) {
  oracle::RandomSource random(607);
  constexpr int64_t circle[][2] = {{7, 4}, {8, 1}, {8, -1}, {4, -7}, {1, -8}, {-4, -7}, {-8, 1}, {-7, 4}, {-1, 8}};
  uint32_t tied[2] = {0, 0}, others = 0;
  for (int k = 0; k < 6000; ++k) {
    const int64_t scale = random.one_in(2) ? 1 : int64_t{1} << 26;
    FiveBalls balls = tied_balls(random, scale);
    const bool along_axis = random.one_in(2);
    for (uint32_t b = 0; along_axis && b < 5; ++b) {
      const auto &point = circle[(random.below(2) + 2 * b) % std::size(circle)];
      balls[b] = {{scale * point[0], scale * point[1], 0}, 9 * scale, b};
    }
    const exact::Sphere sphere = exact::sphere_of(balls[0]);
    const auto side = [&](size_t axis) {
      const int64_t way = random.one_in(2) ? 8 : -8;
      return exact::virtual_plane({axis == 0 ? way : 0, axis == 1 ? way : 0, axis == 2 ? way : 0},
                                  18 * balls[0].radius);
    };
    const bool two = random.one_in(4);
    Plane planes[3] = {plane(balls, 1), two ? side(random.below(2)) : plane(balls, 2), side(2)};
    std::rotate(planes, planes + random.below(3), planes + 3);
    const auto &[P, Q, R] = planes;
    const Plane S = plane(balls, 4);
    if (Wide::triple_product_sign(P.v, Q.v, R.v) == 0) continue;
    const exact::Sign expected = Wide::near(sphere, P, Q, R, S);
    expect_same(sphere, P, Q, R, S, expected);
    ++(expected.tied ? tied[along_axis ? 1 : 0] : others);
  }
  std::cout << "  tied " << tied[0] << " and on the axis " << tied[1] << ", others " << others << '\n';
  EXPECT_GT(tied[1], 500U);
  EXPECT_GT(others, 500U);
}

// A hill climb over five balls: the first four by the search of the other filters' tests, the fifth beside them.
template <class Badness>
double worst_of_five(oracle::RandomSource &random, int starts, int changes, const Badness &badness) {
  double largest = 0.0;
  for (int start = 0; start < starts; ++start) {
    const auto five = [](const FourBalls &four, const LatticeBall &fifth) {
      return FiveBalls{four.ball[0], four.ball[1], four.ball[2], four.ball[3], fifth};
    };
    FourBalls four =
        filter_bounds::random_balls(random, static_cast<filter_bounds::Kind>(start % filter_bounds::kinds));
    LatticeBall fifth = filter_bounds::random_balls(random, filter_bounds::Kind::any).ball[1];
    double current = -1.0;
    for (int k = 0; k < changes; ++k) {
      FourBalls next = filter_bounds::changed(random, four);
      LatticeBall other = fifth;
      if (random.one_in(3)) {
        FourBalls beside = four;
        beside.ball[1] = fifth;
        other = filter_bounds::changed(random, beside).ball[1];
        if (random.one_in(2)) next = four;
      }
      const FiveBalls balls = five(next, other);
      if (!next.valid(1) || !all_meet_the_first(balls)) continue;
      const double value = badness(balls);
      if (value < current) continue;
      four = next;
      fifth = other;
      current = value;
    }
    largest = std::max(largest, current);
  }
  return largest;
}

// The filter's own G, by bisection over bounds; B counts as certain.
double filter_value(const FiveBalls &balls) {
  const Plane P = plane(balls, 1), Q = plane(balls, 2), R = plane(balls, 3), S = plane(balls, 4);
  const int sign_B = exact::filter_near({0, 0, 0, -1.0, 0, -std::numeric_limits<double>::infinity()}, P, Q, R, S);
  const auto sign_beyond = [&](double bound) {
    return exact::filter_near({0, 0, 0, -1.0, 0, bound}, P, Q, R, S) * sign_B;
  };
  const int sign = sign_beyond(0.0);
  if (sign == 0) return 0.0;
  uint64_t below = 0;
  uint64_t not_below = std::bit_cast<uint64_t>(std::numeric_limits<double>::infinity());
  while (not_below - below > 1) {
    const uint64_t middle = below + (not_below - below) / 2;
    (sign_beyond(std::bit_cast<double>(middle)) != 0 ? below : not_below) = middle;
  }
  return sign * std::bit_cast<double>(not_below);
}

TEST(PowerVertex, FilterKeepsItsErrorBound) {
  oracle::RandomSource random(602);
  const double largest = worst_of_five(random, 60, 1500, [](const FiveBalls &balls) {
    const Integer error =
        Integer::from_double(filter_value(balls)).times_power_of_two(unit_bits) - determinants(balls, false).G;
    const double bound = exact::FilterBounds::for_length_squared(length_squared(balls)).G;
    return static_cast<double>(std::fabs(std::ldexp(error.to_long_double(), -unit_bits))) / bound;
  });
  std::cout << "  worst error of G: " << largest << " of its bound\n";
  EXPECT_LT(largest, 1.0) << "the bound does not hold";
  EXPECT_GT(largest, 0.01) << "the bound is so wide that the filter passes on what it could answer";
}

TEST(PowerVertex, LargestValuesStayRight) {
  oracle::RandomSource random(603);
  int wrong = 0;
  const double largest = worst_of_five(random, 60, 1500, [&wrong](const FiveBalls &balls) {
    const auto [G, B] = determinants(balls, false);
    if (B.sign() == 0) return -1.0;
    const exact::Sphere sphere = exact::sphere_of(balls[0]);
    const Plane P = plane(balls, 1), Q = plane(balls, 2), R = plane(balls, 3), S = plane(balls, 4);
    if (G.sign() != 0) {
      wrong += Wide::near(sphere, P, Q, R, S).sign != G.sign() * B.sign() ? 1 : 0;
      wrong += Narrow::near(sphere, P, Q, R, S).sign != G.sign() * B.sign() ? 1 : 0;
    }
    return static_cast<double>(std::fabs(std::ldexp(G.to_long_double(), -unit_bits - 31 * 5)));
  });
  std::cout << "  largest |G|: " << largest << " of at most 4\n";
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(largest, 4.0);
  EXPECT_GT(largest, 0.5) << "the search stays far from the bound";
}

// Rounded once: the factors of chords and where planes meet their lines, against the same from determinants.
TEST(PowerVertex, NumbersAreRoundedOnce) {
  oracle::RandomSource random(604);
  for (int k = 0; k < 2000; ++k) {
    const FourBalls four =
        filter_bounds::random_balls(random, static_cast<filter_bounds::Kind>(k % filter_bounds::kinds));
    const perturbation::Balls balls = filter_bounds::as_given(four);
    const perturbation::Origin origin(balls, 0);
    const perturbation::HalfSpace P = perturbation::half_space(balls, 0, 1);
    const perturbation::HalfSpace Q = perturbation::half_space(balls, 0, 2);
    const perturbation::HalfSpace R = perturbation::half_space(balls, 0, 3);
    const exact::ChordFactors found = WideLine(four.plane(1), four.plane(2)).factors();
    const Integer alpha = origin.beta(Q, P), beta = origin.beta(P, Q), N = origin.N(P, Q);
    const auto rounded = [](const Integer &value) { return static_cast<double>(value.to_long_double()); };
    EXPECT_DOUBLE_EQ(found.alpha, rounded(alpha));
    EXPECT_DOUBLE_EQ(found.beta, rounded(beta));
    EXPECT_DOUBLE_EQ(found.N, rounded(N));
    EXPECT_DOUBLE_EQ(found.third, rounded(N + N - alpha - beta));
    const Integer B = origin.B(P, Q, R);
    if (B.sign() == 0) continue;
    const double parameter = WideLine(four.plane(1), four.plane(2)).parameter(four.plane(3));
    EXPECT_DOUBLE_EQ(parameter, -rounded(origin.A(P, Q, R)) / rounded(B));
    EXPECT_EQ(parameter, NarrowLine(four.plane(1), four.plane(2)).parameter(four.plane(3)));
  }
}

}  // namespace
