// Groups of atoms, as --between and --interface name them: sums over all pairs, areas from three measures, forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "molecule_file.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

// Four chains of a few atoms, of which B has a ligand.
std::string chains() {
  std::string text;
  const char *const names[] = {" N  ", " CA ", " C  ", " O  "};
  char line[120];
  int serial = 0;
  for (int chain = 0; chain < 4; ++chain) {
    for (int k = 0; k < 12; ++k) {
      const double x = 1.3 * (k % 4) + 2.9 * (chain % 2), y = 1.4 * (k / 4 % 3) + 3.1 * (chain / 2),
                   z = 0.7 * (k % 3) + 0.2 * chain;
      const bool ligand = chain == 1 && k >= 8;
      std::snprintf(line, sizeof line, "%-6s%5d %s%4s %c%4d    %8.3f%8.3f%8.3f  1.00  0.00           %c\n",
                    ligand ? "HETATM" : "ATOM", ++serial, names[k % 4], ligand ? "HEM" : "GLY", 'A' + chain, k / 4 + 1,
                    x, y, z, names[k % 4][1]);
      text += line;
    }
  }
  return text;
}

Json between(const std::string &path, const std::string &groups, const Words &more = {}) {
  Words words = {"contacts", path, "--between", groups};
  words.insert(words.end(), more.begin(), more.end());
  return run_json(words);
}

double sum_of(const Json &rows, const char *key) {
  double sum = 0;
  for (const Json &row : rows.items) sum += row[key].number;
  return sum;
}

// Within and between groups that have all atoms there is all that there is.
TEST(Groups, SumsAreTheTotals) {
  const TemporaryFile file("chains.pdb", chains());
  const std::string crambin = support::own_molecule("crambin.pdb").string();
  struct Case {
    std::string path, groups;
    Words more;
    size_t count;
  };
  for (const Case &it : std::vector<Case>{{file.path(), "chains", {}, 10},
                                          {file.path(), "A,B,C,D", {"--probe", "1.4"}, 10},
                                          {file.path(), "residue:HEM,chain:B,rest", {}, 6},
                                          {file.path(), "A+C,rest", {"--box", "11,9,8"}, 3},
                                          {file.path(), "element:N,element:O,rest", {}, 6},
                                          {crambin, "residue:1-20,residue:21-46", {"--probe", "1.4"}, 3}}) {
    Words plain = {"contacts", it.path};
    plain.insert(plain.end(), it.more.begin(), it.more.end());
    const Json all = run_json(plain), json = between(it.path, it.groups, it.more);
    const Json &pairs = json["pairs"];
    ASSERT_EQ(pairs.items.size(), it.count) << it.groups;
    EXPECT_EQ(sum_of(pairs, "atom_pairs"), all["contacts"].number) << it.groups;
    EXPECT_NEAR(sum_of(pairs, "area"), all["area"].number, 1e-12 * all["area"].number) << it.groups;
    EXPECT_NEAR(sum_of(pairs, "rim"), sum_of(all["pairs"], "rim"), 1e-12 * (1 + sum_of(all["pairs"], "rim")));
    EXPECT_EQ(json["area"].text, all["area"].text);
  }
}

// Chains by themselves are those of --by chain, and residues of different groups sum to what is between these.
TEST(Groups, SumsByResidues) {
  const TemporaryFile file("chains.pdb", chains());
  const Json by_chain = run_json({"contacts", file.path(), "--by", "chain"});
  const Json all_chains = between(file.path(), "chains");
  size_t found = 0;
  for (const Json &row : all_chains["pairs"].items) {
    if (row["groups"].items[0].text == row["groups"].items[1].text || row["atom_pairs"].number == 0) continue;
    const Json &same = by_chain["pairs"].items.at(found++);
    EXPECT_EQ(same["chains"].items[0].text + same["chains"].items[1].text,
              row["groups"].items[0].text + row["groups"].items[1].text);
    EXPECT_NEAR(row["area"].number, same["area"].number, 1e-12 * (1 + same["area"].number));
    EXPECT_EQ(row["atom_pairs"].text, same["atom_pairs"].text);
  }
  EXPECT_EQ(found, by_chain["pairs"].items.size());
  const Json json = between(file.path(), "residue:HEM,chain:B,C", {"--by", "residue"});
  EXPECT_EQ(json.keys, (Words{"n", "contacts", "area", "between", "pairs", "input"}));
  double expected = 0;
  for (const Json &row : json["between"].items) {
    if (row["groups"].items[0].text != row["groups"].items[1].text) expected += row["area"].number;
  }
  EXPECT_GT(expected, 1.0);
  EXPECT_NEAR(sum_of(json["pairs"], "area"), expected, 1e-12 * expected);
  for (const Json &row : json["pairs"].items) EXPECT_NE(row["residues"].items[0].text, row["residues"].items[1].text);
  const Outcome csv = run_program({"contacts", file.path(), "--between", "A,B", "--csv"});
  EXPECT_EQ(csv.out.rfind("group_1,group_2,area,rim,atom_pairs,edge\nA,A,", 0), 0u) << csv.out;
  const Outcome residues = run_program({"contacts", file.path(), "--between", "A,B", "--by", "residue", "--csv"});
  EXPECT_EQ(residues.out.rfind("chain_1,residue_1,number_1,insertion_1,chain_2,", 0), 0u) << residues.out;
  EXPECT_EQ(residues.out.find("\nA,GLY,1,,A,"), std::string::npos);
  const Outcome table = run_program({"contacts", file.path(), "--between", "chains"});
  EXPECT_NE(table.out.find("                             A               B               C               D\n"),
            std::string::npos)
      << table.out;
}

double area_of(const std::string &path, const Words &only) {
  Words words = {"measure", path, "--probe", "1.4", "--no-hydrogens"};
  for (const std::string &selection : only) words.insert(words.end(), {"--only", selection});
  return run_json(words)["area"].number;
}

// The buried area is the difference of three measures, every bit; in a matrix as alone.
TEST(Groups, BuriedAreasFromThreeMeasures) {
  const TemporaryFile file("chains.pdb", chains());
  const Words names = {"A", "B", "C", "D"};
  const Json all = run_json({"measure", file.path(), "--probe", "1.4", "--interface", "chains"})["interfaces"];
  ASSERT_EQ(all["groups"].items.size(), 4u);
  ASSERT_EQ(all["pairs"].items.size(), 6u);
  for (const Json &pair : all["pairs"].items) {
    const std::string first = pair["first"].text, second = pair["second"].text;
    const double a = area_of(file.path(), {"chain:" + first}), b = area_of(file.path(), {"chain:" + second});
    const double both = area_of(file.path(), {"chain:" + first + "," + second});
    EXPECT_EQ(pair["together"].number, both) << first << second;
    EXPECT_EQ(pair["buried"].number, a + b - both) << first << second;
    const Json two =
        run_json({"measure", file.path(), "--probe", "1.4", "--interface", first + "," + second})["interface"];
    EXPECT_EQ(two["buried"].text, pair["buried"].text);
    EXPECT_EQ(two["groups"].items[0]["together"].text, pair["first_together"].text);
    EXPECT_EQ(two["groups"].items[1]["together"].text, pair["second_together"].text);
  }
  // A ligand in its chain: the atoms of the chain are all others of it.
  const Json ligand =
      run_json({"measure", file.path(), "--probe", "1.4", "--interface", "residue:HEM,chain:B"})["interface"];
  EXPECT_EQ(ligand["groups"].items[0]["atoms"].text, "4");
  EXPECT_EQ(ligand["groups"].items[1]["atoms"].text, "8");
  const double alone = area_of(file.path(), {"residue:HEM"}), host = area_of(file.path(), {"chain:B&residue:GLY"});
  EXPECT_EQ(ligand["buried"].number, alone + host - area_of(file.path(), {"chain:B"}));
  const Outcome table = run_program({"measure", file.path(), "--interface", "residue:HEM,chain:B"});
  EXPECT_NE(table.out.find("of chain:B 4 more atoms are of a group before it"), std::string::npos) << table.out;
}

// Groups that are too far from each other bury nothing, and are found so without a measure.
TEST(Groups, FarGroups) {
  std::string text;
  for (int k = 0; k < 3; ++k) {
    char line[100];
    std::snprintf(line, sizeof line, "ATOM  %5d  CA  GLY %c   1    %8.3f   0.000   0.000  1.00  0.00           C\n", k,
                  'A' + k, k == 2 ? 6.1 : 2.0 * k);
    text += line;
  }
  const TemporaryFile file("far.pdb", text);
  const Json pairs =
      run_json({"measure", file.path(), "--probe", "0.3", "--interface", "chains"})["interfaces"]["pairs"];
  ASSERT_EQ(pairs.items.size(), 3u);
  const double r = 2.0, cap = 2 * 3.14159265358979323846 * r * (r - 1.0);
  EXPECT_NEAR(pairs.items[0]["buried"].number, 2 * cap, 1e-6);
  EXPECT_EQ(pairs.items[1]["buried"].number, 0.0);
  EXPECT_EQ(pairs.items[2]["buried"].number, 0.0);
  const Json near =
      run_json({"measure", file.path(), "--probe", "0.4", "--interface", "chains"})["interfaces"]["pairs"];
  EXPECT_GT(near.items[2]["buried"].number, 0.1);
}

TEST(Groups, FormsAndWhatIsNone) {
  const TemporaryFile file("chains.pdb", chains());
  for (const char *groups : {"A", "", "A,", ",A", "A++B,C", "residue:HEM,B", "chain:A,B", "rest,rest", "A+rest,B",
                             "A,A", "foo:A,B", "A&B,C", "residue:9-1,A", "chains,A"}) {
    for (const Words &call : {Words{"measure", "--interface"}, Words{"contacts", "--between"}}) {
      const Outcome outcome = run_program({call[0], file.path(), call[1], groups});
      EXPECT_EQ(outcome.status, 2) << groups;
      EXPECT_EQ(outcome.out, "") << groups;
      EXPECT_EQ(outcome.err.rfind("hardsphere: " + call[1] + ": ", 0), 0u) << outcome.err;
    }
  }
  const Outcome one = run_program({"contacts", file.path(), "--between", "residue:HEM,B"});
  EXPECT_NE(one.err.find("a chain behind a selection is chain:A"), std::string::npos) << one.err;
  for (const char *groups : {"A,Z", "B,residue:HEM&chain:B", "A+B+C+D,rest"}) {
    const Outcome outcome = run_program({"contacts", file.path(), "--between", groups});
    EXPECT_EQ(outcome.status, 1) << groups;
    EXPECT_NE(outcome.err.find("--between: there are no atoms in "), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run_program({"contacts", file.path(), "--only", "chain:A", "--between", "chains"}).status, 1);
  EXPECT_EQ(run_program({"contacts", "good/water.xyz", "--between", "chains"}).status, 2);
  EXPECT_EQ(run_program({"contacts", "good/water.xyz", "--between", "element:O,rest"}).status, 0);
  for (const char *groups :
       {"residue:1,residue:2", "A+residue:HEM,chain:C+chain:D", ".,A", "hydrogen,A", "A,rest", "water,A"}) {
    const Outcome outcome = run_program({"contacts", file.path(), "--between", groups});
    EXPECT_NE(outcome.status, 2) << groups << outcome.err;
  }
}

}  // namespace
