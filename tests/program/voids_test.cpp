// Voids and shells as the program lists them: cages of six balls, one in another, and a ring.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

constexpr double pi = std::numbers::pi;

// Six balls of radius 0.9 at distance 1 from a centre, in every direction of the axes, all times a scale.
std::string cage(double scale, double x = 0) {
  std::ostringstream text;
  for (const double side : {1.0, -1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      double centre[3] = {x, 0, 0};
      centre[axis] += side * scale;
      text << centre[0] << ' ' << centre[1] << ' ' << centre[2] << ' ' << 0.9 * scale << '\n';
    }
  }
  return text.str();
}

// The volume inside the cage of scale 1: over each point (y, z) of a quadrant stands a piece of a line along x, between
// the caps of the balls on the x axis and outside the other four.
double volume_in_cage() {
  constexpr int steps = 1000;
  const double corner = (2 - std::sqrt(4 - 2.28)) / 6;  // where three spheres meet: (1 - t)^2 + 2 t^2 = 0.81
  const double width = corner / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      const double y = (i + 0.5) * width;
      const double z = (k + 0.5) * width;
      const double end = 1 - std::sqrt(0.81 - y * y - z * z);
      const double inside_y = 0.81 - (1 - y) * (1 - y) - z * z;
      const double inside_z = 0.81 - (1 - z) * (1 - z) - y * y;
      const double begin = std::sqrt(std::max({inside_y, inside_z, 0.0}));
      sum += std::max(0.0, end - begin);
    }
  }
  return 8 * sum * width * width;
}

std::vector<double> balls_of(const Json &cavity) {
  std::vector<double> balls;
  for (const Json &ball : cavity["balls"].items) balls.push_back(ball.number);
  return balls;
}

std::vector<double> from_to(int first, int last) {
  std::vector<double> numbers;
  for (int i = first; i <= last; ++i) numbers.push_back(i);
  return numbers;
}

TEST(Voids, OneCage) {
  const Json json = run_json({"voids", "good/cage.xyzr"});
  EXPECT_EQ(json["n"].number, 6);
  ASSERT_EQ(json["voids"].items.size(), 1u);
  const Json &cavity = json["voids"].items[0];
  EXPECT_EQ(cavity["cell"].number, 1);
  EXPECT_EQ(cavity["components"].number, 0);
  EXPECT_EQ(balls_of(cavity), from_to(0, 5));
  EXPECT_NEAR(cavity["volume"].number, volume_in_cage(), 1e-5 * volume_in_cage());
}

// A probe of 0.09 still fits, one of 0.1 closes the cage.
TEST(Voids, ProbesShrinkThem) {
  EXPECT_EQ(run_json({"voids", "good/cage.xyzr", "--probe", "0.09"})["voids"].items.size(), 1u);
  EXPECT_EQ(run_json({"voids", "good/cage.xyzr", "--probe", "0.11"})["voids"].items.size(), 0u);
}

TEST(Voids, NothingToList) {
  for (const char *file : {"good/one.xyzr", "good/two.xyzr", "good/touching.xyzr"}) {
    EXPECT_TRUE(run_json({"voids", file})["voids"].items.empty()) << file;
  }
}

// Six balls around the origin leave eight windows, around each three of them: the radius of the circle through their
// centres is sqrt(2/3).
TEST(Voids, TheWidestProbeOutOfACage) {
  const TemporaryFile file("open.xyzr", "1 0 0 0.7\n-1 0 0 0.7\n0 1 0 0.7\n0 -1 0 0.7\n0 0 1 0.7\n0 0 -1 0.7\n");
  const Json gate = run_json({"gate", file.path(), "--from", "0 0 0"});
  EXPECT_NEAR(gate["widest_probe"].number, std::sqrt(2.0 / 3) - 0.7, 2e-8);
  EXPECT_EQ(gate["gate"].items.size(), 3U);
  const Json tight = run_json({"gate", file.path(), "--from", "0.2,0,0", "--to", "-5,0,0.1"});
  EXPECT_NEAR(tight["widest_probe"].number, 0.1, 1e-9);
  ASSERT_EQ(tight["gate"].items.size(), 1U);
  EXPECT_EQ(tight["gate"].items[0].number, 0);
  const Json closed = run_json({"gate", "good/cage.xyzr", "--from", "0,0,0"});
  EXPECT_FALSE(closed["passes"].boolean);
  EXPECT_EQ(closed["gate"].items.size(), 0U);
  // Balls as far apart as this would have no place on the usual lattice if they grew until they meet.
  for (const std::string away : {"50", "500000"}) {
    std::string balls;
    for (const std::string sign : {"", "-"}) {
      for (const std::string &place : {sign + away + " 0 0", "0 " + sign + away + " 0", "0 0 " + sign + away}) {
        balls += place + " 1\n";
      }
    }
    const TemporaryFile far("far.xyzr", balls);
    const Json wide = run_json({"gate", far.path(), "--from", "0,0,0"});
    const double distance = std::stod(away);
    EXPECT_NEAR(wide["widest_probe"].number, distance * std::sqrt(2.0 / 3) - 1, 1e-8);
  }
}

// A ball inside takes its volume away and adds its sphere, and is one of the balls around the void.
TEST(Voids, AGuestInTheCage) {
  const TemporaryFile file("guest.xyzr", cage(1) + "0 0 0 0.05\n");
  const Json empty = run_json({"voids", "good/cage.xyzr"})["voids"].items.at(0);
  const Json json = run_json({"voids", file.path()});
  ASSERT_EQ(json["voids"].items.size(), 1u);
  const Json &cavity = json["voids"].items[0];
  EXPECT_EQ(cavity["components"].number, 1);
  EXPECT_EQ(balls_of(cavity), from_to(0, 6));
  EXPECT_NEAR(cavity["volume"].number, empty["volume"].number - 4 * pi * 0.05 * 0.05 * 0.05 / 3, 1e-13);
  EXPECT_NEAR(cavity["area"].number, empty["area"].number + 4 * pi * 0.05 * 0.05, 1e-13);
}

// A ball in the void with a belt around it shows two faces, and is listed once.
TEST(Voids, ABallWithTwoFacesOnTheVoid) {
  std::ostringstream belt;
  belt << std::setprecision(17) << "0 0 0 1\n";
  for (int i = 0; i < 8; ++i) belt << std::cos(pi * i / 4) << ' ' << std::sin(pi * i / 4) << " 0 0.5\n";
  const TemporaryFile file("belt.xyzr", cage(20) + belt.str());
  EXPECT_EQ(run_json({"boundary", file.path()})["faces"].number, 12 + 2 + 8);
  const Json json = run_json({"voids", file.path()});
  ASSERT_EQ(json["voids"].items.size(), 1u);
  EXPECT_EQ(json["voids"].items[0]["components"].number, 1);
  EXPECT_EQ(balls_of(json["voids"].items[0]), from_to(0, 14));
}

// The middle of each cage is where it was put; voids that are too small are counted and not listed.
TEST(Voids, MiddleAndLeastVolume) {
  const TemporaryFile file("cages.xyzr", cage(1) + cage(3, 20) + cage(2, 40) + cage(1, 60));
  const Json all = run_json({"voids", file.path()});
  EXPECT_EQ(all["smaller"].number, 0);
  const std::vector<double> places = {20, 40};
  for (size_t i = 0; i < places.size(); ++i) {
    const std::vector<Json> &middle = all["voids"].items.at(i)["middle"].items;
    ASSERT_EQ(middle.size(), 3u);
    EXPECT_NEAR(middle[0].number, places[i], 1e-12);
    EXPECT_NEAR(middle[1].number, 0, 1e-12);
    EXPECT_NEAR(middle[2].number, 0, 1e-12);
  }
  const std::string between = std::to_string(4 * volume_in_cage());
  const Json large = run_json({"voids", file.path(), "--min-volume", between});
  EXPECT_EQ(large["voids"].items.size(), 2u);
  EXPECT_EQ(large["smaller"].number, 2);
  const Outcome table = run_program({"voids", file.path(), "--min-volume=" + between});
  EXPECT_NE(table.out.find("smaller          2"), std::string::npos) << table.out;
  EXPECT_EQ(table.out.find("balls around"), std::string::npos) << table.out;
  const Outcome walls = run_program({"voids", file.path(), "--balls", "--min-volume", between});
  EXPECT_NE(walls.out.find("balls around void 2"), std::string::npos) << walls.out;
  EXPECT_EQ(walls.out.find("balls around void 3"), std::string::npos) << walls.out;
  EXPECT_EQ(run_program({"voids", file.path(), "--min-volume", "-1"}).status, 2);
  EXPECT_EQ(run_program({"boundary", file.path(), "--min-volume", "1"}).status, 2);
}

// Largest volume first, whatever the order in the file; of equal ones the lower cell.
TEST(Voids, LargestFirst) {
  const TemporaryFile file("cages.xyzr", cage(1) + cage(3, 20) + cage(2, 40) + cage(1, 60));
  const std::vector<Json> voids = run_json({"voids", file.path()})["voids"].items;
  ASSERT_EQ(voids.size(), 4u);
  EXPECT_EQ(balls_of(voids[0]), from_to(6, 11));
  EXPECT_EQ(balls_of(voids[1]), from_to(12, 17));
  for (size_t i = 0; i + 1 < voids.size(); ++i) {
    const double more = voids[i]["volume"].number - voids[i + 1]["volume"].number;
    EXPECT_TRUE(more > 0 || (more == 0 && voids[i]["cell"].number < voids[i + 1]["cell"].number)) << i;
  }
  EXPECT_NEAR(voids[0]["volume"].number, 27 * volume_in_cage(), 1e-3);
  EXPECT_NEAR(voids[1]["volume"].number, 8 * volume_in_cage(), 1e-3);
}

// A cage in the void of a cage twenty times as large: its outside is a wall of the large void.
TEST(Voids, ACageInACage) {
  const TemporaryFile file("nested.xyzr", cage(20) + cage(1));
  const std::vector<Json> voids = run_json({"voids", file.path()})["voids"].items;
  ASSERT_EQ(voids.size(), 2u);
  EXPECT_EQ(voids[0]["components"].number, 1);
  EXPECT_EQ(balls_of(voids[0]), from_to(0, 11));
  EXPECT_EQ(voids[1]["components"].number, 0);
  EXPECT_EQ(balls_of(voids[1]), from_to(6, 11));

  const Json boundary = run_json({"boundary", file.path(), "--shells"});
  EXPECT_EQ(boundary["components"].number, 2);
  EXPECT_EQ(boundary["voids"].number, 2);
  EXPECT_EQ(boundary["shells"].number, 4);
  EXPECT_EQ(boundary["euler"].number, 8);
  double inner_outside = 0;
  for (const Json &shell : boundary["shell_list"].items) {
    const bool wall = shell["kind"].text == "void";
    EXPECT_EQ(shell["euler"].number, 2);
    EXPECT_EQ(shell["genus"].number, 0);
    EXPECT_EQ(shell["faces"].number, 6);
    EXPECT_GT(shell["volume"].number, 0);
    if (!wall && shell["cell"].number != 0) inner_outside = shell["volume"].number;
  }
  EXPECT_GT(inner_outside, 0);
  EXPECT_NEAR(voids[0]["volume"].number, 8000 * volume_in_cage() - inner_outside, 1e-1);
}

// A ball apart, a cage, and a ball in the cage's void: components in the order of their first balls. The table lists
// the shells as the JSON does.
TEST(Voids, ShellsOfABallApartACageAndABallInIt) {
  const TemporaryFile file("three.xyzr", "100 0 0 2\n" + cage(20) + "0 0 0 1\n");
  const Json json = run_json({"boundary", file.path(), "--shells"});
  EXPECT_EQ(json["components"].number, 3);
  EXPECT_EQ(json["voids"].number, 1);
  const std::vector<Json> &shells = json["shell_list"].items;
  ASSERT_EQ(shells.size(), 4u);
  struct Expected {
    const char *kind;
    double component, cell, faces;
    double radius;  // of the ball with this volume; 0: not known in closed form
  };
  const Expected all[] = {{"outer", 0, 0, 1, 2},
                          {"outer", 1, 0, 6, 0},
                          {"void", 1, 1, 6, 20 * std::cbrt(volume_in_cage() * 3 / (4 * pi))},
                          {"outer", 2, 1, 1, 1}};
  std::istringstream table(run_program({"boundary", file.path()}).out);
  for (std::string line; std::getline(table, line) && line.find("encloses") == std::string::npos;) continue;
  for (size_t i = 0; i < 4; ++i) {
    const Json &shell = shells[i];
    const auto expected = std::find_if(std::begin(all), std::end(all), [&](const Expected &one) {
      return shell["component"].number == one.component && shell["kind"].text == one.kind;
    });
    ASSERT_NE(expected, std::end(all)) << i;
    EXPECT_EQ(shell["cell"].number, expected->cell) << i;
    EXPECT_EQ(shell["faces"].number, expected->faces) << i;
    EXPECT_EQ(shell["euler"].number, 2) << i;
    EXPECT_EQ(shell["genus"].number, 0) << i;
    if (expected->radius > 0) {
      EXPECT_NEAR(std::cbrt(shell["volume"].number * 3 / (4 * pi)), expected->radius, 1e-4) << i;
    }
    size_t number = 77;
    std::string kind;
    double component = 77;
    double faces = 77;
    double genus = 77;
    table >> number >> kind >> component >> faces >> genus;
    EXPECT_EQ(number, i);
    EXPECT_EQ(kind, expected->kind) << i;
    EXPECT_EQ(component, expected->component) << i;
    EXPECT_EQ(faces, expected->faces) << i;
    EXPECT_EQ(genus, 0) << i;
    std::getline(table, kind);
    for (size_t other = 0; other < i; ++other) {
      EXPECT_TRUE(shells[other]["component"].number != expected->component ||
                  shells[other]["kind"].text != expected->kind);
    }
  }
}

// A ring of balls is a torus.
TEST(Voids, ARingHasAHandle) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (int i = 0; i < 12; ++i) text << 2 * std::cos(pi * i / 6) << ' ' << 2 * std::sin(pi * i / 6) << " 0 0.8\n";
  const TemporaryFile file("ring.xyzr", text.str());
  const Json json = run_json({"boundary", file.path(), "--shells"});
  EXPECT_EQ(json["euler"].number, 0);
  EXPECT_EQ(json["circles"].number, 12);
  ASSERT_EQ(json["shell_list"].items.size(), 1u);
  EXPECT_EQ(json["shell_list"].items[0]["genus"].number, 1);
  EXPECT_EQ(json["shell_list"].items[0]["kind"].text, "outer");
}

// Shells and voids of molecules add up to what `measure` says, which does not know of them.
TEST(Voids, ShellsAddUpToTheMeasure) {
  for (const char *name : {"caffeine.pdb", "crambin.pdb"}) {
    for (const char *probe : {"0", "0.5", "1.4"}) {
      const std::string file = molecules_folder() + "/" + name;
      SCOPED_TRACE(file + " probe " + probe);
      const Json measure = run_json({"measure", file, "--probe", probe});
      const Json boundary = run_json({"boundary", file, "--probe", probe, "--shells"});
      const Json voids = run_json({"voids", file, "--probe", probe});
      double area = 0;
      double volume = 0;
      double void_area = 0;
      double euler = 0;
      for (const Json &shell : boundary["shell_list"].items) {
        const bool wall = shell["kind"].text == "void";
        area += shell["area"].number;
        volume += (wall ? -1 : 1) * shell["volume"].number;
        void_area += wall ? shell["area"].number : 0;
        euler += shell["euler"].number;
        EXPECT_EQ(shell["euler"].number, 2 - 2 * shell["genus"].number);
      }
      EXPECT_EQ(euler, boundary["euler"].number);
      EXPECT_NEAR(area, measure["area"].number, 1e-11 * area);
      EXPECT_NEAR(volume, measure["volume"].number, 1e-11 * volume);
      double listed = 0;
      for (const Json &cavity : voids["voids"].items) {
        listed += cavity["area"].number;
        EXPECT_GE(cavity["balls"].items.size(), 4u);
        const std::vector<double> balls = balls_of(cavity);
        EXPECT_TRUE(std::is_sorted(balls.begin(), balls.end()));
        EXPECT_EQ(std::adjacent_find(balls.begin(), balls.end()), balls.end());
      }
      EXPECT_NEAR(listed, void_area, 1e-11 * area);
    }
  }
}

}  // namespace
