// measure --mean and frames by time: against the rows of single frames, summed up here in long double.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "json_reader.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"
#include "trajectory_writers.hpp"

namespace {

using Lines = std::vector<std::string>;
using trajectories::Place;

// Crambin's atoms as in its file, moved by up to half an angstrom: so many frames, 2.5 apart in time.
std::string shaken_crambin(int frames) {
  std::mt19937 random(8);
  std::uniform_int_distribution<int64_t> shift(-50, 50);
  std::vector<Place> atoms;
  const std::string file = read_file(molecules_folder() + "/crambin.pdb");
  for (size_t at = 0; at < file.size(); at = file.find('\n', at) + 1) {
    if (file.compare(at, 4, "ATOM") != 0) continue;
    Place place;
    for (size_t axis = 0; axis < 3; ++axis) {
      place[axis] = std::llround(100 * std::stod(file.substr(at + 30 + 8 * axis, 8)));
    }
    atoms.push_back(place);
  }
  std::string run;
  for (int k = 0; k < frames; ++k) {
    std::vector<Place> moved = atoms;
    for (Place &place : moved) {
      for (int64_t &coordinate : place) coordinate += k == 0 ? 0 : shift(random);
    }
    trajectories::XtcOptions options;
    options.time = 2.5F * static_cast<float>(k);
    options.step = 5 * k;
    run += trajectories::xtc_frame(moved, options, random);
  }
  return run;
}

std::vector<Json> frames_of(const Lines &arguments) {
  Lines call = arguments;
  call.emplace_back("--json");
  const Outcome outcome = run_program(call);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::vector<Json> frames;
  for (size_t at = 0; at < outcome.out.size(); at = outcome.out.find('\n', at) + 1) {
    const auto frame = read_json(outcome.out.substr(at, outcome.out.find('\n', at) - at));
    EXPECT_TRUE(frame.has_value());
    if (frame) frames.push_back(*frame);
  }
  return frames;
}

struct Figures {
  long double mean = 0, deviation = 0, least = 0, most = 0;
};

Figures figures_of(const std::vector<Json> &frames, const std::function<double(const Json &)> &number) {
  Figures found;
  found.least = found.most = number(frames[0]);
  const auto count = static_cast<long double>(frames.size());
  for (const Json &frame : frames) {
    const double value = number(frame);
    found.mean += static_cast<long double>(value) / count;
    found.least = std::min(found.least, static_cast<long double>(value));
    found.most = std::max(found.most, static_cast<long double>(value));
  }
  for (const Json &frame : frames) {
    const long double from = static_cast<long double>(number(frame)) - found.mean;
    found.deviation += from * from / (count - 1);
  }
  found.deviation = std::sqrt(found.deviation);
  return found;
}

void expect_near(const Json &row, const char *mean, const Figures &expected) {
  EXPECT_NEAR(row[mean].number, static_cast<double>(expected.mean), 1e-9);
  EXPECT_NEAR(row["deviation"].number, static_cast<double>(expected.deviation), 1e-8);
}

class Means : public testing::Test {
 protected:
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const TemporaryFile run{"shaken.xtc", shaken_crambin(9)};
  Lines call(const Lines &more) const {
    Lines all = {"measure", crambin, "--probe", "1.4", "--trajectory", run.path()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Json mean(const Lines &more) const {
    Lines all = more;
    all.emplace_back("--mean");
    const std::vector<Json> found = frames_of(call(all));
    EXPECT_EQ(found.size(), 1U);
    return found.empty() ? Json{} : found[0];
  }
};

TEST_F(Means, OfTotals) {
  const Lines options = {"--polar", "--curvature"};
  const std::vector<Json> frames = frames_of(call(options));
  ASSERT_EQ(frames.size(), 9U);
  const Json found = mean(options);
  EXPECT_EQ(found["n"].number, 327);
  EXPECT_EQ(found["frames"].number, 9);
  const Lines expected = {"area",       "volume",      "mean_curvature", "gauss_curvature",
                          "polar_area", "apolar_area", "other_area"};
  ASSERT_EQ(found["means"].items.size(), expected.size());
  for (size_t k = 0; k < expected.size(); ++k) {
    const Json &row = found["means"].items[k];
    EXPECT_EQ(row["quantity"].text, expected[k]);
    const Figures figures = figures_of(frames, [&](const Json &frame) { return frame[expected[k]].number; });
    expect_near(row, "mean", figures);
    EXPECT_EQ(row["least"].number, static_cast<double>(figures.least));
    EXPECT_EQ(row["most"].number, static_cast<double>(figures.most));
  }
}

TEST_F(Means, OfBallsAndGroups) {
  const TemporaryFile index("crambin.ndx", "[ First ]\n1 2 3 4 5\n6 7\n[ none ]\n[ Odd ]\n1 3 5 327\n");
  const struct {
    Lines options;
    const char *key;
    size_t rows;
  } kinds[] = {{{"--per-ball"}, "balls", 327},
               {{"--by", "residue"}, "residues", 46},
               {{"--by", "chain"}, "chains", 1},
               {{"--by", "group", "--index", index.path()}, "groups", 3},
               {{"--surface", "ses", "--by", "residue"}, "residues", 46},
               {{"--of", "residue:7-9", "--by", "residue"}, "residues", 3},
               {{"--of", "residue:7-9", "--per-ball"}, "balls", 20}};
  for (const auto &kind : kinds) {
    const std::vector<Json> frames = frames_of(call(kind.options));
    const Json found = mean(kind.options);
    const std::vector<Json> &rows = found[kind.key].items;
    ASSERT_EQ(rows.size(), kind.rows) << kind.key;
    for (size_t row = 0; row < rows.size(); ++row) {
      expect_near(rows[row], "area",
                  figures_of(frames, [&](const Json &frame) { return frame[kind.key].items[row]["area"].number; }));
    }
  }
}

// Times from 0 to 20 in steps of 2.5.
TEST_F(Means, FramesByTime) {
  const struct {
    Lines options;
    std::vector<double> frames;
  } kinds[] = {{{"--begin", "5"}, {3, 4, 5, 6, 7, 8, 9}},
               {{"--end", "7.4"}, {1, 2, 3}},
               {{"--begin", "4", "--end", "12.5"}, {3, 4, 5, 6}},
               {{"--interval", "5"}, {1, 3, 5, 7, 9}},
               {{"--interval", "2.5"}, {1, 2, 3, 4, 5, 6, 7, 8, 9}},
               {{"--interval", "6"}, {1, 4, 6, 9}},
               {{"--begin", "2", "--interval", "10"}, {2, 6}},
               {{"--begin", "-3", "--frames", "2::3", "--end", "13"}, {2, 5}}};
  for (const auto &kind : kinds) {
    std::vector<double> found;
    for (const Json &frame : frames_of(call(kind.options))) found.push_back(frame["frame"].number);
    EXPECT_EQ(found, kind.frames) << kind.options[0] << kind.options[1];
  }
}

// Behind a gap the intervals go on where the first frame's time puts them.
TEST_F(Means, IntervalsBehindGaps) {
  std::string text;
  for (const char *time : {"0", "10", "10.5", "11.2", "30", "30.9"}) {
    text += std::string("1\nt= ") + time + "\nC 0 0 0\n";
  }
  const TemporaryFile gaps("gaps.xyz", text);
  std::vector<double> found;
  for (const Json &frame : frames_of({"measure", gaps.path(), "--trajectory", gaps.path(), "--interval", "1"})) {
    found.push_back(frame["frame"].number);
  }
  EXPECT_EQ(found, (std::vector<double>{1, 2, 4, 5}));
}

TEST_F(Means, AreTheSameForAnyNumberOfThreads) {
  const Outcome one = run_program(call({"--mean", "--by", "residue", "--threads", "1"}));
  EXPECT_EQ(one.status, 0);
  for (const char *threads : {"2", "3", "7"}) {
    EXPECT_EQ(run_program(call({"--mean", "--by", "residue", "--threads", threads})).out, one.out);
  }
  EXPECT_NE(one.out.find("\n  frames           9\n"), std::string::npos);
  EXPECT_NE(one.out.find("\n  quantity "), std::string::npos);
}

// One frame has no deviation.
TEST_F(Means, OfOneFrame) {
  const Json found = mean({"--frames", "4"});
  EXPECT_EQ(found["frames"].number, 1);
  EXPECT_EQ(found["means"].items[0]["deviation"].kind, Json::Kind::null);
  EXPECT_NE(run_program(call({"--mean", "--frames", "4"})).out.find(" - "), std::string::npos);
}

TEST_F(Means, Tables) {
  const std::string balls = run_program(call({"--mean", "--csv"})).out;
  EXPECT_EQ(balls.substr(0, balls.find('\n')), "ball,atom,element,chain,residue,number,insertion,area,deviation");
  const std::string chains = run_program(call({"--mean", "--csv", "--by", "chain"})).out;
  EXPECT_EQ(chains.substr(0, chains.find(",327,")), "chain,atoms,area,deviation\nA");
  const std::string residues = run_program(call({"--mean", "--csv", "--by", "residue", "--relative"})).out;
  EXPECT_EQ(residues.substr(0, residues.find('\n')), "chain,residue,number,insertion,atoms,area,deviation,relative");
}

TEST_F(Means, Refused) {
  const std::string still = inputs_folder() + "/good/corners.xyzr";
  const TemporaryFile timeless("run.xyz", "1\n\nC 0 0 0\n1\n\nC 1 0 0\n"), one("one.xyz", "1\n\nC 0 0 0\n");
  const struct {
    Lines arguments;
    int status;
    const char *reason;
  } cases[] = {{{"measure", crambin, "--mean"}, 2, "--mean needs --trajectory"},
               {{"measure", crambin, "--begin", "1"}, 2, "--begin needs --trajectory"},
               {{"contacts", crambin, "--interval", "1"}, 2, "--interval needs --trajectory"},
               {call({"--mean", "--gradient"}), 2, "--gradient has no mean"},
               {call({"--mean", "--interface", "A,B"}), 2, "--interface has no mean"},
               {call({"--interval", "0"}), 2, "--interval must be above 0"},
               {call({"--begin", "5", "--begin", "6"}), 2, "--begin is given twice"},
               {call({"--begin", "soon"}), 2, "soon"},
               {call({"--begin", "1000"}), 1, "no frame at such a time"},
               {{"measure", one.path(), "--trajectory", timeless.path(), "--end", "3"}, 1, "frame 1: it has no time"}};
  for (const auto &refused : cases) {
    const Outcome outcome = run_program(refused.arguments);
    EXPECT_EQ(outcome.status, refused.status) << refused.reason;
    EXPECT_NE(outcome.err.find(refused.reason), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
