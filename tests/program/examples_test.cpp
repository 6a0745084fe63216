// The examples of the interface: what they print for sets with a known answer, and where they print it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "molecule_file.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

constexpr double pi = std::numbers::pi;

std::vector<std::string> lines_of(const std::string &text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of(const std::string &line) {
  std::istringstream stream(line);
  std::vector<double> numbers;
  for (double number; stream >> number;) numbers.push_back(number);
  return numbers;
}

// The first balls of a list as the examples read them.
std::string text_of(const support::BallList &balls, size_t count) {
  std::ostringstream text;
  for (size_t i = 0; i < count; ++i) {
    text << balls.xyz[3 * i] << ' ' << balls.xyz[3 * i + 1] << ' ' << balls.xyz[3 * i + 2] << ' ' << balls.radius[i]
         << '\n';
  }
  return text.str();
}

// Three balls around a throat that the probe does not pass: a sphere.
TEST(Examples, TrianglesAreOneSphere) {
  const TemporaryFile file("triangles.xyzr", "1.8 0 0 1.7\n-0.9 1.56 0 1.7\n-0.9 -1.56 0 1.7\n");
  const Outcome outcome = run_example("triangles", {file.path(), "1.4", "0.5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 2u);
  EXPECT_EQ(lines[0], "OFF");
  const std::vector<double> counts = numbers_of(lines[1]);
  EXPECT_EQ(counts.at(0) - counts.at(1) / 2, 2.0);
  EXPECT_EQ(lines.size(), 2 + static_cast<size_t>(counts[0] + counts[1]));
}

// The ring is a torus of six balls and six free circles. Every face but the first is reached across an edge of
// an earlier one, and who lies across whom is mutual.
TEST(Examples, WalkShellVisitsATorus) {
  const Outcome outcome = run_example("walk_shell", {});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::vector<std::string> lines = lines_of(outcome.out);
  EXPECT_EQ(lines.front(), "shell 0 of kind outer");
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  ASSERT_EQ(std::sscanf(lines.back().c_str(), "  V - E + F = %d - %d + %d = 0, genus 1: as the library says", &vertices,
                        &edges, &faces),
            3)
      << lines.back();
  EXPECT_EQ(vertices - edges + faces, 0);
  ASSERT_EQ(lines.size(), static_cast<size_t>(faces) + 2);
  std::vector<std::vector<int>> across(static_cast<size_t>(faces));
  std::vector<bool> seen(static_cast<size_t>(faces));
  int sides = 0;
  for (size_t i = 1; i + 1 < lines.size(); ++i) {
    std::istringstream line(lines[i]);
    std::string word;
    size_t face = 0;
    line >> word >> face;
    ASSERT_LT(face, across.size());
    EXPECT_TRUE(i == 1 || seen[face]) << lines[i];
    seen[face] = true;
    line.ignore(200, ':');
    for (int other = 0; line >> other; ++sides) {
      across[face].push_back(other);
      seen[static_cast<size_t>(other)] = true;
    }
    EXPECT_GE(across[face].size(), 2u);
  }
  EXPECT_EQ(sides, 2 * edges);
  for (size_t a = 0; a < across.size(); ++a) {
    for (size_t b = 0; b < across.size(); ++b) {
      EXPECT_EQ(std::count(across[a].begin(), across[a].end(), static_cast<int>(b)),
                std::count(across[b].begin(), across[b].end(), static_cast<int>(a)));
    }
  }
}

TEST(Examples, CavitiesOfTheCage) {
  const Outcome built_in = run_example("cavities", {});
  EXPECT_EQ(built_in.status, 0) << built_in.err;
  const std::vector<std::string> lines = lines_of(built_in.out);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "cavities: 1");
  EXPECT_NE(lines[1].find("pieces inside 1, balls around: 0 1 2 3 4 5 6"), std::string::npos) << lines[1];
  EXPECT_EQ(lines[2], "the point -0.05 0 0 lies in cavity 1 and cannot get out");
  const std::vector<std::pair<std::vector<std::string>, std::string>> places = {
      {{"0", "0", "0", "0"}, "the point 0 0 0 lies in cavity 1 and cannot get out"},
      {{"0.09", "0", "0", "0"}, "the point 0 0 0 lies in cavity 1 and cannot get out"},
      {{"0.11", "0", "0", "0"}, "the point 0 0 0 lies in a ball"},
      {{"0", "1.89", "0", "0"}, "the point 1.89 0 0 lies in a ball"},
      {{"0", "-3", "4", "0.5"}, "the point -3 4 0.5 lies outside"},
      {{"0", "0", "0", "1.91"}, "the point 0 0 1.91 lies outside"}};
  for (const auto &[place, answer] : places) {
    std::vector<std::string> arguments = {"good/cage.xyzr"};
    arguments.insert(arguments.end(), place.begin(), place.end());
    const Outcome outcome = run_example("cavities", arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(lines_of(outcome.out).back(), answer);
  }
}

// Its cavities are those that the program lists.
TEST(Examples, CavitiesAgreeWithTheProgram) {
  const Outcome outcome = run_example("cavities", {"good/cage.xyzr", "0.02"});
  const Json cavity = run_json({"voids", "good/cage.xyzr", "--probe", "0.02"})["voids"].items.at(0);
  double volume = 0;
  double area = 0;
  ASSERT_EQ(std::sscanf(outcome.out.c_str(), "cavities: 1\ncavity 1: volume %lf, area %lf", &volume, &area), 2);
  EXPECT_NEAR(volume, cavity["volume"].number, 1e-6);
  EXPECT_NEAR(area, cavity["area"].number, 1e-6);
}

TEST(Examples, CavitiesRefuseBadFiles) {
  const TemporaryFile bad("bad.xyzr", "0 0 0 1\n0 0 1\n");
  for (const std::string &file : {bad.path(), std::string("no_such_file.xyzr")}) {
    const Outcome outcome = run_example("cavities", {file});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind(file + ":", 0), 0u) << outcome.err;
  }
}

// A ball with two others in it whose centres are on its sphere: its face has two loops, each of theirs one. Two equal
// spheres whose distance is their radius r meet in a circle of radius r sqrt(3) / 2.
TEST(Examples, FaceLoopsOfABallWithTwoBites) {
  const TemporaryFile file("bites.xyzr", "0 0 0 2\n2 0 0 2\n-2 0 0 2\n");
  const Outcome outcome = run_example("face_loops", {file.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 5u) << outcome.out;
  std::vector<int> loops_of_ball(3);
  for (size_t i = 1; i < lines.size(); ++i) {
    const std::vector<double> numbers = numbers_of(lines[i]);
    ASSERT_EQ(numbers.size(), 4u);
    ++loops_of_ball.at(static_cast<size_t>(numbers[1]));
    EXPECT_EQ(numbers[2], 0.0) << "a whole circle has no arcs";
    EXPECT_NEAR(numbers[3], 2 * pi * std::sqrt(3.0), 1e-7);
  }
  EXPECT_EQ(loops_of_ball, (std::vector<int>{2, 1, 1}));
}

// Three equal spheres through each other's centres: two vertices, three arcs, and around each ball's face two of them.
TEST(Examples, FaceLoopsOfThreeBalls) {
  const TemporaryFile file("three.xyzr", "0 0 0 1\n1 0 0 1\n0.5 0.8660254 0 1\n");
  const Outcome outcome = run_example("face_loops", {file.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 4u) << outcome.out;
  // Each circle of radius sqrt(3) / 2 is free but for the part in the third ball: up to angles with cosine
  // -(1/3) seen from the circle's centre, where the third ball's centre is in direction 0.
  const double free_angle = 2 * pi - 2 * std::acos(1.0 / 3.0);
  for (size_t i = 1; i < lines.size(); ++i) {
    const std::vector<double> numbers = numbers_of(lines[i]);
    ASSERT_EQ(numbers.size(), 4u);
    EXPECT_EQ(numbers[2], 2.0);
    EXPECT_NEAR(numbers[3], 2 * free_angle * std::sqrt(3.0) / 2, 1e-6);
  }
}

// Forces that are the derivatives of the energy keep the sum of potential and kinetic energy.
TEST(Examples, DynamicsKeepsTheEnergy) {
  const support::BallList crambin =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  const TemporaryFile file("hundred.xyzr", text_of(crambin, 100));
  const Outcome outcome = run_example("dynamics", {file.path(), "60"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 5u) << outcome.out;
  double kinetic = 0;
  double drift = 0;
  ASSERT_EQ(
      std::sscanf(lines.back().c_str(), "# largest kinetic energy %lf, total energy kept within %lf", &kinetic, &drift),
      2);
  EXPECT_GT(kinetic, 0.1);
  EXPECT_LT(drift, 5e-3 * kinetic);
}

// A ball of radius 1/2 about a ball of radius 1, in steps of 1/2: they meet up to 3 steps, and are in touch up to 5.
TEST(Examples, DockingOfTwoBalls) {
  const TemporaryFile receptor("receptor.xyzr", "0 0 0 1\n");
  const TemporaryFile ligand("ligand.xyzr", "0 0 0 0.5\n");
  int clashes = 0;
  for (int i = 0; i < 11 * 11 * 11; ++i) {
    const int x = i % 11 - 5;
    const int y = i / 11 % 11 - 5;
    const int z = i / 121 - 5;
    if (x * x + y * y + z * z <= 9) ++clashes;
  }
  const Outcome outcome = run_example("docking", {receptor.path(), ligand.path(), "0.5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "1331 places, " + std::to_string(clashes) + " of them clash, " +
                          std::to_string(2 * 1331 - clashes) + " queries");
  double x = 0;
  double y = 0;
  double z = 0;
  ASSERT_EQ(std::sscanf(lines[1].c_str(), "best shift %lf %lf %lf: 1 contacts", &x, &y, &z), 3) << lines[1];
  EXPECT_GT(x * x + y * y + z * z, 2.25);
  EXPECT_LE(x * x + y * y + z * z, 6.25);
  for (const char *step : {"0", "-1", "nan", "inf", "much"}) {
    const Outcome refused = run_example("docking", {receptor.path(), ligand.path(), step});
    EXPECT_EQ(refused.status, 2) << step;
    EXPECT_EQ(refused.err.rfind("usage: docking", 0), 0u) << refused.err;
  }
}

struct PrintedPose {
  double w, x, y, z;
  std::array<double, 3> shift;

  // By two cross products: p + 2 w (u x p) + 2 u x (u x p) for a quaternion w, u of length 1.
  std::array<double, 3> image(const double *p) const {
    const std::array<double, 3> u{x, y, z};
    const auto cross = [&u](const auto &v) {
      return std::array<double, 3>{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    };
    const std::array<double, 3> once = cross(p), twice = cross(once);
    std::array<double, 3> moved{};
    for (size_t k = 0; k < 3; ++k) moved[k] = p[k] + 2 * w * once[k] + 2 * twice[k] + shift[k];
    return moved;
  }
};

support::BallList about_mean(support::BallList balls) {
  for (size_t axis = 0; axis < 3; ++axis) {
    double sum = 0;
    for (size_t i = axis; i < balls.xyz.size(); i += 3) sum += balls.xyz[i];
    for (size_t i = axis; i < balls.xyz.size(); i += 3) balls.xyz[i] -= sum / balls.size();
  }
  return balls;
}

// Caffeine finds a place at crambin. Brute force over all pairs finds no clash there, and as many contacts.
TEST(Examples, MonteCarloDocksCaffeine) {
  const auto molecule = [](const char *file) {
    return with_radii(support::read_atoms(support::own_molecule(file)), support::Radii::van_der_waals);
  };
  const support::BallList crambin = molecule("crambin.pdb"), caffeine = molecule("caffeine.pdb");
  const TemporaryFile receptor("receptor.xyzr", text_of(crambin, crambin.size()));
  const TemporaryFile ligand("ligand.xyzr", text_of(caffeine, caffeine.size()));
  const Outcome outcome = run_example("monte_carlo", {receptor.path(), ligand.path(), "3000"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_GE(lines.size(), 2u);
  unsigned clashes = 0, accepted = 0, contacts = 0;
  ASSERT_EQ(std::sscanf(lines[0].c_str(), "3001 poses: %u clash, %u accepted", &clashes, &accepted), 2) << lines[0];
  EXPECT_GT(clashes, 100u);
  EXPECT_GT(accepted, 100u);
  EXPECT_LE(clashes + accepted, 3000u);
  PrintedPose pose{};
  ASSERT_EQ(std::sscanf(lines[1].c_str(), "best: %u contacts, quaternion %lf %lf %lf %lf, translation %lf %lf %lf",
                        &contacts, &pose.w, &pose.x, &pose.y, &pose.z, &pose.shift[0], &pose.shift[1], &pose.shift[2]),
            8)
      << lines[1];
  EXPECT_GT(contacts, 20u);
  const support::BallList fixed = about_mean(crambin), moving = about_mean(caffeine);
  unsigned within_reach = 0;
  for (size_t j = 0; j < moving.size(); ++j) {
    const std::array<double, 3> at = pose.image(&moving.xyz[3 * j]);
    for (size_t i = 0; i < fixed.size(); ++i) {
      const double gap =
          std::hypot(at[0] - fixed.xyz[3 * i], at[1] - fixed.xyz[3 * i + 1], at[2] - fixed.xyz[3 * i + 2]) -
          fixed.radius[i] - moving.radius[j];
      EXPECT_GT(gap, 0);
      within_reach += gap <= 1 ? 1 : 0;
    }
  }
  EXPECT_EQ(within_reach, contacts);
}

// A small ball before a large one, and one behind it that is not seen. Of the large one a ring is left, of which the
// widest place is beyond its middle: 5 - (2.5 - 1) wide, at half that from its rim.
TEST(Examples, LabelsOfThreeBalls) {
  const TemporaryFile file("three.xyzr", "0 0 0 5\n2.5 0 20 1\n0 0 -20 3\n");
  const Outcome outcome = run_example("labels", {file.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 20u) << outcome.out;
  // The origin is the middle of the centres: 1.25 0.
  const std::vector<double> large = numbers_of(lines[1]), small = numbers_of(lines[2]);
  ASSERT_EQ(large.size(), 5u) << lines[1];
  ASSERT_EQ(small.size(), 5u) << lines[2];
  EXPECT_NEAR(large[1], 24 * pi, 1e-6);
  EXPECT_NEAR(small[1], pi, 1e-6);
  EXPECT_NEAR(small[2], 1.25, 1e-6);
  EXPECT_NEAR(small[3], 0, 1e-6);
  EXPECT_NEAR(small[4], 1, 1e-6);
  const double widest = 0.5 * (5 + 1.5);
  EXPECT_LE(large[4], widest);
  EXPECT_GE(large[4], widest / (1 + 1.0 / 64) - 1e-6);
  EXPECT_LE(std::hypot(large[2] + 1.25, large[3]), 5 - large[4] + 2e-6);
  EXPECT_GE(std::hypot(large[2] + 1.25, large[3]), 5 - widest - 0.1);
  EXPECT_EQ(lines[3], "most is seen of ball 0");
  EXPECT_EQ(lines[4].substr(0, 3), "rim");
  size_t on_rim = 0;
  double x = 0;
  double y = 0;
  for (; std::sscanf(lines.at(5 + on_rim).c_str(), "%lf %lf", &x, &y) == 2; ++on_rim) {
    EXPECT_NEAR(std::hypot(x + 1.25, y), 5, 2e-6);
  }
  EXPECT_GT(on_rim, 30u);
  EXPECT_EQ(lines.at(5 + on_rim).substr(0, 4), "hole");
  for (size_t i = 6 + on_rim; i < lines.size(); ++i) {
    ASSERT_EQ(std::sscanf(lines[i].c_str(), "%lf %lf", &x, &y), 2);
    EXPECT_NEAR(std::hypot(x - 1.25, y), 1, 2e-6);
  }
  // From the other side the ball behind is in front.
  EXPECT_EQ(numbers_of(lines_of(run_example("labels", {file.path(), "0", "0", "-1"}).out).at(2)).at(0), 2);
}

// Points on a line 1.5 apart: up to a cutoff of 3 each has two later ones, the last two fewer. 3 counts, less does not.
TEST(Examples, NeighbourListOfARow) {
  std::ostringstream row;
  for (int i = 0; i < 10; ++i) row << 1.5 * i << " 0 0 1\n";
  const TemporaryFile file("row.xyzr", row.str());
  const auto pairs = [&](const char *cutoff) {
    const Outcome outcome = run_example("neighbour_list", {file.path(), cutoff});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_EQ(pairs("3"), "17 pairs\n");
  EXPECT_EQ(pairs("2.9999"), "9 pairs\n");
  EXPECT_EQ(pairs("1.4999"), "0 pairs\n");
  EXPECT_EQ(pairs("20"), "45 pairs\n");
  const Outcome printed = run_example("neighbour_list", {file.path(), "3", "print"});
  const std::vector<std::string> lines = lines_of(printed.out);
  ASSERT_EQ(lines.size(), 11u);
  EXPECT_EQ(lines[1], "0: 1 2");
  EXPECT_EQ(lines[9], "8: 9");
  EXPECT_EQ(lines[10], "9:");
}

// The cage has a void in its middle. One thread or many, the counts are the same.
TEST(Examples, ThreadsOnOneHandle) {
  const Outcome alone = run_example("threads", {"good/cage.xyzr", "1"});
  ASSERT_EQ(alone.status, 0) << alone.err;
  unsigned outside = 0;
  unsigned in_voids = 0;
  unsigned in_balls = 0;
  ASSERT_EQ(
      std::sscanf(alone.out.c_str(), "%u points outside, %u in voids, %u in balls", &outside, &in_voids, &in_balls), 3)
      << alone.out;
  EXPECT_EQ(outside + in_voids + in_balls, 24u * 24u * 24u);
  // Grid points in the balls, by their definition.
  unsigned expected = 0;
  const double step = 3.8 / 23;
  for (int at = 0; at < 24 * 24 * 24; ++at) {
    const double p[3] = {-1.9 + step * (at % 24), -1.9 + step * (at / 24 % 24), -1.9 + step * (at / 576)};
    bool inside = false;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        double square = 0;
        for (int k = 0; k < 3; ++k) square += std::pow(p[k] - (k == axis ? side : 0), 2);
        inside = inside || square <= 0.81;
      }
    }
    if (inside) ++expected;
  }
  EXPECT_EQ(in_balls, expected);
  EXPECT_EQ(in_voids, 8u) << "the eight points about the middle";
  for (const char *threads : {"2", "5", "16"}) {
    EXPECT_EQ(run_example("threads", {"good/cage.xyzr", threads}).out, alone.out) << threads;
  }
}

// With a window Newton's method converges; the plain area's slope jumps where balls touch, and there it ends.
TEST(Examples, NewtonConvergesWithAWindow) {
  const auto gradient_at_end = [](const std::vector<std::string> &arguments) {
    const Outcome outcome = run_example("newton", arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::vector<std::string> lines = lines_of(outcome.out);
    double energy = 0, gradient = 1;
    EXPECT_EQ(std::sscanf(lines.back().c_str(), "ends at energy %lf, gradient %lf", &energy, &gradient), 2);
    EXPECT_LE(lines.size(), 61u);
    return gradient;
  };
  for (const char *start : {"2", "5", "8"}) {
    EXPECT_LE(gradient_at_end({"0.05", start}), 1e-12) << start;
    EXPECT_GT(gradient_at_end({"0", start}), 1.0) << start;
  }
}

// Atoms on springs and what their union costs: the energy falls from step to step, and where it ends is what the
// program measures there.
TEST(Examples, MinimiseDescends) {
  const support::BallList crambin =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  const TemporaryFile file("forty.xyzr", text_of(crambin, 40));
  const double pressure = 0.03, tension = 0.06, bending = -0.2, gaussian = 0.5;
  const Outcome outcome = run_example("minimise", {file.path(), "40", "0.03", "0.06", "-0.2", "0.5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::vector<std::vector<double>> steps;
  std::vector<std::vector<double>> ends;
  for (const std::string &line : lines_of(outcome.out)) {
    if (line.front() != '#') {
      ends.push_back(numbers_of(line));
    } else if (const std::vector<double> numbers = numbers_of(line.substr(1)); !numbers.empty()) {
      ASSERT_EQ(numbers.size(), 6u) << line;
      steps.push_back(numbers);
    }
  }
  ASSERT_GT(steps.size(), 10u);
  for (size_t k = 1; k < steps.size(); ++k) {
    EXPECT_GT(steps[k][0], steps[k - 1][0]);
    EXPECT_LE(steps[k][1], steps[k - 1][1]);
  }
  EXPECT_LT(steps.back()[2], 0.1 * steps.front()[2]);
  ASSERT_EQ(ends.size(), 40u);
  const TemporaryFile end("end.xyzr", outcome.out);
  const Json found = run_json({"measure", end.path(), "--probe", "1.4", "--curvature"});
  double energy = pressure * found["volume"].number + tension * found["area"].number +
                  bending * found["mean_curvature"].number + gaussian * found["gauss_curvature"].number;
  for (size_t i = 0; i < ends.size(); ++i) {
    for (size_t axis = 0; axis < 3; ++axis) energy += 2.5 * std::pow(ends[i][axis] - crambin.xyz[3 * i + axis], 2);
  }
  EXPECT_NEAR(steps.back()[1], energy, 1e-5);
  EXPECT_NEAR(steps.back()[3], found["volume"].number, 1e-5);
  EXPECT_NEAR(steps.back()[4], found["area"].number, 1e-5);
  EXPECT_NEAR(steps.back()[5], found["mean_curvature"].number, 1e-4);
}

// Unit spheres at distance 1: each loses a cap of height 1/2, and they touch in a disk of radius sqrt(3) / 2.
TEST(Examples, InterfaceOfTwoBalls) {
  const TemporaryFile first("first.xyzr", "0 0 0 1\n"), second("second.xyzr", "9 0 0 1\n1 0 0 1\n");
  const Outcome outcome = run_example("interface", {first.path(), second.path(), "0"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 6u) << outcome.out;
  for (size_t chain = 1; chain <= 2; ++chain) {
    const std::vector<double> row = numbers_of(lines[chain]);
    ASSERT_EQ(row.size(), 5u);
    EXPECT_EQ(row[1], static_cast<double>(chain));
    EXPECT_NEAR(row[2], 4 * pi * static_cast<double>(chain), 1e-6);
    EXPECT_NEAR(row[4], pi, 1e-6);
  }
  double buried = 0, area = 0, border = 0, pair = 0, distance = 0;
  EXPECT_EQ(std::sscanf(lines[3].c_str(), "buried in all %lf", &buried), 1);
  EXPECT_EQ(std::sscanf(lines[4].c_str(), "contact area %lf in 1 pairs of atoms, %lf of", &area, &border), 2);
  EXPECT_EQ(std::sscanf(lines[5].c_str(), "0 of the first, 1 of the second: area %lf, distance %lf", &pair, &distance),
            2);
  EXPECT_NEAR(buried, 2 * pi, 1e-6);
  EXPECT_NEAR(area, 0.75 * pi, 1e-6);
  EXPECT_NEAR(border, pi * std::sqrt(3.0), 1e-6);
  EXPECT_EQ(pair, area);
  EXPECT_EQ(distance, 1.0);
}

// Two halves of crambin as if they were chains: the contacts between them that the program lists for the whole.
TEST(Examples, InterfaceAgreesWithTheProgram) {
  const support::BallList crambin =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  const size_t half = 163;
  const std::string all = text_of(crambin, crambin.size()), head = text_of(crambin, half);
  const TemporaryFile whole("whole.xyzr", all), first("first.xyzr", head),
      second("second.xyzr", all.substr(head.size()));
  const Json contacts = run_json({"contacts", whole.path(), "--probe", "1.4"});
  double expected = 0, largest = 0;
  unsigned pairs = 0;
  for (const Json &pair : contacts["pairs"].items) {
    if ((pair["balls"].items[0].number < half) == (pair["balls"].items[1].number < half)) continue;
    expected += pair["area"].number;
    largest = std::max(largest, pair["area"].number);
    ++pairs;
  }
  const Outcome outcome = run_example("interface", {first.path(), second.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 15u) << outcome.out;
  double area = 0, top = 0;
  unsigned found = 0;
  ASSERT_EQ(std::sscanf(lines[4].c_str(), "contact area %lf in %u pairs", &area, &found), 2) << lines[4];
  EXPECT_NEAR(area, expected, 1e-5);
  EXPECT_EQ(found, pairs);
  ASSERT_EQ(std::sscanf(lines[5].c_str(), "%*u of the first, %*u of the second: area %lf", &top), 1) << lines[5];
  EXPECT_NEAR(top, largest, 1e-6);
  const double alone[2] = {run_json({"measure", first.path(), "--probe", "1.4"})["area"].number,
                           run_json({"measure", second.path(), "--probe", "1.4"})["area"].number};
  const double together = run_json({"measure", whole.path(), "--probe", "1.4"})["area"].number;
  double buried = 0;
  ASSERT_EQ(std::sscanf(lines[3].c_str(), "buried in all %lf", &buried), 1);
  EXPECT_NEAR(buried, alone[0] + alone[1] - together, 1e-5);
}

// Waters of radius 1.4 around two balls, one of which lies across a face of the box and is given far away: on the
// points of a grid that are farther than that from the spheres of all images. They do not overlap.
TEST(Examples, SolventBoxOfTwoBalls) {
  const double box[3] = {12, 15, 18}, balls[2][4] = {{1, 2, 3, 2}, {31, -8, 8, 1.5}};
  const int grid[3] = {4, 5, 6};
  const TemporaryFile file("solute.xyzr", "1 2 3 2\n31 -8 8 1.5\n");
  std::vector<std::array<double, 3>> waters;
  const auto gap = [&](const std::array<double, 3> &at, const double(&ball)[4]) {
    double square = 0;
    for (size_t k = 0; k < 3; ++k) square += std::pow(std::remainder(at[k] - ball[k], box[k]), 2);
    return std::sqrt(square) - 1.4 - ball[3];
  };
  unsigned near = 0;
  for (int k = 0; k < 4 * 5 * 6; ++k) {
    const int place[3] = {k % 4, k / 4 % 5, k / 20};
    std::array<double, 3> at{};
    for (size_t axis = 0; axis < 3; ++axis) at[axis] = (place[axis] + 0.5) * box[axis] / grid[axis];
    const double least = std::min(gap(at, balls[0]), gap(at, balls[1]));
    if (least <= 0) continue;
    waters.push_back(at);
    near += least <= 1 ? 1 : 0;
  }
  const Outcome outcome = run_example("solvent_box", {file.path(), "12", "15", "18"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 5u) << outcome.out;
  const double sphere = 4 * pi / 3 * 1.4 * 1.4 * 1.4, molecule = 4 * pi / 3 * (8 + 3.375);
  const auto expect_volumes = [&](const std::string &line, const char *pattern, double volume) {
    double found = 0, area = 0, free = 0, all = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), pattern, &found, &area, &free, &all), 4) << line;
    EXPECT_NEAR(found, volume, 2e-6);
    EXPECT_NEAR(free, 12 * 15 * 18 - volume, 2e-6);
    EXPECT_EQ(all, 12 * 15 * 18);
  };
  expect_volumes(lines[0], "molecule: volume %lf, area %lf, free %lf of %lf", molecule);
  const double many = static_cast<double>(waters.size());
  EXPECT_EQ(lines[1], std::to_string(waters.size()) + " waters");
  expect_volumes(lines[2], "with waters: volume %lf, area %lf, free %lf of %lf", molecule + many * sphere);
  EXPECT_EQ(lines[3], std::to_string(near) + " waters no more than 1 from the molecule");
  // The grid's points are 3 apart, so waters no more than 1 apart are all of one net.
  EXPECT_EQ(lines[4], "1 components, the largest of " + std::to_string(waters.size() + 2) +
                          " balls, endless in 3 directions at most");
  EXPECT_GT(near, 5u);
  EXPECT_LT(near, waters.size() / 2);
  for (const char *side : {"nought", "1", "9999"}) {
    EXPECT_EQ(run_example("solvent_box", {file.path(), "12", side, "18"}).status, 2);
  }
}

// Balls of a cubic lattice that touch across the faces of its cells leave a void in each cell between eight of them.
// The same bits in any bricks, and once more from the files of another run.
TEST(Examples, BricksHaveTheWholesVoids) {
  const TemporaryFile file("one.xyzr", "0 0 0 1.5\n");
  const std::string folder = std::filesystem::path(file.path()).parent_path() / "summaries";
  const auto run = [&](const char *size, bool keeps) {
    std::vector<std::string> arguments = {file.path(), "2", "2", "2", "6", "5", "4", size};
    if (keeps) arguments.push_back(folder);
    return run_example("bricks", arguments);
  };
  const Outcome whole = run("6", false);
  ASSERT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(whole.out.rfind("120 balls, 1 components, 60 voids, Euler number 122\n", 0), 0u) << whole.out;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  for (const char *size : {"1", "2", "3", "4", "5"}) EXPECT_EQ(run(size, false).out, whole.out);
  EXPECT_EQ(run("2", true).out, whole.out);
  EXPECT_TRUE(std::filesystem::remove(folder + "/7.brick"));
  EXPECT_EQ(run("2", true).out, whole.out);
  // Three at a time, of which one dies: the last one makes what is missing.
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const auto part = [&](const char *number) {
    return run_example("bricks", {file.path(), "2", "2", "2", "6", "5", "4", "2", folder, number, "3"});
  };
  for (const char *number : {"0", "2"}) {
    const Outcome some = part(number);
    EXPECT_EQ(some.status, 0) << some.err;
    EXPECT_EQ(some.out, "");
  }
  const std::filesystem::directory_iterator summaries(folder);
  EXPECT_EQ(std::distance(begin(summaries), end(summaries)), 12);
  EXPECT_EQ(run("2", true).out, whole.out);
  EXPECT_EQ(part("3").status, 2);
  // Of other bricks, and half of one.
  EXPECT_EQ(run("3", true).status, 1);
  std::filesystem::resize_file(folder + "/7.brick", 100);
  const Outcome damaged = run("2", true);
  EXPECT_EQ(damaged.status, 1);
  EXPECT_NE(damaged.err.find("not as they were written"), std::string::npos) << damaged.err;
  std::filesystem::remove_all(folder);
  EXPECT_EQ(run("0", false).status, 2);
  // Points have one lattice in all bricks.
  const TemporaryFile points("points.xyzr", "0.3 0.1 0.2 0\n1 0.5 0 0\n");
  const auto of_points = [&](const char *size) {
    return run_example("bricks", {points.path(), "2", "2", "2", "6", "5", "4", size});
  };
  EXPECT_EQ(of_points("6").out.rfind("240 balls, 240 components, 0 voids", 0), 0u);
  EXPECT_EQ(of_points("1").out, of_points("6").out);
}

// Of a part of the bricks nothing but the summaries is left, so that one that cannot be kept is a failure; a whole has
// its totals without.
TEST(Examples, BricksSayWhatIsNotKept) {
  const TemporaryFile file("one.xyzr", "0 0 0 1.5\n");
  std::vector<std::string> arguments = {file.path(), "2", "2", "2", "2", "2", "2", "1", "no_such_folder"};
  const Outcome whole = run_example("bricks", arguments);
  EXPECT_EQ(whole.status, 0);
  EXPECT_NE(whole.err.find("no_such_folder/0.brick:"), std::string::npos) << whole.err;
  arguments.insert(arguments.end(), {"0", "2"});
  EXPECT_EQ(run_example("bricks", arguments).status, 1);
  // Names of summaries are whole or refused.
  arguments[8] = std::string(5000, 'd');
  EXPECT_EQ(run_example("bricks", arguments).status, 1);
}

TEST(Examples, BricksOfLargeNumbers) {
  const TemporaryFile file("one.xyzr", "0 0 0 1.5\n");
  using Cells = std::array<const char *, 3>;
  const auto run = [&](const Cells &cells, const char *size) {
    return run_example("bricks", {file.path(), "2", "2", "2", cells[0], cells[1], cells[2], size});
  };
  const Outcome one = run({"2", "2", "2"}, "2");
  EXPECT_EQ(one.out.rfind("8 balls, 1 components, 1 voids", 0), 0u) << one.out;
  EXPECT_EQ(run({"2", "2", "2"}, "2147483647").out, one.out);
  // More bricks than numbers for them, and more cells in one.
  for (const Cells &cells : {Cells{"65536", "65536", "1"}, Cells{"2097153", "1", "1"}, Cells{"2147483647", "1", "1"},
                             Cells{"100000", "100000", "100000"}}) {
    EXPECT_EQ(run(cells, "1").status, 2) << cells[0] << " " << cells[1];
  }
  EXPECT_EQ(run({"2147483647", "2147483647", "2147483647"}, "2147483647").status, 2);
}

TEST(Examples, RefuseBadFiles) {
  const TemporaryFile bad("bad.xyzr", "0 0 0 1\n0 0 1\n");
  const std::string good = "good/one.xyzr";
  const std::vector<std::pair<std::string, std::vector<std::string>>> calls = {
      {"dynamics", {bad.path()}},
      {"face_loops", {bad.path()}},
      {"neighbour_list", {bad.path(), "3"}},
      {"labels", {bad.path()}},
      {"threads", {bad.path()}},
      {"docking", {good, bad.path()}},
      {"interface", {good, bad.path()}},
      {"minimise", {bad.path()}},
      {"monte_carlo", {good, bad.path()}},
      {"single_atoms", {bad.path()}},
      {"solvent_box", {bad.path(), "9", "9", "9"}},
      {"turntable", {bad.path(), "no_picture"}}};
  for (const auto &[example, arguments] : calls) {
    const Outcome outcome = run_example(example, arguments);
    EXPECT_EQ(outcome.status, 1) << example;
    EXPECT_EQ(outcome.out, "") << example;
    EXPECT_EQ(outcome.err.rfind(bad.path() + ":", 0), 0u) << outcome.err;
    EXPECT_EQ(run_example(example, {}).status, 2) << example;
  }
}

// Numbers in a comment are none, however long it is; a line without a comment is read whole or not at all; a folder is
// no file.
TEST(Examples, ReadLinesOfAnyLength) {
  const std::string one = "0 0 0 1\n", blanks(600, ' ');
  const TemporaryFile comment("comment.xyzr", "#" + blanks + "1 2 3 1\n" + one), last("last.xyzr", one + "#" + blanks),
      cut("cut.xyzr", "1 2 3" + blanks + "1\n" + one);
  for (const TemporaryFile *file : {&comment, &last}) {
    EXPECT_EQ(run_example("neighbour_list", {file->path(), "1", "print"}).out, "0 pairs\n0:\n");
  }
  for (const std::string &refused : {cut.path(), inputs_folder()}) {
    const Outcome outcome = run_example("neighbour_list", {refused, "1"});
    EXPECT_EQ(outcome.status, 1) << outcome.out;
    EXPECT_EQ(outcome.err.rfind(refused + ":", 0), 0u) << outcome.err;
  }
  EXPECT_EQ(run_example("frames", {inputs_folder()}).status, 1);
}

// A failure has its reason on standard error, and no result.
TEST(Examples, SayWhyTheyFail) {
  const TemporaryFile negative("negative.xyzr", "0 0 0 -1\n"), empty("empty.xyzr", "");
  const std::vector<std::pair<std::string, std::vector<std::string>>> calls = {
      {"turntable", {negative.path(), "no_picture", "1"}},
      {"turntable", {"good/one.xyzr", std::string(5000, 'd'), "1"}},
      {"single_atoms", {empty.path(), "10"}},
      {"docking", {"good/one.xyzr", negative.path()}},
      {"docking", {"good/one.xyzr", "good/one.xyzr", "1e-9"}},
      {"newton", {"-1"}},
      {"newton", {"nan"}},
      {"newton", {"1e9"}}};
  for (const auto &[example, arguments] : calls) {
    const Outcome outcome = run_example(example, arguments);
    EXPECT_EQ(outcome.status, 1) << example;
    EXPECT_EQ(outcome.out, "") << example;
    EXPECT_EQ(outcome.err.rfind(example + ": ", 0), 0u) << example << ": " << outcome.err;
  }
}

// In steps of 100 one place is tried, in which nothing touches: it has no best one.
TEST(Examples, DockingWithoutContacts) {
  const Outcome outcome = run_example("docking", {"good/one.xyzr", "good/one.xyzr", "100"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.find("best"), std::string::npos) << outcome.out;
}

// It compares itself with a new computation; how many moves are taken depends on the random numbers alone.
TEST(Examples, SingleAtomsHaveTheBitsOfANewModel) {
  const support::BallList crambin =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  const TemporaryFile file("crambin.xyzr", text_of(crambin, crambin.size()));
  const Outcome outcome = run_example("single_atoms", {file.path(), "300"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_GE(lines.size(), 2u);
  unsigned accepted = 0;
  double after = 0, before = 0;
  ASSERT_EQ(std::sscanf(lines[0].c_str(), "327 atoms, 300 moves, %u accepted: %lf kcal/mol, before %lf", &accepted,
                        &after, &before),
            3)
      << lines[0];
  EXPECT_GT(accepted, 100u);
  EXPECT_LT(accepted, 300u);
  EXPECT_NEAR(after, before, 5);
  EXPECT_NE(after, before);
  EXPECT_EQ(lines.back().rfind("a new model has the same bits: ", 0), 0u) << lines.back();
}

// A ball off the axis circles about the middle between it and another one, which is on the other side: in a frame of
// 600 px that is 1.05 times as wide as what the balls sweep, of radius 3 + 1.
TEST(Examples, TurntableStaysCentred) {
  const TemporaryFile file("two.xyzr", "4 5 6 1\n10 5 6 1\n");
  const TemporaryFile first("turn000.svg");
  const std::string prefix = first.path().substr(0, first.path().size() - 7);
  const Outcome outcome = run_example("turntable", {file.path(), prefix, "6"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (int frame = 0; frame < 6; ++frame) {
    const std::string path = prefix + "00" + std::to_string(frame) + ".svg";
    const std::string svg = read_file(path);
    std::remove(path.c_str());
    const double radius = 600 / 2.1 / 4;
    const double shift = 3 * radius * std::cos(frame * pi / 3);
    for (const double x : {300 - shift, 300 + shift}) {
      std::ostringstream ball;
      ball << std::fixed << std::setprecision(2) << "cx=\"" << x << "\" cy=\"300\" r=\"" << radius << '"';
      EXPECT_NE(svg.find(ball.str()), std::string::npos) << path << ": no ball at " << x << '\n' << svg;
    }
  }
}

// The polygons of draw_with_your_plotter, painted one over the other, against the nearest sphere at each point: the
// example turns the balls by 60 degrees about x, then by 25 about y.
TEST(Examples, YourPlotterShowsWhatIsInFront) {
  struct Ball {
    double x, y, z, r;
  };
  const double a = 60 * pi / 180;
  const double b = 25 * pi / 180;
  std::vector<Ball> balls;
  double low[2] = {1e9, 1e9};
  double high[2] = {-1e9, -1e9};
  const std::vector<support::Atom> atoms = support::read_atoms(support::own_molecule("caffeine.pdb"));
  const support::BallList caffeine = with_radii(atoms, support::Radii::van_der_waals);
  for (size_t i = 0; i < atoms.size(); ++i) {
    const auto [x, y, z] = atoms[i].centre;
    const double r = caffeine.radius[i];
    const double turned_z = std::sin(a) * y + std::cos(a) * z;
    const Ball ball = {std::cos(b) * x + std::sin(b) * turned_z, std::cos(a) * y - std::sin(a) * z,
                       std::cos(b) * turned_z - std::sin(b) * x, r};
    balls.push_back(ball);
    low[0] = std::min(low[0], ball.x - r);
    low[1] = std::min(low[1], ball.y - r);
    high[0] = std::max(high[0], ball.x + r);
    high[1] = std::max(high[1], ball.y + r);
  }
  ASSERT_EQ(balls.size(), 24u);

  const Outcome outcome = run_example("draw_with_your_plotter", {});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  double box[4];
  ASSERT_EQ(std::sscanf(lines.at(0).c_str(),
                        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"600\" viewBox=\"%lf %lf %lf %lf", &box[0],
                        &box[1], &box[2], &box[3]),
            4);
  EXPECT_EQ(lines.back(), "</svg>");
  // The balls' box lies in the middle of the picture: so much for where the view's origin is.
  const double shift[2] = {(low[0] + high[0]) / 2 - (box[0] + box[2] / 2),
                           (low[1] + high[1]) / 2 + box[1] + box[3] / 2};
  EXPECT_NEAR(box[2], high[0] - low[0] + 0.2, 1e-3);
  EXPECT_NEAR(box[3], high[1] - low[1] + 0.2, 1e-3);

  struct Piece {
    size_t ball;
    std::vector<std::vector<std::pair<double, double>>> loops;
  };
  std::vector<Piece> pieces;
  for (size_t i = 1; i + 1 < lines.size(); ++i) {
    unsigned ball = 0;
    ASSERT_EQ(std::sscanf(lines[i].c_str(), "<path data-ball=\"%u\"", &ball), 1) << lines[i];
    ASSERT_LT(ball, balls.size());
    Piece piece{ball, {}};
    const size_t begin = lines[i].find(" d=\"") + 4;
    std::istringstream loops(lines[i].substr(begin, lines[i].rfind('"') - begin));
    for (std::string loop; std::getline(loops, loop, 'Z');) {
      ASSERT_EQ(loop.at(0), 'M');
      std::istringstream points(loop.substr(1));
      piece.loops.emplace_back();
      double x = 0;
      double y = 0;
      for (char comma = 0; points >> x >> comma >> y;) piece.loops.back().emplace_back(x + shift[0], shift[1] - y);
      EXPECT_GE(piece.loops.back().size(), 3u);
    }
    pieces.push_back(piece);
  }

  const auto inside = [](const Piece &piece, double x, double y) {
    bool odd = false;
    for (const auto &loop : piece.loops) {
      for (size_t i = 0; i < loop.size(); ++i) {
        const auto &[x0, y0] = loop[i];
        const auto &[x1, y1] = loop[(i + 1) % loop.size()];
        if ((y0 > y) != (y1 > y) && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0)) odd = !odd;
      }
    }
    return odd;
  };
  int shown = 0;
  int wrong = 0;
  const int steps = 100;
  for (int at = 0; at < steps * steps; ++at) {
    const double x = low[0] + (high[0] - low[0]) * (at % steps + 0.5) / steps;
    const double y = low[1] + (high[1] - low[1]) * (at / steps + 0.5) / steps;
    size_t nearest = balls.size();
    double height = -1e9;
    for (size_t i = 0; i < balls.size(); ++i) {
      const double rest = balls[i].r * balls[i].r - std::pow(x - balls[i].x, 2) - std::pow(y - balls[i].y, 2);
      if (rest > 0 && balls[i].z + std::sqrt(rest) > height) {
        height = balls[i].z + std::sqrt(rest);
        nearest = i;
      }
    }
    size_t painted = balls.size();
    for (const Piece &piece : pieces) {
      if (inside(piece, x, y)) painted = piece.ball;
    }
    if (nearest < balls.size()) ++shown;
    if (painted != nearest) ++wrong;
  }
  EXPECT_GT(shown, steps * steps / 2);
  // Chords of 0.1 rad leave up to 0.002 of a radius beside the arcs.
  EXPECT_LT(wrong, 60);
}

// inputs/frames.pdb: two oxygens 1 and 2 apart, then three atoms that do not meet. Two equal balls at distance d have
// the area 2 (2 pi r^2 + pi r d), so the gradient is 2 pi r whatever d is.
TEST(Examples, FramesOfAKnownTrajectory) {
  for (const double probe : {0.0, 0.25}) {
    const Outcome outcome = run_example("frames", {"frames.pdb", std::to_string(probe)});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const std::vector<std::string> lines = lines_of(outcome.out);
    ASSERT_EQ(lines.size(), 5u);
    const double r = 1.52 + probe;
    const double c = 1.70 + probe;
    const double sphere = 4 * pi * r * r;
    for (int frame = 1; frame <= 2; ++frame) {
      const double h = 0.5 * frame;  // of the circle's plane, from both centres
      const std::vector<double> row = numbers_of(lines[static_cast<size_t>(frame)]);
      ASSERT_EQ(row.size(), 5u);
      EXPECT_EQ(row[0], frame);
      EXPECT_EQ(row[1], 2);
      EXPECT_NEAR(row[2], sphere + 4 * pi * r * h, 1e-6);
      EXPECT_NEAR(row[3], 2 * pi * (2 * r * r * r / 3 + r * r * h - h * h * h / 3), 1e-6);
      EXPECT_NEAR(row[4], 2 * pi * r, 1e-6);
    }
    const std::vector<double> last = numbers_of(lines[3]);
    ASSERT_EQ(last.size(), 5u);
    EXPECT_EQ(last[1], 3);
    EXPECT_NEAR(last[2], 2 * sphere + 4 * pi * c * c, 1e-6);
    EXPECT_NEAR(last[3], 4 * pi / 3 * (2 * r * r * r + c * c * c), 1e-6);
    EXPECT_EQ(last[4], 0);
    // Two atoms, then once more for the third.
    EXPECT_EQ(lines[4], "# frames: 3; memory sized: 2");
  }
}

// Frames alike in size share the memory of the first.
TEST(Examples, FramesShareTheirMemory) {
  const std::string crambin = read_file(molecules_folder() + "/crambin.pdb");
  std::string text;
  for (int frame = 0; frame < 3; ++frame) text += "MODEL\n" + crambin.substr(0, crambin.find("\nEND") + 1) + "ENDMDL\n";
  const TemporaryFile file("trajectory.pdb", text);
  const Outcome outcome = run_example("frames", {file.path(), "1.4"});
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 5u) << outcome.err;
  EXPECT_EQ(lines[4], "# frames: 3; memory sized: 1");
  const Json measure = run_json({"measure", molecules_folder() + "/crambin.pdb", "--probe", "1.4"});
  for (size_t frame = 1; frame <= 3; ++frame) {
    EXPECT_NEAR(numbers_of(lines[frame])[2], measure["area"].number, 1e-6);
    EXPECT_NEAR(numbers_of(lines[frame])[3], measure["volume"].number, 1e-6);
  }
}

// Progress is for a person who watches: on a terminal there is some, in a log file none.
TEST(Examples, FramesShowProgressOnTerminalsOnly) {
  EXPECT_EQ(run_example("frames", {"frames.pdb"}).err, "");
  const std::optional<Outcome> watched = run_example_watched("frames", {"frames.pdb"});
  if (!watched) GTEST_SKIP() << "the system has no terminal to give";
  EXPECT_EQ(watched->status, 0);
  EXPECT_EQ(watched->out, run_example("frames", {"frames.pdb"}).out);
  for (const char *shown : {"frame 1", "frame 2", "frame 3"}) {
    EXPECT_NE(watched->err.find(shown), std::string::npos) << watched->err;
  }
}

TEST(Examples, FramesRefuseBadFiles) {
  const TemporaryFile bad("bad_frames.pdb", "ATOM      1  O   HOH A   1       0.000\n");
  EXPECT_EQ(run_example("frames", {bad.path()}).status, 1);
  EXPECT_EQ(run_example("frames", {bad.path()}).err, "frames: frame 1: not an atom record\n");
  EXPECT_EQ(run_example("frames", {"no_such_file.pdb"}).status, 1);
  EXPECT_EQ(run_example("frames", {}).status, 2);
}

}  // namespace
