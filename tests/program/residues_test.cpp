// Sums over residues and chains: which atoms belong together, and that nothing is lost or counted twice.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

constexpr double carbon = 4 * std::numbers::pi * 1.70 * 1.70;
constexpr double nitrogen = 4 * std::numbers::pi * 1.55 * 1.55;
constexpr double oxygen = 4 * std::numbers::pi * 1.52 * 1.52;

struct Residue {
  const char *chain;
  const char *name;
  const char *number;  // as JSON writes it, or the text
  const char *insertion;
  int atoms;
  double area;
};

// good/residues.pdb: each residue differs from the one before in one thing only; no two atoms meet.
TEST(Residues, DifferInAnyPartOfTheirLabel) {
  const std::vector<Residue> expected = {
      {"A", "ALA", "1", "", 2, nitrogen + carbon},
      {"A", "ALA", "1", "A", 1, carbon},
      {"A", "GLY", "1", "A", 1, carbon},
      {"B", "ALA", "1", "", 1, carbon},
      {"B", "ALA", "-5", "", 1, carbon},
      {"", "SER", "9999", "", 1, carbon},
      {"", "SER", "0", "", 1, carbon},
      {"A", "HOH", "101", "", 1, oxygen},
      {"A", "HOH", "102", "", 1, oxygen},
      {"B", "HOH", "101", "", 1, oxygen},
      {",", "U\\\"", "A000", "", 1, carbon},
      {",", "L\u00E9", "", "", 1, carbon},
  };
  const Json residues = run_json({"measure", "good/residues.pdb", "--by", "residue"})["residues"];
  ASSERT_EQ(residues.items.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    SCOPED_TRACE(i);
    const Json &residue = residues.items[i];
    EXPECT_EQ(residue["chain"].text, expected[i].chain);
    EXPECT_EQ(residue["name"].text, expected[i].name);
    EXPECT_EQ(residue["number"].text, expected[i].number);
    EXPECT_EQ(residue["insertion"].text, expected[i].insertion);
    EXPECT_EQ(residue["atoms"].number, expected[i].atoms);
    EXPECT_NEAR(residue["area"].number, expected[i].area, 1e-13 * expected[i].area);
  }
  // Whole numbers are numbers, what is none stays a text.
  EXPECT_EQ(residues.items[4]["number"].kind, Json::Kind::number);
  EXPECT_EQ(residues.items[10]["number"].kind, Json::Kind::string);
  EXPECT_EQ(residues.items[11]["number"].kind, Json::Kind::string);
}

// Chains gather their atoms from the whole file, in the order in which they first appear.
TEST(Residues, ChainsAreGatheredFromTheWholeFile) {
  const Json chains = run_json({"measure", "good/residues.pdb", "--by", "chain"})["chains"];
  const std::vector<Residue> expected = {{"A", "", "", "", 6, nitrogen + 3 * carbon + 2 * oxygen},
                                         {"B", "", "", "", 3, 2 * carbon + oxygen},
                                         {"", "", "", "", 2, 2 * carbon},
                                         {",", "", "", "", 2, 2 * carbon}};
  ASSERT_EQ(chains.items.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(chains.items[i]["chain"].text, expected[i].chain);
    EXPECT_EQ(chains.items[i]["atoms"].number, expected[i].atoms);
    EXPECT_NEAR(chains.items[i]["area"].number, expected[i].area, 1e-13 * expected[i].area);
  }
}

// Leading zeros and plain zero are numbers that JSON knows.
TEST(Residues, NumbersWithLeadingZeros) {
  const TemporaryFile file("zeros.pqr",
                           "ATOM 1 CA ALA A 007 0 0 0 0 1\n"
                           "ATOM 2 CA ALA A -02 9 0 0 0 1\n"
                           "ATOM 3 CA ALA A -0 18 0 0 0 1\n"
                           "ATOM 4 CA ALA A 52B 27 0 0 0 1\n"
                           "ATOM 5 CA ALA A B 36 0 0 0 1\n"
                           "ATOM 6 CA ALA LONGCHAIN1 1 45 0 0 0 1\n"
                           "ATOM 7 CA ALA LONGCHAIN2 1 54 0 0 0 1\n");
  const Json residues = run_json({"measure", file.path(), "--by", "residue"})["residues"];
  const std::vector<std::string> numbers = {"7", "-2", "0", "52", "B", "1", "1"};
  ASSERT_EQ(residues.items.size(), numbers.size());
  for (size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(residues.items[i]["number"].text, numbers[i]);
  EXPECT_EQ(residues.items[3]["insertion"].text, "B");
  EXPECT_EQ(run_json({"measure", file.path(), "--by", "chain"})["chains"].items.size(), 3u);
}

// A .mol2 file with an atom for each pair of a number and a name of a residue.
std::string mol2_of(const std::vector<std::pair<std::string, std::string>> &residues) {
  std::string out = "@<TRIPOS>MOLECULE\nm\n" + std::to_string(residues.size()) + "\n@<TRIPOS>ATOM\n";
  int atom = 0;
  for (const auto &[number, name] : residues) {
    ++atom;
    out += std::to_string(atom) + " C " + std::to_string(9 * atom) + " 0 1 C.3 " + number + " " + name + "\n";
  }
  return out;
}

// Names of residues in .mol2 files end in their numbers, with an insertion code or without, or in digits of their own.
TEST(Residues, OfNamesInMol2) {
  struct Case {
    std::string number, name;  // in the file
    std::string of, is, code;  // name, number, insertion code
  };
  const std::vector<Case> cases = {
      // the number before the name, and digits before it
      {"301", "SO4301", "SO4", "301", ""},
      {"1", "PO41", "PO4", "1", ""},
      {"12", "TIP312", "TIP3", "12", ""},
      {"301", "G6P301", "G6P", "301", ""},
      {"301", "017301", "017", "301", ""},
      {"23", "ALA23", "ALA", "23", ""},
      // known names
      {"101", "TP3", "TP3", "101", ""},
      {"102", "TP3", "TP3", "102", ""},
      {"3", "TP3", "TP3", "3", ""},
      {"2", "NH2", "NH2", "2", ""},
      {"4", "DC4", "DC", "4", ""},
      {"5", "DC5", "DC", "5", ""},
      {"103", "TIP3", "TIP3", "103", ""},
      {"104", "tip3", "tip3", "104", ""},
      {"6", "DC5", "DC5", "6", ""},
      {"7", "RA3", "RA3", "7", ""},
      {"8", "H2O", "H2O", "8", ""},
      // a number of the file's own; that before the name counts residues
      {"1", "ALA23", "ALA", "23", ""},
      {"1", "ALA21", "ALA", "21", ""},
      {"7", "ALA007", "ALA", "7", ""},
      {"1", "H2O5", "H2O", "5", ""},
      {"****", "ALA9", "ALA", "9", ""},
      {"1", "ALA-5", "ALA", "-5", ""},
      {"6", "ALA-6", "ALA", "-6", ""},
      {"-7", "ALA-7", "ALA", "-7", ""},
      {"2", "ALA-22", "ALA", "-22", ""},
      {"1", "GLY52A", "GLY", "52", "A"},
      {"52", "GLY52B", "GLY", "52", "B"},
      {"1", "GLY-3C", "GLY", "-3", "C"},
      {"1", "G52A", "G", "52", "A"},
      // whole names
      {"7", "ALA", "ALA", "7", ""},
      {"-8", "ALA", "ALA", "-8", ""},
      {"3", "G6P", "G6P", "3", ""},
      {"3", "1B2C", "1B2C", "3", ""},
      {"12", "12", "12", "12", ""},
      {"2", "12", "12", "2", ""},
      {"5", "-5", "-5", "5", ""},
      {"8", "****", "****", "8", ""},
      {"****", "LIG", "LIG", "****", ""},
      {"1", "<0>", "", "", ""},
      // more digits than a number has room for
      {"1", "LIG123456789012", "LIG123456789012", "1", ""},
      {"1", "LIG123456789013", "LIG123456789013", "1", ""},
      {"7", "LIG1234567890", "LIG", "1234567890", ""},
  };
  std::vector<std::pair<std::string, std::string>> residues;
  for (const Case &one : cases) residues.emplace_back(one.number, one.name);
  const TemporaryFile file("names.mol2", mol2_of(residues));
  const Json found = run_json({"measure", file.path(), "--by", "residue"})["residues"];
  ASSERT_EQ(found.items.size(), cases.size());
  for (size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(cases[i].number + " " + cases[i].name);
    EXPECT_EQ(found.items[i]["name"].text, cases[i].of);
    EXPECT_EQ(found.items[i]["number"].text, cases[i].is);
    EXPECT_EQ(found.items[i]["insertion"].text, cases[i].code);
  }
  // Selections find them so.
  const TemporaryFile few("few.mol2", mol2_of({{"101", "TP3"}, {"301", "SO4301"}, {"1", "ALA-5"}, {"2", "GLY52A"}}));
  const std::vector<std::pair<std::vector<std::string>, std::string>> selections = {
      {{"--no-water"}, "SO4 ALA GLY "}, {{"--only", "residue:-5"}, "ALA "}, {{"--only", "residue:52A"}, "GLY "}};
  for (const auto &[options, names] : selections) {
    std::vector<std::string> arguments = {"measure", few.path(), "--by", "residue"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::string left;
    const Json json = run_json(arguments);
    for (const Json &residue : json["residues"].items) left += residue["name"].text + " ";
    EXPECT_EQ(left, names);
  }
}

// Two in a row may have one name and one number, where .mol2 has another number before it, or mmCIF another
// label_asym_id.
TEST(Residues, OfTheSameNameInARow) {
  const auto atoms_of = [](const std::string &extension, const std::string &text) {
    const TemporaryFile file("row." + extension, text);
    std::vector<double> atoms;
    for (const Json &residue : run_json({"measure", file.path(), "--by", "residue"})["residues"].items)
      atoms.push_back(residue["atoms"].number);
    return atoms;
  };
  const std::vector<double> two = {2, 1}, one = {3};
  EXPECT_EQ(atoms_of("mol2", mol2_of({{"1", "LIG7"}, {"1", "LIG7"}, {"2", "LIG7"}})), two);
  EXPECT_EQ(atoms_of("mol2", mol2_of({{"1", "LIG7"}, {"1", "LIG7"}, {"1", "LIG7"}})), one);
  EXPECT_EQ(atoms_of("mol2", mol2_of({{"-1", "LIG7"}, {"-1", "LIG7"}, {"-1", "LIG7"}})), one);
  const std::string head =
      "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
      "_atom_site.auth_asym_id\n_atom_site.label_asym_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  EXPECT_EQ(atoms_of("cif", head + "C C1 LIG A B 0 0 0\nC C2 LIG A B 9 0 0\nC C1 LIG A C 19 0 0\n"), two);
  EXPECT_EQ(atoms_of("cif", head + "C C1 LIG A B 0 0 0\nC C2 LIG A B 9 0 0\nC C1 LIG A B 19 0 0\n"), one);
}

// Crambin has 46 residues, numbers 10A and 10B among them, but no 11. Their sums are those of the balls that the CSV
// puts into them.
TEST(Residues, SumUpToTheBallsOfCrambin) {
  const std::string file = molecules_folder() + "/crambin.pdb";
  for (const char *probe : {"0", "1.4"}) {
    const Json json = run_json({"measure", file, "--by", "residue", "--per-ball", "--probe", probe});
    const std::vector<Json> &residues = json["residues"].items;
    ASSERT_EQ(residues.size(), 46u);
    EXPECT_EQ(residues.front()["name"].text, "THR");
    EXPECT_EQ(residues.back()["name"].text, "ASN");
    size_t ball = 0;
    double total = 0;
    for (size_t i = 0; i < residues.size(); ++i) {
      EXPECT_EQ(residues[i]["number"].number, i == 10 ? 10 : static_cast<double>(i + 1));
      EXPECT_EQ(residues[i]["insertion"].text, i == 9 ? "A" : i == 10 ? "B" : "");
      double sum = 0;
      for (int atom = 0; atom < residues[i]["atoms"].number; ++atom) {
        sum += json["balls"].items.at(ball++)["area"].number;
      }
      EXPECT_EQ(residues[i]["area"].number, sum);
      total += sum;
    }
    EXPECT_EQ(ball, 327u);
    EXPECT_NEAR(total, json["area"].number, 1e-12 * total);
    const Json chain = run_json({"measure", file, "--by", "chain", "--probe", probe})["chains"].items.at(0);
    EXPECT_EQ(chain["chain"].text, "A");
    EXPECT_EQ(chain["atoms"].number, 327);
    EXPECT_NEAR(chain["area"].number, total, 1e-12 * total);
  }
}

// Many chains, in an order that mixes them.
TEST(Residues, ManyChains) {
  std::string text;
  std::map<std::string, int> atoms;
  for (int i = 0; i < 3000; ++i) {
    std::string chain(1, 'c');
    chain += std::to_string(i * 7919 % 997);
    ++atoms[chain];
    text += "ATOM " + std::to_string(i) + " O HOH " + chain + " 1 " + std::to_string(3 * i) + " 0 0 0 1\n";
  }
  const TemporaryFile file("chains.pqr", text);
  const Json chains = run_json({"measure", file.path(), "--by", "chain"})["chains"];
  ASSERT_EQ(chains.items.size(), atoms.size());
  EXPECT_EQ(chains.items[0]["chain"].text, "c0");
  for (const Json &chain : chains.items) {
    const int count = atoms[chain["chain"].text];
    EXPECT_EQ(chain["atoms"].number, count);
    EXPECT_NEAR(chain["area"].number, 4 * std::numbers::pi * count, 1e-9);
  }
}

// ---- what tells residues and chains apart beside their names ----

// "HOH A  1" and the like of each residue, and of each chain its name.
std::vector<std::string> names(const std::string &file, const std::string &by) {
  std::vector<std::string> all;
  const Json json = run_json({"measure", file, "--by", by});
  for (const Json &group : json[by + "s"].items) {
    all.push_back(by == "chain" ? group["chain"].text
                                : group["name"].text + " " + group["chain"].text + " " + group["number"].text + " " +
                                      std::to_string(static_cast<int>(group["atoms"].number)));
  }
  return all;
}

using Names = std::vector<std::string>;

// Records with these columns 13 to 27, each far from the others; elements as they are given.
std::string records(const std::vector<std::string> &columns) {
  std::string text;
  int x = 0;
  for (const std::string &it : columns) {
    char line[96];
    if (it == "TER") {
      text += "TER\n";
      continue;
    }
    std::snprintf(line, sizeof line, "ATOM      1 %-15s   %8.3f%8.3f%8.3f  1.00  0.00           %c\n", it.c_str(),
                  20.0 * x++, 0.0, 0.0, it[1]);
    text += line;
  }
  return text;
}

// Column 21 is the fourth letter of a residue or the first one of a chain, by what the file shows.
TEST(Residues, ColumnTwentyOne) {
  struct Case {
    std::vector<std::string> columns;
    Names residues, chains;
  };
  const std::vector<Case> cases = {
      // Chains of two letters beside those of one, known residues and others, a nucleotide.
      {{" CA  GLYAA   1", " CA  GLYBA   1", " CA  GLY A   1", " C1  LIGBA   9", " C1    GAB   2", " C1   DAAC   3"},
       {"GLY AA 1 1", "GLY BA 1 1", "GLY A 1 1", "LIG BA 9 1", "G AB 2 1", "DA AC 3 1"},
       {"AA", "BA", "A", "AB", "AC"}},
      // The same where a ligand comes first, and where its name would be that of a lipid.
      {{" C1  LIGBA   9", " C1  POPCA   8", " CA  GLYAA   1", " CA  GLYBA   1", " CA  ALABA   2"},
       {"LIG BA 9 1", "POP CA 8 1", "GLY AA 1 1", "GLY BA 1 1", "ALA BA 2 1"},
       {"BA", "CA", "AA"}},
      // Residues of four letters, with chains and without, one of which begins as an amino acid does.
      {{" C1  POPC    1", " C1  POPEM   2", " C1  TIP3W   3", " C1  HSPPA   4", " C1  LIGX    5", " C1  LIGYB   6"},
       {"POPC  1 1", "POPE M 2 1", "TIP3 W 3 1", "HSPP A 4 1", "LIGX  5 1", "LIGY B 6 1"},
       {"", "M", "W", "A", "B"}},
      {{" N   LYSH    1", " N   HISBA   2", " N   NALAA   3"}, {"LYSH  1 1", "HISB A 2 1", "NALA A 3 1"}, {"", "A"}},
      // Nothing but what both would do for: the fourth letter.
      {{" C1  LIGXA   1"}, {"LIGX A 1 1"}, {"A"}},
  };
  for (const Case &one : cases) {
    const TemporaryFile file("column.pdb", records(one.columns));
    EXPECT_EQ(names(file.path(), "residue"), one.residues) << one.columns[0];
    EXPECT_EQ(names(file.path(), "chain"), one.chains) << one.columns[0];
  }
  // Two locations of one atom stay one residue, and those of two chains stay apart.
  const TemporaryFile locations("column.pdb", records({" CA AGLYAA   1", " CA BGLYAA   1", " CA AGLYBA   1",
                                                       " CA BGLYBA   1", " CA AHEMBA   9", " CA AHEMCA   9"}));
  EXPECT_EQ(names(locations.path(), "residue"), Names({"GLY AA 1 1", "GLY BA 1 1", "HEM BA 9 1", "HEM CA 9 1"}));
  const TemporaryFile lipids("column.pdb", records({" P   POPC    1", " P   POPE    2", " P   POPE    3"}));
  EXPECT_EQ(run_json({"measure", lipids.path(), "--only", "residue:POPE"})["n"].number, 2);
}

// TER ends a chain that has no name, and so a residue; water and ions go on with water and ions.
TEST(Residues, ChainsByTer) {
  const TemporaryFile file(
      "ter.pdb", records({" CA  GLY     1", " CB  GLY     1", "TER", " CA  GLY     1", "TER", "TER", " CA  GLY A   1",
                          "TER", " CA  GLY A   1", " O   WAT     7", "TER", " O   WAT     8", "TER", " K   K       9",
                          "TER", " K   K      10", "TER", " C1  LIG     9"}));
  EXPECT_EQ(names(file.path(), "residue"), Names({"GLY  1 2", "GLY .2 1 1", "GLY A 1 2", "WAT .3 7 1", "WAT .3 8 1",
                                                  "K .3 9 1", "K .3 10 1", "LIG .4 9 1"}));
  EXPECT_EQ(names(file.path(), "chain"), Names({"", ".2", "A", ".3", ".4"}));
  const auto count = [&](const char *selection) {
    return run_json({"measure", file.path(), "--only", selection})["n"].number;
  };
  EXPECT_EQ(count("chain:."), 8);
  EXPECT_EQ(count("chain:.1"), 2);
  EXPECT_EQ(count("chain:.2"), 1);
  EXPECT_EQ(run_program({"measure", file.path(), "--interface", ".1,.2+.4"}).status, 0);
  const TemporaryFile pqr("ter.pqr", "ATOM 1 CA GLY 1 0 0 0 0 1\nTER\nATOM 2 CA GLY 1 9 0 0 0 1\n");
  EXPECT_EQ(names(pqr.path(), "residue"), Names({"GLY  1 1", "GLY .2 1 1"}));
  // Segments are names.
  const std::string segment = records({" CA  GLY     1"});
  const std::string named = segment.substr(0, 72) + "PROA" + segment.substr(76);
  const TemporaryFile segments("segments.pdb", named + "TER\n" + std::string(named).replace(30, 8, "   9.000"));
  EXPECT_EQ(names(segments.path(), "residue"), Names({"GLY PROA 1 2"}));
}

// Where numbers are stars or missing, an atom's name that comes again begins a residue.
TEST(Residues, NamesThatComeAgain) {
  struct Case {
    std::vector<std::string> columns;
    Names residues;
  };
  const std::vector<Case> cases = {
      {{" O   HOH W****", " H1  HOH W****", " H2  HOH W****", " O   HOH W****", " H1  HOH W****", " H2  HOH W****"},
       {"HOH W **** 3", "HOH W **** 3"}},
      {{" O   HOH W", " H   HOH W", " H   HOH W", " O   HOH W", " H   HOH W", " H   HOH W", " O   HOH W"},
       {"HOH W  3", "HOH W  3", "HOH W  1"}},
      {{" O   HOH W", " H   HOH W", " H   HOH W", " H   HOH W", " O   HOH W"}, {"HOH W  4", "HOH W  1"}},
      {{" N   GLY", " CA  GLY", " C   GLY", " CA  GLY", " C   GLY"}, {"GLY   3", "GLY   2"}},
      {{" C1  LIP  ****", " C2  LIP  ****", " C1  LIP  ****"}, {"LIP  **** 2", "LIP  **** 1"}},
      {{" K   K", " K   K"}, {"K   1", "K   1"}},
      // Names that may be mere elements, and residues with numbers.
      {{" C   LIG", " C   LIG", " O   LIG", " C   LIG"}, {"LIG   4"}},
      {{" C   UNK", " C   UNK", " O   UNK", " C   UNK"}, {"UNK   4"}},
      {{" C1  GLY A   1", " C1  GLY A   1"}, {"GLY A 1 2"}}};
  for (const Case &one : cases) {
    const TemporaryFile file("again.pdb", records(one.columns));
    EXPECT_EQ(names(file.path(), "residue"), one.residues) << one.columns[0];
  }
  const TemporaryFile stars("stars.pdb", records(cases[0].columns));
  EXPECT_EQ(run_json({"measure", stars.path()})["input"]["waters"].number, 2);
  const TemporaryFile cif("waters.cif",
                          "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
                          "_atom_site.label_asym_id\n_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                          "_atom_site.Cartn_z\nO O HOH C . 0 0 0\nO O HOH C . 9 0 0\nO O HOH C . 18 0 0\n"
                          "Na NA NA D . 27 0 0\nNa NA NA D . 36 0 0\n");
  EXPECT_EQ(names(cif.path(), "residue").size(), 5u);
  EXPECT_EQ(run_json({"measure", cif.path()})["input"]["waters"].number, 3);
}

// Selenium in place of sulfur makes no other residue of methionine.
TEST(Residues, SelenomethionineIsAsLargeAsMethionine) {
  const TemporaryFile file("mse.pdb", records({" CA  MET A   1", " CA  MSE A   2"}));
  const Json residues =
      run_json({"measure", file.path(), "--by", "residue", "--relative", "--probe", "1.4"})["residues"];
  ASSERT_EQ(residues.items.size(), 2u);
  EXPECT_GT(residues.items[0]["relative"].number, 0);
  EXPECT_EQ(residues.items[0]["relative"].number, residues.items[1]["relative"].number);
}

}  // namespace
