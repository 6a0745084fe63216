// The JSON of every command is strict JSON with exactly the keys that the contract lists, in that order.
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Keys = std::vector<std::string>;

const std::vector<std::string> files = {"good/one.xyzr",  "good/point.xyzr", "good/points.xyzr",
                                        "good/same.xyzr", "good/two.xyzr",   "good/cage.xyzr",
                                        "good/water.pdb", "good/water.pqr",  "good/water.xyz"};

// The identity of a ball comes first, as far as the file's format says it.
Keys ball_keys(const std::string &file, const Keys &values) {
  const std::string extension = file.substr(file.rfind('.'));
  Keys keys = {"ball"};
  if (extension == ".pdb") keys.insert(keys.end(), {"atom", "element", "chain", "residue", "number", "insertion"});
  if (extension == ".pqr") keys.insert(keys.end(), {"atom", "chain", "residue", "number", "insertion"});
  if (extension == ".xyz") keys.push_back("element");
  keys.insert(keys.end(), {"xyz", "radius"});
  keys.insert(keys.end(), values.begin(), values.end());
  return keys;
}

TEST(JsonReader, IsStrict) {
  for (const char *good : {"{}", " [1, -2.5e-3, 0, 0.0] ", "{\"a\": null, \"b\": [true, false]}", "\"text\"", "1E+2",
                           R"("\"\\\/\b\f\n\r\t\u00e9\uFFFD")"}) {
    EXPECT_TRUE(read_json(good).has_value()) << good;
  }
  for (const char *bad : {"",          "{",           "{,}",        "[1,]",        "[1 2]",
                          "{\"a\" 1}", "{\"a\": 1,}", "{a: 1}",     "nan",         "NaN",
                          "Infinity",  "-inf",        "01",         "1.",          ".5",
                          "+1",        "1e",          "0x1",        "1e999",       "{\"a\": 1, \"a\": 2}",
                          "1 2",       "'a'",         "{\"a\": -}", "[-nan]",      "\"a",
                          "nul",       R"("\a")",     R"("\u12")",  R"("\ud800")", "\"\n\""}) {
    EXPECT_FALSE(read_json(bad).has_value()) << bad;
  }
  EXPECT_EQ(read_json(R"("\"\\ \u0041\u00e9\ufffd")")->text, "\"\\ A\u00E9\uFFFD");
}

// Names of files and titles in UTF-8 are themselves, and each byte of no character is U+FFFD.
TEST(JsonOutput, TextsAreUtf8) {
  const TemporaryFile named("\u00DF\u4E2D\U0001F9EA \"1\".xyz", "1\n\nC 0 0 0\n");
  EXPECT_EQ(run_json({"measure", named.path()})["input"]["file"].text, named.path());
  const std::string bad = "\xEF\xBF\xBD";
  const struct {
    std::string title;
    size_t ill_formed;  // bytes; 0: it is the same in JSON
  } cases[] = {{"\xC2\x80 \xDF\xBF \xE0\xA0\x80 \xED\x9F\xBF \xEE\x80\x80 \xEF\xBF\xBF", 0},
               {"\xF0\x90\x80\x80 \xF4\x8F\xBF\xBF", 0},
               {"\xC0\x80", 2},  // overlong, of two, three and four bytes
               {"\xC1\xBF", 2},
               {"\xE0\x9F\xBF", 3},
               {"\xF0\x8F\xBF\xBF", 4},
               {"\xED\xA0\x80", 3},  // surrogates
               {"\xED\xBF\xBF", 3},
               {"\xF4\x90\x80\x80", 4},  // beyond U+10FFFF
               {"\xF5\x80\x80\x80", 4},
               {"\xFF", 1},
               {"\x80", 1},
               {"\xC3", 1},  // cut
               {"\xE4\xB8", 2},
               {"\xF0\x9F\xA7", 3}};
  for (const auto &one : cases) {
    const TemporaryFile file("titled.xyz", "1\na" + one.title + "\nC 0 0 0\n");
    const Outcome outcome = run_program({"measure", file.path(), "--models", "all", "--json"});
    const auto json = read_json(outcome.out);
    ASSERT_TRUE(json.has_value()) << outcome.out;
    std::string expected = "a";
    for (size_t k = 0; k < one.ill_formed; ++k) expected += bad;
    EXPECT_EQ((*json)["title"].text, one.ill_formed == 0 ? "a" + one.title : expected);
  }
}

TEST(JsonOutput, ModelHasItsKeys) {
  for (const std::string &file : files) {
    EXPECT_EQ(run_json({"model", file}).keys, (Keys{"n", "k", "rho", "max_overlaps", "mean_overlaps", "input"}))
        << file;
  }
}

TEST(JsonOutput, BoundaryHasItsKeys) {
  for (const std::string &file : files) {
    EXPECT_EQ(run_json({"boundary", file}).keys, (Keys{"n", "vertices", "arcs", "circles", "faces", "exposed_balls",
                                                       "shells", "components", "voids", "euler", "input"}))
        << file;
  }
}

TEST(JsonOutput, MeasureHasItsKeys) {
  for (const std::string &file : files) {
    EXPECT_EQ(run_json({"measure", file}).keys, (Keys{"n", "area", "volume", "input"})) << file;
    const Json json = run_json({"measure", file, "--per-ball"});
    EXPECT_EQ(json.keys, (Keys{"n", "area", "volume", "balls", "input"})) << file;
    EXPECT_EQ(json["balls"].kind, Json::Kind::array) << file;
    EXPECT_EQ(static_cast<double>(json["balls"].items.size()), json["n"].number) << file;
    for (const Json &ball : json["balls"].items) {
      EXPECT_EQ(ball.keys, ball_keys(file, {"area"})) << file;
      EXPECT_EQ(ball["area"].kind, Json::Kind::number) << file;
    }
  }
}

TEST(JsonOutput, BallsSayWhatTheyAre) {
  const Json balls = run_json({"measure", "good/water.pdb", "--per-ball", "--probe", "1.4"})["balls"];
  ASSERT_EQ(balls.items.size(), 3u);
  const Json &hydrogen = balls.items[1];
  EXPECT_EQ(hydrogen["ball"].text, "1");
  EXPECT_EQ(hydrogen["atom"].text, "H1");
  EXPECT_EQ(hydrogen["element"].text, "H");
  EXPECT_EQ(hydrogen["chain"].text, "A");
  EXPECT_EQ(hydrogen["residue"].text, "HOH");
  EXPECT_EQ(hydrogen["number"].text, "1");
  EXPECT_EQ(hydrogen["number"].kind, Json::Kind::number);
  EXPECT_EQ(hydrogen["insertion"].text, "");
  EXPECT_EQ(hydrogen["xyz"].items.at(0).text, "0.757");
  EXPECT_EQ(hydrogen["xyz"].items.at(1).text, "0.586");
  EXPECT_EQ(hydrogen["radius"].text, "1.1");
}

TEST(JsonOutput, GradientsHaveTheirKeys) {
  const Keys plain = {"area", "area_gradient", "volume_gradient", "area_dr", "volume_dr"};
  for (const std::string &file : files) {
    const Json json = run_json({"measure", file, "--gradient"});
    EXPECT_EQ(json.keys, (Keys{"n", "area", "volume", "balls", "input"})) << file;
    EXPECT_EQ(static_cast<double>(json["balls"].items.size()), json["n"].number) << file;
    for (const Json &ball : json["balls"].items) {
      EXPECT_EQ(ball.keys, ball_keys(file, plain)) << file;
      for (const char *key : {"area_gradient", "volume_gradient"}) {
        EXPECT_EQ(ball[key].kind, Json::Kind::array) << file;
        EXPECT_EQ(ball[key].items.size(), 3u) << file;
      }
    }
    EXPECT_EQ(run_program({"measure", file, "--gradient", "--per-ball", "--json"}).out,
              run_program({"measure", file, "--gradient", "--json"}).out);
  }
}

TEST(JsonOutput, WeightsHaveTheirKeys) {
  EXPECT_EQ(run_json({"measure", "good/water.pdb", "--weights", "good/water.weights"}).keys,
            (Keys{"n", "area", "volume", "weighted_area", "input"}));
  const Json json = run_json({"measure", "good/water.pdb", "--weights=good/water.weights", "--gradient"});
  EXPECT_EQ(json.keys, (Keys{"n", "area", "volume", "weighted_area", "balls", "input"}));
  for (const Json &ball : json["balls"].items) {
    EXPECT_EQ(ball.keys, ball_keys("good/water.pdb", {"area", "weight", "area_gradient", "volume_gradient", "area_dr",
                                                      "volume_dr", "weighted_gradient", "weighted_dr"}));
  }
}

TEST(JsonOutput, GroupsHaveTheirKeys) {
  for (const char *file : {"good/water.pdb", "good/water.pqr", "good/insertion.pdb"}) {
    const Json residues = run_json({"measure", file, "--by", "residue"});
    EXPECT_EQ(residues.keys, (Keys{"n", "area", "volume", "residues", "input"})) << file;
    EXPECT_EQ(residues["residues"].items.empty(), residues["n"].number == 0) << file;
    for (const Json &residue : residues["residues"].items) {
      EXPECT_EQ(residue.keys, (Keys{"chain", "name", "number", "insertion", "atoms", "area"})) << file;
      EXPECT_EQ(residue["number"].kind, Json::Kind::number) << file;
      EXPECT_EQ(residue["insertion"].kind, Json::Kind::string) << file;
    }
    const Json chains = run_json({"measure", file, "--by=chain", "--per-ball"});
    EXPECT_EQ(chains.keys, (Keys{"n", "area", "volume", "balls", "chains", "input"})) << file;
    for (const Json &chain : chains["chains"].items) EXPECT_EQ(chain.keys, (Keys{"chain", "atoms", "area"})) << file;
  }
}

TEST(JsonOutput, ShellsAndVoidsHaveTheirKeys) {
  for (const std::string &file : files) {
    const Json boundary = run_json({"boundary", file, "--shells"});
    EXPECT_EQ(boundary.keys, (Keys{"n", "vertices", "arcs", "circles", "faces", "exposed_balls", "shells", "components",
                                   "voids", "euler", "shell_list", "input"}))
        << file;
    EXPECT_EQ(static_cast<double>(boundary["shell_list"].items.size()), boundary["shells"].number) << file;
    for (const Json &shell : boundary["shell_list"].items) {
      EXPECT_EQ(shell.keys, (Keys{"kind", "component", "cell", "faces", "euler", "genus", "area", "volume"})) << file;
    }
    const Json voids = run_json({"voids", file});
    EXPECT_EQ(voids.keys, (Keys{"n", "voids", "smaller", "input"})) << file;
    EXPECT_EQ(static_cast<double>(voids["voids"].items.size()), boundary["voids"].number) << file;
    for (const Json &cavity : voids["voids"].items) {
      EXPECT_EQ(cavity.keys, (Keys{"void", "cell", "area", "volume", "components", "balls", "middle", "point",
                                   "clearance", "clearance_bound"}))
          << file;
    }
  }
}

TEST(JsonOutput, ContactsAndComplexHaveTheirKeys) {
  for (const std::string &file : files) {
    const Json plain = run_json({"contacts", file});
    EXPECT_EQ(plain.keys, (Keys{"n", "contacts", "area", "pairs", "balls", "input"})) << file;
    EXPECT_EQ(static_cast<double>(plain["pairs"].items.size()), plain["contacts"].number) << file;
    EXPECT_EQ(static_cast<double>(plain["balls"].items.size()), plain["n"].number) << file;
    for (const Json &ball : plain["balls"].items) EXPECT_EQ(ball.keys, ball_keys(file, {})) << file;
    double sum = 0.0;
    for (const Json &pair : plain["pairs"].items) {
      EXPECT_EQ(pair.keys, (Keys{"balls", "area", "rim", "distance", "edge"})) << file;
      EXPECT_LT(pair["balls"].items.at(0).number, pair["balls"].items.at(1).number) << file;
      sum += pair["area"].number;
    }
    EXPECT_NEAR(sum, plain["area"].number, 1e-12 * (1.0 + sum)) << file;
    const Json measured = run_json({"measure", file, "--curvature"});
    EXPECT_EQ(measured.keys, (Keys{"n", "area", "volume", "mean_curvature", "gauss_curvature", "input"})) << file;
    double volume = 0.0;
    const Json with_cells = run_json({"contacts", file, "--cells"});
    for (const Json &cell : with_cells["cells"].items) {
      EXPECT_EQ(cell.keys, (Keys{"volume", "area", "contact"})) << file;
      volume += cell["volume"].number;
    }
    EXPECT_NEAR(volume, measured["volume"].number, 1e-11 * (1.0 + volume)) << file;
    const Json complex = run_json({"complex", file});
    EXPECT_EQ(complex.keys, (Keys{"n", "simplices", "euler", "betti", "input"})) << file;
    EXPECT_EQ(complex["simplices"].keys, (Keys{"singular", "regular", "interior"})) << file;
    const Json boundary = run_json({"boundary", file});
    EXPECT_EQ(2 * complex["euler"].number, boundary["euler"].number) << file;
    EXPECT_EQ(complex["betti"].items.at(2).number, boundary["voids"].number) << file;
    EXPECT_EQ(run_json({"contacts", file, "--least", "1e9"})["pairs"].items.size(), 0U) << file;
  }
}

TEST(JsonOutput, CellsHaveTheirKeys) {
  for (const std::string &file : files) {
    const Json cells = run_json({"cells", file});
    EXPECT_EQ(cells.keys, (Keys{"n", "cubes", "cells", "free_cells", "adjacencies", "regions", "input"})) << file;
    EXPECT_EQ(cells["regions"].number, 1.0 + run_json({"boundary", file})["voids"].number) << file;
    EXPECT_GE(cells["free_cells"].number, 1.0) << file;
  }
}

TEST(JsonOutput, PathAndGateHaveTheirKeys) {
  for (const std::string &file : files) {
    const Json path = run_json({"path", file, "--from", "0,0,-1000", "--to", "1000,0,0"});
    EXPECT_EQ(path.keys, (Keys{"n", "connected", "covered", "certified", "length", "clearance", "points", "input"}))
        << file;
    EXPECT_TRUE(path["connected"].boolean) << file;
    EXPECT_GE(path["points"].items.size(), 2U) << file;
    const Json gate = run_json({"gate", file, "--from", "0,0,-1000"});
    EXPECT_EQ(gate.keys, (Keys{"n", "passes", "widest_probe", "gate", "from", "to", "input"})) << file;
    EXPECT_TRUE(gate["passes"].boolean) << file;
  }
}

TEST(JsonOutput, QueryHasItsKeys) {
  for (const std::string &file : files) {
    for (const std::vector<std::string> &query :
         {std::vector<std::string>{"--point", "0", "0", "0"}, std::vector<std::string>{"--ball", "0", "0", "0", "9"}}) {
      std::vector<std::string> arguments = {"query", file};
      arguments.insert(arguments.end(), query.begin(), query.end());
      const Json json = run_json(arguments);
      EXPECT_EQ(json.keys, (Keys{"hits", "input"})) << file;
      EXPECT_EQ(json["hits"].kind, Json::Kind::array) << file;
    }
  }
}

// Every command says what it read, and how that became balls.
TEST(JsonOutput, InputHasItsKeys) {
  const Keys keys = {"file",  "format", "unit",        "radii",  "radius_overrides", "substitutes", "probe",
                     "balls", "waters", "water_atoms", "hetatm", "hydrogens",        "radius_zero", "radius_by_element",
                     "model", "models", "left_out"};
  const Keys of_left_out = {
      "other_models", "alternate_locations", "virtual_sites", "hydrogens_of_set", "water", "hetatm", "hydrogen",
      "others"};
  for (const std::string &file : files) {
    const bool xyz = file.ends_with(".xyz"), cif = file.ends_with(".cif");
    Keys expected = keys, left_out = of_left_out;
    if (xyz) expected.insert(expected.begin() + 14, "atomic_numbers");
    if (cif) expected.insert(expected.begin() + 14, "coordinates");
    if (cif) left_out.insert(left_out.begin() + 3, "unplaced");
    for (const char *command : {"model", "boundary", "measure", "voids", "contacts", "complex", "cells"}) {
      const Json input = run_json({command, file})["input"];
      EXPECT_EQ(input.keys, expected) << file;
      EXPECT_EQ(input["file"].text, file);
      EXPECT_EQ(input["left_out"].keys, left_out);
    }
  }
  const Json input =
      run_json({"measure", "good/water.xyz", "--radii=chem3d", "--radius", "H=1", "--probe", "1.5"})["input"];
  EXPECT_EQ(input["format"].text, "xyz");
  EXPECT_EQ(input["unit"].text, "angstrom");
  EXPECT_EQ(input["radii"].text, "chem3d");
  EXPECT_EQ(input["radius_overrides"].text, "H=1");
  EXPECT_EQ(input["probe"].number, 1.5);
  EXPECT_EQ(input["balls"].number, 3);
  EXPECT_EQ(input["hydrogens"].number, 2);
  EXPECT_EQ(run_json({"model", "good/points.xyzr"})["input"]["radius_zero"].number, 2);
  EXPECT_EQ(run_json({"model", "good/two.xyzr"})["input"]["radii"].text, "file");
  EXPECT_EQ(run_json({"model", "good/two.xyzr"})["input"]["unit"].text, "unit");
}

// A missing value is null, never a number that stands for it.
TEST(JsonOutput, MissingValuesAreNull) {
  EXPECT_EQ(run_json({"model", "good/one.xyzr"})["k"].number, 1.0);
  EXPECT_EQ(run_json({"model", "good/one.xyzr"})["rho"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/point.xyzr"})["k"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/points.xyzr"})["k"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/points.xyzr"})["rho"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/points.xyzr", "--probe", "1"})["k"].number, 1.0);
  EXPECT_EQ(run_json({"model", "good/points.xyzr", "--probe", "1"})["rho"].number, 1.0);
  const Json same = run_json({"model", "good/same.xyzr"});
  EXPECT_EQ(same["rho"].kind, Json::Kind::number);
  EXPECT_EQ(same["rho"].number, 0.0);
}

// Weights may carry a sum beyond the largest double; JSON has no word for that.
TEST(JsonOutput, SumsThatOverflowAreNull) {
  const Json json = run_json({"measure", "good/water.pdb", "--gradient", "--weights", "good/huge.weights"});
  EXPECT_EQ(json["area"].kind, Json::Kind::number);
  EXPECT_EQ(json["weighted_area"].kind, Json::Kind::null);
  EXPECT_EQ(json["balls"].items[0]["weighted_dr"].kind, Json::Kind::null);
}

int significant_digits(const std::string &number) {
  const std::string mantissa = number.substr(0, number.find_first_of("eE"));
  std::string digits;
  for (const char c : mantissa) {
    if (c >= '0' && c <= '9' && !(digits.empty() && c == '0')) digits.push_back(c);
  }
  return static_cast<int>(digits.size());
}

// The digits tell each double from its neighbours, and there are no more of them than that takes, 15 at least: the
// standard library, which finds the shortest text by other means, needs as many.
TEST(JsonOutput, NumbersAreTheShortestThatReadBack) {
  const Json json = run_json({"measure", "good/water.pdb", "--probe", "1.4", "--per-ball", "--gradient"});
  std::vector<const Json *> numbers = {&json["area"], &json["volume"]};
  for (const Json &ball : json["balls"].items) {
    for (const char *key : {"area", "area_dr", "volume_dr"}) numbers.push_back(&ball[key]);
    for (const char *key : {"area_gradient", "volume_gradient"}) {
      for (const Json &component : ball[key].items) numbers.push_back(&component);
    }
  }
  EXPECT_GE(numbers.size(), 29u);
  int shorter = 0;
  for (const Json *number : numbers) {
    char shortest[40];
    const auto end = std::to_chars(shortest, shortest + sizeof shortest, number->number);
    const int least = significant_digits(std::string(shortest, end.ptr));
    EXPECT_EQ(std::strtod(number->text.c_str(), nullptr), number->number);
    EXPECT_LE(significant_digits(number->text), std::max(least, 15)) << number->text;
    if (least < 17) ++shorter;
  }
  EXPECT_GT(shorter, 5);
  EXPECT_EQ(run_json({"query", "good/three.xyzr", "--point", "0", "0", "0"})["input"]["probe"].text, "0");
  EXPECT_EQ(run_json({"measure", "good/three.xyzr", "--probe", "0.1"})["input"]["probe"].text, "0.1");
}

}  // namespace
