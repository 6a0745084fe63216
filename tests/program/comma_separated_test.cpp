// The tables that --csv prints, read by the rules of RFC 4180: every row has the columns of the header, and every
// number is the one that JSON gives, to the last digit.
#include <gtest/gtest.h>

#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Row = std::vector<std::string>;

// The rows of a text whose lines end with LF; nothing if a quote stands where none may.
std::optional<std::vector<Row>> read_table(const std::string &text) {
  std::vector<Row> rows;
  size_t at = 0;
  while (at < text.size()) {
    Row row(1);
    while (at < text.size() && text[at] != '\n') {
      if (text[at] == ',') {
        row.emplace_back();
        ++at;
      } else if (text[at] == '"') {
        if (!row.back().empty()) return std::nullopt;
        for (++at; at < text.size(); ++at) {
          if (text[at] == '"' && (at + 1 == text.size() || text[at + 1] != '"')) break;
          if (text[at] == '"') ++at;
          row.back().push_back(text[at]);
        }
        if (at == text.size()) return std::nullopt;
        ++at;
        if (at < text.size() && text[at] != ',' && text[at] != '\n') return std::nullopt;
      } else {
        row.back().push_back(text[at++]);
      }
    }
    if (at == text.size()) return std::nullopt;
    ++at;
    rows.push_back(row);
  }
  return rows;
}

std::vector<Row> run_csv(std::vector<std::string> arguments, const std::string &command = "measure") {
  arguments.insert(arguments.begin(), command);
  arguments.push_back("--csv");
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string water = "; --no-water leaves them out\n";  // selection_test.cpp looks at it
  EXPECT_TRUE(outcome.err.empty() || outcome.err.ends_with(water)) << outcome.err;
  const std::optional<std::vector<Row>> rows = read_table(outcome.out);
  EXPECT_TRUE(rows.has_value()) << outcome.out;
  if (!rows || rows->empty()) return {{}};
  for (const Row &row : *rows) EXPECT_EQ(row.size(), rows->front().size()) << outcome.out;
  return *rows;
}

const Row place = {"x", "y", "z", "radius", "area"};
const Row slopes = {"area_gradient_x",   "area_gradient_y",   "area_gradient_z", "volume_gradient_x",
                    "volume_gradient_y", "volume_gradient_z", "area_dr",         "volume_dr"};
const Row weighted = {"weighted_gradient_x", "weighted_gradient_y", "weighted_gradient_z", "weighted_dr"};

Row operator+(Row a, const Row &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(CommaSeparated, ReaderIsStrict) {
  EXPECT_EQ(read_table("a,\"b,\"\"c\",\n"), (std::vector<Row>{{"a", "b,\"c", ""}}));
  EXPECT_EQ(read_table("\"a\nb\"\nc\n"), (std::vector<Row>{{"a\nb"}, {"c"}}));
  for (const char *bad : {"a", "\"a\n", "a\"b\"\n", "\"a\"b\n"}) EXPECT_FALSE(read_table(bad).has_value()) << bad;
}

TEST(CommaSeparated, ColumnsFollowFromTheFormat) {
  const Row pdb = Row{"ball", "atom", "element", "chain", "residue", "number", "insertion"} + place;
  const Row pqr = Row{"ball", "atom", "chain", "residue", "number", "insertion"} + place;
  EXPECT_EQ(run_csv({"good/water.pdb"})[0], pdb);
  EXPECT_EQ(run_csv({"good/water.pqr"})[0], pqr);
  EXPECT_EQ(run_csv({"good/water.xyz"})[0], (Row{"ball", "element"} + place));
  EXPECT_EQ(run_csv({"good/two.xyzr"})[0], (Row{"ball"} + place));
  EXPECT_EQ(run_csv({"good/two.xyzr", "--per-ball"})[0], (Row{"ball"} + place));
  EXPECT_EQ(run_csv({"good/two.xyzr", "--gradient"})[0], (Row{"ball"} + place + slopes));
  EXPECT_EQ(run_csv({"good/water.pdb", "--weights", "good/water.weights"})[0], (pdb + Row{"weight"}));
  EXPECT_EQ(run_csv({"good/water.pdb", "--weights", "good/water.weights", "--gradient"})[0],
            (pdb + Row{"weight"} + slopes + weighted));
}

TEST(CommaSeparated, NumbersAreThoseOfJson) {
  const std::vector<std::string> arguments = {"good/water.pdb", "--gradient",        "--probe", "0.3",
                                              "--weights",      "good/water.weights"};
  const std::vector<Row> rows = run_csv(arguments);
  const Json balls = run_json(std::vector<std::string>{"measure"} + arguments)["balls"];
  ASSERT_EQ(rows.size(), 4u);
  ASSERT_EQ(balls.items.size(), 3u);
  const std::vector<Row> expected_begin = {{"0", "O", "O", "A", "HOH", "1", "", "0", "0", "0", "1.52"},
                                           {"1", "H1", "H", "A", "HOH", "1", "", "0.757", "0.586", "0", "1.1"},
                                           {"2", "H2", "H", "A", "HOH", "1", "", "-0.757", "0.586", "0", "1.1"}};
  const Row weights = {"1", "-0.5", "2"};
  for (size_t i = 0; i < 3; ++i) {
    const Json &ball = balls.items[i];
    Row expected = expected_begin[i] + Row{ball["area"].text, weights[i]};
    for (const char *key :
         {"area_gradient", "volume_gradient", "area_dr", "volume_dr", "weighted_gradient", "weighted_dr"}) {
      if (ball[key].kind == Json::Kind::number) expected.push_back(ball[key].text);
      for (const Json &item : ball[key].items) expected.push_back(item.text);
    }
    EXPECT_EQ(rows[i + 1], expected);
  }
}

TEST(CommaSeparated, WhatIsNotFiniteIsEmpty) {
  const std::vector<Row> rows = run_csv({"good/water.pdb", "--gradient", "--weights", "good/huge.weights"});
  for (size_t i = 1; i < rows.size(); ++i) EXPECT_EQ(rows[i].back(), "");
}

TEST(CommaSeparated, NamesAreQuoted) {
  const Outcome outcome = run_program({"measure", "good/residues.pdb", "--csv"});
  EXPECT_NE(outcome.out.find("\n11,\"C\"\"\",C,\",\",\"U\\\"\"\",A000,,110,0,0,1.7,"), std::string::npos)
      << outcome.out;
  const std::vector<Row> rows = run_csv({"good/residues.pdb"});
  ASSERT_EQ(rows.size(), 14u);
  EXPECT_EQ(rows[12][1], "C\"");
  EXPECT_EQ(rows[12][3], ",");
  EXPECT_EQ(rows[12][4], "U\\\"");
  EXPECT_EQ(rows[13][1], "C1,");
}

TEST(CommaSeparated, Groups) {
  const std::vector<Row> residues = run_csv({"good/residues.pdb", "--by", "residue"});
  ASSERT_EQ(residues.size(), 13u);
  EXPECT_EQ(residues[0], (Row{"chain", "residue", "number", "insertion", "atoms", "area"}));
  const Json json = run_json({"measure", "good/residues.pdb", "--by", "residue"})["residues"];
  for (size_t i = 0; i < json.items.size(); ++i) {
    EXPECT_EQ(residues[i + 1][2], json.items[i]["number"].text);
    EXPECT_EQ(residues[i + 1][3], json.items[i]["insertion"].text);
    EXPECT_EQ(residues[i + 1][5], json.items[i]["area"].text);
  }
  const std::vector<Row> chains = run_csv({"good/residues.pdb", "--by", "chain"});
  ASSERT_EQ(chains.size(), 5u);
  EXPECT_EQ(chains[0], (Row{"chain", "atoms", "area"}));
  EXPECT_EQ(chains[1][0] + " " + chains[1][1], "A 6");
  EXPECT_EQ(chains[4][0] + " " + chains[4][1], ", 2");
}

// Lists of other commands: a row for each item of the JSON, with the same numbers.
TEST(CommaSeparated, Contacts) {
  const std::vector<std::string> arguments = {"good/residues.pdb", "--probe", "4", "--least", "20"};
  const std::vector<Row> rows = run_csv(arguments, "contacts");
  const Json json = run_json(std::vector<std::string>{"contacts"} + arguments);
  ASSERT_EQ(rows.size(), json["pairs"].items.size() + 1);
  ASSERT_GT(rows.size(), 3U);
  Row titles;
  for (const char *side : {"_1", "_2"}) {
    for (const char *name : {"ball", "atom", "element", "chain", "residue", "number", "insertion"}) {
      titles.push_back(std::string(name) + side);
    }
  }
  EXPECT_EQ(rows[0], (titles + Row{"area", "rim", "distance", "edge"}));
  for (size_t k = 1; k < rows.size(); ++k) {
    const Json &pair = json["pairs"].items[k - 1];
    Row expected;
    for (const Json &ball : pair["balls"].items) {
      const Json &label = json["balls"].items.at(static_cast<size_t>(ball.number));
      for (const char *key : {"ball", "atom", "element", "chain", "residue", "number", "insertion"}) {
        expected.push_back(label[key].text);
      }
    }
    for (const char *key : {"area", "rim", "distance", "edge"}) expected.push_back(pair[key].text);
    if (k == rows.size() - 1) break;  // the last name has a letter that JSON writes in another way
    EXPECT_EQ(rows[k], expected);
  }
  const std::vector<Row> chains = run_csv({"good/residues.pdb", "--probe", "4", "--by", "chain"}, "contacts");
  const Json sums = run_json({"contacts", "good/residues.pdb", "--probe", "4", "--by", "chain"})["pairs"];
  ASSERT_EQ(chains.size(), sums.items.size() + 1);
  EXPECT_EQ(chains[0], (Row{"chain_1", "chain_2", "area", "rim", "atom_pairs", "edge"}));
  for (size_t k = 1; k < chains.size(); ++k) {
    const Json &sum = sums.items[k - 1];
    EXPECT_EQ(chains[k], (Row{sum["chains"].items[0].text, sum["chains"].items[1].text, sum["area"].text,
                              sum["rim"].text, sum["atom_pairs"].text, sum["edge"].text}));
  }
  const std::vector<Row> residues = run_csv({"good/residues.pdb", "--probe", "4", "--by", "residue"}, "contacts");
  EXPECT_EQ(residues[0], (Row{"chain_1", "residue_1", "number_1", "insertion_1", "chain_2", "residue_2", "number_2",
                              "insertion_2", "area", "rim", "atom_pairs", "edge"}));
  EXPECT_EQ(residues.at(1),
            (Row{"A", "ALA", "1", "", "A", "ALA", "1", "A"} + Row(residues.at(1).begin() + 8, residues.at(1).end())));
  const Row shifted = run_csv({"good/two.xyzr", "--box", "9,9,9"}, "contacts")[0];
  EXPECT_EQ(shifted, (Row{"ball_1", "ball_2", "area", "rim", "distance", "shift_x", "shift_y", "shift_z", "edge"}));
}

TEST(CommaSeparated, VoidsAndShells) {
  const std::vector<Row> voids = run_csv({"good/cage.xyzr"}, "voids");
  const Json cavity = run_json({"voids", "good/cage.xyzr"})["voids"].items.at(0);
  ASSERT_EQ(voids.size(), 2U);
  EXPECT_EQ(voids[0],
            (Row{"void", "volume", "area", "x", "y", "z", "clearance", "clearance_bound", "balls", "components"}));
  EXPECT_EQ(voids[1], (Row{"1", cavity["volume"].text, cavity["area"].text, "0", "0", "0", cavity["clearance"].text,
                           cavity["clearance_bound"].text, "6", "0"}));
  const std::vector<Row> counts = run_csv({"good/cage.xyzr", "good/two.xyzr"}, "boundary");
  const Row titles = {"balls",         "vertices", "arcs",       "circles", "faces",
                      "exposed_balls", "shells",   "components", "voids",   "euler"};
  EXPECT_EQ(counts, (std::vector<Row>{Row{"file"} + titles,
                                      {"good/cage.xyzr", "6", "16", "24", "0", "12", "6", "2", "1", "1", "4"},
                                      {"good/two.xyzr", "2", "0", "0", "1", "2", "2", "1", "1", "0", "2"}}));
  const std::vector<Row> shells = run_csv({"good/cage.xyzr", "--shells"}, "boundary");
  const Json list = run_json({"boundary", "good/cage.xyzr", "--shells"})["shell_list"];
  EXPECT_EQ(shells[0], (Row{"shell", "kind", "component", "cell", "faces", "euler", "genus", "area", "volume"}));
  ASSERT_EQ(shells.size(), list.items.size() + 1);
  for (size_t k = 1; k < shells.size(); ++k) {
    Row expected = {std::to_string(k - 1)};
    for (size_t column = 1; column < shells[0].size(); ++column) {
      expected.push_back(list.items[k - 1][shells[0][column]].text);
    }
    EXPECT_EQ(shells[k], expected);
  }
}

// Columns of tables have the same decimals everywhere, if the file has a unit; JSON and CSV have all digits.
TEST(Tables, HaveFixedDecimals) {
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const std::vector<std::vector<std::string>> commands = {
      {"measure", "--by", "residue", "--relative", "--probe", "1.4"},
      {"measure", "--per-ball", "--probe", "2"},
      {"contacts", "--cells"},
      {"contacts", "--by", "residue"},
      {"voids", "--probe", "0.61"},
      {"boundary", "--probe", "0.61", "--shells"},
      {"map", "--per-ball"},
  };
  for (std::vector<std::string> arguments : commands) {
    arguments.insert(arguments.begin() + 1, crambin);
    std::istringstream lines(run_program(arguments).out);
    const std::regex exponent("[0-9]e[-+][0-9]");
    for (std::string line; std::getline(lines, line);) EXPECT_FALSE(std::regex_search(line, exponent)) << line;
  }
}

// Values that four decimals would show as nothing are not 0: two balls that hardly meet. Without a unit it has an
// exponent.
TEST(Tables, SayWhatIsNearlyNothing) {
  const TemporaryFile pair("pair.xyz", "2\n\nC 0 0 0\nC 0 0 3.4\n");
  const TemporaryFile plain("pair.xyzr", "0 0 0 1.700001\n0 0 3.4 1.700001\n");
  const std::string with_unit = run_program({"contacts", pair.path(), "--radius", "C=1.700001"}).out;
  EXPECT_NE(with_unit.find("  <0.0001  "), std::string::npos) << with_unit;
  EXPECT_NE(with_unit.find("  3.4000\n"), std::string::npos) << with_unit;
  const std::string without = run_program({"contacts", plain.path()}).out;
  EXPECT_NE(without.find("e-05  "), std::string::npos) << without;
}

}  // namespace
