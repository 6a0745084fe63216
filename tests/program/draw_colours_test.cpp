// The colours of hardsphere draw: palettes; and whole pictures as they must stand, byte for byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "drawn_colours.hpp"
#include "json_outcome.hpp"
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

// A strand's bases are lighter than its backbone; other elements than carbon are a little darker; and the thirteenth
// chain has the first tint, paler.
TEST(DrawColours, TintsWithinAChain) {
  std::string text;
  const std::vector<std::string> names = {" C1'", " P  ", " O4*", " C2 ", " N1 "};
  for (size_t i = 0; i < names.size() + 12; ++i) {
    char line[100];
    const size_t chain = i < names.size() ? 0 : i - names.size() + 1;
    const std::string name = chain == 0 ? names[i] : " CA ";
    std::snprintf(line, sizeof line, "ATOM  %5d %s %s %c   1    %8.3f%8.3f%8.3f  1.00  0.00           %c\n",
                  static_cast<int>(i), name.c_str(), chain == 0 ? " DA" : "ALA", static_cast<char>('A' + chain),
                  5.0 * static_cast<double>(i), 0.0, 0.0, name[1]);
    text += line;
  }
  const TemporaryFile file("strand.pdb", text);
  const std::map<int, std::string> found = fills(file.path(), {"--colour", "chain"});
  ASSERT_EQ(found.size(), names.size() + 12);
  EXPECT_EQ(found.at(0), "E8A074");
  EXPECT_EQ(found.at(1), "DA966D");  // .94 of it
  EXPECT_EQ(found.at(2), found.at(1));
  EXPECT_EQ(found.at(3), "F0C1A5");  // .35 of the way to white
  EXPECT_EQ(found.at(4), found.at(3));
  EXPECT_EQ(found.at(16), "F1C6AC");  // .4
}

// A colour as people see it, in OKLab (Ottosson 2020): lightness first. blindness: the rows of a simulation by Machado,
// Oliveira and Fernandes (2009) for linear light.
std::array<double, 3> seen(const std::string &colour, const double blindness[3][3]) {
  double light[3];
  for (size_t k = 0; k < 3; ++k) {
    const double c = std::stoi(colour.substr(2 * k, 2), nullptr, 16) / 255.0;
    light[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  const auto times = [](const double rows[3][3], const double v[3], double out[3]) {
    for (int k = 0; k < 3; ++k) out[k] = rows[k][0] * v[0] + rows[k][1] * v[1] + rows[k][2] * v[2];
  };
  const double to_cones[3][3] = {{0.4122214708, 0.5363325363, 0.0514459929},
                                 {0.2119034982, 0.6806995451, 0.1073969566},
                                 {0.0883024619, 0.2817188376, 0.6299787005}};
  const double to_lab[3][3] = {{0.2104542553, 0.7936177850, -0.0040720468},
                               {1.9779984951, -2.4285922050, 0.4505937099},
                               {0.0259040371, 0.7827717662, -0.8086757660}};
  double left[3];
  double cones[3];
  std::array<double, 3> lab{};
  times(blindness, light, left);
  for (double &channel : left) channel = std::min(1.0, std::max(0.0, channel));
  times(to_cones, left, cones);
  for (double &cone : cones) cone = std::cbrt(cone);
  times(to_lab, cones, lab.data());
  return lab;
}

// Twelve chains side by side. The first four differ for all eyes, and in grey print.
TEST(DrawColours, TintsAreToldApart) {
  const double views[3][3][3] = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}},
      {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
  for (const std::string element : {" C", " N"}) {
    std::string text;
    for (int i = 0; i < 12; ++i) {
      char line[100];
      std::snprintf(line, sizeof line, "ATOM  %5d %s   ALA %c   1    %8.3f%8.3f%8.3f  1.00  0.00          %s\n", i,
                    element.c_str(), 'A' + i, 5.0 * i, 0.0, 0.0, element.c_str());
      text += line;
    }
    const TemporaryFile file("chains.pdb", text);
    const std::map<int, std::string> tint = fills(file.path(), {"--palette", "chain"});
    ASSERT_EQ(tint.size(), 12u);
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < i; ++j) {
        for (int view = 0; view < 3; ++view) {
          const auto a = seen(tint.at(i), views[view]);
          const auto b = seen(tint.at(j), views[view]);
          const double apart =
              std::sqrt(std::pow(a[0] - b[0], 2) + std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
          EXPECT_GT(apart, i < 4       ? (view == 0 ? 0.11 : 0.08)
                           : view == 0 ? 0.065
                                       : 0.04)
              << i << " " << j << " " << view;
          if (i < 4 && view == 0) {
            EXPECT_GT(std::fabs(a[0] - b[0]), element == " C" ? 0.06 : 0.05) << i << " " << j;
          }
        }
      }
    }
  }
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
  // A haem beside two chains: its carbon has a colour of its own, in whatever chain, and zinc that of zinc.
  const TemporaryFile haem("haem.pdb",
                           file_of(2001, "ABBBB", "ATOM      1GLY") +
                               "HETATM    1  CHA HEM A   1     -20.000   0.000   0.000  1.00  0.00           C\n"
                               "HETATM    1 ZN    ZN B   2     -20.000  20.000   0.000  1.00  0.00          ZN\n");
  const std::map<int, std::string> found = fills(haem.path(), plain);
  EXPECT_EQ(found.at(2001), "7E8A93");
  EXPECT_EQ(found.at(2002), "ADACC0");
  EXPECT_NE(found.at(0), found.at(1999));
  EXPECT_EQ(found.at(0), found.at(2000));
}

// By kind, under all the names that a kind goes by; what is in no chain has the colours of elements.
TEST(DrawColours, Residues) {
  const std::vector<std::pair<std::string, std::string>> residues = {
      {"ATOM  ARG", "5A84DC"}, {"ATOM  HIP", "5A84DC"}, {"ATOM  ASP", "E8705E"}, {"ATOM  ASN", "AFE0A4"},
      {"ATOM  TRP", "DDB3EC"}, {"ATOM  CYX", "F2DF38"}, {"HETATMMSE", "F2DF38"}, {"ATOM  VAL", "A8A09A"},
      {"ATOM  GLY", "F5F3EE"}, {"ATOM   DA", "F0AC96"}, {"ATOM    C", "9FC3E6"}, {"ATOM  GUA", "B7D3A0"},
      {"ATOM  RU5", "EED28A"}, {"ATOM  DT3", "EED28A"}, {"ATOM  ACE", "D2CDC3"}, {"ATOM  XYZ", "D2CDC3"},
      {"HETATMHEM", "7E8A93"}};
  std::string text;
  for (size_t i = 0; i < residues.size(); ++i) {
    char line[100];
    std::snprintf(line, sizeof line, "%s%5d  C   %s A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n",
                  residues[i].first.substr(0, 6).c_str(), static_cast<int>(i), residues[i].first.substr(6).c_str(),
                  static_cast<int>(i), 5.0 * static_cast<double>(i), 0.0, 0.0);
    text += line;
  }
  const TemporaryFile file("residues.pdb", text);
  const std::map<int, std::string> found = fills(file.path(), {"--colour", "residue"});
  ASSERT_EQ(found.size(), residues.size());
  for (const auto &[ball, colour] : found) {
    EXPECT_EQ(colour, residues[static_cast<size_t>(ball)].second) << residues[static_cast<size_t>(ball)].first;
  }
  std::set<std::string> kinds;
  for (size_t i = 0; i <= 8; ++i) kinds.insert(residues[i].second);
  EXPECT_EQ(kinds.size(), 7u);
  EXPECT_GT(least_difference({kinds.begin(), kinds.end()}), 14);
  const TemporaryFile four("four.cif",
                           "data_x\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
                           "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
                           "C C NALA 0 0 0\nC C CYSH 5 0 0\nC C ASPH 10 0 0\nC C CGLY 15 0 0\n");
  EXPECT_EQ(fills(four.path(), {"--colour", "residue"}),
            (std::map<int, std::string>{{0, "A8A09A"}, {1, "F2DF38"}, {2, "E8705E"}, {3, "F5F3EE"}}));
  EXPECT_EQ(fills(file.path(), {"--colour", "chain"}), fills(file.path(), {"--palette", "chain"}));
  EXPECT_EQ(fills(file.path(), {"--colour", "element"}), fills(file.path(), {}));
}

// Sixty-four steps from blue over grey to red: a number's, between the least and the greatest or the user's.
std::string ramp_colour(double number, double low, double high) {
  const double part = std::min(1.0, std::max(0.0, (number - low) / (high - low)));
  const int ends[3][3] = {{0x3F, 0x74, 0xB5}, {0xE8, 0xE8, 0xE8}, {0xC2, 0x45, 0x2F}};
  const double step = std::floor(64 * part + 0.5) / 32;
  char text[7] = "";
  for (int k = 0; k < 3; ++k) {
    const int from = ends[step <= 1 ? 0 : 1][k];
    const int to = ends[step <= 1 ? 1 : 2][k];
    const int level = static_cast<int>(from + (to - from) * (step <= 1 ? step : step - 1) + 0.5);
    std::snprintf(text + 2 * k, 3, "%02X", static_cast<unsigned>(level));
  }
  return text;
}

TEST(DrawColours, NumbersOfAFile) {
  const TemporaryFile file("row.xyzr", "0 0 0 1\n5 0 0 1\n10 0 0 1\n15 0 0 1\n20 0 0 1\n");
  const double number[5] = {3, -2, 0.5, 4.25, 8};
  const TemporaryFile numbers("numbers.txt", "3\n-2 # the least\n\n0.5\n4.25\n8\n");
  for (const bool given : {false, true}) {
    std::vector<std::string> options = {"--colour", numbers.path()};
    if (given) options.insert(options.end(), {"--range", "0,4"});
    const std::map<int, std::string> found = fills(file.path(), options);
    ASSERT_EQ(found.size(), 5u);
    for (int ball = 0; ball < 5; ++ball) {
      EXPECT_EQ(found.at(ball), ramp_colour(number[ball], given ? 0 : -2, given ? 4 : 8)) << ball;
    }
  }
  const TemporaryFile same("same.txt", "7\n7\n7\n7\n7\n");
  for (const auto &[ball, colour] : fills(file.path(), {"--colour", same.path()})) EXPECT_EQ(colour, "E8E8E8") << ball;
  const TemporaryFile out("numbers.svg");
  const Json json = run_json({"draw", file.path(), "-o", out.path(), "--colour", numbers.path()});
  EXPECT_EQ(json["palette"].text, "ramp");
  EXPECT_EQ(json["range"].items.at(0).number, -2);
  EXPECT_EQ(json["range"].items.at(1).number, 8);
  EXPECT_EQ(json["occlusion"].number, 0);
}

// Columns 61 to 66 of a .pdb file; and the areas that measure finds with a probe of 1.4.
TEST(DrawColours, TemperatureFactorsAndAreas) {
  const std::vector<std::string> atoms = atoms_of(crambin());
  const Json balls = run_json({"measure", crambin(), "--per-ball", "--probe", "1.4"})["balls"];
  std::vector<double> factor;
  std::vector<double> area;
  for (size_t i = 0; i < atoms.size(); ++i) {
    factor.push_back(std::stod(atoms[i].substr(60, 6)));
    area.push_back(balls.items.at(i)["area"].number);
  }
  for (const auto &[what, numbers] : std::map<std::string, std::vector<double>>{{"bfactor", factor}, {"area", area}}) {
    const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
    const std::map<int, std::string> found = fills(crambin(), {"--colour", what});
    EXPECT_GT(found.size(), 200u);
    std::set<std::string> different;
    for (const auto &[ball, colour] : found) {
      EXPECT_EQ(colour, ramp_colour(numbers[static_cast<size_t>(ball)], *low, *high)) << what << ball;
      different.insert(colour);
    }
    EXPECT_GT(different.size(), 8u) << what;
  }
  const TemporaryFile cif("one.cif",
                          "data_x\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n"
                          "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.B_iso_or_equiv\n"
                          "C CA 0 0 0 10.5(3)\nC CB 5 0 0 30\nC CC 10 0 0 20.25\n");
  const std::map<int, std::string> found = fills(cif.path(), {"--colour", "bfactor"});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found.at(0), ramp_colour(0, 0, 1));
  EXPECT_EQ(found.at(1), ramp_colour(1, 0, 1));
  EXPECT_EQ(found.at(2), ramp_colour(0.5, 0, 1));
}

// Names are those of style sheets.
TEST(DrawColours, ColoursHaveNames) {
  for (const auto &[name, digits] : std::map<std::string, std::string>{
           {"white", "FFFFFF"}, {"black", "000000"}, {"navy", "000080"}, {"orange", "ffa500"}, {"grey", "#808080"}}) {
    EXPECT_EQ(drawn(crambin(), {"--background", name}), drawn(crambin(), {"--background", digits})) << name;
  }
  EXPECT_EQ(run_program({"draw", crambin(), "-o", "x.svg", "--background", "whit"}).status, 2);
}

// Far ones of many sticks fade, where nothing is said.
TEST(DrawColours, ManySticksFade) {
  for (const auto &[file, fog] : std::map<std::string, std::string>{{"crambin", "0.7"}, {"caffeine", "0.3"}}) {
    const std::string path = molecules_folder() + "/" + file + ".pdb";
    EXPECT_EQ(drawn(path, {"--as", "ball-and-stick"}), drawn(path, {"--as", "ball-and-stick", "--fog", fog})) << file;
  }
}

// Numbers above 90, 70 and 50, and others.
TEST(DrawColours, BandsOfAlphaFold) {
  std::string text;
  const std::vector<std::pair<double, std::string>> numbers = {{100, "0053D6"},  {90.01, "0053D6"}, {90, "65CBF3"},
                                                               {70.5, "65CBF3"}, {70, "FFDB13"},    {50.1, "FFDB13"},
                                                               {50, "FF7D45"},   {0, "FF7D45"}};
  for (size_t i = 0; i < numbers.size(); ++i) {
    char line[100];
    std::snprintf(line, sizeof line, "ATOM  %5d  CA  ALA A%4d    %8.3f%8.3f%8.3f  1.00%6.2f           C\n",
                  static_cast<int>(i), static_cast<int>(i), 5.0 * static_cast<double>(i), 0.0, 0.0, numbers[i].first);
    text += line;
  }
  const TemporaryFile file("model.pdb", text);
  const std::map<int, std::string> found = fills(file.path(), {"--colour", "plddt"});
  ASSERT_EQ(found.size(), numbers.size());
  for (const auto &[ball, colour] : found) EXPECT_EQ(colour, numbers[static_cast<size_t>(ball)].second) << ball;
  EXPECT_EQ(run_program({"draw", file.path(), "-o", "x.svg", "--colour", "plddt", "--range", "0,1"}).status, 2);
  EXPECT_EQ(run_program({"draw", "good/one.xyzr", "-o", "x.svg", "--colour", "plddt"}).status, 2);
}

// Named atoms keep their colours, but for carbon among elements; all else keeps a quarter of them.
TEST(DrawColours, Highlight) {
  const std::vector<std::string> atoms = atoms_of(crambin());
  const auto muted = [](const std::string &colour) {
    const int grey[3] = {0xDE, 0xDB, 0xD4};
    char text[7] = "";
    for (size_t k = 0; k < 3; ++k) {
      const int own = std::stoi(colour.substr(2 * k, 2), nullptr, 16);
      std::snprintf(text + 2 * k, 3, "%02X", static_cast<unsigned>(grey[k] + (own - grey[k]) * 0.25 + 0.5));
    }
    return std::string(text);
  };
  const std::map<int, std::string> plain = fills(crambin(), {});
  const std::map<int, std::string> some =
      fills(crambin(), {"--highlight", "residue:CYS", "--highlight", "residue:TYR&element:O"});
  ASSERT_EQ(some.size(), plain.size());
  int kept = 0;
  for (const auto &[ball, colour] : some) {
    const std::string &atom = atoms.at(static_cast<size_t>(ball));
    const std::string residue = atom.substr(17, 3);
    const std::string element = atom.substr(76, 2);
    if (residue == "CYS" || (residue == "TYR" && element == " O")) {
      EXPECT_EQ(colour, element == " C" ? "1F8F92" : plain.at(ball)) << atom;
      ++kept;
    } else {
      EXPECT_EQ(colour, muted(plain.at(ball))) << atom;
    }
  }
  EXPECT_GT(kept, 20);
  for (const char *const other : {"D2CDC3", "86A9F2", "F2705C"}) {
    EXPECT_GT(least_difference({"1F8F92", muted(other)}), 20) << other;
  }
  const std::map<int, std::string> tinted = fills(crambin(), {"--palette", "chain"});
  EXPECT_EQ(fills(crambin(), {"--palette", "chain", "--highlight", "chain:A"}), tinted);
}

TEST(DrawColours, AtomsWithoutElementsAreGrey) {
  const TemporaryFile unknown("unknown.pqr", "ATOM 1 Q1 XYZ A 1 0 0 0 0 1\nATOM 2 A XYZ A 1 5 0 0 0 1\n");
  for (const std::string &file : {std::string("good/two.xyzr"), unknown.path()}) {
    const std::map<int, std::string> found = fills(file, {});
    EXPECT_GE(found.size(), 2u);
    for (const auto &[ball, colour] : found) EXPECT_EQ(colour, "D2CDC3") << file << ball;
  }
}

// Contours: in all formats, of the chosen kinds; of balls and sticks, too, which have no outlines else.
TEST(DrawColours, InkFollowsDepth) {
  const std::string plain = drawn(crambin(), {"--style", "flat"}), ink = drawn(crambin(), {"--style", "flat", "--ink"});
  EXPECT_EQ(plain.find("class="), std::string::npos);
  EXPECT_NE(ink.find("class=\"border\""), std::string::npos);
  EXPECT_NE(ink.find("class=\"depth\""), std::string::npos);
  EXPECT_EQ(ink.find("class=\"group\""), std::string::npos);  // one chain
  const std::string by_residue = drawn(crambin(), {"--style", "flat", "--ink", "--colour", "residue"});
  EXPECT_NE(by_residue.find("class=\"group\""), std::string::npos);
  for (const char *extension : {".eps", ".pdf"}) {
    EXPECT_GT(drawn(crambin(), {"--ink"}, extension).size(), drawn(crambin(), {}, extension).size() + 20000);
  }
  EXPECT_NE(drawn(crambin(), {"--ink", "--pieces", "visible"}).find("class=\"depth\""), std::string::npos);
  const std::string labelled = drawn(crambin(), {"--as", "ball-and-stick", "--ink", "--label", "residue"});
  EXPECT_NE(labelled.find("class=\"depth\""), std::string::npos);
  EXPECT_NE(labelled.find("<text"), std::string::npos);
  for (const std::string &pieces : {std::string("all"), std::string("--pieces=visible")}) {
    std::vector<std::string> options = {"--as", "ball-and-stick", "--style", "flat", "--ink"};
    if (pieces != "all") options.push_back(pieces);
    const std::string sticks = drawn(crambin(), options);
    EXPECT_NE(sticks.find("class=\"border\""), std::string::npos);
    EXPECT_NE(sticks.find("class=\"depth\""), std::string::npos);
  }
}

// Widths and colours of contours: one for all kinds, or three. Widths that are 0 are no contours.
TEST(DrawColours, InkWidthsAndColours) {
  const std::string residues = "--colour=residue";
  const auto inked = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--style", "flat", "--fog", "0", residues});
    return drawn(crambin(), options);
  };
  const std::string ink = inked({"--ink"});
  EXPECT_EQ(inked({"--ink-colour", "23202b"}), ink);
  EXPECT_EQ(inked({"--ink", "--ink-colour", "#23202B,#23202B,#23202B"}), ink);
  const std::string coloured = inked({"--ink-colour", "010203,040506,070809"});
  EXPECT_NE(coloured.find("<g fill=\"#010203\""), std::string::npos);
  EXPECT_NE(coloured.find("<path class=\"group\" fill=\"#040506\""), std::string::npos);
  EXPECT_NE(coloured.find("<path class=\"depth\" fill=\"#070809\""), std::string::npos);
  EXPECT_EQ(inked({"--ink-width", "0"}), inked({}));
  const std::string border = inked({"--ink-width", "3,0,0"});
  EXPECT_NE(border.find("class=\"border\""), std::string::npos);
  EXPECT_LT(border.size() + 20000, ink.size());  // others only where they go over into it
  EXPECT_EQ(inked({"--ink-width=2"}), inked({"--ink-width", "2,2,2"}));
  EXPECT_NE(inked({"--ink-width=2"}), inked({"--ink-width", "2,2,1"}));
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--ink-width", "1,2"}, "--ink-width needs 3 numbers"},
      {{"--ink-width", "-1"}, "--ink-width must be between 0 and 1000000"},
      {{"--ink-width", "1,2,2e6"}, "--ink-width must be between 0 and 1000000"},
      {{"--ink-width", "1", "--ink-width", "1"}, "--ink-width is given twice"},
      {{"--ink-colour", "010203,040506"}, "either one RRGGBB or three, not two"},
      {{"--ink-colour", "01020"}, "--ink-colour: '01020' is not RRGGBB"},
      {{"--ink-colour", "010203,,040506"}, "--ink-colour: '' is not RRGGBB"},
      {{"--ink-colour", "010203,040506,070809,0"}, "is not RRGGBB"},
      {{"--ink-colour", "0102030405060708,040506,070809"}, "is not RRGGBB"},
      {{"--ink-colour", "010203", "--ink-colour", "010203"}, "--ink-colour is given twice"}};
  for (const auto &[options, complaint] : wrong) {
    const TemporaryFile out("inked.svg");
    std::vector<std::string> line = {"draw", crambin(), "-o", out.path()};
    line.insert(line.end(), options.begin(), options.end());
    const Outcome refused = run_program(line);
    EXPECT_EQ(refused.status, 2) << complaint;
    EXPECT_NE(refused.err.find(complaint), std::string::npos) << refused.err;
  }
}

// A look is what its options are, and any of these that is given wins.
TEST(DrawColours, LooksArePresets) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> looks = {
      {"paper", {"--ink", "--occlusion", "0.5"}},
      {"goodsell",
       {"--palette", "chain", "--ink", "--style", "flat", "--occlusion", "0.5", "--outline", "0", "--fog", "0.4"}},
      {"slide",
       {"--colour", "bfactor", "--ink", "--occlusion", "0.1", "--outline", "1", "--fog", "0.15", "--background",
        "14171E", "--outline-colour", "3A414F", "--ink-colour", "3A414F", "--width", "1600", "--height", "900"}},
      {"print",
       {"--ink", "--style", "flat", "--occlusion", "0", "--fog", "0", "--outline-colour", "000000", "--ink-colour",
        "000000"}}};
  for (const auto &[look, same] : looks) {
    std::vector<std::string> by_look = {"--look", look};
    // Colours of numbers are not lightened.
    if (look == "slide") by_look.insert(by_look.end(), {"--colour", "bfactor"});
    EXPECT_EQ(drawn(crambin(), by_look), drawn(crambin(), same)) << look;
    // The last of its options that has a value says something else now.
    std::vector<std::string> other = same;
    other.back() = look == "slide" ? "800" : look == "print" ? "0000ff" : "0.1";
    const std::string option = other[other.size() - 2];
    by_look.insert(by_look.end(), {option, other.back()});
    EXPECT_EQ(drawn(crambin(), by_look),
              look == "slide" ? drawn(crambin(), {"--colour", "bfactor", "--ink", "--occlusion", "0.1", "--outline",
                                                  "1", "--fog", "0.15", "--background", "14171E", "--outline-colour",
                                                  "3A414F", "--ink-colour", "3A414F", "--height", "800"})
                              : drawn(crambin(), other))
        << look;
    // Balls and sticks have no contours, nor are they darkened.
    const std::string sticks = drawn(molecules_folder() + "/caffeine.pdb", {"--look", look, "--as", "ball-and-stick"});
    EXPECT_EQ(sticks.find("class=\"border\""), std::string::npos) << look;
    EXPECT_GT(sticks.size(), 5000u) << look;
    for (const std::string background : {"none", "00FF00"}) {
      EXPECT_FALSE(drawn(crambin(), {"--look", look, "--background", background}).empty()) << look;
    }
  }
  EXPECT_LT(drawn(crambin(), {"--look", "goodsell", "--style", "soft", "--classes"}).size(), 170000u);
  // Lines are lighter than a dark background, around the molecule, too, and what is written there is light; those
  // around sticks have its colour.
  const TemporaryFile pair("pair.xyz", "2\n\nC 0 0 0\nO 1.2 0 0\n");
  const std::string slide = drawn(pair.path(), {"--look", "slide", "--scale-bar", "--view", "0,0,1"});
  EXPECT_NE(slide.find("class=\"border\""), std::string::npos);
  const std::vector<std::string> slide_of_sticks = {"--look", "slide", "--as", "ball-and-stick"};
  EXPECT_NE(slide.find("stroke=\"#3a414f\""), std::string::npos);
  EXPECT_EQ(drawn(pair.path(), slide_of_sticks).find("#3a414f"), std::string::npos);
  EXPECT_NE(drawn(pair.path(), {"--look", "paper", "--view", "0,0,1"}).find("class=\"border\""), std::string::npos);
  EXPECT_NE(drawn(crambin(), {"--look", "slide"}).find("class=\"depth\""), std::string::npos);
  EXPECT_NE(slide.find("fill=\"#ece9e2\">"), std::string::npos);
  const std::string own = drawn(crambin(), {"--look", "slide", "--scale-bar", "--outline-colour", "0000FF"});
  EXPECT_NE(own.find("fill=\"#0000ff\">"), std::string::npos);
  // By chain where there are two, unless colours are asked for.
  const TemporaryFile two("two.pdb",
                          "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  0.00           C\n"
                          "ATOM      2  CA  ALA B   1       9.000   0.000   0.000  1.00  0.00           C\n");
  const std::string goodsell = drawn(two.path(), {"--look", "goodsell"});
  EXPECT_EQ(goodsell, drawn(two.path(), {"--look", "goodsell", "--palette", "chain"}));
  EXPECT_NE(goodsell, drawn(two.path(), {"--look", "goodsell", "--palette", "soft"}));
  EXPECT_EQ(drawn(two.path(), {"--look", "paper"}), drawn(two.path(), {"--look", "paper", "--palette", "soft"}));
  const TemporaryFile out("look.svg");
  const Outcome refused = run_program({"draw", crambin(), "-o", out.path(), "--look", "monet"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--look"), std::string::npos);
}

// Sticks have no light, and lines of their own between balls that have it.
TEST(DrawColours, SticksHaveLinesBesideBallsWithLight) {
  const std::string sticks =
      drawn(molecules_folder() + "/caffeine.pdb", {"--as", "ball-and-stick", "--style", "soft", "--outline", "2"});
  size_t paths = 0;
  for (size_t at = sticks.find("<path data-ball="); at != std::string::npos;
       at = sticks.find("<path data-ball=", at + 1), ++paths) {
    EXPECT_NE(sticks.substr(at, sticks.find('\n', at) - at).find(" stroke=\"#"), std::string::npos);
  }
  EXPECT_GT(paths, 25u);
}

// Elements, residues and chains as classes, with ids in the place of data-ball, and names beside the pointer.
TEST(DrawColours, ClassesAndTooltips) {
  const std::string plain = drawn(crambin(), {});
  EXPECT_EQ(plain.find("class="), std::string::npos);
  const std::string named = drawn(crambin(), {"--classes"});
  EXPECT_NE(named.find("-17\" class=\"el-O res-CYS chain-A\" fill=\"#"), std::string::npos);
  EXPECT_EQ(named.find("data-ball="), std::string::npos);
  EXPECT_EQ(named.find("CYS A"), std::string::npos);
  const std::string told = drawn(crambin(), {"--tooltips", "--style", "flat"});
  EXPECT_NE(told.find("<title>CYS A 16 SG</title></path>"), std::string::npos);
  EXPECT_EQ(told.find("class="), std::string::npos);
  EXPECT_NE(told.find("data-ball="), std::string::npos);
  EXPECT_LT(drawn(crambin(), {"--classes", "--ink"}).size(), 170000u);
  EXPECT_LT(drawn(molecules_folder() + "/sod_stand_in.pdb", {"--ink"}).size(), 670000u);
  // An id stands for one thing: of balls and sticks for the ball.
  const std::string sticks =
      drawn(molecules_folder() + "/caffeine.pdb", {"--classes", "--as", "ball-and-stick", "--style", "flat"});
  std::set<std::string> ids;
  size_t given = 0;
  for (size_t at = sticks.find(" id=\"a"); at != std::string::npos; at = sticks.find(" id=\"a", at + 1), ++given) {
    ids.insert(sticks.substr(at, sticks.find('"', at + 5) - at));
  }
  EXPECT_EQ(given, 24u);
  EXPECT_EQ(ids.size(), 24u);
  // No residues, no chains.
  const TemporaryFile pair("pair.xyz", "2\n\nC 1 2 3\nO 9 4 3\n");
  EXPECT_NE(drawn(pair.path(), {"--classes", "--tooltips"}).find("-1\" class=\"el-O\" fill=\"#"), std::string::npos);
  for (const std::string option : {"--classes", "--tooltips"}) {
    const TemporaryFile out("named.eps");
    const Outcome refused = run_program({"draw", crambin(), "-o", out.path(), option});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find(option + " is for .svg: other formats have none"), std::string::npos);
  }
}

void expect_golden(const std::string &molecule, const std::vector<std::string> &options) {
  const std::string golden = read_file(pictures_folder() + "/" + molecule + ".svg");
  const std::string found = drawn(molecules_folder() + "/" + molecule + ".pdb", options);
  EXPECT_TRUE(found == golden) << molecule << " differs: " << found.size() << " bytes, expected " << golden.size();
}

// Whole pictures: a small one, and the one in README.md. tests/packaging/gallery.sh writes them anew, and holds others
// by digests.
TEST(DrawColours, GoldenPictures) {
  expect_golden("caffeine", {"--view", "0,0,1", "--rotate", "60,25,0", "--width", "240"});
  expect_golden("crambin", {"--legend"});
}

}  // namespace
