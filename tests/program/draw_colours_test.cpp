// The colours of hardsphere draw: palettes, occlusion; and whole pictures as they must stand, byte for byte.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

std::string crambin() {
  return molecules_folder() + "/crambin.pdb";
}

std::string drawn(const std::string &file, std::vector<std::string> options, const std::string &extension = ".svg") {
  const TemporaryFile out("colours" + extension);
  options.insert(options.begin(), {"draw", file, "-o", out.path()});
  const Outcome outcome = run_program(options);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.status == 0 ? read_file(out.path()) : "";
}

// The colour of every ball that has a piece, in capitals, as a flat picture without fog shows it.
std::map<int, std::string> fills(const std::string &file, std::vector<std::string> options) {
  options.insert(options.end(), {"--style", "flat", "--fog", "0", "--all-balls"});
  const std::string svg = drawn(file, options);
  const std::string path = "<path data-ball=\"";
  std::map<int, std::string> found;
  for (std::size_t at = svg.find(path); at != std::string::npos; at = svg.find(path, at + 1)) {
    int ball = -1;
    char colour[7] = "";
    EXPECT_EQ(std::sscanf(svg.c_str() + at + path.size(), "%d\" fill=\"#%6[0-9A-Fa-f]\"", &ball, colour), 2);
    for (char &digit : colour) digit = static_cast<char>(std::toupper(static_cast<unsigned char>(digit)));
    found[ball] = colour;
  }
  return found;
}

double brightness(const std::string &colour) {
  double sum = 0;
  for (std::size_t at = 0; at < 6; at += 2) sum += std::stoi(colour.substr(at, 2), nullptr, 16);
  return sum;
}

std::vector<std::string> atoms_of(const std::string &file) {
  std::istringstream lines(read_file(file));
  std::vector<std::string> atoms;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("ATOM", 0) == 0 || line.rfind("HETATM", 0) == 0) atoms.push_back(line);
  }
  return atoms;
}

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
        EXPECT_EQ(colour, colour_of.at(atoms.at(static_cast<std::size_t>(ball)).substr(76, 2))) << palette << ball;
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
  for (std::size_t i = 0; i < elements.size(); ++i) {
    text += elements[i].first + " " + std::to_string(5 * i) + " 0 0\n";
    if (elements[i].first != "D") radii += (radii.empty() ? "" : ",") + elements[i].first + "=1";
  }
  const TemporaryFile file("elements.xyz", text);
  const std::map<int, std::string> found = fills(file.path(), {"--palette", "jmol", "--radius", radii});
  ASSERT_EQ(found.size(), elements.size());
  for (const auto &[ball, colour] : found) {
    EXPECT_EQ(colour, elements[static_cast<std::size_t>(ball)].second)
        << elements[static_cast<std::size_t>(ball)].first;
  }
}

// Chains get their tints in the order of their first atoms, wherever the others stand.
TEST(DrawColours, Chains) {
  const auto file_of = [](const std::string &chains) {
    std::string text;
    for (std::size_t i = 0; i < chains.size(); ++i) {
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
  for (const auto &[ball, colour] : found) EXPECT_EQ(colour, tint.at(expected[static_cast<std::size_t>(ball)])) << ball;
  // Palettes by element take no notice.
  for (const auto &[ball, colour] : fills(file.path(), {})) EXPECT_EQ(colour, "D2CDC3") << ball;
}

TEST(DrawColours, FilesWithoutElementsAreGrey) {
  for (const char *file : {"good/two.xyzr", "good/water.pqr"}) {
    const std::map<int, std::string> found = fills(file, {});
    EXPECT_GE(found.size(), 2u);
    for (const auto &[ball, colour] : found) EXPECT_EQ(colour, "D2CDC3") << file << ball;
  }
}

// Sixteen shades and the full colour of each element at most; what a large probe reaches is brighter.
TEST(DrawColours, OcclusionDarkensWhatIsBuried) {
  const std::map<int, std::string> plain = fills(crambin(), {});
  const std::map<int, std::string> half = fills(crambin(), {"--occlusion", "0.5"});
  const std::map<int, std::string> full = fills(crambin(), {"--occlusion", "1"});
  ASSERT_EQ(plain.size(), full.size());
  std::map<std::string, std::set<std::string>> shades;
  for (const auto &[ball, colour] : full) {
    EXPECT_LE(brightness(colour), brightness(half.at(ball)) + 2);
    EXPECT_LE(brightness(half.at(ball)), brightness(plain.at(ball)));
    shades[plain.at(ball)].insert(colour);
  }
  for (const auto &[colour, darker] : shades) EXPECT_LE(darker.size(), 17u) << colour;
  EXPECT_GT(shades["D2CDC3"].size(), 10u);

  const Json balls = run_json({"measure", crambin(), "--per-ball", "--probe", "4"})["balls"];
  double buried = 0;
  double exposed = 0;
  int buried_count = 0;
  int exposed_count = 0;
  for (const auto &[ball, colour] : full) {
    const double part = brightness(colour) / brightness(plain.at(ball));
    const double area = balls.items.at(static_cast<std::size_t>(ball))["area"].number;
    if (area == 0) buried += part, ++buried_count;
    if (area > 60) exposed += part, ++exposed_count;
  }
  ASSERT_GT(buried_count, 20);
  ASSERT_GT(exposed_count, 20);
  EXPECT_LT(buried / buried_count, 0.75);
  EXPECT_GT(exposed / exposed_count, 0.9);
}

// Large molecules are darkened in any style, others with style soft alone, unless the user says so.
TEST(DrawColours, OcclusionByDefault) {
  const auto grid = [](int balls) {
    std::string text;
    for (int i = 0; i < balls; ++i) {
      text += std::to_string(2 * (i % 13)) + " " + std::to_string(2 * (i / 13 % 13)) + " " +
              std::to_string(2 * (i / 169)) + " 1.2\n";
    }
    return text;
  };
  const TemporaryFile small("small.xyzr", grid(2000));
  const TemporaryFile large("large.xyzr", grid(2001));
  EXPECT_EQ(fills(small.path(), {}), fills(small.path(), {"--occlusion", "0"}));
  EXPECT_EQ(fills(large.path(), {}), fills(large.path(), {"--occlusion", "0.5"}));
  EXPECT_NE(fills(large.path(), {}), fills(large.path(), {"--occlusion", "0"}));
  for (const TemporaryFile *file : {&small, &large}) {
    EXPECT_TRUE(drawn(file->path(), {"--style", "soft"}) ==
                drawn(file->path(), {"--style", "soft", "--occlusion", "0.5"}));
  }
  EXPECT_TRUE(drawn(small.path(), {}) == drawn(small.path(), {"--style", "soft"}));
  EXPECT_TRUE(drawn(large.path(), {}) == drawn(large.path(), {"--style", "flat"}));
}

// A lone ball and two that hardly meet are as bright as can be; so is everything where all balls are alike.
TEST(DrawColours, OcclusionOfFewBalls) {
  EXPECT_EQ(fills("good/one.xyzr", {"--occlusion", "1"}), fills("good/one.xyzr", {}));
  EXPECT_EQ(fills("good/touching.xyzr", {"--occlusion", "1"}).size(), fills("good/touching.xyzr", {}).size());
  const TemporaryFile equal("equal.xyzr", "0 0 0 1\n1 0 0 1\n");
  EXPECT_EQ(fills(equal.path(), {"--occlusion", "1"}), fills(equal.path(), {}));
}

// Lengths in another unit, the same shades: nanometres, and a thousandth of an angstrom.
TEST(DrawColours, OcclusionInAnyUnit) {
  std::vector<std::map<int, std::string>> found;
  for (const double factor : {1.0, 0.1, 1000.0}) {
    std::string text;
    for (const std::string &atom : atoms_of(crambin())) {
      char line[120];
      std::snprintf(line, sizeof line, "%.10g %.10g %.10g %.10g\n", std::stod(atom.substr(30, 8)) * factor,
                    std::stod(atom.substr(38, 8)) * factor, std::stod(atom.substr(46, 8)) * factor, 1.7 * factor);
      text += line;
    }
    const TemporaryFile file("unit.xyzr", text);
    found.push_back(fills(file.path(), {"--occlusion", "1"}));
  }
  EXPECT_GT(found[0].size(), 200u);
  EXPECT_EQ(found[1], found[0]);
  EXPECT_EQ(found[2], found[0]);
}

// More balls within a probe's reach of each other than any molecule has: not shaded unless that is asked for.
TEST(DrawColours, CrowdedSetsAreNotShadedByDefault) {
  std::string text;
  for (int i = 0; i < 2000; ++i) {
    text += std::to_string(i % 20 * 0.03) + " " + std::to_string(i / 20 % 10 * 0.03) + " " +
            std::to_string(i / 200 * 0.03) + " 0.01\n";
  }
  for (int i = 0; i < 600; ++i) text += std::to_string(2.5 * i) + " 5 0 1.7\n";
  const TemporaryFile file("crowded.xyzr", text);
  EXPECT_EQ(fills(file.path(), {}), fills(file.path(), {"--occlusion", "0"}));
}

// At both ends of what the library takes, where probes would be too large or too small for it: no shades, no failure.
TEST(DrawColours, OcclusionAtTheEndsOfTheLattice) {
  for (const char *unit : {"e30", "e-25", "e-160", "e-300"}) {
    const TemporaryFile file(
        "ends.xyzr", std::string("0 0 0 9") + unit + "\n1" + unit + " 0 0 9" + unit + "\n0 0 0 2" + unit + "\n");
    const TemporaryFile out("ends.svg");
    const Outcome outcome = run_program({"draw", file.path(), "-o", out.path(), "--occlusion", "1"});
    EXPECT_EQ(outcome.status, 0) << unit << outcome.err;
    EXPECT_EQ(outcome.err, "") << unit;
    EXPECT_EQ(fills(file.path(), {"--occlusion", "1"}), fills(file.path(), {"--occlusion", "0"})) << unit;
  }
}

// Larger molecules take a cheaper way; it must tell the inside from the outside as well. A grid has corners.
TEST(DrawColours, OcclusionOfManyBalls) {
  std::string text;
  for (int i = 0; i < 1331; ++i) {
    text += std::to_string(2 * (i % 11)) + " " + std::to_string(2 * (i / 11 % 11)) + " " +
            std::to_string(2 * (i / 121)) + " 1.2\n";
  }
  const TemporaryFile file("grid.xyzr", text);
  const std::map<int, std::string> found = fills(file.path(), {"--occlusion", "1"});
  ASSERT_EQ(found.count(1330), 1u);
  EXPECT_EQ(found.at(1330), "D2CDC3");                                     // a corner
  EXPECT_LT(brightness(found.at(665)), 0.6 * brightness(found.at(1330)));  // the middle
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
    expect_golden("caffeine", extension, {"--rotate", "60,25,0", "--width", "240"});
  }
  // The picture in README.md.
  expect_golden("crambin", ".svg", {});
}

}  // namespace
