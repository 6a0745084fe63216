// The picture of `contacts --map` shows the pairs that the list has, each twice, and larger areas in later shades.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "drawn_colours.hpp"
#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Pair = std::pair<int, int>;

// The shade of every square that is drawn; several squares of one place fail the test.
std::map<Pair, int> drawn_squares(const std::string &svg) {
  std::map<Pair, int> squares;
  static const std::regex path("<path fill=\"#[0-9a-f]{6}\" d=\"([^\"]*)\"/>"), square("M([0-9]+) ([0-9]+)h");
  int shade = 0;
  for (std::sregex_iterator p(svg.begin(), svg.end(), path), end; p != end; ++p, ++shade) {
    const std::string points = (*p)[1];
    for (std::sregex_iterator s(points.begin(), points.end(), square); s != end; ++s) {
      EXPECT_TRUE(squares.emplace(Pair{std::stoi((*s)[1]), std::stoi((*s)[2])}, shade).second) << s->str();
    }
  }
  return squares;
}

void expect_drawn(const std::string &svg, const std::map<Pair, double> &areas) {
  const std::map<Pair, int> squares = drawn_squares(svg);
  EXPECT_EQ(squares.size(), 2 * areas.size());
  std::map<int, std::pair<double, double>> range;  // of the areas in a shade
  for (const auto &[pair, area] : areas) {
    const auto one = squares.find(pair), other = squares.find({pair.second, pair.first});
    ASSERT_TRUE(one != squares.end() && other != squares.end()) << pair.first << ' ' << pair.second;
    EXPECT_EQ(one->second, other->second);
    auto &[least, most] = range.emplace(one->second, std::pair{area, area}).first->second;
    least = std::min(least, area);
    most = std::max(most, area);
  }
  double before = 0.0;
  for (const auto &[shade, areas_there] : range) {
    EXPECT_GT(areas_there.first, before) << shade;
    before = areas_there.second;
  }
}

TEST(ContactMap, ShowsThePairsOfBalls) {
  for (const char *file : {"good/water.pdb", "good/cage.xyzr", "good/one.xyzr", "good/same.xyzr"}) {
    const TemporaryFile picture("map.svg");
    const Json listed = run_json({"contacts", file, "--map", picture.path()});
    std::map<Pair, double> areas;
    for (const Json &pair : listed["pairs"].items) {
      if (pair["area"].number == 0.0) continue;
      const std::vector<Json> &balls = pair["balls"].items;
      areas[{static_cast<int>(balls.at(0).number), static_cast<int>(balls.at(1).number)}] = pair["area"].number;
    }
    expect_drawn(read_file(picture.path()), areas);
  }
}

TEST(ContactMap, ShowsThePairsOfResidues) {
  const TemporaryFile picture("map.svg");
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const Json listed =
      run_json({"contacts", crambin, "--by", "residue", "--least", "2", "--probe", "1.4", "--map", picture.path()});
  std::map<std::string, int> row;
  const Json measured = run_json({"measure", crambin, "--by", "residue"});
  for (const Json &residue : measured["residues"].items) {
    const std::string name =
        residue["chain"].text + ':' + residue["name"].text + ':' + residue["number"].text + residue["insertion"].text;
    ASSERT_TRUE(row.emplace(name, static_cast<int>(row.size())).second) << name;
  }
  std::map<Pair, double> areas;
  for (const Json &pair : listed["pairs"].items) {
    const std::vector<Json> &residues = pair["residues"].items;
    areas[{row.at(residues.at(0).text), row.at(residues.at(1).text)}] = pair["area"].number;
  }
  ASSERT_GT(areas.size(), 100u);
  const std::string svg = read_file(picture.path());
  expect_drawn(svg, areas);
  EXPECT_NE(svg.find(">45</text>"), std::string::npos);
  const size_t ten = svg.find(">10</text>", svg.find(">5</text>"));  // of 10A; 10B has none
  EXPECT_LT(ten, svg.find(">15</text>"));
  EXPECT_EQ(svg.find(">10", ten + 1), svg.find(">10</text>", ten + 1));
}

// The numbers that the shades end at, in order; each stands where its shade meets the next.
std::vector<double> shade_ends(const std::string &svg) {
  std::vector<double> ends;
  static const std::regex entry(
      "<rect x=\"([0-9.]+)\"[^>]* width=\"([0-9]+)\"[^>]*/>\n<text x=\"([0-9.]+)\" [^>]*>([^<]*)</text>");
  for (std::sregex_iterator e(svg.begin(), svg.end(), entry), end; e != end; ++e) {
    EXPECT_NEAR(std::stod((*e)[1]) + std::stod((*e)[2]), std::stod((*e)[3]), 0.1);
    ends.push_back(std::stod((*e)[4]));
  }
  return ends;
}

// Every end has two digits at most, each is above the one before, and the last one holds the largest area.
TEST(ContactMap, ShadesEndAtRoundNumbers) {
  for (const char *distance : {"0.1", "0.7", "1.1", "1.3", "1.55", "1.7", "1.83", "1.97", "1.999"}) {
    const TemporaryFile pair("pair.xyzr", "0 0 0 1\n" + std::string(distance) + " 0 0 1\n");
    const TemporaryFile picture("map.svg");
    const Json listed = run_json({"contacts", pair.path(), "--map", picture.path()});
    const double largest = listed["pairs"].items.at(0)["area"].number;
    const std::vector<double> ends = shade_ends(read_file(picture.path()));
    ASSERT_EQ(ends.size(), 6u);
    for (size_t k = 0; k < 6; ++k) {
      std::string digits = std::to_string(static_cast<long>(std::round(ends[k] * 1e6)));
      digits.erase(digits.find_last_not_of('0') + 1);
      EXPECT_LE(digits.size(), 2u) << ends[k];
      EXPECT_GT(ends[k], k == 0 ? 0.0 : ends[k - 1]);
    }
    EXPECT_GE(ends.back(), largest * (1 - 1e-9));
    EXPECT_LT(ends.back(), largest * 1.1);
  }
}

// Labels of one axis keep away from each other: letters are at most .6 of their size wide, as those of Helvetica are.
TEST(ContactMap, LabelsDoNotOverlap) {
  std::string atoms;
  for (int k = 0; k < 40; ++k) {
    char line[96];
    std::snprintf(line, sizeof line, "ATOM  %5d  C   ALA A%4d%c   %8.3f%8.3f%8.3f  1.00  0.00           C\n", k + 1,
                  1000 + k / 4, "ABCD"[k % 4], 1.5 * k, 0.0, 0.0);
    atoms += line;
  }
  const TemporaryFile file("many.pdb", atoms);
  const TemporaryFile picture("map.svg");
  ASSERT_EQ(run_program({"contacts", file.path(), "--by", "residue", "--map", picture.path()}).status, 0);
  const std::string whole = read_file(picture.path());
  const std::string svg = whole.substr(0, whole.find("<rect x="));  // without the scale
  static const std::regex label("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\" text-anchor=\"(end|middle)\">([0-9]+)<");
  double before[2] = {-1e9, -1e9};
  size_t labels = 0;
  for (std::sregex_iterator l(svg.begin(), svg.end(), label), end; l != end; ++l, ++labels) {
    const bool below = (*l)[3] == "middle";
    const double half = below ? 0.3 * 16 * static_cast<double>((*l)[4].length()) : 8;
    const double at = std::stod((*l)[below ? 1 : 2]);
    EXPECT_GT(at - half, before[below]) << (*l)[0];
    before[below] = at + half;
  }
  EXPECT_GE(labels, 4u);
  EXPECT_EQ(labels % 2, 0u);
  EXPECT_NE(svg.find(">residue, chain A<"), std::string::npos);
}

// No edge of a square lies between pixels: rows are whole pixels, and lines of a pixel are in the middle of one. A dark
// page has the same squares.
TEST(ContactMap, LiesOnWholePixels) {
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const TemporaryFile picture("map.svg"), dark("dark.svg");
  ASSERT_EQ(run_program({"contacts", crambin, "--by", "residue", "--map", picture.path()}).status, 0);
  ASSERT_EQ(run_program({"contacts", crambin, "--by", "residue", "--map", dark.path(), "--dark"}).status, 0);
  const std::string svg = read_file(picture.path());
  std::smatch found;
  ASSERT_TRUE(std::regex_search(svg, found, std::regex(" scale\\(([0-9.]+)\\)")));
  EXPECT_EQ(found[1], "14");  // 46 rows on 644 pixels
  ASSERT_TRUE(std::regex_search(svg, found, std::regex("stroke=\"#9a9a9a\" d=\"M([0-9.]+) ([0-9.]+)h([0-9.]+)v")));
  EXPECT_EQ(found[1], "87.5");
  EXPECT_EQ(found[2], "39.5");
  EXPECT_EQ(found[3], "645");
  EXPECT_EQ(drawn_squares(read_file(dark.path())), drawn_squares(svg));
  EXPECT_EQ(read_file(dark.path()).find("#ffffff"), std::string::npos);
}

// The shades go away from the page, and the first of them is seen on it.
TEST(ContactMap, ShadesAreSeenOnThePage) {
  static const std::regex page("<rect width=[^>]* fill=\"#([0-9a-f]{6})\""),
      shade("height=\"16\" fill=\"#([0-9a-f]{6})\"");
  for (const bool dark : {false, true}) {
    const TemporaryFile picture("map.svg");
    std::vector<std::string> call = {"contacts", crambin(), "--by", "residue", "--map", picture.path()};
    if (dark) call.emplace_back("--dark");
    ASSERT_EQ(run_program(call).status, 0);
    const std::string svg = read_file(picture.path());
    std::smatch before;
    ASSERT_TRUE(std::regex_search(svg, before, page));
    double least = dark ? 2.4 : 1.65;
    int shades = 0;
    for (std::sregex_iterator s(svg.begin(), svg.end(), shade), end; s != end; ++s, ++shades) {
      EXPECT_GT(contrast((*s)[1], before[1]), least) << (*s)[1];
      least = 1.3 * contrast((*s)[1], before[1]);
    }
    EXPECT_EQ(shades, 6);
  }
}

TEST(ContactMap, IsRefusedWhereItHasNoPlace) {
  EXPECT_EQ(run_program({"contacts", "good/water.pdb", "good/two.xyzr", "--map", "map.svg"}).status, 2);
  EXPECT_EQ(run_program({"contacts", "good/water.pdb", "--map", "map.png"}).status, 2);
  const TemporaryFile read("water.svg", read_file(inputs_folder() + "/good/water.pdb"));
  EXPECT_EQ(run_program({"contacts", read.path(), "--format", "pdb", "--map", read.path()}).status, 2);
  EXPECT_EQ(run_program({"contacts", "good/water.pdb", "--map", "-", "--json"}).status, 2);
  EXPECT_EQ(run_program({"contacts", "good/water.pdb", "--map", "nowhere/map.svg"}).status, 1);
  const Outcome printed = run_program({"contacts", "good/water.pdb", "--map", "-"});
  EXPECT_EQ(printed.status, 0);
  EXPECT_EQ(printed.out.rfind("<svg", 0), 0u);
}

}  // namespace
