// Where a void has most room, as `voids` prints it and `gate --from void:K` begins: closed forms, and points on a grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

struct Ball {
  std::array<double, 3> centre;
  double radius;
};

// Six balls at distance `scale` from a point, in every direction of the axes.
std::vector<Ball> cage(double scale, double radius, double x = 0) {
  std::vector<Ball> balls;
  for (const double side : {1.0, -1.0}) {
    for (size_t axis = 0; axis < 3; ++axis) {
      Ball ball = {{x, 0, 0}, radius};
      ball.centre[axis] += side * scale;
      balls.push_back(ball);
    }
  }
  return balls;
}

std::string text_of(const std::vector<Ball> &balls) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (const Ball &ball : balls) {
    text << ball.centre[0] << ' ' << ball.centre[1] << ' ' << ball.centre[2] << ' ' << ball.radius << '\n';
  }
  return text.str();
}

double clearance(const std::vector<Ball> &balls, const std::array<double, 3> &point) {
  double least = INFINITY;
  for (const Ball &ball : balls) {
    const double distance = std::hypot(point[0] - ball.centre[0], point[1] - ball.centre[1], point[2] - ball.centre[2]);
    least = std::min(least, distance - ball.radius);
  }
  return least;
}

std::array<double, 3> point_of(const Json &cavity) {
  std::array<double, 3> point = {NAN, NAN, NAN};
  for (size_t axis = 0; axis < 3 && cavity["point"].items.size() == 3; ++axis) {
    point[axis] = cavity["point"].items[axis].number;
  }
  return point;
}

TEST(VoidRooms, TheMiddleOfACage) {
  const TemporaryFile file("cages.xyzr", text_of(cage(1, 0.9)) + text_of(cage(3, 2.7, 20)));
  const std::vector<Json> voids = run_json({"voids", file.path()})["voids"].items;
  ASSERT_EQ(voids.size(), 2U);
  for (const size_t i : {0U, 1U}) {
    const std::array<double, 3> point = point_of(voids[i]);
    EXPECT_NEAR(point[0], i == 0 ? 20 : 0, 1e-12);
    EXPECT_NEAR(point[1], 0, 1e-12);
    EXPECT_NEAR(point[2], 0, 1e-12);
    EXPECT_NEAR(voids[i]["clearance"].number, i == 0 ? 0.3 : 0.1, 1e-12);
    EXPECT_EQ(voids[i]["clearance_bound"].text, voids[i]["clearance"].text);
  }
}

// The mean of the balls around the void lies in the guest; most room is in one of eight corners: s from the middle
// along a diagonal, s - 0.05 = sqrt(1 - 2 s / sqrt(3) + s^2) - 0.9.
TEST(VoidRooms, BesideAGuest) {
  std::vector<Ball> balls = cage(1, 0.9);
  balls.push_back({{0, 0, 0}, 0.05});
  const TemporaryFile file("guest.xyzr", text_of(balls));
  const Json cavity = run_json({"voids", file.path()})["voids"].items.at(0);
  const double away = 0.2775 / (1.7 + 2 / std::sqrt(3.0));
  const std::array<double, 3> point = point_of(cavity);
  EXPECT_NEAR(cavity["clearance"].number, away - 0.05, 1e-12);
  for (const double coordinate : point) EXPECT_NEAR(std::fabs(coordinate), away / std::sqrt(3.0), 1e-12);
  EXPECT_LT(clearance(balls, {0, 0, 0}), 0);
  const Json probe = run_json({"voids", file.path(), "--probe", "0.01"})["voids"].items.at(0);
  EXPECT_NEAR(probe["clearance"].number, away - 0.06, 1e-12);
}

// So many balls, evenly spread.
std::vector<Ball> shell(int balls, double scale, double radius) {
  std::vector<Ball> result;
  for (int k = 0; k < balls; ++k) {
    const double z = 1 - (2 * k + 1.0) / balls, across = std::sqrt(1 - z * z), angle = 2.39996323 * k;
    result.push_back({{scale * across * std::cos(angle), scale * across * std::sin(angle), scale * z}, radius});
  }
  return result;
}

// The balls of a hollow guest are around both voids, and there is more room in it than around it.
TEST(VoidRooms, AroundAHollowGuest) {
  std::vector<Ball> balls = shell(200, 10, 2);
  for (const Ball &ball : shell(100, 5, 1.5)) balls.push_back(ball);
  const TemporaryFile file("hollow.xyzr", text_of(balls));
  const std::vector<Json> voids = run_json({"voids", file.path()})["voids"].items;
  ASSERT_EQ(voids.size(), 2U);
  std::array<double, 2> away{};
  for (const size_t i : {0U, 1U}) {
    const std::array<double, 3> point = point_of(voids[i]);
    away[i] = std::hypot(point[0], point[1], point[2]);
    EXPECT_NEAR(voids[i]["clearance"].number, clearance(balls, point), 1e-6);
  }
  EXPECT_GT(std::max(away[0], away[1]), 6.5);
  EXPECT_LT(std::min(away[0], away[1]), 0.5);
}

// Many balls as far away as each other: the corners of an icosahedron and of a dodecahedron.
TEST(VoidRooms, ManyBallsAroundThePoint) {
  const double golden = std::numbers::phi;
  std::vector<Ball> balls;
  const double size = std::hypot(1, golden);
  for (const double a : {1.0, -1.0}) {
    for (const double b : {golden, -golden}) {
      balls.push_back({{5, 6 + a, 7 + b}, size - 0.25});
      balls.push_back({{5 + a, 6 + b, 7}, size - 0.25});
      balls.push_back({{5 + b, 6, 7 + a}, size - 0.25});
    }
  }
  const TemporaryFile file("icosahedron.xyzr", text_of(balls));
  const Json cavity = run_json({"voids", file.path()})["voids"].items.at(0);
  const std::array<double, 3> point = point_of(cavity);
  // Balls are rounded to the lattice, of 1e-8.
  for (size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(point[axis], 5.0 + static_cast<double>(axis), 4e-8);
  EXPECT_NEAR(cavity["clearance"].number, 0.25, 4e-8);
  EXPECT_EQ(cavity["clearance_bound"].number, cavity["clearance"].number);
}

// Random guests in a cage: no point of a grid has more room, and one of them nearly as much.
TEST(VoidRooms, NoPointOfAGridHasMore) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> place(-2, 2), size(0.1, 0.7);
  for (int round = 0; round < 12; ++round) {
    std::vector<Ball> balls = cage(20, 18);
    const auto on_lattice = [](double x) { return std::round(1e6 * x) / 1e6; };
    for (int guest = 0; guest <= round; ++guest) {
      const double x = place(random), y = place(random), z = place(random);
      balls.push_back({{on_lattice(x), on_lattice(y), on_lattice(z)}, on_lattice(size(random))});
    }
    const TemporaryFile file("guests.xyzr", text_of(balls));
    const std::vector<Json> voids = run_json({"voids", file.path()})["voids"].items;
    double best = 0;
    for (const Json &cavity : voids) {
      EXPECT_NEAR(clearance(balls, point_of(cavity)), cavity["clearance"].number, 1e-12) << round;
      EXPECT_EQ(cavity["clearance_bound"].number, cavity["clearance"].number) << round;
      best = std::max(best, cavity["clearance"].number);
    }
    double found = 0;
    const double step = 0.25;
    for (double x = -5; x < 5; x += step) {
      for (double y = -5; y < 5; y += step) {
        for (double z = -5; z < 5; z += step) {
          // Behind the windows between the balls of the cage the outside begins.
          if (std::fabs(x) + std::fabs(y) + std::fabs(z) < 7.5) found = std::max(found, clearance(balls, {x, y, z}));
        }
      }
    }
    EXPECT_LE(found, best + 1e-12) << round;
    EXPECT_GE(found, best - step) << round;
  }
}

// The library finds the points of crambin and ubiquitin free, and nothing that a step away has more room.
TEST(VoidRooms, OfMolecules) {
  for (const char *name : {"crambin.pdb", "ubiquitin.pdb"}) {
    const std::string file = molecules_folder() + "/" + name;
    for (const double probe : {0.5, 1.4}) {
      std::vector<Ball> balls;
      const Json measured = run_json({"measure", file, "--per-ball"});
      for (const Json &ball : measured["balls"].items) {
        balls.push_back({{ball["xyz"].items[0].number, ball["xyz"].items[1].number, ball["xyz"].items[2].number},
                         ball["radius"].number + probe});
      }
      const std::vector<Json> voids = run_json({"voids", file, "--probe", std::to_string(probe)})["voids"].items;
      ASSERT_FALSE(voids.empty()) << name;
      for (const Json &cavity : voids) {
        const std::array<double, 3> point = point_of(cavity);
        const double room = cavity["clearance"].number;
        EXPECT_NEAR(clearance(balls, point), room, 1e-12) << name;
        EXPECT_GT(room, 0) << name;
        for (int direction = 0; direction < 27; ++direction) {
          const double move = 0.1 * room;
          const std::array<double, 3> near = {point[0] + move * (direction % 3 - 1),
                                              point[1] + move * (direction / 3 % 3 - 1),
                                              point[2] + move * (direction / 9 - 1)};
          EXPECT_LE(clearance(balls, near), room + 1e-12) << name;
        }
      }
    }
  }
}

// A probe that closes the windows makes a void of what is open without it, and the way out begins there: six balls
// leave windows of sqrt(2/3) about their centres.
TEST(VoidRooms, TheGateBeginsInAVoid) {
  std::vector<Ball> balls = cage(1, 0.7);
  balls.push_back({{0.05, 0, 0}, 0.02});  // where the mean of all seven is
  for (const Ball &ball : cage(3, 2.2, 30)) balls.push_back(ball);
  const TemporaryFile file("open.xyzr", text_of(balls));
  const double windows[2] = {3 * std::sqrt(2.0 / 3) - 2.2, std::sqrt(2.0 / 3) - 0.7};
  EXPECT_EQ(run_program({"gate", file.path(), "--from", "void:1"}).status, 1);
  EXPECT_EQ(run_program({"gate", file.path(), "--from", "void:3", "--probe", "0.3"}).status, 1);
  // With 0.3 both cages are closed, and the large one is first; with 0.12 the small one alone.
  for (const size_t i : {0U, 1U}) {
    const std::string probe = i == 0 ? "0.3" : "0.12";
    const Json gate = run_json({"gate", file.path(), "--from", "void:1", "--probe", probe});
    const std::vector<Json> voids = run_json({"voids", file.path(), "--probe", probe})["voids"].items;
    ASSERT_FALSE(voids.empty()) << i;
    EXPECT_NEAR(gate["widest_probe"].number, windows[i], 2e-8);
    EXPECT_EQ(point_of(voids[0])[0], gate["from"].items.at(0).number);
  }
}

// The void of crambin: its gate is that of reference_values_test.cpp.
TEST(VoidRooms, TheGateOfCrambin) {
  const std::string file = molecules_folder() + "/crambin.pdb";
  EXPECT_NEAR(run_json({"gate", file, "--from=void:1", "--probe", "1.4"})["widest_probe"].number, 0.838840049, 6e-10);
}

}  // namespace
