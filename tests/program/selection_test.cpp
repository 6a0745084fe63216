// Which atoms become balls: models, selections, and what the program says it left out. The atoms of residues.pdb lie 10
// angstrom apart along x, which tells them from each other.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Numbers = std::vector<int>;

// The atoms read from residues.pdb, by their place in the file.
Numbers taken(const std::vector<std::string> &options) {
  std::vector<std::string> arguments = {"measure", "good/residues.pdb", "--csv"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  Numbers numbers;
  while (std::getline(lines, line)) {
    // x, y, z, radius and area stand at the end.
    size_t at = line.size();
    for (int comma = 0; comma < 5; ++comma) at = line.rfind(',', at - 1);
    numbers.push_back(static_cast<int>(std::stod(line.substr(at + 1)) / 10 + 0.5));
  }
  return numbers;
}

TEST(Selection, ByOneProperty) {
  EXPECT_EQ(taken({"--only", "chain:A"}), (Numbers{0, 1, 2, 3, 8, 9}));
  EXPECT_EQ(taken({"--only=chain:B,A"}), (Numbers{0, 1, 2, 3, 4, 5, 8, 9, 10}));
  EXPECT_EQ(taken({"--only", "chain:."}), (Numbers{6, 7}));
  EXPECT_EQ(taken({"--only", "residue:ala"}), (Numbers{0, 1, 2, 4, 5}));
  EXPECT_EQ(taken({"--only", "residue:1"}), (Numbers{0, 1, 2, 3, 4}));
  EXPECT_EQ(taken({"--only", "residue:1A"}), (Numbers{2, 3}));
  EXPECT_EQ(taken({"--only", "residue:-5-0,102"}), (Numbers{5, 7, 9}));
  EXPECT_EQ(taken({"--only", "residue:-9--5"}), (Numbers{5}));
  EXPECT_EQ(taken({"--only", "residue:A000"}), (Numbers{11}));
  EXPECT_EQ(taken({"--only", "element:O,N"}), (Numbers{0, 8, 9, 10}));
  EXPECT_EQ(taken({"--only", "atom:ca"}), (Numbers{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(taken({"--only", "water"}), (Numbers{8, 9, 10}));
  EXPECT_EQ(taken({"--only", "hetatm"}), (Numbers{8, 9, 10, 11, 12}));
}

// Ends of a range may have insertion codes: then residues count by their numbers, and those of one number by their
// codes, none before A. An end without one has all codes of its number.
TEST(Selection, RangesWithInsertionCodes) {
  std::string text;
  int x = 0;
  for (const char *number :
       {"  51 ", "  52 ", "  52A", "  52B", "  52C", "  53 ", "  53A", "  54 ", "  -5 ", "  -5A"}) {
    char line[96];
    std::snprintf(line, sizeof line, "ATOM      1  CA  GLY A%s   %8.3f%8.3f%8.3f  1.00  0.00           C\n", number,
                  10.0 * x++, 0.0, 0.0);
    text += line;
  }
  const TemporaryFile file("codes.pdb", text);
  const auto range = [&](const std::string &item) {
    const Json json = run_json({"measure", file.path(), "--per-ball", "--only", "residue:" + item});
    Numbers numbers;
    for (const Json &ball : json["balls"].items) {
      numbers.push_back(static_cast<int>(ball["xyz"].items[0].number / 10 + 0.5));
    }
    return numbers;
  };
  EXPECT_EQ(range("52A-53"), (Numbers{2, 3, 4, 5, 6}));
  EXPECT_EQ(range("52-53"), (Numbers{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(range("52-52B"), (Numbers{1, 2, 3}));
  EXPECT_EQ(range("52b-52C"), (Numbers{3, 4}));
  EXPECT_EQ(range("52C-53A"), (Numbers{4, 5, 6}));
  EXPECT_EQ(range("51-52A"), (Numbers{0, 1, 2}));
  EXPECT_EQ(range("-5A-51"), (Numbers{0, 9}));
  EXPECT_EQ(range("52A"), (Numbers{2}));
  // The codes of a range are of no other item.
  EXPECT_EQ(range("52B-53,51"), (Numbers{0, 3, 4, 5, 6}));
  EXPECT_EQ(range("51-52A,52"), (Numbers{0, 1, 2, 3, 4}));
  for (const char *item : {"53-52A", "52C-52A", "54A-53"}) {
    const Outcome outcome = run_program({"measure", file.path(), "--only", std::string("residue:") + item});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, std::string("hardsphere: --only: the range '") + item + "' is empty\n");
  }
}

TEST(Selection, BySeveral) {
  EXPECT_EQ(taken({"--only", "chain:A&residue:ALA&atom:N,CA"}), (Numbers{0, 1, 2}));
  EXPECT_EQ(taken({"--only", "chain:B", "--only", "residue:SER"}), (Numbers{4, 5, 6, 7, 10}));
  EXPECT_EQ(taken({"--hide", "chain:A", "--hide", "water"}), (Numbers{4, 5, 6, 7, 11, 12}));
  EXPECT_EQ(taken({"--only", "chain:A", "--hide", "residue:1"}), (Numbers{8, 9}));
  EXPECT_EQ(taken({"--hide", "residue:1", "--only", "chain:A"}), (Numbers{8, 9}));
  EXPECT_EQ(taken({"--no-hetatm", "--hide=element:N"}), (Numbers{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(taken({"--no-water"}), (Numbers{0, 1, 2, 3, 4, 5, 6, 7, 11, 12}));
}

// The warning about names that nothing has; the status stays 0, and stdout what it is without them.
std::string note(const std::vector<std::string> &options) {
  std::vector<std::string> arguments = {"model", "good/residues.pdb"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.err;
}

TEST(Selection, NamesThatNothingHas) {
  const std::string begin = "hardsphere: good/residues.pdb: nothing matches ";
  EXPECT_EQ(note({"--only", "chain:A,Z"}), begin + "--only chain:Z\n");
  EXPECT_EQ(note({"--hide", "chain:Z", "--hide", "residue:900-950,ALA"}),
            begin + "--hide chain:Z, --hide residue:900-950\n");
  EXPECT_EQ(note({"--hide=element:Xe", "--radius", "Xe=2,C=1.5,Fe=1"}),
            begin + "--hide element:Xe, --radius Xe, --radius Fe\n");
  EXPECT_EQ(note({"--only", "chain:A", "--hide", "chain:B&residue:1A"}), begin + "--hide chain:B&residue:1A\n");
  EXPECT_EQ(note({"--only", "chain:A", "--hide", "chain:B"}), "");
  EXPECT_EQ(note({"--no-water", "--radius", "O=1.5"}), "");
  EXPECT_EQ(note({"--only", "chain:A&residue:1", "--hide", "hydrogen"}), "");
  const Outcome nothing = run_program({"model", "good/residues.pdb", "--only", "chain:Z"});
  EXPECT_EQ(nothing.status, 1);
  EXPECT_EQ(nothing.err, "hardsphere: good/residues.pdb: no atoms are left: all 13 are left out by the selection\n");
  const Outcome picture = run_program({"draw", "good/residues.pdb", "-o", "-", "--only", "chain:A", "--highlight",
                                       "chain:B", "--highlight", "chain:A"});
  EXPECT_EQ(picture.status, 0);
  EXPECT_EQ(picture.err, begin + "--highlight chain:B\n");
  EXPECT_EQ(run_program({"clash", "good/water.pdb", "good/residues.pdb", "--hide", "chain:B"}).err,
            "hardsphere: good/water.pdb: nothing matches --hide chain:B\n");
}

// A table of comma-separated values has no heading to tell of water.
TEST(Selection, WaterInCommaSeparatedValues) {
  const std::string line = "hardsphere: good/residues.pdb: 3 waters are counted; --no-water leaves them out\n";
  EXPECT_EQ(run_program({"measure", "good/residues.pdb", "--csv"}).err, line);
  EXPECT_EQ(run_program({"measure", "good/residues.pdb", "--csv", "--by", "chain"}).err, line);
  EXPECT_EQ(run_program({"measure", "good/residues.pdb", "--csv", "--no-water"}).err, "");
  EXPECT_EQ(run_program({"measure", "good/water.pdb", "--csv"}).err, "");
  EXPECT_EQ(run_program({"measure", "good/residues.pdb"}).err, "");
  EXPECT_EQ(run_program({"measure", "good/residues.pdb", "good/two.xyzr", "--csv"}).err.rfind(line, 0), 0U);
}

TEST(Selection, Hydrogens) {
  EXPECT_EQ(run_json({"measure", "good/water.pdb", "--no-hydrogens"})["n"].number, 1);
  EXPECT_EQ(run_json({"measure", "good/water.xyz", "--no-hydrogens"})["n"].number, 1);
  EXPECT_EQ(run_json({"measure", "good/water.xyz", "--only", "element:h"})["n"].number, 2);
  EXPECT_EQ(run_json({"measure", "good/water_deuterium.pdb", "--only", "hydrogen"})["n"].number, 2);
}

// Atoms that are left out take no area from those that are read: carbon alone has its whole sphere.
TEST(Selection, WhatIsLeftOutBlocksNothing) {
  const double pi = 3.141592653589793;
  const TemporaryFile file("pair.xyz", "2\n\nC 0 0 0\nO 1 0 0\n");
  EXPECT_LT(run_json({"measure", file.path(), "--per-ball"})["balls"].items.at(0)["area"].number, 30);
  EXPECT_NEAR(run_json({"measure", file.path(), "--only", "element:C"})["area"].number, 4 * pi * 1.7 * 1.7, 1e-11);
}

// An element without a radius may be left out.
TEST(Selection, ComesBeforeRadii) {
  const TemporaryFile file("unknown.xyz", "2\n\nC 0 0 0\nXx 1 0 0\n");
  EXPECT_EQ(run_program({"measure", file.path()}).status, 1);
  EXPECT_EQ(run_json({"measure", file.path(), "--hide", "element:Xx"})["n"].number, 1);
}

void expect_left_out(const std::vector<std::string> &arguments, const std::vector<double> &expected) {
  const Json left_out = run_json(arguments)["input"]["left_out"];
  const std::vector<std::string> keys = {
      "other_models", "alternate_locations", "virtual_sites", "water", "hetatm", "hydrogen", "others"};
  for (size_t i = 0; i < keys.size(); ++i) EXPECT_EQ(left_out[keys[i]].number, expected[i]) << keys[i];
}

TEST(Selection, SaysWhatIsLeftOut) {
  expect_left_out({"measure", "good/residues.pdb"}, {0, 0, 0, 0, 0, 0, 0});
  expect_left_out({"measure", "good/residues.pdb", "--only", "residue:GLY"}, {0, 0, 0, 3, 2, 0, 7});
  expect_left_out({"measure", "good/water.xyz", "--no-hydrogens"}, {0, 0, 0, 0, 0, 2, 0});
  expect_left_out({"measure", "good/water_alternates.pdb"}, {0, 2, 0, 0, 0, 0, 0});
  expect_left_out({"measure", "good/water_two_models.pdb"}, {2, 0, 0, 0, 0, 0, 0});
  expect_left_out({"measure", "good/water_two_models.pqr", "--model", "1"}, {1, 0, 0, 0, 0, 0, 0});
  expect_left_out({"measure", "good/water_two_models.xyz"}, {2, 0, 0, 0, 0, 0, 0});
}

TEST(Selection, SaysWhatIsAmongTheBalls) {
  const Json input = run_json({"measure", "good/residues.pdb"})["input"];
  EXPECT_EQ(input["balls"].number, 13);
  EXPECT_EQ(input["waters"].number, 3);
  EXPECT_EQ(input["water_atoms"].number, 3);
  EXPECT_EQ(input["hetatm"].number, 2);
  EXPECT_EQ(input["hydrogens"].number, 0);
  const Json water = run_json({"measure", "good/water.pdb"})["input"];
  EXPECT_EQ(water["waters"].number, 1);
  EXPECT_EQ(water["water_atoms"].number, 3);
  EXPECT_EQ(water["hetatm"].number, 0);
  EXPECT_EQ(water["hydrogens"].number, 2);
}

// A model, in a file of so many, has this many atoms.
void expect_models(const std::string &text, const std::string &name, const std::vector<double> &atoms) {
  const TemporaryFile file(name, text);
  double all = 0;
  for (const double count : atoms) all += count;
  for (size_t i = 0; i < atoms.size(); ++i) {
    const std::string model = std::to_string(i + 1);
    if (atoms[i] == 0) {
      EXPECT_EQ(run_program({"model", file.path(), "--model", model}).err,
                "hardsphere: " + file.path() + ": no atoms in model " + model + "\n");
      continue;
    }
    const Json json = run_json({"model", file.path(), "--model", model});
    EXPECT_EQ(json["n"].number, atoms[i]) << text;
    EXPECT_EQ(json["input"]["model"].number, static_cast<double>(i + 1)) << text;
    EXPECT_EQ(json["input"]["models"].number, static_cast<double>(atoms.size())) << text;
    EXPECT_EQ(json["input"]["left_out"]["other_models"].number, all - atoms[i]) << text;
  }
  const std::string beyond = std::to_string(atoms.size() + 1);
  EXPECT_EQ(
      run_program({"model", file.path(), "--model=" + beyond}).err,
      "hardsphere: " + file.path() + ": no model " + beyond + ": the file has " + std::to_string(atoms.size()) + "\n");
}

const std::string atom = "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  0.00           C  \n";

TEST(Models, OfPdbFiles) {
  const std::string m1 = "MODEL        1\n", m2 = "MODEL        2\n", endmdl = "ENDMDL\n", end = "END\n";
  const std::string next = atom.substr(0, 30) + "   9.000" + atom.substr(38);
  expect_models(atom + next, "m.pdb", {2});
  expect_models(m1 + atom + endmdl + m2 + atom + next + endmdl + end, "m.pdb", {1, 2});
  expect_models(m1 + atom + m2 + atom + next + next, "m.pdb", {1, 3});
  expect_models(m1 + endmdl + m2 + atom + end, "m.pdb", {0, 1});
  // Frames of a trajectory, each with its END; and atoms behind ENDMDL, which belong to no model that has a name.
  expect_models("REMARK\n" + atom + end + atom + next + end + end + atom + end, "m.pdb", {1, 2, 1});
  expect_models(atom + next + endmdl + atom + end, "m.pdb", {2, 1});
}

TEST(Models, OfXyzFiles) {
  expect_models("1\nfirst\nC 0 0 0\n2\n\nC 0 0 0\nC 9 0 0\n\n", "m.xyz", {1, 2});
  expect_models("1\nfirst\nC 0 0 0\n0\nnothing\n1\n\nO 0 0 0\n", "m.xyz", {1, 0, 1});
}

// A later model may break off; one that comes before may not, and no more may the model itself.
TEST(Models, ThatBreakOff) {
  const TemporaryFile file("broken.xyz", "1\n\nC 0 0 0\n2\n\nC 0 0 0\n");
  EXPECT_EQ(run_json({"model", file.path()})["input"]["models"].number, 2);
  EXPECT_EQ(run_program({"model", file.path(), "--model", "2"}).err,
            "hardsphere: " + file.path() + ":4: 2 atoms announced, the file ends after 1\n");
  const TemporaryFile words("words.xyz", "1\n\nC 0 0 0\n2\n\nC 0 0 0\nC 1 1 1\nand more\n");
  EXPECT_EQ(run_program({"model", words.path()}).err,
            "hardsphere: " + words.path() + ":8: data after the last atom (2 announced)\n");
}

// The file that is written again holds what was read.
TEST(Models, ArePdbOutputs) {
  const std::string other = "ATOM      1  CB  ALA A   1      50.000   0.000   0.000  1.00  0.00           C  \n";
  const std::string area = "  1.00 36.32           C  \n";
  const TemporaryFile file("two.pdb", "HEADER\nMODEL        1\n" + atom + "TER\nENDMDL\nMODEL        2\n" + other +
                                          "TER\nENDMDL\nCONECT    1\nEND\n");
  const TemporaryFile out("out.pdb");
  EXPECT_EQ(run_program({"measure", file.path(), "--pdb-out", out.path(), "--model", "2"}).status, 0);
  EXPECT_EQ(read_file(out.path()),
            "HEADER\nMODEL        2\n" + other.substr(0, 54) + area + "TER\nENDMDL\nCONECT    1\nEND\n");
  const TemporaryFile frames("frames.pdb", "HEADER\n" + atom + "END\n" + other + "TER\nEND\n" + atom + "END\n");
  EXPECT_EQ(run_program({"measure", frames.path(), "--pdb-out", out.path(), "--model", "2"}).status, 0);
  EXPECT_EQ(read_file(out.path()), "HEADER\n" + other.substr(0, 54) + area + "TER\nEND\n");
  const TemporaryFile pair("pair.pdb", atom + "ANISOU\n" + other);
  EXPECT_EQ(run_program({"measure", pair.path(), "--pdb-out", out.path(), "--hide", "atom:CA"}).status, 0);
  EXPECT_EQ(read_file(out.path()), other.substr(0, 54) + area);
}

// draw leaves out water, unless it is asked for or there is nothing else.
TEST(Selection, WaterInPictures) {
  const TemporaryFile out("water.svg");
  const auto drawn = [&](const std::string &file, const std::vector<std::string> &options) {
    std::vector<std::string> arguments = {"draw", file, "-o", out.path()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_json(arguments)["n"].number;
  };
  EXPECT_EQ(drawn("good/residues.pdb", {}), 10);
  EXPECT_EQ(drawn("good/residues.pdb", {"--water"}), 13);
  EXPECT_EQ(drawn("good/residues.pdb", {"--no-hetatm", "--water"}), 8);
  EXPECT_EQ(drawn("good/residues.pdb", {"--only", "chain:A"}), 4);
  EXPECT_EQ(drawn("good/residues.pdb", {"--only", "water"}), 3);
  EXPECT_EQ(drawn("good/water.pdb", {}), 3);
  EXPECT_EQ(run_json({"draw", "good/residues.pdb", "-o", out.path()})["input"]["left_out"]["water"].number, 3);
}

}  // namespace
