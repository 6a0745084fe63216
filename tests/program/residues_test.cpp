// Sums over residues and chains: which atoms belong together, and that nothing is lost or counted twice.
#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <string>
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
      {",", "L\uFFFD\uFFFD", "", "", 1, carbon},
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

}  // namespace
