// Second derivatives and means over a window of radii as the program prints them: closed forms, difference quotients of
// its own gradients, and quadrature of its own areas.
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
using Matrix = std::vector<std::vector<double>>;

// In general position: none touch, and no vertex is near the plane of its centres.
const std::vector<Ball> seven = {{0.02, -0.01, 0.03, 1.2}, {1.1, 0.3, -0.2, 1.0}, {-0.7, 0.9, 0.4, 0.9},
                                 {0.2, -1.3, 0.6, 1.1},    {0.4, 0.5, 1.4, 0.8},  {-0.9, -0.6, -0.8, 1.05},
                                 {0.5, 0.2, -1.5, 0.7}};
const std::vector<double> weights = {1, -0.5, 2, 0, 0.75, 3, 1.5};

std::string write_balls(const std::vector<Ball> &balls) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(9);
  for (const Ball &ball : balls) text << ball[0] << ' ' << ball[1] << ' ' << ball[2] << ' ' << ball[3] << '\n';
  return text.str();
}

std::string write_weights() {
  std::ostringstream text;
  for (const double weight : weights) text << weight << '\n';
  return text.str();
}

// As the format states: a line that says what it is, comments, the size, and the lower triangle in numbers from 1 on.
Matrix read_matrix(const std::string &text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "%%MatrixMarket matrix coordinate real symmetric");
  while (std::getline(lines, line) && line[0] == '%') {
  }
  size_t rows = 0, columns = 0, numbers = 0;
  std::istringstream(line) >> rows >> columns >> numbers;
  EXPECT_EQ(rows, columns);
  Matrix matrix(rows, std::vector<double>(rows));
  size_t row = 0, column = 0, read = 0;
  for (double value = 0; lines >> row >> column >> value; ++read) {
    EXPECT_TRUE(column >= 1 && column <= row && row <= rows) << row << ' ' << column;
    EXPECT_EQ(matrix[row - 1][column - 1], 0) << "twice: " << row << ' ' << column;
    matrix[row - 1][column - 1] = matrix[column - 1][row - 1] = value;
  }
  EXPECT_TRUE(lines.eof());
  EXPECT_EQ(read, numbers);
  return matrix;
}

Matrix run_hessian(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "hessian");
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return read_matrix(outcome.out);
}

// good/two.xyzr: radii 2 and 1.5 at distance 3 along x. Along x dA/dd = 2 pi (r1 h2 + r2 h1) / d and dV/dd = pi rho^2;
// across, the slope over the distance.
TEST(Hessian, TwoBallsInClosedForm) {
  const double r1 = 2, r2 = 1.5, d = 3;
  const double h1 = (d * d + r1 * r1 - r2 * r2) / (2 * d), h2 = d - h1;
  const double area_slope = 2 * pi * (r1 * h2 + r2 * h1) / d, volume_slope = pi * (r1 * r1 - h1 * h1);
  const double area_bend = 2 * pi * (r1 - r2) * (r1 * r1 - r2 * r2) / (d * d * d), volume_bend = -2 * pi * h1 * h2 / d;
  const Matrix matrix = run_hessian({"good/two.xyzr", "--tension", "-0.75", "--pressure", "2"});
  ASSERT_EQ(matrix.size(), 6U);
  const double along = -0.75 * area_bend + 2 * volume_bend, across = (-0.75 * area_slope + 2 * volume_slope) / d;
  for (size_t row = 0; row < 6; ++row) {
    for (size_t column = 0; column < 6; ++column) {
      const double sign = (row < 3) == (column < 3) ? 1 : -1, size = row % 3 == 0 ? along : across;
      const double expected = row % 3 == column % 3 ? sign * size : 0;
      EXPECT_NEAR(matrix[row][column], expected, 1e-12) << row << ' ' << column;
    }
  }
}

// The derivatives of the energy by all coordinates, as measure prints them.
std::vector<double> gradient(const std::vector<Ball> &balls, const std::string &weights_file, double tension,
                             double pressure, const std::vector<std::string> &window) {
  const TemporaryFile file("moved.xyzr", write_balls(balls));
  std::vector<std::string> arguments = {"measure", file.path(), "--gradient", "--weights", weights_file};
  arguments.insert(arguments.end(), window.begin(), window.end());
  const Json json = run_json(arguments);
  const std::string of_area = window.empty() ? "weighted_gradient" : "windowed_gradient";
  std::vector<double> derivatives;
  for (const Json &ball : json["balls"].items) {
    for (size_t axis = 0; axis < 3; ++axis) {
      derivatives.push_back(tension * ball[of_area].items[axis].number +
                            pressure * ball["volume_gradient"].items[axis].number);
    }
  }
  return derivatives;
}

TEST(Hessian, IsTheDifferenceQuotientOfGradients) {
  const double tension = 1.25, pressure = -0.5, step = 2e-5;
  const TemporaryFile file("seven.xyzr", write_balls(seven)), weighted("seven.weights", write_weights());
  for (const std::vector<std::string> &window : {std::vector<std::string>{}, {"--window", "0.0625"}}) {
    std::vector<std::string> arguments = {file.path(), "--tension", "1.25",         "--pressure",
                                          "-0.5",      "--weights", weighted.path()};
    arguments.insert(arguments.end(), window.begin(), window.end());
    const Matrix matrix = run_hessian(arguments);
    ASSERT_EQ(matrix.size(), 3 * seven.size());
    for (size_t k = 0; k < 3 * seven.size(); ++k) {
      std::array<std::vector<double>, 2> moved;
      for (size_t side = 0; side < 2; ++side) {
        std::vector<Ball> balls = seven;
        balls[k / 3][k % 3] += side == 0 ? -step : step;
        moved[side] = gradient(balls, weighted.path(), tension, pressure, window);
      }
      for (size_t row = 0; row < 3 * seven.size(); ++row) {
        EXPECT_NEAR(matrix[row][k], (moved[1][row] - moved[0][row]) / (2 * step), 1e-5) << row << ' ' << k;
      }
    }
  }
}

// JSON has the same numbers, each block twice.
TEST(Hessian, JsonHasTheRows) {
  const TemporaryFile file("seven.xyzr", write_balls(seven));
  const Matrix matrix = run_hessian({file.path(), "--tension", "1", "--window", "0.05", "--pressure", "1"});
  const Json json = run_json({"hessian", file.path(), "--tension", "1", "--window", "0.05", "--pressure", "1"});
  Matrix found(matrix.size(), std::vector<double>(matrix.size()));
  const std::vector<Json> &first = json["first"].items;
  ASSERT_EQ(first.size(), seven.size() + 1);
  for (size_t i = 0; i < seven.size(); ++i) {
    for (auto k = static_cast<size_t>(first[i].number); k < static_cast<size_t>(first[i + 1].number); ++k) {
      const auto j = static_cast<size_t>(json["ball"].items[k].number);
      for (size_t e = 0; e < 9; ++e) found[3 * i + e / 3][3 * j + e % 3] = json["block"].items[k].items[e].number;
    }
  }
  EXPECT_EQ(found, matrix);
}

// Eight spheres that touch; and two triples whose vertices lie in the plane of the centres.
TEST(Hessian, NamesBallsOfWhichDerivativesFail) {
  const Json corners = run_json({"hessian", "good/corners.xyzr", "--tension", "1"});
  EXPECT_EQ(corners["one_sided"].items.size(), 8U);
  EXPECT_TRUE(corners["singular"].items.empty());
  // Four unit spheres about the corners of a square of diagonal 2 pass through its middle.
  const TemporaryFile square("square.xyzr", "1 0 0 1\n-1 0 0 1\n0 1 0 1\n0 -1 0 1\n");
  EXPECT_FALSE(run_json({"hessian", square.path(), "--tension", "1"})["singular"].items.empty());
  EXPECT_TRUE(run_json({"hessian", square.path(), "--pressure", "1"})["singular"].items.empty());
  const Outcome outcome = run_program({"hessian", square.path(), "--tension", "1"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("\n% singular balls "), std::string::npos);
}

// The mean of the weighted area over R + s weight, by the rule of five points in each of 32 panels.
double mean_over(const std::vector<Ball> &balls, const std::string &weights_file, double width) {
  const std::array<double, 3> at = {0, 0.5384693101056831, 0.9061798459386640},
                              part = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  constexpr int panels = 32;
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    for (int k = -2; k <= 2; ++k) {
      const auto place = static_cast<size_t>(std::abs(k));
      const double s = width * (2 * (panel + 0.5 * (1 + (k < 0 ? -at[place] : at[place]))) / panels - 1);
      std::vector<Ball> grown = balls;
      for (size_t i = 0; i < balls.size(); ++i) grown[i][3] += s * weights[i];
      const TemporaryFile file("grown.xyzr", write_balls(grown));
      sum += part[place] * run_json({"measure", file.path(), "--weights", weights_file})["weighted_area"].number;
    }
  }
  return sum / (2 * panels);
}

TEST(Window, IsTheMeanOverItsRadii) {
  const TemporaryFile file("seven.xyzr", write_balls(seven)), weighted("seven.weights", write_weights());
  const Json json = run_json({"measure", file.path(), "--weights", weighted.path(), "--window", "0.05"});
  EXPECT_NEAR(json["windowed_area"].number, mean_over(seven, weighted.path(), 0.05), 1e-5);  // kinks between the points
  EXPECT_GT(std::abs(json["windowed_area"].number - json["weighted_area"].number), 1e-4);
}

// By every radius, and of a part over radii of its balls alone.
TEST(Window, DerivativesAreDifferenceQuotients) {
  const double step = 2e-5;
  const TemporaryFile weighted("seven.weights", write_weights()), file("seven.xyzr", write_balls(seven));
  const Json exact = run_json({"measure", file.path(), "--weights", weighted.path(), "--window", "0.05", "--gradient"});
  for (size_t i = 0; i < seven.size(); ++i) {
    for (size_t variable = 0; variable < 4; ++variable) {
      std::array<double, 2> moved{};
      for (size_t side = 0; side < 2; ++side) {
        std::vector<Ball> balls = seven;
        balls[i][variable] += side == 0 ? -step : step;
        const TemporaryFile other("moved.xyzr", write_balls(balls));
        moved[side] =
            run_json({"measure", other.path(), "--weights", weighted.path(), "--window", "0.05"})["windowed_area"]
                .number;
      }
      const Json &ball = exact["balls"].items[i];
      const double derivative =
          variable < 3 ? ball["windowed_gradient"].items[variable].number : ball["windowed_dr"].number;
      EXPECT_NEAR(derivative, (moved[1] - moved[0]) / (2 * step), 1e-6) << i << ' ' << variable;
    }
  }
}

// Of one ball of two, of which the other one's radius stays: its free area is 2 pi r (r + h) there.
TEST(Window, OfAPartGrowsItAlone) {
  const double d = 3, w = 0.1;
  const auto volume = [d](double r1, double r2) {
    const double h1 = (d * d + r1 * r1 - r2 * r2) / (2 * d), h2 = d - h1;
    const auto below = [](double r, double h) { return pi * (2 * r * r * r / 3 + r * r * h - h * h * h / 3); };
    return below(r1, h1) + below(r2, h2);
  };
  const TemporaryFile file("two.pdb",
                           "ATOM      1  C   AAA A   1       0.000   0.000   0.000  1.00  0.00           C\n"
                           "ATOM      2  C   BBB A   2       3.000   0.000   0.000  1.00  0.00           C\n");
  const Json json = run_json({"measure", file.path(), "--radius", "C=2", "--of", "residue:AAA", "--window", "0.1"});
  EXPECT_NEAR(json["windowed_area"].number, (volume(2 + w, 2) - volume(2 - w, 2)) / (2 * w), 1e-9);
}

}  // namespace
