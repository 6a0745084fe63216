// Derivatives as the program prints them: closed forms, difference quotients of its own areas, and the weights' part.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

constexpr double pi = std::numbers::pi;

using Ball = std::array<double, 4>;

std::string write_balls(const std::vector<Ball> &balls) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(9);
  for (const Ball &ball : balls) text << ball[0] << ' ' << ball[1] << ' ' << ball[2] << ' ' << ball[3] << '\n';
  return text.str();
}

std::vector<double> vector_of(const Json &json) {
  std::vector<double> numbers;
  for (const Json &item : json.items) numbers.push_back(item.number);
  return numbers;
}

// Derivatives with respect to x, y, z and r of a ball, in this order.
std::vector<double> derivatives(const Json &ball, const std::string &quantity) {
  std::vector<double> all = vector_of(ball[quantity + "_gradient"]);
  all.push_back(ball[quantity + "_dr"].number);
  return all;
}

// good/two.xyzr: radii 2 and 1.5 at distance 3 along x. With h1, h2 the distances of the circle's plane from the
// centres, A = 2 pi r1 (r1 + h1) + 2 pi r2 (r2 + h2), and dV/dd is the area of the circle's disc.
TEST(Gradients, TwoBallsInClosedForm) {
  const double r1 = 2;
  const double r2 = 1.5;
  const double d = 3;
  const double h1 = (d * d + r1 * r1 - r2 * r2) / (2 * d);
  const double h2 = d - h1;
  const double area_slope = 2 * pi * (r1 * h2 + r2 * h1) / d;
  const double volume_slope = pi * (r1 * r1 - h1 * h1);
  const double by_r1 = 4 * pi * r1 + 2 * pi * h1 + 2 * pi * (r1 - r2) * r1 / d;
  const double by_r2 = 4 * pi * r2 + 2 * pi * h2 + 2 * pi * (r2 - r1) * r2 / d;
  const Json balls = run_json({"measure", "good/two.xyzr", "--gradient"})["balls"];
  ASSERT_EQ(balls.items.size(), 2u);
  const double sign[2] = {-1, 1};
  const double area_dr[2] = {by_r1, by_r2};
  const double volume_dr[2] = {2 * pi * r1 * (r1 + h1), 2 * pi * r2 * (r2 + h2)};
  for (size_t i = 0; i < 2; ++i) {
    const std::vector<double> of_area = vector_of(balls.items[i]["area_gradient"]);
    const std::vector<double> of_volume = vector_of(balls.items[i]["volume_gradient"]);
    EXPECT_NEAR(of_area[0], sign[i] * area_slope, 1e-13 * area_slope);
    EXPECT_NEAR(of_volume[0], sign[i] * volume_slope, 1e-13 * volume_slope);
    for (size_t axis = 1; axis < 3; ++axis) {
      EXPECT_NEAR(of_area[axis], 0, 1e-14);
      EXPECT_NEAR(of_volume[axis], 0, 1e-14);
    }
    EXPECT_NEAR(balls.items[i]["area_dr"].number, area_dr[i], 1e-13 * area_dr[i]);
    EXPECT_NEAR(balls.items[i]["volume_dr"].number, volume_dr[i], 1e-13 * volume_dr[i]);
  }
}

// The probe is a part of every radius: two equal balls of radius 1, 2 apart, grown by 0.5.
TEST(Gradients, CountTheProbe) {
  const TemporaryFile file("probe.xyzr", "0 0 0 1\n2 0 0 1\n");
  const Json balls = run_json({"measure", file.path(), "--gradient", "--probe", "0.5"})["balls"];
  ASSERT_EQ(balls.items.size(), 2u);
  for (const Json &ball : balls.items) {
    EXPECT_NEAR(std::abs(ball["area_gradient"].items[0].number), 2 * pi * 1.5, 1e-12);
    EXPECT_NEAR(std::abs(ball["volume_gradient"].items[0].number), pi * (1.5 * 1.5 - 1), 1e-12);
  }
}

// Seven balls in general position with weights: each derivative against a difference quotient of what the program
// prints for balls that were moved a little.
TEST(Gradients, AreDifferenceQuotients) {
  const std::vector<Ball> balls = {{0.02, -0.01, 0.03, 1.2}, {1.1, 0.3, -0.2, 1.0}, {-0.7, 0.9, 0.4, 0.9},
                                   {0.2, -1.3, 0.6, 1.1},    {0.4, 0.5, 1.4, 0.8},  {-0.9, -0.6, -0.8, 1.05},
                                   {0.5, 0.2, -1.5, 0.7}};
  const TemporaryFile weights("moved.weights", "1\n-0.5\n2\n0\n0.75\n3\n1.5\n");
  const TemporaryFile base("base.xyzr", write_balls(balls));
  const Json exact = run_json({"measure", base.path(), "--gradient", "--weights", weights.path()});
  ASSERT_EQ(exact["balls"].items.size(), balls.size());
  const double step = 2e-5;
  for (size_t i = 0; i < balls.size(); ++i) {
    for (size_t variable = 0; variable < 4; ++variable) {
      std::array<Json, 2> moved;
      for (size_t side = 0; side < 2; ++side) {
        std::vector<Ball> others = balls;
        others[i][variable] += side == 0 ? -step : step;
        const TemporaryFile file("moved.xyzr", write_balls(others));
        moved[side] = run_json({"measure", file.path(), "--weights", weights.path()});
      }
      const Json &ball = exact["balls"].items[i];
      const std::array<const char *, 3> totals = {"area", "volume", "weighted_area"};
      const std::array<const char *, 3> names = {"area", "volume", "weighted"};
      for (size_t k = 0; k < 3; ++k) {
        const double quotient = (moved[1][totals[k]].number - moved[0][totals[k]].number) / (2 * step);
        EXPECT_NEAR(derivatives(ball, names[k])[variable], quotient, 1e-6)
            << names[k] << " of ball " << i << " by variable " << variable;
      }
    }
  }
}

// Weights of one make the weighted area the area, bit for bit in every derivative.
TEST(Gradients, WeightsOfOneChangeNothing) {
  const TemporaryFile weights("ones.weights", "1\n1\n1\n1\n1\n1\n");
  const Json json = run_json({"measure", "good/cage.xyzr", "--gradient", "--weights", weights.path()});
  EXPECT_NEAR(json["weighted_area"].number, json["area"].number, 1e-14 * json["area"].number);
  ASSERT_EQ(json["balls"].items.size(), 6u);
  for (const Json &ball : json["balls"].items) {
    EXPECT_EQ(derivatives(ball, "weighted"), derivatives(ball, "area"));
  }
}

TEST(Gradients, WeightedAreaIsTheSum) {
  const Json json = run_json({"measure", "good/water.pdb", "--per-ball", "--weights", "good/water.weights"});
  const double weight[3] = {1, -0.5, 2};
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) sum += weight[i] * json["balls"].items[i]["area"].number;
  EXPECT_NEAR(json["weighted_area"].number, sum, 1e-14 * std::abs(sum));
}

// Tables show noise about zero as zero.
TEST(Gradients, TablesShowNoNegativeZero) {
  const Outcome outcome = run_program({"measure", molecules_folder() + "/caffeine.pdb", "--gradient"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find(" 0.000000 "), std::string::npos);
  EXPECT_EQ(outcome.out.find("-0.000000"), std::string::npos) << outcome.out;
}

// Crambin: moving or turning the whole changes nothing, and each ball's dV/dr is its free area.
TEST(Gradients, KeepTheLawsOfMotionOnCrambin) {
  const std::string file = molecules_folder() + "/crambin.pdb";
  for (const char *probe : {"0", "1.4"}) {
    const Json balls = run_json({"measure", file, "--gradient", "--probe", probe})["balls"];
    ASSERT_EQ(balls.items.size(), 327u);
    for (const char *key : {"area_gradient", "volume_gradient"}) {
      double sum[3] = {0, 0, 0};
      double largest = 0;
      for (const Json &ball : balls.items) {
        for (size_t axis = 0; axis < 3; ++axis) {
          sum[axis] += ball[key].items[axis].number;
          largest = std::max(largest, std::abs(ball[key].items[axis].number));
        }
      }
      EXPECT_GT(largest, 1);
      for (const double component : sum) EXPECT_NEAR(component, 0, 1e-10);
    }
    for (const Json &ball : balls.items) {
      EXPECT_NEAR(ball["volume_dr"].number, ball["area"].number, 1e-12 * (1 + ball["area"].number));
    }
  }
}

}  // namespace
