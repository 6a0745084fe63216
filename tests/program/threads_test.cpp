// Threads of the program: whatever is shared out among them, what comes is what one thread gives, byte for byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "program_runner.hpp"
#include "temporary_file.hpp"
#include "trajectory_writers.hpp"

namespace {

using Words = std::vector<std::string>;
using trajectories::Floats;

Words operator+(Words words, const Words &more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Standard output and standard error in one text, in the order in which they are written.
Outcome run_as_one(const Words &arguments) {
  Surroundings surroundings;
  surroundings.err_is_out = true;
  return run_program_in(surroundings, arguments);
}

// Large texts, of which only the place is said where they part.
void expect_same(const std::string &text, const std::string &expected) {
  const auto [at, other] = std::mismatch(text.begin(), text.end(), expected.begin(), expected.end());
  EXPECT_TRUE(at == text.end() && other == expected.end())
      << "other bytes from " << at - text.begin() << " on, of " << text.size() << " and " << expected.size();
}

// The output of one thread; several give the same, each stream alone and both together.
Outcome run_by_threads(const Words &arguments) {
  const Outcome one = run_program(arguments + Words{"--threads", "1"});
  const Outcome together = run_as_one(arguments + Words{"--threads", "1"});
  EXPECT_EQ(together.status, one.status);
  EXPECT_EQ(together.out.size(), one.out.size() + one.err.size());
  for (const std::string threads : {"2", "3", "16", ""}) {
    SCOPED_TRACE(threads + " threads: " + arguments[0]);
    const Words several = threads.empty() ? arguments : arguments + Words{"--threads", threads};
    const Outcome outcome = run_program(several);
    EXPECT_EQ(outcome.status, one.status);
    expect_same(outcome.out, one.out);
    expect_same(outcome.err, one.err);
    expect_same(run_as_one(several).out, together.out);
  }
  return one;
}

// All inputs, good ones and bad ones by turns: more of both than there are slots for any number of threads here.
Words all_inputs() {
  Words good, bad, mixed;
  for (const std::string folder : {"good", "bad"}) {
    for (const auto &entry : std::filesystem::directory_iterator(inputs_folder() + "/" + folder)) {
      (folder == "good" ? good : bad).push_back(folder + "/" + entry.path().filename().string());
    }
  }
  for (size_t k = 0; k < std::max(good.size(), bad.size()); ++k) {
    if (k < bad.size()) mixed.push_back(bad[k]);
    if (k < good.size()) mixed.push_back(good[k]);
    if (k % 20 == 0) mixed.push_back("missing.pdb");
  }
  return mixed;
}

TEST(Threads, ManyFilesWithDamagedOnesAmongThem) {
  const Words inputs = all_inputs();
  ASSERT_GT(inputs.size(), 150u);
  Words of_pdb;
  std::copy_if(inputs.begin(), inputs.end(), std::back_inserter(of_pdb),
               [](const std::string &name) { return name.ends_with(".pdb"); });
  for (const Words &command :
       {Words{"measure", "--json"} + inputs, Words{"measure", "--csv", "--probe", "1.4"} + inputs,
        Words{"measure", "--csv", "--hide", "atom:QQ"} + of_pdb, Words{"voids"} + inputs,
        Words{"boundary", "--csv"} + inputs}) {
    const Outcome one = run_by_threads(command);
    EXPECT_EQ(one.status, 1);
    EXPECT_NE(one.err, "");
    EXPECT_NE(one.out, "");
  }
}

// One that takes long, with small ones behind it that are ready before.
TEST(Threads, ALargeFileBeforeSmallOnes) {
  const Words small(40, "good/water.pdb");
  const std::string large = molecules_folder() + "/sod_stand_in.pdb";
  const Outcome one = run_by_threads(Words{"measure", "good/one.pdb", large} + small);
  EXPECT_EQ(one.status, 1);
}

// Also where others are ready behind the first one.
TEST(Threads, FullOutputIsSaidOnce) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const Words many(100, "good/water.pdb"), large{"measure", "--threads", "3", molecules_folder() + "/sod_stand_in.pdb"};
  const Outcome outcome = run_program(large + many, "/dev/full");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "hardsphere: standard output: No space left on device\n");
}

TEST(Threads, FaultsOfTheCommandLineComeFirst) {
  const Words many(30, "good/water.pdb");
  for (const Words &fault : {Words{"good/three.xyzr", "--radii", "bondi"}, Words{"none.gz", "--bogus"}, Words{"-"}}) {
    const Outcome outcome = run_program(Words{"measure", "--threads", "3"} + many + fault);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
  }
}

constexpr uint32_t atoms = 60;

std::string molecule_of_carbons() {
  std::string text = std::to_string(atoms) + "\n\n";
  for (uint32_t i = 0; i < atoms; ++i) text += "C 0 0 0\n";
  return text;
}

trajectories::Bytes run_of_frames(uint32_t frames) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> anywhere(0, 12);
  trajectories::DcdOptions options;
  options.frames = frames;
  trajectories::Bytes file = trajectories::dcd_header(atoms, options);
  for (uint32_t k = 0; k < frames; ++k) {
    Floats places(atoms);
    for (auto &place : places) place = {anywhere(random), anywhere(random), anywhere(random)};
    file += trajectories::dcd_frame(places, k == 0, options);
  }
  return file;
}

TEST(Threads, FramesOfATrajectory) {
  constexpr uint32_t frames = 100;
  const trajectories::Bytes bytes = run_of_frames(frames);
  const TemporaryFile molecule("carbons.xyz", molecule_of_carbons()), run("run.dcd", bytes);
  const TemporaryFile cut("cut.dcd", bytes.substr(0, bytes.size() * 7 / 10)), few("few.txt", "1\n2\n");
  const auto on = [&](const std::string &path, const Words &more) {
    return run_by_threads(Words{"measure", molecule.path(), "--trajectory", path} + more);
  };
  const auto rows = [](const Outcome &outcome) { return std::count(outcome.out.begin(), outcome.out.end(), '\n'); };
  const Outcome whole = on(run.path(), {"--probe", "1.4"});
  EXPECT_EQ(whole.status, 0);
  EXPECT_EQ(rows(whole), frames + 1);
  EXPECT_EQ(rows(on(run.path(), {"--frames", "5:90:7", "--json", "--per-ball"})), 13);
  EXPECT_EQ(on(run.path(), {"--frames", "101:"}).status, 1);
  // Frames before the position where the file is cut off are measured.
  const Outcome broken = on(cut.path(), {});
  EXPECT_EQ(broken.status, 1);
  EXPECT_GT(rows(broken), 60);
  EXPECT_LT(rows(broken), 75);
  EXPECT_NE(broken.err.find("frame "), std::string::npos) << broken.err;
  const Outcome weights = on(run.path(), {"--weights", few.path()});
  EXPECT_EQ(weights.status, 1);
  EXPECT_EQ(weights.out, "");
  EXPECT_EQ(on("none.dcd", {}).status, 1);
}

// Frames of text are read by lines, and a bad one names its line.
TEST(Threads, FramesOfText) {
  std::string text;
  for (int k = 0; k < 50; ++k) {
    text += "2\nframe\nC 0 0 0\nC " + std::to_string(k) + " 1 0\n";
    if (k == 40) text += "2\nframe\nC 0 0 0\nC nowhere 1 0\n";
  }
  const TemporaryFile run("run.xyz", text);
  const Outcome one = run_by_threads({"measure", run.path(), "--trajectory", run.path()});
  EXPECT_EQ(one.status, 1);
  EXPECT_EQ(std::count(one.out.begin(), one.out.end(), '\n'), 42);
  EXPECT_NE(one.err.find(":168: frame 42: "), std::string::npos) << one.err;
}

// Enough balls for several threads to share them.
TEST(Threads, OneLargeMolecule) {
  constexpr int side = 18;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> off(-0.3, 0.3);
  std::string text;
  for (int i = 0; i < side * side * side; ++i) {
    char row[120];
    const double x = 2.1 * (i % side) + off(random), y = 2.1 * (i / side % side) + off(random);
    std::snprintf(row, sizeof row, "%.3f %.3f %.3f %.2f\n", x, y, 2.1 * (i / side / side) + off(random),
                  1.2 + std::abs(off(random)));
    text += row;
  }
  const TemporaryFile large("large.xyzr", text);
  for (const Words &command : {Words{"measure"}, Words{"measure", "--csv"}, Words{"measure", "--per-ball"},
                               Words{"measure", "--per-ball", "--json", "--probe", "0.3"}, Words{"boundary", "--json"},
                               Words{"voids", "--csv"}, Words{"contacts", "--csv"}}) {
    EXPECT_EQ(run_by_threads(command + Words{large.path()}).status, 0);
  }
}

}  // namespace
