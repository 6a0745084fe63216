// Small sets whose geometry is known in closed form, through the program.
#include <gtest/gtest.h>

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

void expect_close(double actual, double expected) {
  EXPECT_NEAR(actual, expected, 1e-13 * std::abs(expected)) << expected;
}

void expect_measure(const std::vector<std::string> &arguments, double area, double volume) {
  std::vector<std::string> all = {"measure"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Json json = run_json(all);
  SCOPED_TRACE(arguments.front());
  EXPECT_EQ(json["area"].kind, Json::Kind::number);
  expect_close(json["area"].number, area);
  expect_close(json["volume"].number, volume);
}

struct Counts {
  int n, vertices, arcs, circles, faces, exposed, shells, components, voids, euler;
};

void expect_boundary(const std::vector<std::string> &arguments, const Counts &counts) {
  std::vector<std::string> all = {"boundary"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Json json = run_json(all);
  SCOPED_TRACE(arguments.front());
  EXPECT_EQ(json["n"].number, counts.n);
  EXPECT_EQ(json["vertices"].number, counts.vertices);
  EXPECT_EQ(json["arcs"].number, counts.arcs);
  EXPECT_EQ(json["circles"].number, counts.circles);
  EXPECT_EQ(json["faces"].number, counts.faces);
  EXPECT_EQ(json["exposed_balls"].number, counts.exposed);
  EXPECT_EQ(json["shells"].number, counts.shells);
  EXPECT_EQ(json["components"].number, counts.components);
  EXPECT_EQ(json["voids"].number, counts.voids);
  EXPECT_EQ(json["euler"].number, counts.euler);
}

double sphere_area(double r) {
  return 4 * pi * r * r;
}
double sphere_volume(double r) {
  return 4 * pi * r * r * r / 3;
}
double cap_area(double r, double height) {
  return 2 * pi * r * height;
}
double cap_volume(double r, double height) {
  return pi * height * height * (3 * r - height) / 3;
}

std::vector<double> hits(const std::vector<std::string> &arguments) {
  std::vector<std::string> all = {"query"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Json json = run_json(all);
  std::vector<double> ids;
  for (const Json &id : json["hits"].items) ids.push_back(id.number);
  return ids;
}

TEST(KnownSolids, OneBall) {
  expect_measure({"good/one.xyzr"}, sphere_area(2), sphere_volume(2));
  expect_measure({"good/one.xyzr", "--probe", "0.5"}, sphere_area(2.5), sphere_volume(2.5));
  expect_boundary({"good/one.xyzr"}, {1, 0, 0, 0, 1, 1, 1, 1, 0, 2});
}

TEST(KnownSolids, PointThatTheProbeBlowsUp) {
  expect_measure({"good/point.xyzr"}, 0, 0);
  expect_measure({"good/point.xyzr", "--probe", "1.4"}, sphere_area(1.4), sphere_volume(1.4));
}

// Radii 2 and 1.5 at distance 3: the plane of their circle lies (9 + 4 - 2.25) / 6 from the first centre.
TEST(KnownSolids, TwoBallsThatOverlap) {
  const double h = (9 + 4 - 2.25) / 6;
  const double lost[2] = {2 - h, 1.5 - (3 - h)};  // heights of the caps that lie inside the other ball
  const double area[2] = {sphere_area(2) - cap_area(2, lost[0]), sphere_area(1.5) - cap_area(1.5, lost[1])};
  expect_measure({"good/two.xyzr"}, area[0] + area[1],
                 sphere_volume(2) - cap_volume(2, lost[0]) + sphere_volume(1.5) - cap_volume(1.5, lost[1]));
  const Json json = run_json({"measure", "good/two.xyzr", "--per-ball"});
  ASSERT_EQ(json["balls"].items.size(), 2u);
  for (size_t i = 0; i < 2; ++i) expect_close(json["balls"].items[i]["area"].number, area[i]);
  expect_boundary({"good/two.xyzr"}, {2, 0, 0, 1, 2, 2, 1, 1, 0, 2});

  const Json model = run_json({"model", "good/two.xyzr"});
  expect_close(model["k"].number, 2 / 1.5);
  expect_close(model["rho"].number, 1.5);
  EXPECT_EQ(model["max_overlaps"].number, 1);
  EXPECT_EQ(model["mean_overlaps"].number, 1);
}

// Balls are closed, so balls that touch are one component; but they do not overlap.
TEST(KnownSolids, TwoBallsThatTouch) {
  expect_measure({"good/touching.xyzr"}, sphere_area(1) + sphere_area(2), sphere_volume(1) + sphere_volume(2));
  EXPECT_EQ(run_json({"boundary", "good/touching.xyzr"})["components"].number, 1);
  EXPECT_EQ(run_json({"model", "good/touching.xyzr"})["max_overlaps"].number, 0);
  EXPECT_EQ(hits({"good/touching.xyzr", "--point", "1", "0", "0"}), (std::vector<double>{0, 1}));
  EXPECT_EQ(hits({"good/touching.xyzr", "--point", "1.00000001", "0", "0"}), std::vector<double>{1});
}

TEST(KnownSolids, TwoBallsApart) {
  expect_measure({"good/apart.xyzr"}, 2 * sphere_area(1), 2 * sphere_volume(1));
  expect_boundary({"good/apart.xyzr"}, {2, 0, 0, 0, 2, 2, 2, 2, 0, 4});
}

TEST(KnownSolids, BallInsideAnother) {
  expect_measure({"good/inside.xyzr"}, sphere_area(3), sphere_volume(3));
  expect_boundary({"good/inside.xyzr"}, {2, 0, 0, 0, 1, 1, 1, 1, 0, 2});
}

TEST(KnownSolids, TheSameBallTwice) {
  expect_measure({"good/same.xyzr"}, sphere_area(1), sphere_volume(1));
  expect_boundary({"good/same.xyzr"}, {2, 0, 0, 0, 1, 1, 1, 1, 0, 2});
}

// Six balls of radius 0.9 at the corners of an octahedron close a cage about the origin, whose wall has the shape of a
// cube with round faces; the outside has the same shape. Vertices: two for each of the eight corner triples.
TEST(KnownSolids, CageWithAVoid) {
  expect_boundary({"good/cage.xyzr"}, {6, 16, 24, 0, 12, 6, 2, 1, 1, 4});
  EXPECT_EQ(hits({"good/cage.xyzr", "--point", "0", "0", "0"}), std::vector<double>{});
  EXPECT_EQ(hits({"good/cage.xyzr", "--point", "0", "0", "0", "--probe", "0.1"}),
            (std::vector<double>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(hits({"good/cage.xyzr", "--ball", "0", "0", "0", "0.1"}), (std::vector<double>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(hits({"good/cage.xyzr", "--ball", "0", "0", "0", "0.09999"}), std::vector<double>{});
  EXPECT_EQ(hits({"good/cage.xyzr", "--ball", "-1.5", "0", "1e-3", "0"}), std::vector<double>{1});
}

// Two balls 2 apart and 1e7 from the origin: no digit is lost on the way.
TEST(KnownSolids, FarFromTheOrigin) {
  const double lost = 0.5;
  expect_measure({"good/huge.xyzr"}, 2 * (sphere_area(1.5) - cap_area(1.5, lost)),
                 2 * (sphere_volume(1.5) - cap_volume(1.5, lost)));
}

// More neighbours than the library's usual limits provide for: a ball with 400 bumps that do not meet each other.
TEST(KnownSolids, ManyNeighbours) {
  constexpr int bumps = 400;
  constexpr double big = 100;
  std::ostringstream text;
  text << "0 0 0 " << big << '\n' << std::setprecision(17);
  for (int i = 0; i < bumps; ++i) {
    const double z = 1 - (2 * i + 1.0) / bumps;
    const double turn = 2.399963229728653 * i;
    const double s = std::sqrt(1 - z * z);
    text << big * s * std::cos(turn) << ' ' << big * s * std::sin(turn) << ' ' << big * z << " 1\n";
  }
  const TemporaryFile file("bumps.xyzr", text.str());
  const std::string &path = file.path();
  expect_boundary({path}, {bumps + 1, 0, 0, bumps, bumps + 1, bumps + 1, 1, 1, 0, 2});
  EXPECT_EQ(run_json({"model", path})["max_overlaps"].number, bumps);
  const double h = (big * big + 1 - big * big) / (2 * big);  // of the circle's plane, from the bump's centre
  const double area = sphere_area(big) + bumps * (cap_area(1, 1 + h) - cap_area(big, h));
  // Positions are rounded to the lattice of the big ball, 1e-7.
  EXPECT_NEAR(run_json({"measure", path})["area"].number, area, 1e-9 * area);
}

// A face that a great circle enters and leaves many times, so that cutting it takes more than the library's estimate
// for a face with two loops: a chain of bumps that winds about a meridian of a large ball, and one bump more on it.
TEST(KnownSolids, WindingFace) {
  constexpr double big = 100;
  std::ostringstream text;
  text << std::fixed << std::setprecision(6) << "0 0 0 " << big << '\n';
  int bumps = 0;
  const auto add_bump = [&](double along, double aside) {
    const double latitude = along / big;
    const double turn = aside / (big * std::cos(latitude));
    text << big * std::cos(latitude) * std::cos(turn) << ' ' << big * std::cos(latitude) * std::sin(turn) << ' '
         << big * std::sin(latitude) << " 3\n";
    ++bumps;
  };
  for (double along = -100; along < 100; along += 2) {
    const double phase = std::fmod(along + 200, 24) / 24;
    add_bump(along, 10 * (phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase));
  }
  add_bump(135, 0);
  const TemporaryFile file("winding.xyzr", text.str());
  const Json json = run_json({"boundary", file.path(), "--shells"});
  EXPECT_EQ(json["exposed_balls"].number, bumps + 1);
  EXPECT_EQ(json["circles"].number, 1);
  EXPECT_EQ(json["shells"].number, 1);
  EXPECT_EQ(json["euler"].number, 2);
  EXPECT_EQ(json["shell_list"].items.at(0)["genus"].number, 0);
  EXPECT_EQ(json["shell_list"].items.at(0)["faces"].number, json["faces"].number);
}

TEST(KnownSolids, RadiiOfTheUser) {
  const double r = 1.25;
  expect_measure({"good/touching_columns.pdb", "--radius", "c=1.25"}, sphere_area(r), sphere_volume(r));
  expect_measure({"good/touching_columns.pdb", "--radii", "chem3d"}, sphere_area(1.52), sphere_volume(1.52));
  expect_measure({"good/touching_columns.pdb", "--radii=chem3d", "--radius=C=7,C=1.25"}, sphere_area(r),
                 sphere_volume(r));
  expect_measure({"good/metal.xyz", "--radius", "FE=1,xx=2"}, sphere_area(1) + sphere_area(2),
                 sphere_volume(1) + sphere_volume(2));
  expect_measure({"good/water_deuterium.xyz", "--radius", "D=0,O=1"}, sphere_area(1), sphere_volume(1));
}

// A lattice that is coarse for small radii beside a large one is said on stderr, by every command; the output is as it
// would be. Radii of 0 do not count.
TEST(KnownSolids, CoarseLatticesAreSaid) {
  const auto note_of = [](const std::string &balls, std::vector<std::string> arguments) {
    const TemporaryFile file("balls.xyzr", balls);
    arguments.insert(arguments.begin() + 1, file.path());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string begin =
        "hardsphere: " + file.path() + ": coordinates and radii are rounded to a coarse lattice: ";
    if (outcome.err.empty()) return outcome.err;
    EXPECT_EQ(outcome.err.substr(0, begin.size()), begin);
    return outcome.err.size() < begin.size() ? outcome.err : outcome.err.substr(begin.size());
  };
  const std::string atoms = "0 0 0 1.7\n9 0 0 1.52\n9 9 9 0\n", large = "-2e7 0 0 1e7\n", small = "5 5 5 1e-7\n",
                    nothing = "5 5 5 1e-9\n";
  const std::string few = "the smallest radius has only 152 steps\n", none = "a radius above 0 became 0\n";
  for (const std::vector<std::string> &command : {std::vector<std::string>{"measure"},
                                                  {"measure", "--json"},
                                                  {"model"},
                                                  {"contacts"},
                                                  {"voids"},
                                                  {"pores"},
                                                  {"query", "--point", "0,0,0"},
                                                  {"draw", "-o", "-"}}) {
    SCOPED_TRACE(command.front());
    EXPECT_EQ(note_of(atoms, command), "");
    EXPECT_EQ(note_of(large + atoms, command), few);
    EXPECT_EQ(note_of(large + nothing, command), none);
    EXPECT_EQ(note_of(atoms + small, command), "the smallest radius has only 10 steps\n");
    EXPECT_EQ(note_of(atoms + nothing, command), none);
  }
  EXPECT_EQ(note_of(large + atoms, {"measure", "--probe", "1e7"}), "");
}

TEST(KnownSolids, TinyLengthsAreRefused) {
  const TemporaryFile file("tiny.xyzr", "0 0 0 1e-24\n2e-24 0 0 1.5e-24\n");
  const Outcome outcome = run_program({"measure", file.path()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "hardsphere: " + file.path() + ": all lengths are below 1.05e-16: give them in a smaller unit\n");
}

}  // namespace
