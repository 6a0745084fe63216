// Angles of directions several at a time, and sums of many angles by the product of their directions, against a longer
// floating-point format.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/elementary.hpp"
#include "lane_angles.hpp"
#include "measure/exterior_angles.hpp"
#include "runnable_targets.hpp"

namespace {

using L = hsp::Wide<double, 2>;
using Lanes = L::Real;

constexpr long double whole_turn = 6.283185307179586476925286766559L;

// In [0, 2 pi).
long double exact_angle(double x, double y) {
  const long double angle = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  return angle < 0.0L ? angle + whole_turn : angle;
}

// Error in units of 2^-53, of the angle itself and absolute; the latter for angles up to pi, too.
struct Errors {
  double relative = 0.0, absolute = 0.0, half_turn = 0.0;
  const std::vector<hsp::Target> targets = runnable_targets();
  int lane = 0;

  void add(double x, double y) {
    const long double exact = exact_angle(x, y);
    // The other lane must not matter.
    const double angle = hsp::turn_angle<2>(Lanes{x, 1.0}, Lanes{y, 2.0})[0];
    const double turned = hsp::signed_angle<L>(Lanes{x, 1.0}, Lanes{y, 2.0})[0];
    EXPECT_EQ(std::signbit(turned), std::signbit(y));
    EXPECT_EQ(hsp::arc_tangent(y, x), turned);
    const double magnitude = std::fabs(turned);
    EXPECT_EQ(magnitude, hsp::turn_angle<2>(Lanes{x, 1.0}, Lanes{std::fabs(y), 2.0})[0]);
    if (y >= 0.0) half_turn = std::max(half_turn, error_of(magnitude, exact));
    EXPECT_EQ(hsp::turn_angle<2>(Lanes{-3.0, x}, Lanes{-0.5, y})[1], angle);
    EXPECT_EQ(hsp::turn_angle<1>(hsp::Wide<double, 1>::all(x), hsp::Wide<double, 1>::all(y))[0], angle);
    expect_the_same_of_four(x, y, turned, angle);
    EXPECT_GE(angle, 0.0);
    const double error = error_of(angle, exact);
    absolute = std::max(absolute, error);
    if (exact > 0.0L) relative = std::max(relative, error / static_cast<double>(exact));
  }
  // In one of four lanes after the other, with other directions beside it, on every target.
  void expect_the_same_of_four(double x, double y, double turned, double angle) {
    double xs[4] = {1.0, -2.0, 0.5, -3.0}, ys[4] = {2.0, -1.0, -0.25, 3.0};
    const int next = lane;
    lane = (lane + 1) % 4;
    xs[lane] = x;
    ys[lane] = y;
    for (const hsp::Target target : targets) {
      double half_turns[4], turns[4];
      hsp::angles_of_four(target, xs, ys, half_turns, turns);
      EXPECT_EQ(half_turns[lane], std::fabs(turned)) << "lane " << lane;
      EXPECT_EQ(turns[lane], angle) << "lane " << lane;
      EXPECT_EQ(half_turns[next], std::fabs(hsp::arc_tangent(ys[next], xs[next]))) << "lane " << next;
    }
  }
  static double error_of(double angle, long double exact) {
    return static_cast<double>(std::fabs(static_cast<long double>(angle) - exact) * 0x1p53L);
  }
};

TEST(TurnAngle, StaysWithinItsBounds) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is no longer than double here";
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  Errors errors;
  for (int k = 0; k < 300000; ++k) {
    const int widest = k % 3 == 0 ? 1 : k % 3 == 1 ? 6 : 60;
    const auto exponent = [&]() { return static_cast<int>(random() % static_cast<unsigned>(widest)) - widest / 2; };
    errors.add(std::ldexp(mantissa(random), exponent()), std::ldexp(mantissa(random), exponent()));
  }
  // Around the joints, in every octant.
  for (int k = 1; k <= 128; ++k) {
    double tangent = k / 128.0;
    for (int step = 0; step < 32; ++step) tangent = std::nextafter(tangent, 0.0);
    for (int step = 0; step < 64; ++step, tangent = std::nextafter(tangent, 2.0)) {
      for (int octant = 0; octant < 8; ++octant) {
        const double x = octant & 1 ? -3.0 : 3.0;
        const double y = octant & 2 ? -3.0 * tangent : 3.0 * tangent;
        octant & 4 ? errors.add(y, x) : errors.add(x, y);
      }
    }
  }
  EXPECT_LE(errors.relative, 2.7);
  EXPECT_LE(errors.absolute, 5.4);
  EXPECT_LE(errors.half_turn, 3.4);
  EXPECT_GT(errors.absolute, 4.0);  // the measurement measures
  RecordProperty("relative", std::to_string(errors.relative));
  RecordProperty("absolute", std::to_string(errors.absolute));
  RecordProperty("up to pi", std::to_string(errors.half_turn));
}

TEST(TurnAngle, Axes) {
  const Lanes first = hsp::turn_angle<2>(Lanes{1.0, 0.0}, Lanes{0.0, 1.0});
  const Lanes second = hsp::turn_angle<2>(Lanes{-1.0, 0.0}, Lanes{0.0, -1.0});
  EXPECT_EQ(first[0], 0.0);
  EXPECT_EQ(first[1], hsp::pi / 2);
  EXPECT_EQ(second[0], hsp::pi);
  EXPECT_EQ(second[1], 3 * (hsp::pi / 2));
}

struct Direction {
  double x, y;
};

double total(const hsp::ExteriorAngleSum<2> &sum) {
  const Lanes rest = sum.angles();
  return 2 * hsp::pi * static_cast<double>(L::sum(sum.turns())) + (rest[0] + rest[1]);
}

// The sum of the directions' angles as ExteriorAngleSum has it, less the exact one. Directions go to the lanes in turn.
double error_of_sum(const std::vector<Direction> &directions) {
  hsp::ExteriorAngleSum<2> turn;
  long double exact = 0.0L;
  for (size_t k = 0; k < directions.size(); k += 2) {
    const Direction &a = directions[k];
    const Direction b = k + 1 < directions.size() ? directions[k + 1] : Direction{1.0, 0.0};
    turn.add_directions(Lanes{a.x, b.x}, Lanes{a.y, b.y});
    exact += exact_angle(a.x, a.y) + exact_angle(b.x, b.y);
  }
  return static_cast<double>(std::fabs(static_cast<long double>(total(turn)) - exact));
}

TEST(ExteriorAngleSum, CountsWholeTurnsWhereRoundingCouldMislead) {
  // Angles at and next to 0 and pi, where sums come to lie on either side of whole turns: a wrong count is off by 2 pi.
  const double tiny = 0x1p-53;
  const Direction choice[] = {{1.0, 0.0},     {-1.0, 0.0},     {1.0, tiny},      {-1.0, tiny},
                              {1.0, 0x1p-80}, {0.0, 1.0},      {-1.0, 0x1p-100}, {-0.5, 0.5},
                              {0x1p-7, 0.0},  {-2.0, 0.0},     {0.7071, 0.7071}, {-tiny, 0.01},
                              {tiny, 0.25},   {-0.1, 0x1p-60}, {0.999, 0.001},   {-0.999, 0.001}};
  // The exact sum, of up to 60 angles, is rounded too where long double is no longer than double.
  const double bound = std::numeric_limits<long double>::digits < 64 ? 1e-12 : 1e-13;
  std::mt19937 random(3);
  for (int round = 0; round < 20000; ++round) {
    const unsigned kinds = 1 + random() % 16;
    std::vector<Direction> directions(1 + random() % 60);
    for (Direction &direction : directions) direction = choice[(random() % kinds + static_cast<unsigned>(round)) % 16];
    EXPECT_LT(error_of_sum(directions), bound) << "round " << round;
  }
}

TEST(ExteriorAngleSum, SumsAnyAngles) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> angle(0.0, 3.14159), length(0x1p-7, 2.0);
  for (int round = 0; round < 300; ++round) {
    std::vector<Direction> directions(
        static_cast<size_t>(1 + random() % (2 * hsp::ExteriorAngleSum<2>::most_directions)));
    for (Direction &direction : directions) {
      const double a = angle(random);
      const double l = round % 3 == 0 ? 0x1p-7 : length(random);  // the shortest that are allowed
      direction = {l * std::cos(a), l * std::fabs(std::sin(a))};
    }
    EXPECT_LT(error_of_sum(directions), 1e-15 * static_cast<double>(directions.size()) + 1e-14);
  }
}

}  // namespace
