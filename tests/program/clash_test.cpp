// hardsphere clash: a molecule against another one that is turned and moved, against sums over all pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "random_numbers.hpp"
#include "temporary_file.hpp"

namespace {

using Point = std::array<double, 3>;
struct Ball {
  Point centre;
  double radius;
};

std::string written(TemporaryFolder &folder, const std::string &name, const std::vector<Ball> &balls) {
  const std::string path = folder.path(name);
  std::ofstream out(path);
  for (const Ball &b : balls) {
    char line[100];
    std::snprintf(line, sizeof line, "%.3f %.3f %.3f %.3f\n", b.centre[0], b.centre[1], b.centre[2], b.radius);
    out << line;
  }
  return path;
}

double thousandths(int64_t value) {
  return static_cast<double>(value) / 1000;
}

std::vector<Ball> random_balls(support::Random &random, int n, int64_t half_side) {
  std::vector<Ball> balls;
  for (int k = 0; k < n; ++k) {
    Ball ball{};
    for (double &x : ball.centre) x = thousandths(random.in(-half_side, half_side));
    ball.radius = thousandths(random.in(800, 2000));
    balls.push_back(ball);
  }
  return balls;
}

Point turned(Point p, int axis, double degrees) {
  const auto a = static_cast<size_t>((axis + 1) % 3), b = static_cast<size_t>((axis + 2) % 3);
  const double angle = degrees * std::acos(-1.0) / 180;
  const double x = p[a], y = p[b];
  p[a] = std::cos(angle) * x - std::sin(angle) * y;
  p[b] = std::sin(angle) * x + std::cos(angle) * y;
  return p;
}

std::string triple(const Point &p) {
  char text[120];
  std::snprintf(text, sizeof text, "%.3f,%.3f,%.3f", p[0], p[1], p[2]);
  return text;
}

TEST(Clash, FindsThePairsThatMeet) {
  TemporaryFolder folder("clash");
  support::Random random(1);
  for (int time = 0; time < 12; ++time) {
    const std::vector<Ball> fixed = random_balls(random, 60, 8000), moving = random_balls(random, 30, 5000);
    Point degrees{}, shift{}, mean{};
    for (size_t k = 0; k < 3; ++k) {
      degrees[k] = thousandths(random.in(-360000, 360000));
      shift[k] = thousandths(random.in(-9000, 9000));
    }
    for (const Ball &ball : moving)
      for (size_t k = 0; k < 3; ++k) mean[k] += ball.centre[k] / 30;
    const Json found = run_json({"clash", written(folder, "fixed.xyzr", fixed), written(folder, "moving.xyzr", moving),
                                 "--rotate", triple(degrees), "--translate", triple(shift)});
    size_t meeting = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < fixed.size(); ++i)
      for (size_t j = 0; j < moving.size(); ++j) {
        Point p = moving[j].centre;
        for (size_t k = 0; k < 3; ++k) p[k] -= mean[k];
        for (int axis = 0; axis < 3; ++axis) p = turned(p, axis, degrees[static_cast<size_t>(axis)]);
        double square = 0;
        for (size_t k = 0; k < 3; ++k) square += std::pow(p[k] + mean[k] + shift[k] - fixed[i].centre[k], 2);
        const double gap = std::sqrt(square) - fixed[i].radius - moving[j].radius;
        least = std::min(least, gap);
        if (gap > 0) continue;
        ASSERT_LT(meeting, found["pairs"].items.size());
        const Json &pair = found["pairs"].items[meeting++];
        EXPECT_EQ(pair.items[0].number, static_cast<double>(i));
        EXPECT_EQ(pair.items[1].number, static_cast<double>(j));
      }
    EXPECT_EQ(found["pairs"].items.size(), meeting);
    EXPECT_EQ(found["hit"].boolean, meeting > 0);
    EXPECT_NEAR(found["gap"].number, least, 1e-7);
  }
}

// The two nearest balls have the names of their files, in the table and in the JSON.
TEST(Clash, NamesTheNearestBalls) {
  const std::vector<std::string> arguments = {"clash", "good/residues.pdb", "good/water.pqr", "--translate", "21,0,0"};
  const Json found = run_json(arguments);
  ASSERT_EQ(found["nearest_balls"].items.size(), 2U);
  const Json &first = found["nearest_balls"].items[0], &second = found["nearest_balls"].items[1];
  EXPECT_EQ(first["ball"].text, found["nearest"].items[0].text);
  EXPECT_EQ(second["ball"].text, found["nearest"].items[1].text);
  EXPECT_EQ(first["atom"].text + ' ' + first["residue"].text + first["number"].text, "CA ALA1");
  EXPECT_EQ(second["atom"].text + ' ' + second["residue"].text, "O HOH");
  const std::string table = run_program(arguments).out;
  for (const char *row : {"\n  first             2  CA     ALA A 1A ", "\n  second            0  O      HOH A 1 "}) {
    EXPECT_NE(table.find(row), std::string::npos) << row << table;
  }
}

// Balls of very different size, whose lattices differ by themselves; they touch exactly.
TEST(Clash, TouchingCounts) {
  TemporaryFolder folder("clash");
  const std::string small = written(folder, "small.xyzr", {{{1, 2, 3}, 1}});
  const std::string large = written(folder, "large.xyzr", {{{1, 2, 3}, 30000}});
  const std::string coarse = "the smallest radius has only 10000 steps";
  for (const char *turn : {"0,0,0", "90,0,0", "180,270,-90"}) {
    const Json touching = run_json({"clash", small, large, "--rotate", turn, "--translate", "0,30001,0"}, coarse);
    EXPECT_TRUE(touching["hit"].boolean);
    EXPECT_EQ(touching["gap"].number, 0);
    EXPECT_EQ(touching["overlap_volume"].number, 0);
    const Json apart = run_json({"clash", small, large, "--rotate", turn, "--translate", "0,30001.001,0"}, coarse);
    EXPECT_FALSE(apart["hit"].boolean);
    EXPECT_NEAR(apart["gap"].number, 0.001, 1e-9);
  }
  const Json probe = run_json({"clash", small, large, "--translate", "0,30003.8,0", "--probe", "1.4"},
                              "the smallest radius has only 24000 steps");
  EXPECT_TRUE(probe["hit"].boolean);
  EXPECT_EQ(probe["gap"].number, 0);
}

TEST(Clash, TellsWhatIsWrong) {
  TemporaryFolder folder("clash");
  const std::string one = written(folder, "one.xyzr", {{{0, 0, 0}, 1}});
  for (const std::vector<std::string> &arguments :
       std::vector<std::vector<std::string>>{{"clash"},
                                             {"clash", one},
                                             {"clash", one, one, one},
                                             {"clash", one, one, "--rotate", "1,2"},
                                             {"clash", one, one, "--translate", "1e30,0,0"},
                                             {"clash", one, one, "--view", "0,0,1"},
                                             {"clash", one, one, "--rotate", "1e7,0,0"},
                                             {"clash", "-", "-", "--format", "xyzr"}}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
  }
  EXPECT_EQ(run_program({"clash", one, folder.path("none.xyzr")}).status, 1);
}

}  // namespace
