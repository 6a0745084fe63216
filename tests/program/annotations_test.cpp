// hardsphere draw --label, --scale-bar and --legend: what is written over a picture, and where.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "drawn_colours.hpp"
#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

struct Text {
  double x, y, size;
  std::string anchor, text;
};
struct Line {
  double from[2], to[2], width;
};

double number_after(const std::string &text, const std::string &key) {
  const size_t at = text.find(key);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + key.size()));
}
std::string word_after(const std::string &text, const std::string &key, const std::string &end) {
  const size_t at = text.find(key);
  if (at == std::string::npos) return "";
  return text.substr(at + key.size(), text.find(end, at + key.size()) - at - key.size());
}

std::vector<std::string> elements(const std::string &svg, const std::string &head) {
  std::vector<std::string> found;
  for (size_t at = svg.find(head); at != std::string::npos; at = svg.find(head, at + 1)) {
    found.push_back(svg.substr(at, svg.find('\n', at) - at));
  }
  return found;
}

// Every text stands there twice, first its seam.
std::vector<Text> texts_of(const std::string &svg) {
  std::vector<Text> texts;
  for (const std::string &one : elements(svg, "<text ")) {
    if (one.find("fill=\"none\"") != std::string::npos) continue;
    texts.push_back({number_after(one, " x=\""), number_after(one, " y=\""), number_after(one, "font-size=\""),
                     word_after(one, "text-anchor=\"", "\""), word_after(one, ">", "<")});
  }
  return texts;
}
std::vector<Line> lines_of(const std::string &svg) {
  std::vector<Line> lines;
  for (const std::string &one : elements(svg, "<path stroke=")) {
    const std::string to = word_after(one, "L", "\"");
    const std::string from = word_after(one, "d=\"M", "L");
    lines.push_back({{std::stod(from), std::stod(from.substr(from.find(' ')))},
                     {std::stod(to), std::stod(to.substr(to.find(' ')))},
                     number_after(one, "stroke-width=\"")});
  }
  return lines;
}

// A ball that is seen whole is named in its middle, with its letters half their height above the line that they are on.
TEST(Annotations, LabelsStandInTheMiddle) {
  const TemporaryFile pair("pair.xyz", "2\n\nC 1 2 3\nO 9 4 3\n");
  for (const char *unit : {"px", "mm"}) {
    const std::string svg =
        drawn(pair.path(), {"--label", "atom", "--style", "flat", "--view", "0,0,1", "--unit", unit});
    const std::vector<Text> texts = texts_of(svg);
    const std::vector<std::string> paths = elements(svg, "<circle data-ball=");
    ASSERT_EQ(texts.size(), 2u);
    ASSERT_EQ(paths.size(), 2u);
    for (size_t k = 0; k < 2; ++k) {
      const bool oxygen = paths[k].find("data-ball=\"1\"") != std::string::npos;
      const Text &text = texts[oxygen ? 1 : 0];
      EXPECT_EQ(text.text, oxygen ? "O2" : "C1");
      EXPECT_EQ(text.anchor, "middle");
      const double radius = number_after(paths[k], " r=\"");
      const double at[2] = {number_after(paths[k], " cx=\""), number_after(paths[k], " cy=\"")};
      EXPECT_NEAR(text.x, at[0], 0.02 * radius) << unit;
      EXPECT_NEAR(text.y - 0.36 * text.size, at[1], 0.02 * radius) << unit;
    }
  }
}

// Balls of balls and sticks, too.
TEST(Annotations, LabelsOfBallsAndSticks) {
  const TemporaryFile chain("chain.xyz", "3\n\nC 0 0 0\nO 1.2 0 0\nO -1.2 0 0\n");
  const std::vector<std::string> options = {"--as",    "ball-and-stick", "--label", "atom", "--view",  "0,0,1",
                                            "--style", "flat",           "--scale", "300",  "--width", "1000"};
  std::vector<std::string> visible = options;
  visible.insert(visible.end(), {"--pieces", "visible"});
  EXPECT_EQ(texts_of(drawn(chain.path(), visible)).size(), 3u);
  const std::vector<Text> texts = texts_of(drawn(chain.path(), options));
  ASSERT_EQ(texts.size(), 3u);
  const std::vector<std::pair<std::string, double>> expected = {{"C1", 500}, {"O2", 860}, {"O3", 140}};
  for (size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(texts[k].text, expected[k].first);
    EXPECT_EQ(texts[k].anchor, "middle");
    EXPECT_NEAR(texts[k].x, expected[k].second, 3);
    EXPECT_NEAR(texts[k].y - 0.36 * texts[k].size, 500, 3);
  }
}

// Left, top, right and bottom of its letters, at least.
std::array<double, 4> box_of(const Text &text) {
  const double width = 0.45 * text.size * static_cast<double>(text.text.size());
  const double left = text.x - width * (text.anchor == "start" ? 0 : text.anchor == "middle" ? 0.5 : 1);
  return {left, text.y - 0.72 * text.size, left + width, text.y};
}

// Whether a line comes into a box.
bool meets(const Line &line, const std::array<double, 4> &box) {
  for (int k = 0; k <= 1000; ++k) {
    const double x = line.from[0] + k / 1000.0 * (line.to[0] - line.from[0]);
    const double y = line.from[1] + k / 1000.0 * (line.to[1] - line.from[1]);
    if (x > box[0] && x < box[2] && y > box[1] && y < box[3]) return true;
  }
  return false;
}

bool cross(const Line &a, const Line &b) {
  const auto side = [](const Line &line, const double at[2]) {
    return (line.to[0] - line.from[0]) * (at[1] - line.from[1]) - (line.to[1] - line.from[1]) * (at[0] - line.from[0]);
  };
  return side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
}

bool is_dot(const Line &line) {
  return line.from[0] == line.to[0] && line.from[1] == line.to[1];
}

// Lines without their seams, and without the dots at their ends.
std::vector<Line> leaders_of(const std::string &svg, double size) {
  std::vector<Line> leaders;
  for (const Line &line : lines_of(svg)) {
    if (!is_dot(line) && line.width < 0.1 * size) leaders.push_back(line);
  }
  return leaders;
}

// Whether the text may end there, a letter being half its size wide and a blank as much behind it.
bool ends_at(const Text &text, double x) {
  const double letters = (x - text.x) / text.size;
  return letters > 0.45 * static_cast<double>(text.text.size()) &&
         letters < 0.75 * static_cast<double>(text.text.size());
}

// A label without room is named beside its ball, or at the end of a line that ends on one of its atoms and is level,
// upright or goes at 45 degrees; labels lie over no other label, and lines cross no label and no line.
TEST(Annotations, LinesLeadToWhatIsNamed) {
  const double scale = 20;
  const std::vector<std::string> options = {"--view",   "0,0,1",  "--style", "flat", "--scale", "20",
                                            "--centre", "9,10,7", "--width", "800",  "--label", "residue"};
  const std::string svg = drawn(crambin(), options);
  const std::vector<Text> texts = texts_of(svg);
  EXPECT_GT(texts.size(), 30u);
  const std::vector<std::string> atoms = atoms_of(crambin());
  const std::vector<Line> lines = leaders_of(svg, texts[0].size);
  EXPECT_GT(lines.size(), 20u);
  size_t looked_at = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    const Line &line = lines[i];
    const double way[2] = {std::fabs(line.to[0] - line.from[0]), std::fabs(line.to[1] - line.from[1])};
    EXPECT_TRUE(way[0] < 0.011 || way[1] < 0.011 || std::fabs(way[0] - way[1]) < 0.021) << way[0] << ' ' << way[1];
    for (const Text &text : texts) EXPECT_FALSE(meets(line, box_of(text))) << text.text;
    for (size_t k = 0; k < i; ++k) EXPECT_FALSE(cross(line, lines[k]));
    const Text *named = nullptr;
    for (const Text &text : texts) {
      const std::array<double, 4> box = box_of(text);
      const bool level = std::fabs(text.y - 0.36 * text.size - line.from[1]) < 0.02 && text.anchor != "middle" &&
                         (std::fabs(text.x - line.from[0]) < 0.5 * text.size || ends_at(text, line.from[0]));
      const bool upright = text.anchor == "middle" && std::fabs(text.x - line.from[0]) < 0.02 &&
                           std::fabs((box[1] + box[3]) / 2 - line.from[1]) < 1.1 * text.size;
      if (level || upright) named = &text;
    }
    const bool bent = i + 1 < lines.size() && lines[i + 1].from[0] == line.to[0] && lines[i + 1].from[1] == line.to[1];
    if (named == nullptr || looked_at == 12) continue;  // the other half of a bent one
    const double *const end = bent ? lines[i + 1].to : line.to;
    const double x = 9 + (end[0] - 400) / scale;
    const double y = 10 - (end[1] - 400) / scale;
    const Json seen =
        run_json({"pick", crambin(), "--view", "0,0,1", "--at", std::to_string(x) + "," + std::to_string(y)});
    const std::string &atom = atoms.at(static_cast<size_t>(seen["ball"].number));
    EXPECT_EQ(named->text, atom.substr(17, 3) + " " + std::to_string(std::stoi(atom.substr(22, 4))) +
                               (atom[26] == ' ' ? "" : atom.substr(26, 1)));
    ++looked_at;
  }
  EXPECT_EQ(looked_at, 12u);
  for (size_t i = 0; i < texts.size(); ++i) {
    const std::array<double, 4> box = box_of(texts[i]);
    EXPECT_GT(box[1], 0);
    EXPECT_LT(box[3], 800);
    for (size_t k = 0; k < i; ++k) {
      const std::array<double, 4> other = box_of(texts[k]);
      const bool apart = box[2] < other[0] || other[2] < box[0] || box[3] < other[1] || other[3] < box[1];
      EXPECT_TRUE(apart) << texts[i].text << " and " << texts[k].text;
    }
  }
}

// Hydrogens of caffeine stand beside their balls, without lines; oxygens within theirs, on a wide page, too.
TEST(Annotations, NamesStandBesideSmallBalls) {
  for (const char *look : {"paper", "slide"}) {
    const std::string svg = drawn(molecules_folder() + "/caffeine.pdb",
                                  {"--as", "ball-and-stick", "--label", "atom", "--rotate", "10,40,0", "--look", look});
    EXPECT_TRUE(lines_of(svg).empty()) << look;
    for (const Text &text : texts_of(svg)) {
      EXPECT_TRUE(text.text[0] != 'O' || text.anchor == "middle") << text.text;
      EXPECT_NE(text.anchor, "end") << text.text;  // some programs have the ink of a 1 end there
    }
  }
}

// Names of bridges keep a third of a letter apart, before a light page and before a dark one.
TEST(Annotations, LabelsOfBridgesAreApart) {
  for (const char *look : {"paper", "slide"}) {
    const std::string svg = drawn(crambin(), {"--as", "ball-and-stick", "--highlight", "residue:CYS", "--view",
                                              "highlight", "--label", "residue", "--style", "flat", "--look", look});
    const std::vector<Text> texts = texts_of(svg);
    ASSERT_EQ(texts.size(), 6u);
    const double size = texts[0].size;
    for (size_t i = 0; i < texts.size(); ++i) {
      const std::array<double, 4> box = box_of(texts[i]);
      for (size_t k = 0; k < i; ++k) {
        const std::array<double, 4> other = box_of(texts[k]);
        const double across = std::max(other[0] - box[2], box[0] - other[2]);
        EXPECT_GT(std::max({across, other[1] - box[3], box[1] - other[3]}), 0.33 * size) << texts[i].text;
      }
    }
  }
}

// A line that ends on another ball than its own seems to name that one.
TEST(Annotations, LinesEndBesideOtherBalls) {
  const std::string svg = drawn(crambin(), {"--as", "ball-and-stick", "--highlight", "residue:CYS", "--view",
                                            "highlight", "--label", "residue", "--style", "flat", "--look", "paper"});
  size_t ends = 0;
  for (const Text &text : texts_of(svg)) {
    for (const Line &line : leaders_of(svg, text.size)) {
      const bool level = std::fabs(line.from[1] - (text.y - 0.36 * text.size)) < 1;
      if (!level || std::fabs(line.from[0] - text.x) > 0.3 * text.size) continue;
      ++ends;
      for (const std::string &ball : elements(svg, "<circle data-ball=")) {
        const double x = number_after(ball, " cx=\"") - line.from[0], y = number_after(ball, " cy=\"") - line.from[1];
        EXPECT_GT(std::hypot(x, y), number_after(ball, " r=\"") - 2) << text.text;
      }
    }
  }
  EXPECT_GE(ends, 3u);
}

TEST(Annotations, OnlyWhatIsHighlightedIsNamed) {
  const std::string svg = drawn(crambin(), {"--label", "residue", "--highlight", "residue:CYS"});
  const std::vector<Text> texts = texts_of(svg);
  EXPECT_GE(texts.size(), 3u);
  for (const Text &text : texts) EXPECT_EQ(text.text.substr(0, 4), "CYS ");
  const std::vector<Text> zinc =
      texts_of(drawn(molecules_folder() + "/sod_stand_in.pdb", {"--label", "residue", "--highlight", "residue:CU,ZN"}));
  ASSERT_FALSE(zinc.empty());
  for (const Text &text : zinc) EXPECT_EQ(std::count(text.text.begin(), text.text.end(), ' '), 2) << text.text;
  const std::vector<Text> chain = texts_of(drawn(crambin(), {"--label", "chain"}));
  ASSERT_EQ(chain.size(), 1u);
  EXPECT_EQ(chain[0].text, "A");
}

// Of many directions the one from which most of the highlighted atoms is seen, all the three bridges at once.
TEST(Annotations, ViewsOfWhatIsHighlighted) {
  const std::vector<std::string> options = {"--as", "ball-and-stick", "--highlight", "residue:CYS", "--style", "flat"};
  const auto largest_seen = [&](const std::string &view) {
    std::vector<std::string> all = options;
    all.insert(all.end(), {"--label", "residue", "--view", view});
    std::map<std::string, int> dots;
    const std::string svg = drawn(crambin(), all);
    for (const Line &line : lines_of(svg)) dots["dots"] += is_dot(line) ? 1 : 0;
    EXPECT_EQ(texts_of(svg).size(), 6u) << view;
    return dots["dots"];
  };
  EXPECT_EQ(largest_seen("highlight"), 12);  // none is hidden: each has a dot and its seam
  // An oxygen behind a plate of carbons is seen from its own side.
  std::string atoms = "50\n\nO 0 0 -2.5\n";
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      atoms += "C " + std::to_string(1.5 * x) + " " + std::to_string(1.5 * y) + " 0\n";
    }
  }
  const TemporaryFile plate("plate.xyz", atoms);
  const std::vector<Text> oxygen = texts_of(
      drawn(plate.path(), {"--style", "flat", "--highlight", "element:O", "--label", "atom", "--view", "highlight"}));
  ASSERT_EQ(oxygen.size(), 1u);
  EXPECT_EQ(oxygen[0].text, "O1");
  const Outcome of_all = run_program({"draw", crambin(), "-o", "-", "--view", "highlight"});
  EXPECT_EQ(of_all.status, 0) << of_all.err;
  for (const char *command : {"map", "mesh"}) {
    EXPECT_EQ(run_program({command, crambin(), "--view", "highlight"}).status, 2) << command;
  }
}

// A name that just has room beside its atom stands there, and not at the end of a line across half the molecule.
TEST(Annotations, LinesAreShort) {
  const std::string svg = drawn(crambin(), {"--as", "ball-and-stick", "--highlight", "residue:CYS", "--view",
                                            "highlight", "--label", "residue", "--scale-bar", "--legend"});
  const std::vector<Line> lines = lines_of(svg);
  EXPECT_GT(lines.size(), 24u);  // each with its seam, and the dots
  for (const Line &line : lines) {
    EXPECT_LT(std::hypot(line.to[0] - line.from[0], line.to[1] - line.from[1]), 200) << line.from[0];
  }
}

// The bar is as long as its text says: 1, 2 or 5 of a power of ten, at most a fifth of the page.
TEST(Annotations, ScaleBars) {
  for (const auto &[scale, length] : {std::pair<int, double>{20, 5}, {12, 10}, {7, 10}, {100, 1}, {500, 0.2}}) {
    const std::string svg = drawn(crambin(), {"--scale", std::to_string(scale), "--width", "600", "--scale-bar"});
    const std::vector<Text> texts = texts_of(svg);
    const std::vector<Line> lines = lines_of(svg);
    ASSERT_EQ(texts.size(), 1u);
    ASSERT_EQ(lines.size(), 6u);
    EXPECT_NEAR(lines[0].to[0] - lines[0].from[0], length * scale, 0.011);
    EXPECT_EQ(texts[0].text, (length < 1 ? "0.2" : std::to_string(static_cast<int>(length))) + " \xC3\x85");
    EXPECT_LE(length * scale, 120);
    EXPECT_GT(2.5 * length * scale, 120 * 0.999);
  }
  // With units of one's own.
  const TemporaryFile ball("ball.xyzr", "0 0 0 7\n");
  EXPECT_EQ(texts_of(drawn(ball.path(), {"--scale-bar"})).at(0).text, "2");
}

TEST(Annotations, LegendsOfElements) {
  const std::string svg = drawn(molecules_folder() + "/caffeine.pdb", {"--legend", "--style", "flat", "--fog", "0"});
  const std::vector<Text> texts = texts_of(svg);
  ASSERT_EQ(texts.size(), 4u);
  std::vector<std::string> names;
  std::vector<std::string> squares;
  for (const Text &text : texts) names.push_back(text.text);
  for (const std::string &one : elements(svg, "<rect x=")) squares.push_back(word_after(one, "fill=\"#", "\""));
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"C", "H", "N", "O"}));
  ASSERT_EQ(squares.size(), 8u);  // each in a frame
  for (size_t k = 1; k < 8; k += 2) {
    const std::string fill = " fill=\"#" + squares[k] + "\" ";  // a ball has it
    EXPECT_TRUE(svg.find(fill + "d=") != std::string::npos || svg.find(fill + "c") != std::string::npos) << squares[k];
  }
}

// Swatches have the mean tones that are seen: darker where balls are darkened, but not as dark as the darkest one.
TEST(Annotations, SwatchesAreAsDarkAsBalls) {
  std::vector<std::string> swatches[2];
  for (const int dark : {0, 1}) {
    const std::string svg =
        drawn(crambin(), {"--legend", "--style", "flat", "--fog", "0", "--occlusion", dark == 1 ? "1" : "0"});
    for (const std::string &one : elements(svg, "<rect x=")) {
      swatches[dark].push_back(word_after(one, "fill=\"#", "\""));
    }
    ASSERT_EQ(swatches[dark].size(), 8u);
  }
  for (size_t k = 1; k < 8; k += 2) {  // each in a frame
    for (size_t channel = 0; channel < 6; channel += 2) {
      EXPECT_LT(swatches[1][k].substr(channel, 2), swatches[0][k].substr(channel, 2));
      EXPECT_GT(std::stoi(swatches[1][k].substr(channel, 2), nullptr, 16),
                std::stoi(swatches[0][k].substr(channel, 2), nullptr, 16) * 0.42);
    }
  }
}

// Likewise in fog: where each colour is that of one ball, the swatch has the colour of the ball. Of flat molecules the
// farthest is not as pale as of deep ones.
TEST(Annotations, SwatchesAreAsPaleAsBalls) {
  const TemporaryFile deep("deep.xyz", "3\n\nC 0 0 0\nN 4 0 -6\nO 8 0 -12\n");
  const TemporaryFile flat("flat.xyz", "3\n\nC 0 0 0\nN 4 0 -0.5\nO 8 0 -1\n");
  for (const TemporaryFile *const file : {&deep, &flat}) {
    for (const char *const as : {"balls", "ball-and-stick"}) {
      for (const char *const fog : {"0", "0.8"}) {
        const std::string svg = drawn(file->path(), {"--legend", "--style", "flat", "--fog", fog, "--background=102030",
                                                     "--view=0,0,1", "--occlusion=0", "--as", as});
        const std::vector<std::string> squares = elements(svg, "<rect x=");
        ASSERT_EQ(squares.size(), 6u);
        for (size_t k = 1; k < 6; k += 2) {  // each in a frame
          const std::string colour = word_after(squares[k], "fill=\"#", "\"");
          EXPECT_NE(svg.find(" fill=\"#" + colour + "\" c"), std::string::npos) << as << " " << fog << " " << colour;
        }
      }
    }
  }
}

TEST(Annotations, LegendsOfNumbersAndChains) {
  const std::string svg = drawn(crambin(), {"--legend", "--colour", "bfactor", "--range", "2.5,15"});
  const std::vector<Text> texts = texts_of(svg);
  ASSERT_EQ(texts.size(), 3u);
  EXPECT_EQ(texts[0].text, "15");
  EXPECT_EQ(texts[1].text, "2.5");
  EXPECT_EQ(texts[2].text, "B factor, \xC3\x85\xC2\xB2");
  EXPECT_LT(texts[1].x, texts[0].x);
  const std::vector<std::string> parts = elements(svg, "<rect x=");
  ASSERT_EQ(parts.size(), 65u);
  EXPECT_EQ(word_after(parts.front(), "fill=\"#", "\""), "3f74b5");
  EXPECT_EQ(word_after(parts.back(), "fill=\"#", "\""), "c2452f");
  const std::vector<Text> chains = texts_of(drawn(molecules_folder() + "/sod_stand_in.pdb", {"--legend"}));
  std::vector<std::string> names;
  for (auto chain = chains.rbegin(); chain != chains.rend(); ++chain) names.push_back(chain->text);
  EXPECT_EQ(names, (std::vector<std::string>{"chains", "A", "B", "C", "D", "Cu", "Zn"}));
  // Kinds of residues that are found: the one methionine is two patches a few px wide, from another side an atom.
  std::vector<std::string> kinds = {"residues", "positive",    "negative",  "polar",
                                    "aromatic", "with sulfur", "aliphatic", "glycine"};
  for (const char *const turn : {"--rotate=0,180,0", "--rotate=0,0,0", "--rotate=0,-90,0"}) {
    names.clear();
    for (const Text &kind :
         texts_of(drawn(molecules_folder() + "/ubiquitin.pdb", {"--legend", "--colour", "residue", turn}))) {
      names.insert(names.begin(), kind.text);
    }
    EXPECT_EQ(names, kinds);
    if (kinds.size() == 8) kinds.erase(kinds.begin() + 5);
  }
  const std::string svg_of_others =
      drawn(crambin(), {"--legend", "--highlight", "residue:CYS", "--style", "flat", "--fog", "0", "--occlusion", "0"});
  const std::vector<Text> muted = texts_of(svg_of_others);
  ASSERT_EQ(muted.size(), 5u);
  EXPECT_EQ(muted[0].text, "others");
  EXPECT_EQ(muted[1].text, "S");
  // These keep some of their own colours, so that their swatch has those of C, N and O; all of them are drawn.
  const std::vector<std::string> stripes = elements(svg_of_others, "<rect x=");
  ASSERT_EQ(stripes.size(), 4 + 8u);  // with frames
  std::set<std::string> others;
  for (size_t k = 1; k <= 3; ++k) {
    others.insert(word_after(stripes[k], "fill=\"#", "\""));
    EXPECT_NE(svg_of_others.find(" fill=\"#" + *others.rbegin() + "\" c"), std::string::npos);
  }
  EXPECT_EQ(others.size(), 3u);
  const std::vector<Text> bands = texts_of(drawn(crambin(), {"--legend", "--colour", "plddt"}));
  ASSERT_EQ(bands.size(), 5u);
  EXPECT_EQ(bands[3].text, "&gt; 90");
  EXPECT_EQ(bands[4].text, "pLDDT");
}

// Many chains have a legend, too, within the page: of smaller letters, and where these are small enough of fewer names.
TEST(Annotations, LegendsOfManyChains) {
  for (const size_t count : {21u, 62u}) {
    std::string text;
    for (size_t i = 0; i < count; ++i) {
      char line[100];
      const char chain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"[count - 1 - i];
      std::snprintf(line, sizeof line, "ATOM  %5d  CA  ALA %c   1    %8.3f%8.3f%8.3f  1.00  0.00           C\n",
                    static_cast<int>(i), chain, 5.0 * static_cast<double>(i), 0.0, 0.0);
      text += line;
    }
    const TemporaryFile file("chains.pdb", text);
    std::vector<Text> texts = texts_of(drawn(file.path(), {"--legend", "--palette", "chain", "--scale-bar"}));
    texts.erase(texts.begin());  // of the scale bar
    const bool all = count == 21;
    EXPECT_EQ(texts.front().text, all ? "U" : "..");
    EXPECT_EQ(texts.back().text, "chains");
    EXPECT_EQ(texts[texts.size() - 2].text, count == 21 ? "A" : "0");  // digits come before letters
    EXPECT_EQ(texts.size() == count + 1, all);
    EXPECT_GT(texts.back().x, 345);  // beside the scale bar
    for (const Text &one : texts) EXPECT_LT(one.x + one.size, 1000);
  }
}

// An atom of which less is seen than the dot would cover has a ring: a dot of the seam's colour in the dot. Where more
// is seen no line is needed.
TEST(Annotations, RingsWhereLittleIsSeen) {
  const TemporaryFile hidden("hidden.xyz", "2\n\nC 0 0 0\nO 0.7 0 -4\n");
  const std::vector<std::string> options = {"--label", "atom", "--style", "flat", "--view", "0,0,1", "--radius"};
  for (const auto &[radius, dots] :
       {std::pair<const char *, int>{"C=1.7,O=1.02", 3}, {"C=1.7,O=1.05", 2}, {"C=1.7,O=1.1", 0}}) {
    std::vector<std::string> all = options;
    all.emplace_back(radius);
    int found = 0;
    for (const Line &line : lines_of(drawn(hidden.path(), all))) {
      found += line.from[0] == line.to[0] && line.from[1] == line.to[1];
    }
    EXPECT_EQ(found, dots) << radius;
  }
}

// Charges: red below nothing, blue above, white at nothing; the larger end decides.
TEST(Annotations, Charges) {
  const TemporaryFile ions("ions.pqr",
                           "ATOM 1 CL X A 1 0 0 0 -0.5 1\nATOM 2 NA X A 1 5 0 0 1 1\nATOM 3 AR X A 1 9 0 0 0 1\n");
  std::map<int, std::string> found = fills(ions.path(), {"--colour", "charge"});
  EXPECT_EQ(found[1], "3F74B5");
  EXPECT_EQ(found[2], "E8E8E8");
  EXPECT_GT(std::stoi(found[0].substr(0, 2), nullptr, 16), std::stoi(found[0].substr(4, 2), nullptr, 16) + 40);
  found = fills(ions.path(), {"--colour", "charge", "--range=-0.5,0.5"});
  EXPECT_EQ(found[0], "C2452F");
  const std::vector<Text> texts = texts_of(drawn(ions.path(), {"--colour", "charge", "--legend"}));
  ASSERT_EQ(texts.size(), 3u);
  EXPECT_EQ(texts[0].text, "1");
  EXPECT_EQ(texts[1].text, "-1");
}

std::string charged(const std::string &type, const std::string &last) {
  return "@<TRIPOS>MOLECULE\nx\n3 0\nSMALL\n" + type +
         "\n@<TRIPOS>ATOM\n1 CL 0 0 0 Cl 1 X1 -0.5\n2 NA 5 0 0 Na 1 X1 1\n3 AR 9 0 0 Ar 1 X1" + last + '\n';
}

// The same charges in a .mol2 file; there some atoms may have none, or all by what the file says.
TEST(Annotations, ChargesOfMol2Files) {
  const TemporaryFile pqr("ions.pqr",
                          "ATOM 1 CL X A 1 0 0 0 -0.5 1\nATOM 2 NA X A 1 5 0 0 1 1\nATOM 3 AR X A 1 9 0 0 0 1\n");
  const std::vector<std::string> options = {"--colour", "charge", "--view", "0,0,1"};
  const TemporaryFile ions("ions.mol2", charged("GASTEIGER", " 0.0"));
  EXPECT_EQ(fills(ions.path(), options), fills(pqr.path(), options));
  const TemporaryFile without("without.mol2", charged("# none\nNO_CHARGES", " 0.0")),
      lacking("some.mol2", charged("X", "")), no_number("text.mol2", charged("X", " none")), out("x.svg");
  for (const auto &[file, line] : {std::pair{&without, "8"}, {&lacking, "9"}, {&no_number, "9"}}) {
    const Outcome outcome = run_program({"draw", file->path(), "-o", out.path(), "--colour", "charge"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find(std::string(".mol2:") + line + ": no charge for --colour charge"), std::string::npos)
        << outcome.err;
  }
}

// A page has room for what is written, and what is written is within; EPS holds the same.
TEST(Annotations, HaveRoom) {
  const std::string file = molecules_folder() + "/caffeine.pdb";
  const TemporaryFile out("room.svg");
  const Json json = run_json({"draw", file, "-o", out.path(), "--label", "atom", "--scale-bar", "--legend"});
  const std::string svg = read_file(out.path());
  EXPECT_EQ(json["bytes"].number, static_cast<double>(svg.size()));
  EXPECT_EQ(json["width"].number, 1000);
  EXPECT_EQ(svg.substr(svg.size() - 13), "\n</g>\n</svg>\n");
  for (const Text &text : texts_of(svg)) {
    EXPECT_GT(text.y, text.size);
    EXPECT_LT(text.y, json["height"].number);
    const double width = 0.6 * text.size * static_cast<double>(text.text.size());
    const double left = text.x - width * (text.anchor == "start" ? 0 : text.anchor == "middle" ? 0.5 : 1);
    EXPECT_GT(left, 0) << text.text;
    EXPECT_LT(left + width, 1000) << text.text;
  }
  const std::string eps = drawn(file, {"--label", "atom", "--scale-bar", "--legend"}, ".eps");
  EXPECT_NE(eps.find("\\305"), std::string::npos);
  EXPECT_NE(eps.find("\ngrestore\nshowpage\n%%Trailer\nrestore end\n%%EOF\n"), std::string::npos);
  if (std::system("command -v gs >/dev/null 2>&1") == 0) {
    const TemporaryFile written("room.eps", eps);
    EXPECT_EQ(std::system(("gs -q -dSAFER -dBATCH -dNOPAUSE -sDEVICE=nullpage " + written.path()).c_str()), 0);
  }
}

// An object of a file that has been updated, by the table of the update or, if that does not have it, by that before.
size_t place_of(const std::string &pdf, const std::string &table_of_update, int object) {
  // One line for each of the objects 3, 11 and 12: in use, place, generation.
  const size_t line = table_of_update.find("\nstream\n") + 8 + 23 * (object == 3 ? 0U : object == 11 ? 1U : 2U);
  EXPECT_EQ(table_of_update.substr(line, 2), "01");
  EXPECT_EQ(table_of_update.substr(line + 18, 5), "0000\n");
  const size_t place = std::stoul(table_of_update.substr(line + 2, 16), nullptr, 16);
  const std::string head = std::to_string(object) + " 0 obj\n";
  EXPECT_EQ(pdf.substr(place, head.size()), head);
  return place;
}

TEST(Annotations, AreAnUpdateOfPdfFiles) {
  const std::string caffeine = molecules_folder() + "/caffeine.pdb";
  const std::string pdf = drawn(caffeine, {"--label", "atom", "--scale-bar", "--legend"}, ".pdf");
  const size_t first_end = pdf.find("%%EOF\n");
  ASSERT_NE(first_end, std::string::npos);
  const std::string before = pdf.substr(0, first_end + 6);
  const std::string old_table = word_after(before, "\nstartxref\n", "\n");
  const size_t start = std::stoul(word_after(pdf.substr(before.size()), "\nstartxref\n", "\n"));
  const std::string table = pdf.substr(start);
  EXPECT_EQ(table.rfind("12 0 obj\n<</Type/XRef/Size 13/Index[3 1 11 2]/W[1 8 2]/Root 1 0 R/Info 7 0 R/Prev " +
                            old_table + "/Filter/ASCIIHexDecode/Length 70>>\nstream\n",
                        0),
            0U)
      << table;
  EXPECT_EQ(word_after(table, "stream\n", "endstream").size(), 71U);
  EXPECT_EQ(place_of(pdf, table, 12), start);
  const std::string page = pdf.substr(place_of(pdf, table, 3));
  EXPECT_EQ(page.find("<</Type/Page/Parent 2 0 R/Resources 4 0 R/Contents[5 0 R 11 0 R]/MediaBox[0 0 "), 8U);
  EXPECT_NEAR(number_after(page, "/MediaBox[0 0 "), number_after(before, "/MediaBox[0 0 "), 1e-6);
  EXPECT_NEAR(std::stod(word_after(word_after(page, "/MediaBox[0 0 ", "]"), " ", "]")),
              std::stod(word_after(word_after(before, "/MediaBox[0 0 ", "]"), " ", "]")), 1e-6);
  const std::string over = pdf.substr(place_of(pdf, table, 11));
  const auto length = static_cast<size_t>(number_after(over, "<</Length "));
  EXPECT_EQ(over.substr(over.find("stream\n") + 7 + length, 11), "\nendstream\n");
  EXPECT_NE(over.find("\\305) Tj"), std::string::npos);
  if (std::system("command -v pdftotext >/dev/null 2>&1") != 0) GTEST_SKIP() << "pdftotext is missing";
  const TemporaryFile written("labels.pdf", pdf);
  const TemporaryFile text("labels.txt", "");
  ASSERT_EQ(std::system(("pdftotext -enc UTF-8 " + written.path() + " " + text.path()).c_str()), 0);
  const std::string found = read_file(text.path());
  for (const char *label : {"C10", "N1", "O13", "H142", "2\xC3\x85"}) {
    EXPECT_NE(found.find(label), std::string::npos) << label << " is not in " << found;
  }
}

// Where SVG has the middle of a text, or its end, PDF begins that much to the left of it: widths of Helvetica.
TEST(Annotations, TextsInPdfAreWhereSvgHasThem) {
  const std::string caffeine = molecules_folder() + "/caffeine.pdb";
  const std::vector<std::string> options = {"--label", "atom", "--width", "500", "--height", "400", "--unit", "px"};
  const std::string svg = drawn(caffeine, options);
  const std::string pdf = drawn(caffeine, options, ".pdf");
  const std::map<char, double> widths = {{'C', 0.722}, {'H', 0.722}, {'N', 0.722}, {'O', 0.778}};
  for (const Text &text : texts_of(svg)) {
    const double width = (widths.at(text.text[0]) + 0.556 * static_cast<double>(text.text.size() - 1)) * text.size;
    const double x = text.x - (text.anchor == "middle" ? 0.5 : text.anchor == "end" ? 1.0 : 0.0) * width;
    char expected[128];
    std::snprintf(expected, sizeof expected, "BT /F1 %.3f Tf 0 Tr ", text.size);
    const size_t at = pdf.rfind('(' + text.text + ") Tj");  // before it may come the seam
    ASSERT_NE(at, std::string::npos) << text.text;
    const size_t line = pdf.rfind('\n', at) + 1;
    EXPECT_EQ(pdf.substr(line, std::string(expected).size()), expected);
    double found[2];
    ASSERT_EQ(std::sscanf(pdf.c_str() + line + std::string(expected).size(), "%lf %lf Td", &found[0], &found[1]), 2);
    EXPECT_NEAR(found[0], x, 0.02) << text.text;
    EXPECT_NEAR(found[1], 400 - text.y, 0.02) << text.text;
  }
  EXPECT_GE(texts_of(svg).size(), 15U);
}

TEST(Annotations, Refusals) {
  const std::string caffeine = molecules_folder() + "/caffeine.pdb";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"draw", caffeine, "-o", "none/x.svg", "--label", "name"}, "atom, residue or chain"},
      {{"draw", "good/water.xyz", "-o", "none/x.svg", "--label", "chain"}, "the file names no residues"},
      {{"draw", caffeine, "-o", "none/x.svg", "--colour", "charge"}, ".pqr, .mol2 and .pdbqt files"}};
  for (const auto &[arguments, complaint] : cases) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 2) << complaint;
    EXPECT_NE(outcome.err.find(complaint), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists("none/x.svg"));
}

// Labels without room are left out, and a note says how many there are; the others are apart.
TEST(Annotations, LabelsWithoutRoomAreLeftOut) {
  for (const bool sticks : {true, false}) {
    const TemporaryFile out("labels.svg");
    std::vector<std::string> call = {"draw", crambin(), "-o", out.path(), "--label", "atom", "--style", "flat"};
    if (sticks) call.insert(call.end(), {"--as", "ball-and-stick"});
    const Outcome many = run_program(call);
    ASSERT_EQ(many.status, 0) << many.err;
    unsigned left_out = 0, all = 0;
    const size_t note = many.err.find("no room for ");
    ASSERT_NE(note, std::string::npos) << many.err;
    ASSERT_EQ(std::sscanf(many.err.c_str() + note, "no room for %u of %u labels,", &left_out, &all), 2) << many.err;
    const std::vector<Text> texts = texts_of(read_file(out.path()));
    EXPECT_GT(left_out, 0u);
    EXPECT_EQ(texts.size(), all - left_out);
    EXPECT_LE(all, 327u);
    for (size_t i = 0; i < texts.size(); ++i) {
      const std::array<double, 4> box = box_of(texts[i]);
      for (size_t k = 0; k < i; ++k) {
        const std::array<double, 4> other = box_of(texts[k]);
        EXPECT_TRUE(box[2] < other[0] || other[2] < box[0] || box[3] < other[1] || other[3] < box[1])
            << texts[i].text << " and " << texts[k].text;
      }
    }
  }
  // Where one after the other has no room, those first of which most is seen may have it all the same.
  const TemporaryFile out("residues.svg");
  const Outcome residues = run_program({"draw", molecules_folder() + "/ubiquitin.pdb", "-o", out.path(), "--label",
                                        "residue", "--as", "ball-and-stick", "--style", "flat"});
  EXPECT_EQ(residues.status, 0);
  EXPECT_EQ(residues.err, "");
  EXPECT_EQ(texts_of(read_file(out.path())).size(), 76u);
}

}  // namespace
