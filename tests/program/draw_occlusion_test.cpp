// Occlusion in hardsphere draw: how dark each ball is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "drawn_colours.hpp"
#include "json_outcome.hpp"
#include "molecule_file.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

// Sixteen shades and the full colour of each element at most; what a large probe reaches is brighter.
TEST(DrawOcclusion, DarkensWhatIsBuried) {
  const std::map<int, std::string> plain = fills(crambin(), {});
  const std::map<int, std::string> half = fills(crambin(), {"--occlusion", "0.5"});
  const std::map<int, std::string> full = fills(crambin(), {"--occlusion", "1"});
  ASSERT_EQ(plain.size(), full.size());
  std::map<std::string, std::set<std::string>> shades;
  for (const auto &[ball, colour] : full) {
    EXPECT_LE(brightness(colour), brightness(half.at(ball)) + 2);
    EXPECT_LE(brightness(half.at(ball)), brightness(plain.at(ball)));
    shades[plain.at(ball)].insert(colour);
  }
  for (const auto &[colour, darker] : shades) EXPECT_LE(darker.size(), 17u) << colour;
  EXPECT_GT(shades["D2CDC3"].size(), 10u);

  const Json balls = run_json({"measure", crambin(), "--per-ball", "--probe", "4"})["balls"];
  double buried = 0;
  double exposed = 0;
  int buried_count = 0;
  int exposed_count = 0;
  for (const auto &[ball, colour] : full) {
    const double part = brightness(colour) / brightness(plain.at(ball));
    const double area = balls.items.at(static_cast<size_t>(ball))["area"].number;
    if (area == 0) buried += part, ++buried_count;
    if (area > 60) exposed += part, ++exposed_count;
  }
  ASSERT_GT(buried_count, 20);
  ASSERT_GT(exposed_count, 20);
  EXPECT_LT(buried / buried_count, 0.75);
  EXPECT_GT(exposed / exposed_count, 0.9);
}

// Large molecules are darkened in any style, others with style soft alone, unless the user says so.
TEST(DrawOcclusion, ByDefault) {
  const auto grid = [](int balls) {
    std::string text;
    for (int i = 0; i < balls; ++i) {
      text += std::to_string(2 * (i % 13)) + " " + std::to_string(2 * (i / 13 % 13)) + " " +
              std::to_string(2 * (i / 169)) + " 1.2\n";
    }
    return text;
  };
  const TemporaryFile small("small.xyzr", grid(2000));
  const TemporaryFile large("large.xyzr", grid(2001));
  EXPECT_EQ(fills(small.path(), {}), fills(small.path(), {"--occlusion", "0"}));
  EXPECT_EQ(fills(large.path(), {}), fills(large.path(), {"--occlusion", "0.5"}));
  EXPECT_NE(fills(large.path(), {}), fills(large.path(), {"--occlusion", "0"}));
  for (const TemporaryFile *file : {&small, &large}) {
    EXPECT_TRUE(drawn(file->path(), {"--style", "soft"}) ==
                drawn(file->path(), {"--style", "soft", "--occlusion", "0.5"}));
  }
  EXPECT_TRUE(drawn(small.path(), {}) == drawn(small.path(), {"--style", "soft"}));
  EXPECT_TRUE(drawn(large.path(), {}) == drawn(large.path(), {"--style", "flat"}));
}

// A lone ball and two that hardly meet are as bright as can be; so is everything where all balls are alike.
TEST(DrawOcclusion, OfFewBalls) {
  EXPECT_EQ(fills("good/one.xyzr", {"--occlusion", "1"}), fills("good/one.xyzr", {}));
  EXPECT_EQ(fills("good/touching.xyzr", {"--occlusion", "1"}).size(), fills("good/touching.xyzr", {}).size());
  const TemporaryFile equal("equal.xyzr", "0 0 0 1\n1 0 0 1\n");
  EXPECT_EQ(fills(equal.path(), {"--occlusion", "1"}), fills(equal.path(), {}));
}

// Lengths in another unit, the same shades: nanometres, and a thousandth of an angstrom.
TEST(DrawOcclusion, InAnyUnit) {
  std::vector<std::map<int, std::string>> found;
  for (const double factor : {1.0, 0.1, 1000.0}) {
    std::string text;
    for (const support::Atom &atom : support::read_atoms(crambin())) {
      char line[120];
      std::snprintf(line, sizeof line, "%.10g %.10g %.10g %.10g\n", atom.centre[0] * factor, atom.centre[1] * factor,
                    atom.centre[2] * factor, 1.7 * factor);
      text += line;
    }
    const TemporaryFile file("unit.xyzr", text);
    found.push_back(fills(file.path(), {"--occlusion", "1"}));
  }
  EXPECT_GT(found[0].size(), 200u);
  EXPECT_EQ(found[1], found[0]);
  EXPECT_EQ(found[2], found[0]);
}

// More balls within a probe's reach of each other than any molecule has: not shaded unless that is asked for.
TEST(DrawOcclusion, CrowdedSetsAreNotShadedByDefault) {
  std::string text;
  for (int i = 0; i < 2000; ++i) {
    text += std::to_string(i % 20 * 0.03) + " " + std::to_string(i / 20 % 10 * 0.03) + " " +
            std::to_string(i / 200 * 0.03) + " 0.01\n";
  }
  for (int i = 0; i < 600; ++i) text += std::to_string(2.5 * i) + " 5 0 1.7\n";
  const TemporaryFile file("crowded.xyzr", text);
  EXPECT_EQ(fills(file.path(), {}), fills(file.path(), {"--occlusion", "0"}));
}

// Whether a set is crowded does not hang on which balls one looks at: here every 41st and a row of others stand alone.
TEST(DrawOcclusion, EveryBallCountsForACrowd) {
  std::string text;
  int lone = 0;
  int packed = 0;
  for (int i = 0; i < 2600; ++i) {
    if (i % 41 == 0 || packed == 2000) {
      text += std::to_string(2.5 * lone++) + " 5 0 1.7\n";
    } else {
      text += std::to_string(packed % 20 * 0.03) + " " + std::to_string(packed / 20 % 10 * 0.03) + " " +
              std::to_string(packed / 200 * 0.03) + " 0.01\n";
      ++packed;
    }
  }
  ASSERT_EQ(packed, 2000);
  const TemporaryFile file("crowd.xyzr", text);
  EXPECT_EQ(fills(file.path(), {}), fills(file.path(), {"--occlusion", "0"}));
}

// The results say how far balls were darkened.
TEST(DrawOcclusion, IsReported) {
  const TemporaryFile out("reported.svg");
  std::string text;
  for (int i = 0; i < 3000; ++i) text += "0 0 " + std::to_string(i * 1e-3) + " 1\n";
  const TemporaryFile crowded("crowded.xyzr", text);
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const auto reported = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", out.path()});
    return run_json(arguments)["occlusion"].number;
  };
  EXPECT_EQ(reported({"draw", crambin}), 0.5);
  EXPECT_EQ(reported({"draw", crambin, "--occlusion", "0.7"}), 0.7);
  EXPECT_EQ(reported({"draw", crambin, "--occlusion", "0"}), 0);
  EXPECT_EQ(reported({"draw", crambin, "--style", "flat"}), 0);
  EXPECT_EQ(reported({"draw", "good/one.xyzr"}), 0);
  EXPECT_EQ(reported({"draw", crowded.path()}), 0);
  // However many there are.
  std::string row;
  for (int i = 0; i < 30000; ++i) row += std::to_string(i) + " 0 0 1\n";
  const TemporaryFile many("many.xyzr", row);
  EXPECT_EQ(reported({"draw", many.path()}), 0.5);
  EXPECT_NE(
      run_program({"draw", crambin, "-o", out.path()}).out.find("  occlusion        0.5            buried balls are"),
      std::string::npos);
}

// At both ends of what the library takes, where probes would be too large or too small for it: no shades, no failure.
TEST(DrawOcclusion, AtTheEndsOfTheLattice) {
  for (const char *unit : {"e30", "e-16"}) {
    const TemporaryFile file(
        "ends.xyzr", std::string("0 0 0 9") + unit + "\n1" + unit + " 0 0 9" + unit + "\n0 0 0 2" + unit + "\n");
    const TemporaryFile out("ends.svg");
    const Outcome outcome = run_program({"draw", file.path(), "-o", out.path(), "--occlusion", "1"});
    EXPECT_EQ(outcome.status, 0) << unit << outcome.err;
    EXPECT_EQ(outcome.err, "") << unit;
    EXPECT_EQ(fills(file.path(), {"--occlusion", "1"}), fills(file.path(), {"--occlusion", "0"})) << unit;
  }
}

// Larger molecules take a cheaper way; it must tell the inside from the outside as well. A grid has corners.
TEST(DrawOcclusion, OfManyBalls) {
  std::string text;
  for (int i = 0; i < 1331; ++i) {
    text += std::to_string(2 * (i % 11)) + " " + std::to_string(2 * (i / 11 % 11)) + " " +
            std::to_string(2 * (i / 121)) + " 1.2\n";
  }
  const TemporaryFile file("grid.xyzr", text);
  const std::map<int, std::string> found = fills(file.path(), {"--occlusion", "1"});
  ASSERT_EQ(found.count(1330), 1u);
  EXPECT_EQ(found.at(1330), "D2CDC3");                                     // a corner
  EXPECT_LT(brightness(found.at(665)), 0.6 * brightness(found.at(1330)));  // the middle
}

// Pairs of balls among lone ones, all of radius 1.7 and too far from each other for any probe. A probe p sees of a ball
// with a partner at distance d the part 1/2 + d / (4 (1.7 + p)), at most all of it. At least a fifth of the balls are
// alone, so that exposure is relative to theirs, which is 1. Smoothing changes nothing: both of a pair are alike.
class PairsAmongLoneBalls {
 public:
  explicit PairsAmongLoneBalls(int balls) : balls_(balls), pairs_(std::min(3 * balls / 8, 1000)) {}

  int pairs() const { return pairs_; }
  static double distance(int pair) { return 0.3 + std::fmod(10.506 * pair, 17.0); }

  // The colours of the pairs' first balls.
  std::vector<std::string> colours() const {
    std::string text;
    for (int place = 0, ball = 0; ball < balls_; ++place) {
      char line[200];
      const double xyz[3] = {40.0 * (place % 25), 40.0 * (place / 25 % 25), 40.0 * (place / 625)};
      std::snprintf(line, sizeof line, "%.10g %.10g %.10g 1.7\n", xyz[0], xyz[1], xyz[2]);
      text += line;
      ++ball;
      if (place >= pairs_) continue;
      std::snprintf(line, sizeof line, "%.10g %.10g %.10g 1.7\n", xyz[0] + distance(place), xyz[1], xyz[2]);
      text += line;
      ++ball;
    }
    const TemporaryFile file("pairs.xyzr", text);
    const std::map<int, std::string> found = fills(file.path(), {"--occlusion", "1"});
    EXPECT_EQ(static_cast<int>(found.size()), balls_);
    EXPECT_EQ(found.at(balls_ - 1), "D2CDC3");
    std::vector<std::string> colours;
    for (int pair = 0; pair < pairs_; ++pair) {
      colours.push_back(found.at(2 * pair));
      EXPECT_EQ(found.at(2 * pair + 1), found.at(2 * pair));
    }
    return colours;
  }

 private:
  int balls_;
  int pairs_;
};

// How much the probes of 1.4, 2.8 and 7 count, and the least exposure.
struct Weights {
  int balls;
  double probe[3];
  double least;
};

double exposure_of_pair(const Weights &weights, double distance) {
  const double radius[3] = {1.7 + 1.4, 1.7 + 2.8, 1.7 + 7.0};
  double sum = 0.0;
  double all = 0.0;
  for (int k = 0; k < 3; ++k) {
    sum += weights.probe[k] * std::min(1.0, 0.5 + distance / (4 * radius[k]));
    all += weights.probe[k];
  }
  return weights.least + (1 - weights.least) * sum / all;
}

// In sixteenths, before it is rounded: hidden^1.1, nearly.
double shade_of(double exposure) {
  const double hidden = 1 - exposure;
  return 16 * hidden * (0.87 + 0.13 * hidden);
}

// 0xD2CDC3 in a shade.
std::string shaded(int shade) {
  const double factor[3] = {0.42, 0.40, 0.46};
  const double offset[3] = {0.03, 0.03, 0.06};
  const int plain[3] = {0xD2, 0xCD, 0xC3};
  int channel[3];
  for (int k = 0; k < 3; ++k) {
    const double light = plain[k] / 255.0;
    const double dark = factor[k] * light + offset[k];
    channel[k] = static_cast<int>(std::floor(255 * (light + shade / 16.0 * (dark - light)) + 0.5));
  }
  char text[20];
  std::snprintf(text, sizeof text, "%02X%02X%02X", channel[0], channel[1], channel[2]);
  return text;
}

// The weights of capi/program/draw/occlusion.h at their corners, between them, and one ball to either side.
TEST(DrawOcclusion, PairsInClosedForm) {
  const Weights all[] = {
      {20, {0, 1, 1}, 0.6},           {29, {0, 1, 1}, 0.6},       {30, {0, 1, 1}, 0.6},        {31, {0, 1, 1}, 0.59},
      {59, {0, 1, 1}, 0.31},          {60, {0, 1, 1}, 0.3},       {61, {0, 1, 1}, 0.29},       {75, {0, 1, 1}, 0.15},
      {89, {0, 1, 1}, 0.01},          {90, {0, 1, 1}, 0},         {91, {0, 1, 1}, 0},          {500, {0, 1, 1}, 0},
      {501, {0, 1, 0.998}, 0},        {600, {0, 1, 0.8}, 0},      {750, {0, 1, 0.5}, 0},       {900, {0, 1, 0.2}, 0},
      {999, {0, 1, 0.002}, 0},        {1000, {0, 1, 0}, 0},       {1001, {0, 1, 0}, 0},        {5000, {0, 1, 0}, 0},
      {5001, {0.0001, 0.9999, 0}, 0}, {7500, {0.25, 0.75, 0}, 0}, {12500, {0.75, 0.25, 0}, 0}, {15000, {1, 0, 0}, 0},
      {15001, {1, 0, 0}, 0}};
  for (const Weights &weights : all) {
    const PairsAmongLoneBalls pairs(weights.balls);
    const std::vector<std::string> colours = pairs.colours();
    std::set<std::string> different;
    for (int pair = 0; pair < pairs.pairs(); ++pair) {
      const double shade = shade_of(exposure_of_pair(weights, pairs.distance(pair))) + 0.5;
      if (std::fabs(shade - std::round(shade)) < 1e-9) continue;
      different.insert(shaded(static_cast<int>(shade)));
      EXPECT_EQ(colours[static_cast<size_t>(pair)], shaded(static_cast<int>(shade)))
          << weights.balls << " balls, at distance " << pairs.distance(pair);
    }
    EXPECT_GE(different.size(), 3U) << weights.balls;
  }
}

// No line parts bonded carbons, so their shades should be near each other: in the mean by 1.1 of sixteen steps.
TEST(DrawOcclusion, ChangesLittleAlongBonds) {
  const std::map<int, std::string> full = fills(crambin(), {"--occlusion", "1", "--all-balls"});
  const std::vector<std::string> atoms = atoms_of(crambin());
  ASSERT_EQ(full.size(), atoms.size());
  const double step = (brightness("D2CDC3") - brightness(shaded(16))) / 16;
  double sum = 0;
  int bonds = 0;
  for (size_t i = 0; i < atoms.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      if (atoms[i].substr(76, 2) != " C" || atoms[k].substr(76, 2) != " C") continue;
      double squares = 0;
      for (const size_t column : {30, 38, 46}) {
        const double apart = std::stod(atoms[i].substr(column, 8)) - std::stod(atoms[k].substr(column, 8));
        squares += apart * apart;
      }
      if (squares > 1.9 * 1.9) continue;
      sum += std::fabs(brightness(full.at(static_cast<int>(i))) - brightness(full.at(static_cast<int>(k)))) / step;
      ++bonds;
    }
  }
  ASSERT_GT(bonds, 150);
  EXPECT_LT(sum / bonds, 1.1);
}

// No edges: another ball far away changes no shade by more than one.
TEST(DrawOcclusion, OneBallMoreMakesNoDifference) {
  std::map<std::string, int> shade_of_colour;
  for (int shade = 0; shade <= 16; ++shade) shade_of_colour[shaded(shade)] = shade;
  for (const int balls : {24, 30, 59, 60, 75, 90, 500, 999, 1000, 2000, 5000, 15000}) {
    const std::vector<std::string> fewer = PairsAmongLoneBalls(balls).colours();
    const std::vector<std::string> more = PairsAmongLoneBalls(balls + 1).colours();
    for (size_t pair = 0; pair < fewer.size(); ++pair) {
      EXPECT_LE(std::abs(shade_of_colour.at(fewer[pair]) - shade_of_colour.at(more[pair])), 1) << balls;
    }
  }
}

}  // namespace
