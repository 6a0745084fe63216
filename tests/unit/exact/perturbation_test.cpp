// Every stage of the predicates against balls that are really inflated by tiny amounts (perturbation_determinants.hpp):
// the symbolic perturbation gives the sign of the inflated value, the exact stage that of the value as given, a tie is
// reported where that is zero, and the filter is sure only where the exact stage says the same. Both limb widths.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "big_integer.hpp"
#include "exact/filter.hpp"
#include "exact/lattice_ball.hpp"
#include "perturbation_balls.hpp"
#include "sweep_length.hpp"

namespace {

using namespace perturbation;
namespace exact = hsp::exact;
using Narrow = exact::ExactPredicates<uint32_t>;
#if defined(__SIZEOF_INT128__)
using Wide = exact::ExactPredicates<uint64_t>;
#else
using Wide = Narrow;
#endif

struct Tally {
  uint64_t pairs = 0, crossings = 0, sides = 0, points = 0;
  uint64_t tied_pairs = 0, tied_crossings = 0, tied_sides = 0, tied_points = 0;
  uint64_t with_planes = 0, tied_with_planes = 0;
  uint64_t filter_sure = 0, filter_unsure = 0;
  uint64_t disagreements = 0;
  std::string first;

  uint64_t calls() const { return pairs + crossings + sides + points; }
  uint64_t tied() const { return tied_pairs + tied_crossings + tied_sides + tied_points; }
};

// A cap of a sphere in the library's form and in the two naive ones.
struct Circle {
  exact::Plane plane;
  HalfSpace inflated;
  HalfSpace given;
  bool is_virtual;
};

class Comparison {
 public:
  Comparison(const TiedBalls &four, int gap, oracle::RandomSource &random, Tally &tally)
      : four_(four), inflated_(four.ball, gap), given_(four.ball, 0), random_(random), tally_(tally) {}

  void run() {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        if (a != b) compare_pair(a, b);
      }
    }
    for (int a = 0; a < 4; ++a) compare_on_sphere(a);
  }

 private:
  static exact::LatticeBall library_ball(const Ball &ball) {
    return {{ball.centre[0], ball.centre[1], ball.centre[2]}, ball.radius, ball.index};
  }

  void expect(bool agrees, const char *what, int origin) {
    if (agrees) return;
    if (++tally_.disagreements > 1) return;
    std::ostringstream text;
    text << what << " on the sphere of ball " << origin << " of (x y z r index)";
    for (const Ball &ball : four_.ball) {
      text << " (" << ball.centre[0] << ' ' << ball.centre[1] << ' ' << ball.centre[2] << ' ' << ball.radius << ' '
           << ball.index << ')';
    }
    if (p_ != nullptr) append(text, "P", *p_);
    if (q_ != nullptr) append(text, "Q", *q_);
    if (r_ != nullptr) append(text, "R", *r_);
    tally_.first = text.str();
  }
  static void append(std::ostringstream &text, const char *name, const Circle &circle) {
    const exact::Plane &plane = circle.plane;
    text << ' ' << name << " = (" << plane.v.x << ' ' << plane.v.y << ' ' << plane.v.z << ") h " << plane.h
         << " perturbed " << plane.perturbed;
  }

  void compare_pair(int a, int b) {
    const exact::PairRelation answer = exact::pair_relation(library_ball(four_.ball[a]), library_ball(four_.ball[b]));
    Relation as_named = Relation::tangent;
    switch (answer) {
      case exact::PairRelation::disjoint:
        as_named = Relation::disjoint;
        break;
      case exact::PairRelation::circle:
        as_named = Relation::circle;
        break;
      case exact::PairRelation::first_in_second:
        as_named = Relation::first_in_second;
        break;
      case exact::PairRelation::second_in_first:
        as_named = Relation::second_in_first;
    }
    ++tally_.pairs;
    tally_.tied_pairs += relation(given_, a, b) == Relation::tangent;
    expect(as_named == relation(inflated_, a, b), "pair", a);
  }

  void add_virtual(int a, exact::Vector v, int64_t h) {
    const int64_t components[3] = {v.x, v.y, v.z};
    circles_[count_++] = {exact::virtual_plane(v, h), half_space_of_plane(inflated_, components, h),
                          half_space_of_plane(given_, components, h), true};
    // No plane beyond the contract: it has to meet the sphere in a proper circle.
    const Int128 uu = Int128{v.x} * v.x + Int128{v.y} * v.y + Int128{v.z} * v.z;
    if (Int128{4} * four_.ball[a].radius * four_.ball[a].radius * uu <= Int128{h} * h && h != 0) --count_;
  }

  void compare_on_sphere(int a) {
    const exact::LatticeBall own = library_ball(four_.ball[a]);
    sphere_ = exact::sphere_of(own);
    count_ = 0;
    for (int b = 0; b < 4; ++b) {
      if (b == a || relation(inflated_, a, b) != Relation::circle) continue;
      circles_[count_++] = {exact::plane_of(own, library_ball(four_.ball[b])), half_space(inflated_, a, b),
                            half_space(given_, a, b), false};
    }
    const int balls = count_;
    if (balls == 0) return;
    // The virtual planes the library asks about: the meridian of one of the balls and the planes through the poles; and
    // one that is none of these.
    const exact::Vector axis = circles_[random_.next() % static_cast<unsigned>(balls)].plane.v;
    switch (random_.next() % 4) {
      case 0:
        add_virtual(a, {1, 0, 0}, 0);
        add_virtual(a, {0, 1, 0}, 0);
        break;
      case 1:
        add_virtual(a, {axis.y, axis.z, axis.x}, axis.x);
        [[fallthrough]];
      default:
        add_virtual(a, axis.x != 0 || axis.y != 0 ? exact::Vector{-axis.y, axis.x, 0} : exact::Vector{1, 0, 0}, 0);
    }

    double length_squared = static_cast<double>(sphere_.W);
    for (int k = 0; k < count_; ++k) {
      length_squared = std::max(length_squared, static_cast<double>(dot(circles_[k].plane.v, circles_[k].plane.v)));
    }
    bounds_ = exact::FilterBounds::for_length_squared(length_squared);

    const Origin inflated(inflated_, a);
    const Origin given(given_, a);
    for (int p = 0; p < count_; ++p) {
      for (int q = 0; q < count_; ++q) {
        if (p != q) compare_circles(inflated, given, a, balls, circles_[p], circles_[q]);
      }
    }
  }

  void compare_circles(const Origin &inflated, const Origin &given, int a, int balls, const Circle &P,
                       const Circle &Q) {
    p_ = &P;
    q_ = &Q;
    r_ = nullptr;
    const bool parallel = given.N(P.given, Q.given).sign() == 0;
    // Two virtual planes are only ever asked about if their circles cross in the poles.
    if (P.is_virtual && Q.is_virtual && parallel) return;
    const Integer D = inflated.D(P.inflated, Q.inflated);
    const Integer given_D = given.D(P.given, Q.given);

    const exact::Sign crossing = Wide::crossing(sphere_, P.plane, Q.plane);
    const exact::Sign narrow = Narrow::crossing(sphere_, P.plane, Q.plane);
    ++tally_.crossings;
    // Circles with one axis never cross, and no tie is reported for them even if they are the same circle.
    const bool tied = given_D.sign() == 0 && !parallel;
    tally_.tied_crossings += tied;
    count_planes(P.is_virtual || Q.is_virtual, tied);
    expect(crossing.sign == D.sign(), "crossing", a);
    expect(crossing.tied == tied, "crossing, tied", a);
    expect(crossing.tied || parallel || crossing.sign == given_D.sign(), "crossing, exact stage", a);
    expect(narrow.sign == crossing.sign && narrow.tied == crossing.tied, "crossing, limbs", a);
    const int filter = exact::filter_crossing(bounds_, sphere_, P.plane, Q.plane);
    count_filter(filter != 0);
    expect(filter == 0 || (filter == crossing.sign && !crossing.tied), "crossing, filter", a);

    if (D.sign() < 0) {
      compare_side(inflated, given, a, P, Q);
      return;
    }
    for (int r = 0; r < count_; ++r) {
      const Circle &R = circles_[r];
      // A virtual plane is asked about points of balls, and points of virtual planes are asked about balls.
      if (&R == &P || &R == &Q || (r >= balls && (P.is_virtual || Q.is_virtual))) continue;
      compare_points(inflated, given, a, P, Q, R, D, given_D);
    }
  }

  void compare_side(const Origin &inflated, const Origin &given, int a, const Circle &P, const Circle &R) {
    const Integer beta = inflated.beta(P.inflated, R.inflated);
    const Integer given_beta = given.beta(P.given, R.given);
    const exact::Sign side = Wide::side(sphere_, P.plane, R.plane);
    const exact::Sign narrow = Narrow::side(sphere_, P.plane, R.plane);
    const bool tied = given_beta.sign() == 0;
    ++tally_.sides;
    tally_.tied_sides += tied;
    count_planes(P.is_virtual || R.is_virtual, tied);
    expect(side.sign == -beta.sign(), "side", a);
    expect(side.tied == tied, "side, tied", a);
    expect(side.tied || side.sign == -given_beta.sign(), "side, exact stage", a);
    expect(narrow.sign == side.sign && narrow.tied == side.tied, "side, limbs", a);
    const int filter = exact::filter_side(bounds_, P.plane, R.plane);
    count_filter(filter != 0);
    expect(filter == 0 || (filter == side.sign && !side.tied), "side, filter", a);
  }

  void compare_points(const Origin &inflated, const Origin &given, int a, const Circle &P, const Circle &Q,
                      const Circle &R, const Integer &D, const Integer &given_D) {
    r_ = &R;
    const Integer A = inflated.A(P.inflated, Q.inflated, R.inflated);
    const Integer given_A = given.A(P.given, Q.given, R.given);
    const Integer B = given.B(P.given, Q.given, R.given);
    const exact::PointStatus status = Wide::point_status(sphere_, P.plane, Q.plane, R.plane);
    const exact::PointStatus narrow = Narrow::point_status(sphere_, P.plane, Q.plane, R.plane);
    exact::PointStatus filtered{};
    const bool sure = exact::filter_point_status(bounds_, sphere_, P.plane, Q.plane, R.plane, filtered);
    ++tally_.points;
    count_filter(sure);
    bool any_tied = false;
    for (int point = 0; point < 2; ++point) {
      const int s = point == 1 ? 1 : -1;
      const int as_given = Origin::point_sign(given_D, given_A, B, s);
      const bool tied = as_given == 0;
      any_tied = any_tied || tied;
      expect(status.side[point] == Origin::point_sign(D, A, B, s), "point", a);
      expect(status.tied[point] == tied, "point, tied", a);
      expect(tied || status.side[point] == as_given, "point, exact stage", a);
      expect(narrow.side[point] == status.side[point] && narrow.tied[point] == status.tied[point], "point, limbs", a);
      expect(!sure || (filtered.side[point] == status.side[point] && !status.tied[point] && !filtered.tied[point]),
             "point, filter", a);
    }
    tally_.tied_points += any_tied;
    count_planes(P.is_virtual || Q.is_virtual || R.is_virtual, any_tied);
    r_ = nullptr;
  }

  void count_planes(bool is_virtual, bool tied) {
    tally_.with_planes += is_virtual;
    tally_.tied_with_planes += is_virtual && tied;
  }
  void count_filter(bool sure) { ++(sure ? tally_.filter_sure : tally_.filter_unsure); }

  const TiedBalls &four_;
  Balls inflated_, given_;
  oracle::RandomSource &random_;
  Tally &tally_;
  exact::Sphere sphere_{};
  exact::FilterBounds bounds_{};
  Circle circles_[6];
  int count_ = 0;
  const Circle *p_ = nullptr, *q_ = nullptr, *r_ = nullptr;
};

Tally compare_sets(Size size, int gap, int sets, uint64_t seed) {
  oracle::RandomSource random(seed);
  Tally tally;
  for (int k = 0; k < sets; ++k) {
    const TiedBalls four = random_tied_balls(random, size);
    Comparison(four, gap, random, tally).run();
  }
  const auto record = [](const char *name, uint64_t value) {
    testing::Test::RecordProperty(name, std::to_string(value));
    std::cout << "  " << name << ' ' << value << '\n';
  };
  record("pair_calls", tally.pairs);
  record("pair_tied", tally.tied_pairs);
  record("crossing_calls", tally.crossings);
  record("crossing_tied", tally.tied_crossings);
  record("side_calls", tally.sides);
  record("side_tied", tally.tied_sides);
  record("point_status_calls", tally.points);
  record("point_status_tied", tally.tied_points);
  record("calls_with_virtual_planes", tally.with_planes);
  record("calls_with_virtual_planes_tied", tally.tied_with_planes);
  record("filter_sure", tally.filter_sure);
  record("filter_unsure", tally.filter_unsure);
  record("calls", tally.calls());
  record("tied", tally.tied());
  return tally;
}

// Of a number of the long form, sets or what has to be found in them.
int part_of(int number) {
  return oracle::rounds(number / 4, number);
}
uint64_t count(int number) {
  return static_cast<uint64_t>(part_of(number));
}

TEST(TieRule, SmallSetsAgreeWithATinyInflation) {
  Tally tally = compare_sets(Size::small, 3, part_of(30000), 101);
  EXPECT_EQ(tally.disagreements, 0U) << tally.first;
  // As much again with a much smaller one.
  tally = compare_sets(Size::small, 5, part_of(30000), 104);
  EXPECT_EQ(tally.disagreements, 0U) << tally.first;
  EXPECT_GT(tally.calls(), count(1000000));
  EXPECT_GT(tally.tied(), count(100000));
  EXPECT_GT(tally.tied_pairs, count(10000));
  EXPECT_GT(tally.tied_crossings, count(10000));
  EXPECT_GT(tally.tied_sides, count(1000));
  EXPECT_GT(tally.tied_points, count(50000));
  EXPECT_GT(tally.tied_with_planes, count(10000));
}

TEST(TieRule, SetsNearTheLimitAgreeWithATinyInflation) {
  const Tally tally = compare_sets(Size::near_limit, 7, part_of(10000), 102);
  EXPECT_EQ(tally.disagreements, 0U) << tally.first;
  EXPECT_GT(tally.calls(), count(200000));
  EXPECT_GT(tally.tied(), count(20000));
}

// Equal balls at the corners of rectangles whose sides the quadratic form of the tie rule sets at right angles, too.
TEST(TieRule, RanksDecideWhatNoLevelDoes) {
  oracle::RandomSource random(105);
  Tally tally;
  for (int k = 0; k < 200; ++k) {
    const int64_t x = random.in(1, 900), times = random.in(1, 2);
    TiedBalls four{};
    const std::vector<uint32_t> corner = random.permutation(4), index = random.permutation(4);
    for (size_t b = 0; b < 4; ++b) {
      const int64_t along = corner[b] % 2 == 0 ? 0 : x, across = corner[b] < 2 ? 0 : times;
      four.ball[b] = {{along, -499 * across, 757 * across}, 1100 + 13 * (k % 3), index[b]};
    }
    Comparison(four, 7, random, tally).run();
  }
  EXPECT_EQ(tally.disagreements, 0U) << tally.first;
  EXPECT_GT(tally.tied_points, 2000U);
}

// The integers these tests rely on.
TEST(TieRule, IntegersAgreeWithTheOracles) {
  oracle::RandomSource random(103);
  const auto limbs_of = [](const Integer &value) {
    oracle::BigInteger result;
    for (int k = value.limbs() - 1; k >= 0; --k) {
      result = result.times_power_of_two(64) + oracle::BigInteger(static_cast<oracle::Int128>(value.limb(k)));
    }
    return value.sign() < 0 ? -result : result;
  };
  const auto any = [&random]() {
    Integer value;
    const uint64_t limbs = random.next() % 5;
    for (uint64_t k = 0; k < limbs; ++k) {
      const uint64_t kind = random.next() % 4;
      const uint64_t limb = kind == 0 ? 0 : kind == 1 ? ~uint64_t{0} : random.next();
      value = value.times_power_of_two(64) + Integer(static_cast<Int128>(limb));
    }
    return random.next() % 2 == 0 ? value : -value;
  };
  for (int k = 0; k < 20000; ++k) {
    const Integer a = any();
    const Integer b = random.next() % 8 == 0 ? a : any();
    const int bits = static_cast<int>(random.next() % 200);
    ASSERT_EQ(limbs_of(a + b), limbs_of(a) + limbs_of(b));
    ASSERT_EQ(limbs_of(a - b), limbs_of(a) - limbs_of(b));
    ASSERT_EQ(limbs_of(a * b), limbs_of(a) * limbs_of(b));
    ASSERT_EQ((a - b).sign(), (limbs_of(a) - limbs_of(b)).sign());
    ASSERT_EQ(limbs_of(a.times_power_of_two(bits)), limbs_of(a).times_power_of_two(static_cast<unsigned>(bits)));
    const double integral = std::ldexp(static_cast<double>(static_cast<int64_t>(random.next()) >> 10), bits);
    ASSERT_EQ(Integer::from_double(integral).to_long_double(), static_cast<long double>(integral));
  }
}

}  // namespace
