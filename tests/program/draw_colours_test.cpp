// The colours of hardsphere draw: palettes; and whole pictures as they must stand, byte for byte.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "drawn_colours.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

// The colours that Jmol's documentation lists, and the muted ones of this project.
TEST(DrawColours, EveryBallHasTheColourOfItsElement) {
  const std::map<std::string, std::string> jmol = {
      {" H", "FFFFFF"}, {" C", "909090"}, {" N", "3050F8"}, {" O", "FF0D0D"}, {" S", "FFFF30"}};
  const std::map<std::string, std::string> soft = {
      {" H", "FBFAF7"}, {" C", "D2CDC3"}, {" N", "86A9F2"}, {" O", "F2705C"}, {" S", "F8D660"}};
  for (const std::string &file : {crambin(), molecules_folder() + "/caffeine.pdb"}) {
    const std::vector<std::string> atoms = atoms_of(file);
    for (const auto &[palette, colour_of] :
         std::map<std::string, std::map<std::string, std::string>>{{"jmol", jmol}, {"soft", soft}}) {
      const std::map<int, std::string> found = fills(file, {"--palette", palette});
      EXPECT_GT(found.size(), atoms.size() / 2);
      for (const auto &[ball, colour] : found) {
        EXPECT_EQ(colour, colour_of.at(atoms.at(static_cast<size_t>(ball)).substr(76, 2))) << palette << ball;
      }
    }
  }
}

// All the symbols, from their names to their numbers: one of each at a distance, and Jmol's colours for some.
TEST(DrawColours, AtomicNumbers) {
  const std::vector<std::pair<std::string, std::string>> elements = {
      {"He", "D9FFFF"}, {"B", "FFB5B5"},  {"F", "90E050"},  {"P", "FF8000"},  {"K", "8F40D4"},
      {"V", "A6A6AB"},  {"Fe", "E06633"}, {"Zn", "7D80B0"}, {"Y", "94FFFF"},  {"Ag", "C0C0C0"},
      {"I", "940094"},  {"Ba", "00C900"}, {"W", "2194D6"},  {"Au", "FFD123"}, {"U", "008FFF"},
      {"Mt", "EB0026"}, {"Og", "FF1493"}, {"D", "FFFFFF"},  {"Qq", "FF1493"}};
  std::string text = std::to_string(elements.size()) + "\ntitle\n";
  std::string radii;
  for (size_t i = 0; i < elements.size(); ++i) {
    text += elements[i].first + " " + std::to_string(5 * i) + " 0 0\n";
    if (elements[i].first != "D") radii += (radii.empty() ? "" : ",") + elements[i].first + "=1";
  }
  const TemporaryFile file("elements.xyz", text);
  const std::map<int, std::string> found = fills(file.path(), {"--palette", "jmol", "--radius", radii});
  ASSERT_EQ(found.size(), elements.size());
  for (const auto &[ball, colour] : found) {
    EXPECT_EQ(colour, elements[static_cast<size_t>(ball)].second) << elements[static_cast<size_t>(ball)].first;
  }
}

// Chains get their tints in the order of their first atoms, wherever the others stand.
TEST(DrawColours, Chains) {
  const auto file_of = [](const std::string &chains) {
    std::string text;
    for (size_t i = 0; i < chains.size(); ++i) {
      char line[100];
      std::snprintf(line, sizeof line, "ATOM  %5d  CA  ALA %c   1    %8.3f%8.3f%8.3f  1.00  0.00           C\n",
                    static_cast<int>(i), chains[i], 5.0 * static_cast<double>(i), 0.0, 0.0);
      text += line;
    }
    return text;
  };
  const TemporaryFile file("chains.pdb", file_of("ZABZ AB"));
  const TemporaryFile in_order("in_order.pdb", file_of("abcd"));
  const std::map<int, std::string> found = fills(file.path(), {"--palette", "chain"});
  const std::map<int, std::string> tint = fills(in_order.path(), {"--palette=chain"});
  ASSERT_EQ(tint.size(), 4u);
  EXPECT_EQ(std::set<std::string>({tint.at(0), tint.at(1), tint.at(2), tint.at(3)}).size(), 4u);
  const std::vector<int> expected = {0, 1, 2, 0, 3, 1, 2};
  ASSERT_EQ(found.size(), expected.size());
  for (const auto &[ball, colour] : found) EXPECT_EQ(colour, tint.at(expected[static_cast<size_t>(ball)])) << ball;
  // Palettes by element take no notice.
  for (const auto &[ball, colour] : fills(file.path(), {})) EXPECT_EQ(colour, "D2CDC3") << ball;
}

// Many atoms of two chains are tinted by chain, ligands and ions by element; fewer are not, nor those of one chain.
// Ligands and water make no chain, and modified residues are part of theirs.
TEST(DrawColours, TintsByDefault) {
  const auto file_of = [](int atoms, const std::string &chain_of_rest, const std::string &rest) {
    std::string text;
    for (int i = 0; i < atoms; ++i) {
      const bool last = i >= atoms - 5;
      char line[100];
      std::snprintf(line, sizeof line, "%s  CA  %s %c%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n",
                    last ? rest.substr(0, 11).c_str() : "ATOM      1", last ? rest.substr(11, 3).c_str() : "ALA",
                    last ? chain_of_rest[static_cast<size_t>(atoms - 1 - i)] : 'A', i % 1000, 5.0 * (i % 15),
                    5.0 * (i / 15 % 15), 5.0 * (i / 225));
      text += line;
    }
    return text;
  };
  const std::vector<std::string> plain = {"--occlusion", "0"};
  const std::string grey = "D2CDC3";
  struct Case {
    int atoms;
    std::string chains;
    std::string rest;  // record and residue of the last five atoms
    bool tinted;       // the first one
    bool last_tinted;
  };
  for (const Case &it :
       {Case{2001, "BBBBB", "ATOM      1GLY", true, true}, Case{2000, "BBBBB", "ATOM      1GLY", false, false},
        Case{2001, "AAAAA", "ATOM      1GLY", false, false}, Case{2001, "BBBBB", "HETATM    1MSE", true, true},
        Case{2001, "BBBBB", "HETATM    1HEM", false, false}, Case{2001, "BBBBB", "ATOM      1HEM", true, true}}) {
    const TemporaryFile file("chains.pdb", file_of(it.atoms, it.chains, it.rest));
    const std::map<int, std::string> found = fills(file.path(), plain);
    ASSERT_EQ(found.size(), static_cast<size_t>(it.atoms));
    EXPECT_EQ(found.at(0) != grey, it.tinted) << it.atoms << it.chains << it.rest;
    EXPECT_EQ(found.at(it.atoms - 1) != grey, it.last_tinted) << it.atoms << it.chains << it.rest;
    EXPECT_EQ(found, fills(file.path(), {"--occlusion", "0", "--palette", it.tinted ? "chain" : "soft"}));
  }
  // A haem beside two chains: its carbon as Jmol has it, in whatever chain.
  const TemporaryFile haem("haem.pdb",
                           file_of(2001, "ABBBB", "ATOM      1GLY") +
                               "HETATM    1  CHA HEM A   1     -20.000   0.000   0.000  1.00  0.00           C\n"
                               "HETATM    1 ZN    ZN B   2     -20.000  20.000   0.000  1.00  0.00          ZN\n");
  const std::map<int, std::string> found = fills(haem.path(), plain);
  EXPECT_EQ(found.at(2001), "909090");
  EXPECT_EQ(found.at(2002), "7D80B0");
  EXPECT_NE(found.at(0), found.at(1999));
  EXPECT_EQ(found.at(0), found.at(2000));
}

TEST(DrawColours, AtomsWithoutElementsAreGrey) {
  const TemporaryFile unknown("unknown.pqr", "ATOM 1 Q1 XYZ A 1 0 0 0 0 1\nATOM 2 A XYZ A 1 5 0 0 0 1\n");
  for (const std::string &file : {std::string("good/two.xyzr"), unknown.path()}) {
    const std::map<int, std::string> found = fills(file, {});
    EXPECT_GE(found.size(), 2u);
    for (const auto &[ball, colour] : found) EXPECT_EQ(colour, "D2CDC3") << file << ball;
  }
}

void expect_golden(const std::string &molecule, const std::string &extension, const std::vector<std::string> &options) {
  const std::string golden = read_file(pictures_folder() + "/" + molecule + extension);
  const std::string found = drawn(molecules_folder() + "/" + molecule + ".pdb", options, extension);
  EXPECT_TRUE(found == golden) << molecule << extension << " differs: " << found.size() << " bytes, expected "
                               << golden.size();
}

// Whole pictures. If they are meant to change: hardsphere draw with these arguments, -o the file.
TEST(DrawColours, GoldenPictures) {
  for (const char *extension : {".svg", ".eps", ".pdf"}) {
    expect_golden("caffeine", extension, {"--view", "0,0,1", "--rotate", "60,25,0", "--width", "240"});
  }
  // The picture in README.md.
  expect_golden("crambin", ".svg", {});
}

}  // namespace
