// Cavities along a trajectory: a made run in which one splits in two, another closes and opens again, and the two
// become one again, with the numbers that one gives them by hand; and pairs that meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "molecule_file.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

// A tube of five rings of four balls with a ball at each end, a cage of six balls far away, and a small ball, which is
// outside or stands between two rings. All but that have radius 0.7; no gap lets a probe of 0.2 through.
// CAGE, LEFT and RIGHT: the first ball of the cage, of the leftmost and of the rightmost ring.
enum : size_t { CAGE = 2, PLUG = 8, LEFT = 9, RIGHT = 25, BALLS = 29 };

struct Frame {
  double plug;  // its x; 0: outside
  double cage;  // distance of its balls from its middle
};

const std::vector<Frame> run = {{0, 1}, {1.5, 1}, {1.5, 0.85}, {1.5, 1}, {0, 1}, {2.5, 1}};

std::vector<std::vector<double>> balls_of(const Frame &frame) {
  std::vector<std::vector<double>> balls = {{-1, 0, 0}, {5, 0, 0}};
  for (const double side : {frame.cage, -frame.cage}) {
    balls.insert(balls.end(), {{20 + side, 0, 0}, {20, side, 0}, {20, 0, side}});
  }
  balls.push_back({frame.plug, frame.plug == 0 ? 9.0 : 0.0, 0});
  for (int ring = 0; ring < 5; ++ring) {
    const double x = ring;
    balls.insert(balls.end(), {{x, 1, 0}, {x, -1, 0}, {x, 0, 1}, {x, 0, -1}});
  }
  return balls;
}

std::string molecule() {
  std::ostringstream text;
  size_t ball = 0;
  for (const std::vector<double> &place : balls_of(run[0])) {
    text << place[0] << ' ' << place[1] << ' ' << place[2] << ' ' << (ball++ == PLUG ? 0.3 : 0.7) << '\n';
  }
  return text.str();
}

std::string frames(size_t count = run.size()) {
  std::ostringstream text;
  for (const Frame &frame : std::vector<Frame>{run.begin(), run.begin() + static_cast<std::ptrdiff_t>(count)}) {
    text << BALLS << "\n\n";
    for (const std::vector<double> &place : balls_of(frame)) {
      text << "C " << place[0] << ' ' << place[1] << ' ' << place[2] << '\n';
    }
  }
  return text.str();
}

std::vector<Json> lines_of_json(const std::string &text) {
  std::vector<Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(read_json(line).value_or(Json{}));
  return lines;
}

std::vector<Words> rows_of(const std::string &text) {
  std::vector<Words> rows;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    rows.emplace_back();
    std::istringstream cells(line + ',');
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

struct Expected {
  std::string from;
  std::set<double> merged, has, lacks;  // balls
};

// By number, of each frame.
const std::vector<std::map<double, Expected>> by_hand = {
    {{1, {"none", {}, {LEFT, RIGHT}, {CAGE}}}, {2, {"none", {}, {CAGE, CAGE + 5}, {LEFT}}}},
    {{1, {"none", {}, {RIGHT}, {LEFT}}},  // it splits, and the part of more rings keeps its number
     {2, {"none", {}, {CAGE}, {}}},
     {3, {"1", {}, {LEFT}, {RIGHT}}}},
    {{1, {"none", {}, {RIGHT}, {}}}, {3, {"none", {}, {LEFT}, {}}}},  // the cage is closed
    {{1, {"none", {}, {RIGHT}, {}}},
     {2, {"none", {}, {CAGE}, {}}},  // and opens again
     {3, {"none", {}, {LEFT}, {}}}},
    {{1, {"none", {3}, {LEFT, RIGHT}, {}}}, {2, {"none", {}, {CAGE}, {}}}},  // the tube is one again
    {{1, {"none", {}, {RIGHT}, {LEFT}}},
     {2, {"none", {}, {CAGE}, {}}},
     {3, {"1", {}, {LEFT, LEFT + 8}, {RIGHT}}}},  // and splits elsewhere: this is the part that was there before
};

struct Command {
  Words words;
  std::string list, number;
};

const Command commands[] = {{{"pores", "--probe", "0.2", "--pockets", "0.25"}, "pocket_list", "pocket"},
                            {{"voids", "--probe", "0.2"}, "voids", "void"}};

Words with(Words words, const Words &more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Cavities, KeepTheirNumbers) {
  const TemporaryFile file("tube.xyzr", molecule()), trajectory("run.xyz", frames());
  for (const Command &command : commands) {
    const Words words = with(command.words, {file.path(), "--trajectory", trajectory.path()});
    const Outcome outcome = run_program(with(words, {"--json"}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::vector<Json> lines = lines_of_json(outcome.out);
    ASSERT_EQ(lines.size(), by_hand.size());
    std::vector<Words> expected_rows;
    for (size_t k = 0; k < lines.size(); ++k) {
      std::map<double, const Json *> found;
      double last = HUGE_VAL;
      for (const Json &cavity : lines[k][command.list].items) {
        found[cavity[command.number].number] = &cavity;
        EXPECT_LE(cavity["volume"].number, last);
        last = cavity["volume"].number;
        expected_rows.push_back({std::to_string(k + 1), cavity[command.number].text, cavity["from"].text});
      }
      ASSERT_EQ(found.size(), by_hand[k].size()) << command.list << k;
      for (const auto &[number, expected] : by_hand[k]) {
        ASSERT_TRUE(found.contains(number)) << command.list << k << ' ' << number;
        const Json &cavity = *found[number];
        std::set<double> balls, merged;
        for (const Json &ball : cavity["balls"].items) balls.insert(ball.number);
        for (const Json &other : cavity["merged"].items) merged.insert(other.number);
        EXPECT_EQ(cavity["from"].text, expected.from) << k << ' ' << number;
        EXPECT_EQ(merged, expected.merged) << k << ' ' << number;
        for (const double ball : expected.has) EXPECT_TRUE(balls.contains(ball)) << k << ' ' << number << ' ' << ball;
        for (const double ball : expected.lacks) EXPECT_FALSE(balls.contains(ball)) << k << ' ' << number;
      }
    }
    // The list as rows, the same by any number of threads.
    const Outcome list = run_program(with(words, {"--csv", "--threads", "1"}));
    EXPECT_EQ(list.out, run_program(with(words, {"--csv", "--threads", "5"})).out);
    std::vector<Words> rows = rows_of(list.out);
    ASSERT_EQ(rows.size(), expected_rows.size() + 1);
    EXPECT_EQ((Words{rows[0].begin(), rows[0].begin() + 4}), (Words{"frame", "time", "step", command.number}));
    EXPECT_EQ(rows[0].back(), "from");
    for (size_t k = 1; k < rows.size(); ++k) {
      EXPECT_EQ((Words{rows[k][0], rows[k][3], rows[k].back()}), expected_rows[k - 1]);
    }
  }
}

// The row of a frame has sums over the list; small ones are left out of both, and have no numbers.
TEST(Cavities, RowsOfFrames) {
  const TemporaryFile file("tube.xyzr", molecule()), trajectory("run.xyz", frames());
  for (const Command &command : commands) {
    for (const Words &more : std::vector<Words>{{}, {"--min-volume", "0.05"}, {"--frames", "2:6:2"}}) {
      const Words words = with(with(command.words, {file.path(), "--trajectory", trajectory.path()}), more);
      const std::vector<Json> lines = lines_of_json(run_program(with(words, {"--json"})).out);
      const std::vector<Words> rows = rows_of(run_program(words).out);
      ASSERT_EQ(rows.size(), lines.size() + 1);
      const auto cell = [&](size_t row, const std::string &title) {
        const auto at = std::find(rows[0].begin(), rows[0].end(), title) - rows[0].begin();
        return rows.at(row).at(static_cast<size_t>(at));
      };
      const bool pores = command.list == "pocket_list";
      for (size_t k = 0; k < lines.size(); ++k) {
        const std::vector<Json> &list = lines[k][command.list].items;
        double volume = 0;
        for (const Json &cavity : list) volume += cavity["volume"].number;
        EXPECT_EQ(cell(k + 1, "frame"), lines[k]["frame"].text);
        EXPECT_EQ(cell(k + 1, "smaller"), lines[k]["smaller"].text);
        EXPECT_NEAR(std::stod(cell(k + 1, pores ? "pocket_volume" : "volume")), volume, 1e-12);
        EXPECT_EQ(cell(k + 1, pores ? "largest_pocket_volume" : "largest"), list.at(0)["volume"].text);
        if (pores) {
          EXPECT_EQ(cell(k + 1, "largest_pocket"), list[0]["pocket"].text);
        } else {
          EXPECT_EQ(cell(k + 1, "voids"), std::to_string(list.size()));
        }
        for (const Json &cavity : list)
          EXPECT_TRUE(more.empty() || more[0] == "--frames" || cavity["volume"].number >= 0.05);
      }
    }
  }
}

// Largest first, those of volume 0 and a line about them; with --min-volume they are left out.
TEST(Cavities, LargePocketsFirst) {
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const Words words = {"pores", crambin, "--probe", "0.8", "--pockets", "3"};
  const Json all = run_json(words), some = run_json(with(words, {"--min-volume", "0.5"}));
  const std::vector<Json> &pockets = all["pocket_list"].items;
  std::set<std::string> numbers;
  size_t empty = 0, large = 0;
  for (size_t k = 0; k < pockets.size(); ++k) {
    const double volume = pockets[k]["volume"].number;
    numbers.insert(pockets[k]["pocket"].text);
    EXPECT_GE(pockets[k == 0 ? 0 : k - 1]["volume"].number, volume);
    empty += volume == 0 ? 1 : 0;
    if (volume < 0.5) continue;
    ++large;
    EXPECT_EQ(some["pocket_list"].items.at(k)["pocket"].text, pockets[k]["pocket"].text);
  }
  EXPECT_EQ(numbers.size(), pockets.size());
  EXPECT_GT(empty, 0U);
  EXPECT_EQ(some["pocket_list"].items.size(), large);
  EXPECT_EQ(some["smaller"].number, static_cast<double>(pockets.size() - large));
  EXPECT_EQ(all["smaller"].number, 0);
  const std::string table = run_program(words).out;
  EXPECT_NE(table.find("\n  of volume 0      " + std::to_string(empty) + " "), std::string::npos) << table;
  EXPECT_EQ(run_program(with(words, {"--min-volume", "0.5"})).out.find("of volume 0"), std::string::npos);
}

// A line for each, with gaps, and what the legend says of it.
TEST(Cavities, ChartOfVolumes) {
  const TemporaryFile file("tube.xyzr", molecule()), trajectory("run.xyz", frames());
  for (const Command &command : commands) {
    const Words words = with(command.words, {file.path(), "--trajectory", trajectory.path()});
    const std::string svg = run_program(with(words, {"--plot", "-"})).out;
    EXPECT_EQ(svg.rfind("<svg", 0), 0U) << svg;
    const std::string noun = command.number;
    for (const auto &[number, there] : std::map<int, int>{{1, 6}, {2, 5}, {3, 4}}) {
      const size_t at = svg.find('>' + noun + ' ' + std::to_string(number) + ": mean ");
      ASSERT_NE(at, std::string::npos) << number << svg;
      const std::string line = svg.substr(at, svg.find('<', at) - at);
      EXPECT_NE(line.find(", in " + std::to_string(there) + " of 6 frames"), std::string::npos) << line;
    }
    // The cage is not there in the third frame, and the left part not in the fifth: lines have gaps. Behind its gap the
    // latter is there once, as a point.
    std::multiset<size_t> starts;
    std::istringstream lines(svg);
    for (std::string line; std::getline(lines, line);) {
      const bool of_cavity = line.find("stroke-linejoin") != std::string::npos && line.find('L') != std::string::npos;
      if (of_cavity) starts.insert(count_of(line, "M"));
    }
    EXPECT_EQ(starts, (std::multiset<size_t>{1, 2, 2}));
    EXPECT_EQ(count_of(svg, "<circle"), 1U);
    const std::string one = run_program(with(words, {"--plot", "-", "--frames", "3", "--min-volume", "99"})).out;
    EXPECT_NE(one.find(">no " + noun + " has a volume<"), std::string::npos) << one;
    EXPECT_EQ(run_program(with(words, {"--plot", "-", "--csv"})).status, 2);
  }
}

TEST(Cavities, UsageThatIsRefused) {
  for (const Words &words : std::vector<Words>{{"voids", "--plot", "x.svg"},
                                               {"pores", "--trajectory", "run.xyz", "--plot", "x.svg"},
                                               {"pores", "--min-volume", "1"},
                                               {"pores", "--trajectory", "run.xyz", "--tree", "x.svg"},
                                               {"pores", "--trajectory", "run.xyz", "--points", "x.pdb"},
                                               {"voids", "--trajectory", "run.xyz", "--balls"},
                                               {"voids", "--trajectory", "run.xyz", "--plot", "x.png"},
                                               {"voids", "--frames", "1"}}) {
    const Outcome outcome = run_program(with(words, {"good/corners.xyzr"}));
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(words);
    EXPECT_EQ(outcome.out, "");
  }
}

// Frames of the second molecule: what each gives on its own.
TEST(Cavities, ClashOfFrames) {
  const TemporaryFile fixed("fixed.xyz", frames(1)), moving("moving.xyz", "2\n\nC 0 0 0\nO 1 0 0\n"),
      trajectory("run.xyz", "2\n\nC 0 0 0\nO 1 0 0\n2\n\nC 2 9 0\nO 3 9 0\n2\n\nC 2 3 0\nO 1 3 0\n");
  const Words words = {"clash", fixed.path(), moving.path(), "--translate", "0,0.5,0"};
  const Words of_run = with(words, {"--trajectory", trajectory.path()});
  const std::vector<Json> lines = lines_of_json(run_program(with(of_run, {"--json"})).out);
  const std::vector<Words> rows = rows_of(run_program(of_run).out);
  ASSERT_EQ(lines.size(), 3U);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0],
            (Words{"frame", "time", "step", "hit", "pairs", "gap", "nearest_1", "nearest_2", "overlap_volume"}));
  const std::string alone[] = {"2\n\nC 0 0 0\nO 1 0 0\n", "2\n\nC 2 9 0\nO 3 9 0\n", "2\n\nC 2 3 0\nO 1 3 0\n"};
  for (size_t k = 0; k < 3; ++k) {
    const TemporaryFile single("alone.xyz", alone[k]);
    const Json json = run_json({"clash", fixed.path(), single.path(), "--translate", "0,0.5,0"});
    EXPECT_EQ(lines[k]["frame"].number, static_cast<double>(k + 1));
    EXPECT_EQ(lines[k]["gap"].number, json["gap"].number);
    EXPECT_EQ(lines[k]["overlap_volume"].number, json["overlap_volume"].number);
    EXPECT_EQ(lines[k]["pairs"].items.size(), json["pairs"].items.size());
    EXPECT_EQ(rows[k + 1][3], json["hit"].boolean ? "true" : "false");
    EXPECT_EQ(rows[k + 1][4], std::to_string(json["pairs"].items.size()));
    EXPECT_EQ(std::stod(rows[k + 1][5]), json["gap"].number);
    for (size_t side = 0; side < 2; ++side) {
      EXPECT_EQ(std::stod(rows[k + 1][6 + side]), json["nearest"].items[side].number);
    }
  }
  const Outcome broken = run_program(with(words, {"--trajectory", "frames.pdb"}));
  EXPECT_EQ(rows_of(broken.out).size(), 3U);
  EXPECT_NE(broken.err.find("hardsphere: frames.pdb:"), std::string::npos) << broken.err;
  EXPECT_NE(broken.err.find(": frame 3: "), std::string::npos) << broken.err;
  // One that is too far away for the lattice is said with its number, too.
  const TemporaryFile far("far.xyz", "2\n\nC 0 0 0\nO 1 0 0\n2\n\nC 0 0 0\nO 1e15 0 0\n");
  const Outcome beyond = run_program(with(words, {"--trajectory", far.path()}));
  EXPECT_EQ(beyond.status, 1);
  EXPECT_NE(beyond.err.find(": frame 2: "), std::string::npos) << beyond.err;
}

}  // namespace
