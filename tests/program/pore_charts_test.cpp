// The charts of `pores`: the radius along tunnels and the tree of classes show what is listed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "drawn_colours.hpp"
#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

struct Written {
  Json json;
  std::string svg;
};

Written written(const std::string &option, const Words &words) {
  const TemporaryFile picture("chart.svg");
  Words call = {"pores"};
  call.insert(call.end(), words.begin(), words.end());
  call.insert(call.end(), {option, picture.path()});
  Json json = run_json(call);
  return {json, read_file(picture.path())};
}

// The numbers in a text, in their order.
std::vector<double> numbers_of(const std::string &text) {
  std::vector<double> numbers;
  static const std::regex number("-?[0-9]+(\\.[0-9]+)?");
  for (std::sregex_iterator n(text.begin(), text.end(), number), end; n != end; ++n)
    numbers.push_back(std::stod(n->str()));
  return numbers;
}

// Where labels of ticks say that a number is: x by its number below the frame, or y to the left of it.
constexpr double half_letter = 5.5;  // from the line of a text up to the middle of its figures

struct Scale {
  double at, per_unit;

  double operator()(double number) const { return at + per_unit * number; }
};

Scale scale_of(const std::string &svg, bool below) {
  static const std::regex label(
      "<text x=\"([0-9.]+)\" y=\"([0-9.]+)\" text-anchor=\"(end|middle)\">(-?[0-9.]+)</text>");
  std::vector<std::pair<double, double>> ticks;  // number and place
  for (std::sregex_iterator l(svg.begin(), svg.end(), label), end; l != end; ++l) {
    if (((*l)[3] == "middle") != below) continue;
    ticks.emplace_back(std::stod((*l)[4]), below ? std::stod((*l)[1]) : std::stod((*l)[2]) - half_letter);
  }
  EXPECT_GE(ticks.size(), 4u);
  EXPECT_LE(ticks.size(), 14u);
  const auto &[first, from] = ticks.front();
  const auto &[last, to] = ticks.back();
  const double per_unit = (to - from) / (last - first);
  const double step = (last - first) / static_cast<double>(ticks.size() - 1);
  EXPECT_NEAR(first / step, std::round(first / step), 1e-6) << first;
  return {from - per_unit * first, per_unit};
}

constexpr double tenth_of_px = 0.06;  // labels have one decimal

// The points of a curve; between two of them it goes to the right, and neither above nor below both.
std::vector<double> points_of(const std::string &path) {
  const std::vector<double> numbers = numbers_of(path);
  std::vector<double> points(numbers.begin(), numbers.begin() + 2);
  for (size_t k = 2; k + 5 < numbers.size(); k += 6) {
    for (size_t axis = 0; axis < 2; ++axis) {
      const auto &[low, high] = std::minmax(numbers[k - 2 + axis], numbers[k + 4 + axis]);
      for (const double control : {numbers[k + axis], numbers[k + 2 + axis]}) {
        EXPECT_GE(control, low - 0.011);
        EXPECT_LE(control, high + 0.011);
      }
      points.push_back(numbers[k + 4 + axis]);
    }
  }
  return points;
}

TEST(PoreCharts, ProfileOfEachTunnel) {
  for (const char *probe : {"0", "0.6"}) {
    const auto &[json, svg] =
        written("--profile", {crambin(), "--tunnels-from", "9.6,12.8,5.7", "--tunnels", "8", "--probe", probe});
    const Scale x = scale_of(svg, true), y = scale_of(svg, false);
    static const std::regex line(
        "<path fill=\"none\" stroke=\"#[0-9a-f]{6}\" stroke-width=\"1.5\"[^>]* d=\"([^\"]*)\"/>"),
        ring("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"[^>]* stroke=[^>]*/>\n(?!<text)");
    std::vector<std::vector<double>> lines;
    for (std::sregex_iterator l(svg.begin(), svg.end(), line), end; l != end; ++l) {
      if ((*l)[1].str().find('h') == std::string::npos) lines.push_back(points_of((*l)[1]));
    }
    std::vector<std::pair<double, double>> rings;
    for (std::sregex_iterator r(svg.begin(), svg.end(), ring), end; r != end; ++r) {
      rings.emplace_back(std::stod((*r)[1]), std::stod((*r)[2]));
    }
    std::reverse(lines.begin(), lines.end());  // the first tunnel lies over the others
    std::reverse(rings.begin(), rings.end());
    const std::vector<Json> &tunnels = json["tunnel_list"].items;
    ASSERT_EQ(lines.size(), tunnels.size());
    ASSERT_EQ(rings.size(), tunnels.size());
    ASSERT_GE(tunnels.size(), 4u);
    std::vector<size_t> at(tunnels.size(), 0);
    for (const Json &step : json["tunnel_points"].items) {
      const auto tunnel = static_cast<size_t>(step["tunnel"].number) - 1;
      const std::vector<double> &points = lines.at(tunnel);
      size_t &k = at.at(tunnel);
      ASSERT_LT(k + 1, points.size());
      EXPECT_NEAR(points[k], x(step["length"].number), tenth_of_px);
      EXPECT_NEAR(points[k + 1], y(step["radius"].number), tenth_of_px);
      k += 2;
    }
    for (size_t t = 0; t < tunnels.size(); ++t) {
      EXPECT_EQ(at[t], lines[t].size());
      EXPECT_NEAR(rings[t].second, y(tunnels[t]["radius"].number), tenth_of_px);
      EXPECT_NE(svg.find(">tunnel " + std::to_string(t + 1) + ": bottleneck "), std::string::npos);
    }
    EXPECT_EQ(svg.find("stroke-dasharray=\"4 3\"") != std::string::npos, std::stod(probe) > 0);
    // Where a tunnel goes the way of earlier ones, its line is wider than theirs.
    static const std::regex shared(
        "<path fill=\"none\" stroke=\"#[0-9a-f]{6}\" stroke-width=\"([0-9.]+)\"[^>]* d=\"(M[^\"hC]*C[^\"hC]*)");
    size_t wide = 0;
    for (std::sregex_iterator s(svg.begin(), svg.end(), shared), end; s != end; ++s) {
      if (!(std::stod((*s)[1]) > 1.5)) continue;
      const std::vector<double> first = points_of((*s)[2]);
      const auto same = [&](const std::vector<double> &other) {
        for (size_t k = 0; k + 3 < other.size(); k += 2) {
          if (std::equal(first.begin(), first.end(), other.begin() + static_cast<std::ptrdiff_t>(k))) return true;
        }
        return false;
      };
      const auto times = static_cast<double>(std::count_if(lines.begin(), lines.end(), same));
      EXPECT_GE(1.5 + 4.5 * (times - 1.0), std::stod((*s)[1]));
      ++wide;
    }
    EXPECT_GT(wide, 0u);
  }
}

// From the seventh tunnel on colours come again, with dashes, which the legend has too.
TEST(PoreCharts, TunnelsOfOneColourDifferByDashes) {
  std::string svg = written("--profile", {crambin(), "--tunnels-from", "9.6,12.8,5.7", "--tunnels", "14"}).svg;
  static const std::regex swatch_of_two("stroke=\"#ffffff\"[^>]* d=\"[^\"]*h28\"/>\n<path[^>]*/>");
  svg = std::regex_replace(svg, swatch_of_two, "", std::regex_constants::format_first_only);
  static const std::regex line("<path( fill=\"none\")? (stroke=\"#[0-9a-f]{6}\" stroke-width=\"1.5\"[^>]*) d=");
  std::map<std::string, int> drawn;  // by its look
  for (std::sregex_iterator l(svg.begin(), svg.end(), line), end; l != end; ++l) {
    std::string look = (*l)[2];
    const size_t join = look.find(" stroke-linejoin=\"round\"");
    if (join != std::string::npos) look.erase(join, std::string(" stroke-linejoin=\"round\"").size());
    ++drawn[look];
  }
  EXPECT_GT(drawn.size(), 6u);
  std::set<std::string> colours;
  for (const auto &[look, times] : drawn) {
    EXPECT_EQ(times, 2) << look;
    colours.insert(look.substr(look.find('#') + 1, 6));
  }
  EXPECT_EQ(colours.size(), 6u);
  EXPECT_GT(least_difference({colours.begin(), colours.end()}), 18);
  for (const std::string &colour : colours) EXPECT_GT(contrast(colour, "ffffff"), 2.6) << colour;
}

struct Bar {
  double birth, death, y, parent;  // in px; parent as y where the line ends, negative: none
};

std::vector<Bar> bars_of(const std::string &svg) {
  std::vector<Bar> bars;
  static const std::regex path(
      "<path fill=\"none\" stroke=\"#[0-9a-f]{6}\" stroke-width=\"(0.8|1.5)\"[^>]* d=\"([^\"]*)\"/>"),
      bar("M([0-9.]+) ([0-9.]+)H([0-9.]+)(V([0-9.]+))?");
  for (std::sregex_iterator p(svg.begin(), svg.end(), path), end; p != end; ++p) {
    const std::string points = (*p)[2];
    for (std::sregex_iterator b(points.begin(), points.end(), bar); b != end; ++b) {
      bars.push_back(
          {std::stod((*b)[1]), std::stod((*b)[3]), std::stod((*b)[2]), (*b)[5].matched ? std::stod((*b)[5]) : -1.0});
    }
  }
  return bars;
}

// Each class that is listed is a line of its own, of more than 100 those that live longest; its end is on that of its
// parent, and lines do not cross.
void expect_tree(const Json &json, const std::string &svg, double persistence, bool outside) {
  const Scale x = scale_of(svg, true);
  std::vector<Bar> bars = bars_of(svg);
  std::map<std::string, double> row;  // by the name of the class
  constexpr double rounding = 0.02;
  size_t listed = 0;
  std::vector<const Json *> classes;
  for (const Json &maximum : json["maximum_list"].items) {
    if (maximum["radius"].number - maximum["death"].number < persistence) continue;
    ++listed;
    classes.push_back(&maximum);
  }
  constexpr size_t most = 100;
  ASSERT_EQ(bars.size(), std::min(listed, most));
  const auto life = [](const Json *maximum) { return (*maximum)["radius"].number - (*maximum)["death"].number; };
  std::stable_sort(classes.begin(), classes.end(), [&](const Json *a, const Json *b) { return life(a) > life(b); });
  classes.resize(bars.size());
  std::sort(classes.begin(), classes.end(),
            [](const Json *a, const Json *b) { return (*a)["maximum"].number < (*b)["maximum"].number; });
  const std::string left_out = std::to_string(listed - bars.size()) + " more are left out<";
  EXPECT_EQ(svg.find(left_out) != std::string::npos, listed > most) << left_out;
  // Equal classes in any order: find a bar with the same birth and death whose parent's row is right, once known.
  std::vector<bool> used(bars.size(), false);
  for (const Json *maximum : classes) {
    const std::string parent = (*maximum)["parent"].text;
    double parent_y = -1;
    if (parent == "outside") {
      parent_y = -2;  // the first row
    } else if (parent != "none") {
      ASSERT_TRUE(row.contains(parent)) << parent;  // wider classes have lower numbers
      parent_y = row[parent];
    }
    bool found = false;
    for (size_t k = 0; k < bars.size() && !found; ++k) {
      if (used[k] || std::abs(bars[k].birth - x((*maximum)["radius"].number)) > tenth_of_px ||
          std::abs(bars[k].death - x((*maximum)["death"].number)) > tenth_of_px) {
        continue;
      }
      if (parent_y == -2 ? bars[k].parent < 0 || bars[k].parent > bars[k].y
                         : std::abs(bars[k].parent - parent_y) > rounding) {
        continue;
      }
      used[k] = found = true;
      row[std::to_string(static_cast<int>((*maximum)["maximum"].number))] = bars[k].y;
    }
    EXPECT_TRUE(found) << (*maximum)["maximum"].number;
  }
  double before = outside ? 20.7 : 20.3;
  std::sort(bars.begin(), bars.end(), [](const Bar &a, const Bar &b) { return a.y < b.y; });
  for (const Bar &bar : bars) {
    EXPECT_GT(bar.y, before + 0.2);
    before = bar.y;
  }
  for (const Bar &bar : bars) {
    EXPECT_LT(bar.parent, bar.y);
    for (const Bar &other : bars) {
      const bool between = other.y < bar.y - rounding && other.y > bar.parent + rounding && bar.parent >= 0;
      EXPECT_FALSE(between && other.birth > bar.death + rounding && other.death < bar.death - rounding);
    }
  }
}

TEST(PoreCharts, TreeOfCrambin) {
  for (const auto &[words, persistence] :
       std::vector<std::pair<Words, double>>{{{"--probe", "0.37"}, 0},
                                             {{"--probe", "0.8", "--least", "0.1"}, 0.1},
                                             {{"--probe", "0.8", "--pockets", "1.3"}, 0}}) {
    Words call = {crambin()};
    call.insert(call.end(), words.begin(), words.end());
    const auto &[json, svg] = written("--tree", call);
    expect_tree(json, svg, persistence, true);
    EXPECT_NE(svg.find(">outside<"), std::string::npos);
    EXPECT_EQ(svg.find("stroke-dasharray") != std::string::npos, words.back() == "1.3");
  }
}

// Pockets have colours of their own, which the legend names.
TEST(PoreCharts, TreeWithPockets) {
  const auto &[json, svg] = written("--tree", {crambin(), "--probe", "0.8", "--pockets", "3", "--least", "0.1"});
  const Scale x = scale_of(svg, true);
  static const std::regex named("stroke=\"(#[0-9a-f]{6})\" stroke-width=\"3\"[^>]*/>\n<text[^>]*>pocket ([0-9]+)<");
  size_t names = 0;
  std::vector<std::string> colours;
  for (std::sregex_iterator n(svg.begin(), svg.end(), named), end; n != end; ++n, ++names) {
    const Json &pocket = json["pocket_list"].items.at(names);
    EXPECT_EQ(std::stod((*n)[2]), pocket["pocket"].number);
    // The line of its widest maximum has that colour.
    const std::string colour = (*n)[1];
    colours.push_back(colour.substr(1));
    const std::regex path("<path fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.5\"[^>]* d=\"([^\"]*)\"/>");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(svg, match, path)) << colour;
    const std::string points = match[1];
    static const std::regex birth("M([0-9.]+) ");
    double widest = 0;
    for (std::sregex_iterator b(points.begin(), points.end(), birth); b != end; ++b) {
      widest = std::max(widest, std::stod((*b)[1]));
    }
    EXPECT_NEAR(widest, x(pocket["radius"].number), tenth_of_px);
  }
  EXPECT_EQ(names, 6u);
  colours.emplace_back("73787e");
  EXPECT_NE(svg.find("stroke=\"#" + colours.back()), std::string::npos);  // of other pockets
  EXPECT_GT(least_difference(colours), 10);
  // It stands beside that line, too, all of it on the page; so it does in others, where their classes have the grey of
  // all that have no colour. Other numbers stand alone.
  const double wide = std::stod(svg.substr(svg.find("width=\"") + 7));
  static const std::regex beside("<text x=\"([0-9.]+)\"[^>]*text-anchor=\"start\">([0-9]+)(, (in )?pocket ([0-9]+))?<");
  size_t with_pocket = 0, within = 0, alone = 0;
  for (std::sregex_iterator b(svg.begin(), svg.end(), beside), end; b != end; ++b) {
    for (const Json &maximum : json["maximum_list"].items) {
      if (maximum["maximum"].number != std::stod((*b)[2])) continue;
      EXPECT_NEAR(std::stod((*b)[1]), x(maximum["radius"].number) + 5, tenth_of_px);
    }
    if (!(*b)[3].matched) {
      ++alone;
      continue;
    }
    EXPECT_LT(std::stod((*b)[1]) + 74, wide);
    ++((*b)[4].matched ? within : with_pocket);
    bool found = false;
    for (const Json &other : json["pocket_list"].items) {
      found = found || (other["pocket"].number == std::stod((*b)[5]) && other["maximum"].number == std::stod((*b)[2]));
    }
    EXPECT_EQ(found, !(*b)[4].matched) << (*b)[2];
  }
  EXPECT_EQ(within, 2u);
  EXPECT_EQ(with_pocket, 6u);
  EXPECT_GE(alone, 2u);
}

// Entries of legends stand beside each other without touching, and all on the page; what they explain is drawn.
TEST(PoreCharts, LegendsHaveRoom) {
  const std::vector<std::pair<std::string, Words>> charts = {
      {"--tree", {crambin(), "--probe", "0.8", "--pockets", "3", "--least", "0.1"}},
      {"--tree", {crambin(), "--probe", "0.6", "--pockets", "1.3", "--least", "0.05"}},
      {"--profile", {crambin(), "--tunnels-from", "9.6,12.8,5.7", "--probe", "0.6"}}};
  for (const auto &[option, words] : charts) {
    const std::string svg = written(option, words).svg;
    static const std::regex size("width=\"([0-9]+)\" height=\"([0-9]+)\""),
        text("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"( text-anchor=\"start\")?>([^<]*)<");
    std::smatch page;
    ASSERT_TRUE(std::regex_search(svg, page, size));
    std::map<double, std::map<double, size_t>> rows;  // by their lines: where letters begin, how many
    for (std::sregex_iterator t(svg.begin(), svg.end(), text), end; t != end; ++t) {
      rows[std::stod((*t)[2])][std::stod((*t)[1])] = static_cast<std::size_t>((*t)[4].length());
    }
    double above = -1e9;
    for (const auto &[y, row] : rows) {
      EXPECT_GE(y, above + 18) << "lines touch";
      above = y;
      double free_from = 0;
      for (const auto &[x, letters] : row) {
        EXPECT_GE(x, free_from);
        free_from = x + 0.45 * 16 * static_cast<double>(letters) + 8;
      }
      EXPECT_LT(free_from, std::stod(page[1]) + 8);
    }
    EXPECT_LT(above + 4, std::stod(page[2]));
    const bool wide_probe = words.at(words.size() - 3) == "1.3";
    EXPECT_EQ(svg.find(">the wide probe of pockets<") != std::string::npos, wide_probe);
    EXPECT_EQ(svg.find(">ends in a dot: a cavity, which no such probe leaves<") != std::string::npos,
              option == "--tree");
  }
  EXPECT_EQ(written("--tree", {crambin(), "--probe", "0"}).svg.find("ends in a dot"), std::string::npos);
}

// Where two tunnels part, the sides of the outer one meet around the end: a circle in its colour and a white one in it.
TEST(PoreCharts, SharedWaysEndRound) {
  const std::string svg = written("--profile", {crambin(), "--tunnels-from", "atom:242"}).svg;
  static const std::regex wide(
      " stroke=\"(#[0-9a-f]{6})\" stroke-width=\"6.0\"[^>]* d=\"M([0-9.]+) [^\"h]* ([0-9.]+) "
      "([0-9.]+)\"/>\n<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"3.00\" fill=\"(#[0-9a-f]{6})\"/>");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(svg, found, wide));
  EXPECT_EQ(found[1], found[7]);
  EXPECT_EQ(found[3], found[5]);
  EXPECT_EQ(found[4], found[6]);
  EXPECT_EQ(std::stod(found[2]), 88.5);  // where all begin, on the axis, there is no circle
  EXPECT_EQ(svg.find("<circle cx=\"88.50\""), std::string::npos);
  const size_t inner = svg.find("r=\"2.00\" fill=\"#ffffff\"");
  EXPECT_NE(inner, std::string::npos);
}

// Letters go a quarter of their 16 px below the line on which they stand: none of a row touches the axis.
TEST(PoreCharts, NamesInTheTreeStandAboveTheAxis) {
  const std::string svg = written("--tree", {crambin(), "--probe", "0.8", "--pockets", "3", "--least", "0.1"}).svg;
  static const std::regex axis("<path stroke=\"#9a9a9a\" d=\"M[0-9.]+ ([0-9.]+)h[0-9.]+\"/>"),
      name("<text x=\"[0-9.]+\" y=\"([0-9.]+)\"[^>]*text-anchor=\"start\">[0-9]+(, (in )?pocket [0-9]+)?<");
  std::smatch line;
  ASSERT_TRUE(std::regex_search(svg, line, axis));
  size_t names = 0;
  for (std::sregex_iterator n(svg.begin(), svg.end(), name), end; n != end; ++n, ++names) {
    EXPECT_LT(std::stod((*n)[1]) + 4 + 2, std::stod(line[1])) << (*n)[0];
  }
  EXPECT_GT(names, 8u);
}

// A row of rooms, each between six balls, with windows to the next ones: channels along one vector.
TEST(PoreCharts, TreeInABox) {
  const TemporaryFile file("room.xyzr", "1 0 0 0.7\n0 1 0 0.7\n0 0 1 0.7\n1.3 1.2 1.1 0.4\n");
  const auto &[json, svg] = written("--tree", {file.path(), "--box", "2,2,2.4", "--probe", "0.25"});
  expect_tree(json, svg, 0, false);
  const Scale x = scale_of(svg, true);
  static const std::regex limit("<text x=\"([0-9.]+)\" y=\"15.5\" text-anchor=\"middle\">([123])-d<");
  size_t limits = 0;
  double before = -1;
  for (std::sregex_iterator l(svg.begin(), svg.end(), limit), end; l != end; ++l, ++limits) {
    const size_t d = std::stoul((*l)[2]) - 1;
    EXPECT_NEAR(std::stod((*l)[1]), x(json["pore_limiting_diameter"].items.at(d).number / 2), tenth_of_px);
    EXPECT_GT(std::stod((*l)[1]), before);
    before = std::stod((*l)[1]);
  }
  EXPECT_EQ(limits, 3u);
  EXPECT_EQ(svg.find(">outside<"), std::string::npos);
  const TemporaryFile ball("ball.xyzr", "0 0 0 1\n");
  const std::string cubic = written("--tree", {ball.path(), "--box", "4,4,4"}).svg;
  EXPECT_NE(cubic.find(">3-d<"), std::string::npos);
  EXPECT_EQ(cubic.find(">1-d<"), std::string::npos);  // all three at once
}

// Lines that are near each other have one label with both names, from left to right.
TEST(PoreCharts, NamesOfNearLimitsDoNotOverlap) {
  const TemporaryFile file("near.xyz", "3\nLattice=\"0 9 0 0 0 10 8 0 0\"\nC 1 2 3\nC 5 1 7\nO 4 6 2\n");
  const auto &[json, svg] = written("--tree", {file.path(), "--box", "file", "--probe", "2"});
  const Scale x = scale_of(svg, true);
  const auto at = [&, &limits = json["pore_limiting_diameter"].items](size_t d) { return x(limits.at(d).number / 2); };
  ASSERT_LT(at(1), at(2) + 32);
  ASSERT_GE(at(0), at(2) + 64);
  static const std::regex limit("<text x=\"([0-9.]+)\" y=\"15.5\" text-anchor=\"middle\">([^<]*-d)<");
  std::map<std::string, double> names;
  for (std::sregex_iterator l(svg.begin(), svg.end(), limit), end; l != end; ++l) names[(*l)[2]] = std::stod((*l)[1]);
  ASSERT_EQ(names.size(), 2u);
  EXPECT_NEAR(names["3-d, 2-d"], at(2) + 16, tenth_of_px);
  EXPECT_NEAR(names["1-d"], at(0), tenth_of_px);
}

// Along a side they have the same number of decimals.
TEST(PoreCharts, TicksHaveTheSameDecimals) {
  const std::string svg = written("--profile", {crambin(), "--tunnels-from", "9.6,12.8,5.7"}).svg;
  static const std::regex label("text-anchor=\"end\">[0-9]+(\\.[0-9]+)?</text>");
  std::set<size_t> lengths;
  for (std::sregex_iterator l(svg.begin(), svg.end(), label), end; l != end; ++l)
    lengths.insert(static_cast<size_t>((*l)[1].length()));
  EXPECT_EQ(lengths.size(), 1U);
}

// Numbers of ticks have as many digits as tell them apart.
TEST(PoreCharts, TicksOfALargeCageDiffer) {
  std::string balls;
  for (const char *place : {"2e6 0 0", "-2e6 0 0", "0 2e6 0", "0 -2e6 0", "0 0 2e6", "0 0 -2e6"}) {
    balls += std::string(place) + " 1e6\n";
  }
  const TemporaryFile cage("cage.xyzr", balls);
  const auto &[json, svg] = written("--tree", {cage.path(), "--probe", "999999"});
  EXPECT_EQ(json["maxima"].number, 1);
  static const std::regex label("text-anchor=\"middle\">([0-9.e+]+)</text>");
  std::set<double> ticks;
  size_t count = 0;
  for (std::sregex_iterator l(svg.begin(), svg.end(), label), end; l != end; ++l, ++count)
    ticks.insert(std::stod((*l)[1]));
  EXPECT_GE(count, 4u);
  EXPECT_EQ(ticks.size(), count);
}

TEST(PoreCharts, OfNothing) {
  const Written tree = written("--tree", {"good/one.xyzr"});
  EXPECT_TRUE(bars_of(tree.svg).empty());
  EXPECT_EQ(tree.svg.substr(tree.svg.size() - 7), "</svg>\n");
  const auto &[json, svg] = written("--profile", {"good/cage.xyzr", "--tunnels-from", "0,0,0", "--probe", "5"});
  EXPECT_EQ(json["tunnels"].number, 0);
  EXPECT_EQ(svg.find("<circle"), std::string::npos);
}

TEST(PoreCharts, AreRefusedWhereTheyHaveNoPlace) {
  EXPECT_EQ(run_program({"pores", "good/cage.xyzr", "--profile", "chart.svg"}).err,
            "hardsphere: --profile needs --tunnels-from\n");
  EXPECT_EQ(run_program({"pores", "good/cage.xyzr", "--tree", "chart.png"}).err,
            "hardsphere: --tree writes an .svg file, and its name says so\n");
  const Outcome printed = run_program({"pores", "good/cage.xyzr", "--tree", "-"});
  EXPECT_EQ(printed.status, 0);
  EXPECT_EQ(printed.out.rfind("<svg", 0), 0u);
}

}  // namespace
