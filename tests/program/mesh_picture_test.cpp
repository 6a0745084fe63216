// hardsphere mesh -o OUT.svg: what the triangles of a picture cover, in which order and colours, and what a cut shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Point = std::array<double, 2>;

struct Part {
  std::array<int, 3> colour;
  std::vector<Point> points;  // px, y up; of curves their ends
  bool closed;
  double swept;  // between the ends of curves and the curves
  std::string fill;

  [[nodiscard]] double area() const {
    double sum = swept;
    for (size_t k = 0; closed && k < points.size(); ++k) {
      const auto &a = points[k];
      const auto &b = points[(k + 1) % points.size()];
      sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sum;
  }
  [[nodiscard]] bool is_teal() const { return colour[1] > colour[0] + 40 && colour[2] < colour[1] + 30; }
};

std::string attribute(const std::string &element, const std::string &name) {
  const size_t at = element.find(' ' + name + "=\"");
  if (at == std::string::npos) return "";
  const size_t begin = at + name.size() + 3;
  return element.substr(begin, element.find('"', begin) - begin);
}

std::string element_of(const std::string &svg, const std::string &id) {
  const size_t at = svg.find("id=\"" + id + "\"");
  EXPECT_NE(at, std::string::npos) << id;
  return svg.substr(svg.rfind('<', at), svg.find('\n', at) - svg.rfind('<', at));
}

// A colour itself, or what the gradient of a sphere makes of it in the middle.
std::array<int, 3> colour_of(const std::string &svg, const std::string &path) {
  const std::string fill = attribute(path, "fill");
  std::string colour = fill;
  if (fill.rfind("url(#", 0) == 0) {
    const std::string sphere = element_of(svg, fill.substr(5, fill.size() - 6));
    colour = sphere.substr(sphere.find("offset=\"0.4\" stop-color=\"") + 25, 7);
  }
  const unsigned long number = std::stoul(colour.substr(1), nullptr, 16);
  return {static_cast<int>(number >> 16 & 0xFF), static_cast<int>(number >> 8 & 0xFF), static_cast<int>(number & 0xFF)};
}

// The loops of a path, in twentieths of a px: lines, and parabolas that are given by the point where their tangents
// meet.
std::vector<Part> loops_of(const std::string &path) {
  std::vector<Part> parts;
  std::string spaced;
  for (const char c : path) {
    const bool command = std::string("Mlqtz").find(c) != std::string::npos;
    spaced += command ? std::string(" ") + c + ' ' : c == '-' ? " -" : std::string(1, c);
  }
  std::istringstream words(spaced);
  char command = 'M';
  Point at{}, control{};
  const auto next = [&words](const Point &from, int sign) {
    Point to{};
    words >> to[0] >> to[1];
    return Point{from[0] * sign + to[0] / 20, from[1] * sign - to[1] / 20};
  };
  for (std::string word; words >> word;) {
    if (std::string("Mlqtz").find(word[0]) != std::string::npos) {
      command = word[0];
      if (command == 'z') parts.back().closed = true;
      if (command == 'M') parts.push_back({{}, {at = next(at, 0)}, false, 0, ""});
      continue;
    }
    words.seekg(-static_cast<std::streamoff>(word.size()), std::ios::cur);
    if (command == 'q') control = next(at, 1);
    if (command == 't') control = {2 * at[0] - control[0], 2 * at[1] - control[1]};
    const Point to = next(at, 1);
    if (command != 'l') {
      const Point a{control[0] - at[0], control[1] - at[1]}, b{to[0] - at[0], to[1] - at[1]};
      parts.back().swept += (a[0] * b[1] - a[1] * b[0]) / 3;
    }
    parts.back().points.push_back(at = to);
  }
  return parts;
}

// Of an area several, if it has several loops. Contours and borders of patches are left out.
std::vector<Part> parts_of(const std::string &svg) {
  std::vector<Part> parts;
  for (size_t at = svg.find("<path "); at != std::string::npos; at = svg.find("<path ", at + 1)) {
    const std::string path = svg.substr(at, svg.find('\n', at) - at);
    if (attribute(path, "fill") == "none") continue;
    const bool line = attribute(path, "id") == "section";
    for (Part part : loops_of(attribute(path, "d"))) {
      if (line) {
        part.closed = false;
      } else {
        part.colour = colour_of(svg, path);
        part.fill = attribute(path, "fill");
      }
      parts.push_back(part);
    }
  }
  return parts;
}

// Contours, rims of pockets, or borders of patches, which are faint, with their widths in px.
struct Line {
  std::vector<Point> points;
  double width;
};
std::vector<Line> lines_of(const std::string &svg, bool faint, bool rims = false) {
  std::vector<Line> lines;
  for (size_t at = svg.find("<path fill=\"none\""); at != std::string::npos;
       at = svg.find("<path fill=\"none\"", at + 1)) {
    const std::string path = svg.substr(at, svg.find('\n', at) - at);
    if (attribute(path, "stroke-opacity").empty() == faint) continue;
    if (attribute(path, "stroke").substr(0, 1) != "#" || (attribute(path, "stroke") != "#23202b") != rims) continue;
    const double width = std::stod(attribute(path, "stroke-width")) / 20;
    for (Part part : loops_of(attribute(path, "d"))) {
      if (part.closed) part.points.push_back(part.points.front());
      lines.push_back({part.points, width});
    }
  }
  return lines;
}

std::vector<Line> rims_of(const std::string &svg) {
  return lines_of(svg, false, true);
}

std::string drawn_text(const std::string &file, std::vector<std::string> options) {
  const TemporaryFile out("mesh.svg");
  options.insert(options.begin(), {"mesh", file, "-o", out.path()});
  const Outcome outcome = run_program(options);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string svg = read_file(out.path());
  EXPECT_EQ(svg.substr(0, 38), "<svg xmlns=\"http://www.w3.org/2000/svg");
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(svg.find(" d=\"\""), std::string::npos);
  return svg;
}

std::vector<Part> drawn(const std::string &file, const std::vector<std::string> &options) {
  return parts_of(drawn_text(file, options));
}

// The front of a ball covers its disc, in one area with one gradient: 1000 px are its diameter and a margin of .03 of
// it on either side.
TEST(MeshPicture, TheFrontOfABallIsADisc) {
  const TemporaryFile ball("ball.xyzr", "5 6 7 2\n");
  const double disc = std::numbers::pi * 0.25 * std::pow(1000 / 1.06, 2);
  for (const char *view : {"0,0,1", "1,2,3"}) {
    const std::string svg = drawn_text(ball.path(), {"--edge", "0.2", "--view", view});
    const std::vector<Part> parts = parts_of(svg);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_NEAR(parts[0].area(), disc, 0.01 * disc) << view;
    const std::string gradient = element_of(svg, "s0");
    EXPECT_NEAR(std::stod(attribute(gradient, "r")), 20 * 500 / 1.06, 0.01 * 20 * 500);
    for (const char *centre : {"cx", "cy"}) EXPECT_NEAR(std::stod(attribute(gradient, centre)), 20 * 500, 20 * 5);
    EXPECT_LT(std::stod(attribute(gradient, "fx")), std::stod(attribute(gradient, "cx")));
    EXPECT_LT(std::stod(attribute(gradient, "fy")), std::stod(attribute(gradient, "cy")));
  }
}

// Its outline is one line all around: one that is begun anew at each edge has corners.
TEST(MeshPicture, OutlinesAreOneLine) {
  const TemporaryFile ball("ball.xyzr", "5 6 7 2\n");
  for (const char *view : {"0,0,1", "1,2,3"}) {
    const std::vector<Line> lines = lines_of(drawn_text(ball.path(), {"--edge", "0.1", "--view", view}), false);
    ASSERT_EQ(lines.size(), 1u) << view;
    EXPECT_EQ(lines[0].points.front(), lines[0].points.back());
  }
}

// Before a dark page outlines are light, and contours before a surface dark.
TEST(MeshPicture, OutlinesAreSeenBeforeADarkPage) {
  const TemporaryFile pair("pair.xyzr", "0 0 0 3\n0 0 7 0.5\n");
  const std::vector<std::string> options = {"--edge", "0.1", "--view", "0,0,1"};
  std::vector<std::string> dark = options;
  dark.push_back("--dark");
  EXPECT_EQ(rims_of(drawn_text(pair.path(), options)).size(), 0u);
  const std::string svg = drawn_text(pair.path(), dark);
  const std::vector<Line> light = rims_of(svg), inner = lines_of(svg, false);
  ASSERT_EQ(light.size(), 1u);
  ASSERT_EQ(inner.size(), 1u);
  for (const Point &at : light[0].points) EXPECT_NEAR(std::hypot(at[0] - 500, at[1] + 500), 500 / 1.06, 1);
  for (const Point &at : inner[0].points) EXPECT_NEAR(std::hypot(at[0] - 500, at[1] + 500), 500 / 1.06 / 6, 1);
}

// Two balls, the farther one partly hidden: its contour ends at that of the nearer one, which is whole. Seen from the
// other side it is the other way round.
TEST(MeshPicture, ContoursEndWhereTheyAreHidden) {
  const TemporaryFile pair("pair.xyzr", "0 0 5 2\n2.5 0 -5 2\n");
  const double scale = 1000 / (6.5 * 1.06), radius = 2 * scale;
  // Of a circle with another one of the same radius 2.5 beside it the half angle within that.
  const double hidden = 2 * std::acos(2.5 / 4) * radius, around = 2 * std::numbers::pi * radius;
  for (const auto &[view, near] : {std::pair<const char *, size_t>{"0,0,1", 0}, {"0,0,-1", 1}}) {
    const std::string svg = drawn_text(pair.path(), {"--edge", "0.1", "--view", view, "--up", "0,1,0"});
    const double left = (0.03 * 6.5 + 2) * scale, right = left + 2.5 * scale;
    const bool turned = near == 1;
    const double centre[2] = {turned ? right : left, turned ? left : right};
    double length[2] = {0, 0};
    for (const Line &line : lines_of(svg, false)) {
      const double y = -(0.03 * 6.5 + 2) * scale;
      for (size_t k = 0; k < line.points.size(); ++k) {
        const Point &at = line.points[k];
        const double from[2] = {std::hypot(at[0] - centre[0], at[1] - y), std::hypot(at[0] - centre[1], at[1] - y)};
        const size_t on = std::abs(from[0] - radius) < std::abs(from[1] - radius) ? 0 : 1;
        EXPECT_NEAR(from[on], radius, 0.5) << view;
        EXPECT_GT(from[near], radius - 0.5) << view;
        if (k > 0) length[on] += std::hypot(at[0] - line.points[k - 1][0], at[1] - line.points[k - 1][1]);
      }
    }
    EXPECT_NEAR(length[near], around, 0.01 * around) << view;
    EXPECT_NEAR(length[1 - near], around - hidden, 0.01 * around) << view;
  }
}

// A ball close before a large one has a thinner contour than far before it, and one that leaves it has one that grows.
TEST(MeshPicture, ContoursGrowWithTheGapBehind) {
  std::vector<double> widest;
  for (const char *above : {"3.3", "4", "7"}) {
    const TemporaryFile pair("pair.xyzr", "0 0 0 3\n0 0 " + std::string(above) + " 0.5\n");
    double most = 0;
    for (const Line &line : lines_of(drawn_text(pair.path(), {"--edge", "0.1", "--view", "0,0,1"}), false)) {
      const Point &at = line.points[0];
      if (std::hypot(at[0] - 500, at[1] + 500) < 200) most = std::max(most, line.width);
    }
    widest.push_back(most);
  }
  EXPECT_GT(widest[0], 0);
  EXPECT_LT(widest[0], widest[1]);
  EXPECT_LT(widest[1], widest[2]);
}

// Small balls that all but hide a larger one behind them, of which a narrow rim is seen: its contour stands for both.
TEST(MeshPicture, ContoursDoNotDoubleOthers) {
  const auto lengths = [](const std::string &behind) {
    const TemporaryFile pair("pair.xyzr", "0 0 2 3\n0 0 0 " + behind + "\n");
    std::array<double, 2> length = {0, 0};
    for (const Line &line : lines_of(drawn_text(pair.path(), {"--edge", "0.1", "--view", "0,0,1"}), false)) {
      for (size_t k = 1; k < line.points.size(); ++k) {
        const Point &at = line.points[k], &last = line.points[k - 1];
        const double radius = 500 / 1.06 - std::hypot(at[0] - 500, at[1] + 500);
        length[radius > 1 ? 1 : 0] += std::hypot(at[0] - last[0], at[1] - last[1]);
      }
    }
    return length;
  };
  const std::array<double, 2> narrow = lengths("3.01"), wide = lengths("3.2");
  const double around = 1000 * std::numbers::pi / 1.06;
  EXPECT_NEAR(narrow[0], around, 0.02 * around);
  EXPECT_EQ(narrow[1], 0);
  EXPECT_NEAR(wide[0], around, 0.02 * around);
  EXPECT_NEAR(wide[1], around * 3 / 3.2, 0.02 * around);
}

// The contour of a ball of few px that nothing is near to is a speck.
TEST(MeshPicture, SpecksAreLeftOut) {
  const auto contours_within = [](const std::string &radius) {
    const TemporaryFile pair("pair.xyzr", "0 0 0 3\n0 0 6 " + radius + "\n");
    size_t count = 0;
    for (const Line &line : lines_of(drawn_text(pair.path(), {"--edge", "0.3", "--view", "0,0,1"}), false)) {
      if (std::hypot(line.points[0][0] - 500, line.points[0][1] + 500) < 300) ++count;
    }
    return count;
  };
  EXPECT_EQ(contours_within("0.015"), 0u);
  EXPECT_GT(contours_within("0.1"), 0u);
}

// Widths do not depend on the unit of a file: the picture of a molecule in any other is the same.
TEST(MeshPicture, WidthsAreTheSameInEveryUnit) {
  for (const char *surface : {"sas", "ses"}) {
    std::vector<std::string> pictures;
    for (const double unit : {1.0, 0.25, 0.01, 4.0, 100.0}) {
      const auto number = [unit](double value) {
        std::ostringstream out;
        out.precision(15);
        out << value * unit;
        return out.str();
      };
      const TemporaryFile pair(
          "pair.xyzr", "0 0 0 " + number(3) + "\n" + number(0.5) + " 0 " + number(4.5) + ' ' + number(1) + "\n");
      pictures.push_back(drawn_text(
          pair.path(), {"--edge", number(0.2), "--probe", number(1.4), "--surface", surface, "--view", "1,0,2"}));
      ASSERT_EQ(lines_of(pictures[0], false).empty(), false);
      const std::vector<Line> first = lines_of(pictures[0], false), lines = lines_of(pictures.back(), false);
      ASSERT_EQ(lines.size(), first.size()) << surface << ' ' << unit;
      for (size_t k = 0; k < lines.size(); ++k) EXPECT_EQ(lines[k].width, first[k].width) << surface << ' ' << unit;
    }
  }
}

// The gap is measured in mean radii of the balls that are seen, which a probe inflates: three of them make a contour of
// full width, and less the power 5/8 of that share.
TEST(MeshPicture, GapsAreMeasuredInMeanRadii) {
  const auto width_of = [](const std::string &balls, const std::vector<std::string> &options) {
    const TemporaryFile file("balls.xyzr", balls);
    std::vector<std::string> words = {"--edge", "0.1", "--view", "0,0,1"};
    words.insert(words.end(), options.begin(), options.end());
    double most = 0;
    for (const Line &line : lines_of(drawn_text(file.path(), words), false)) {
      const Point &at = line.points[0];
      if (std::hypot(at[0] - 500, at[1] + 500) < 300) most = std::max(most, line.width);
    }
    return most;
  };
  // Mean radius 2: a gap is the height of the small one's equator over the large one.
  const double near = width_of("0 0 0 3\n0 0 5 1\n", {}), full = width_of("0 0 0 3\n0 0 9 1\n", {});
  const double below = std::sqrt(9.0 - 1.0);
  EXPECT_GT(near, 0);
  EXPECT_NEAR(near / full, std::pow((5 - below) / (3 * 2), 0.625), 1.0 / 12);
  // The same balls, half of each the probe's.
  EXPECT_EQ(width_of("0 0 0 2.5\n0 0 5 0.5\n", {"--probe", "0.5", "--surface", "sas"}), near);
}

// Cut in the middle, the back of the ball shows its inside, on the same disc, within a rim all around. The light of a
// hollow comes from the other side.
TEST(MeshPicture, ACutShowsTheInside) {
  const TemporaryFile ball("ball.xyzr", "5 6 7 2\n");
  const double radius = 500 / 1.06;
  const std::string svg = drawn_text(ball.path(), {"--edge", "0.2", "--view", "0,0,1", "--cut"});
  double rim = 0;
  double area = 0;
  for (const Part &part : parts_of(svg)) {
    area += part.area();
    if (part.closed) continue;
    for (size_t k = 0; k < part.points.size(); ++k) {
      const Point &next = part.points[(k + 1) % part.points.size()];
      rim += std::hypot(next[0] - part.points[k][0], next[1] - part.points[k][1]);
      EXPECT_NEAR(std::hypot(part.points[k][0] - 500, part.points[k][1] + 500), radius, 0.02 * radius);
    }
  }
  EXPECT_NEAR(area, -std::numbers::pi * radius * radius, 0.01 * std::numbers::pi * radius * radius);
  EXPECT_NEAR(rim, 2 * std::numbers::pi * radius, 0.02 * rim);
  EXPECT_GT(std::stod(attribute(element_of(svg, "s1"), "fx")), 20 * 500);
  EXPECT_EQ(svg.find(">voids<"), std::string::npos);
  EXPECT_NE(svg.find(">inside, cut open<"), std::string::npos);
}

// The piece that a cut leaves of a ball of a 200th of the area floats behind the plane: it is dropped. One of a 20th is
// not.
TEST(MeshPicture, ACutLeavesNoCrumbs) {
  for (const auto &[small, sections] : {std::pair<const char *, size_t>{"0.28", 1}, {"0.9", 2}}) {
    const TemporaryFile balls("balls.xyzr", "0 0 0 4\n9 0 0.1 " + std::string(small) + "\n");
    size_t lines = 0;
    for (const Part &part : drawn(balls.path(), {"--edge", "0.1", "--view", "0,0,1", "--cut"})) {
      lines += part.closed ? 0 : 1;
    }
    EXPECT_EQ(lines, sections) << small;
  }
}

// Two balls of radii 1.7 and 1.52 in a distance of 3, probe 1.4: the probe's centres are in the plane
// x = (3.1^2 - 2.92^2 + 3^2) / 6, and it touches the balls in circles, seen edge-on, between which neither has its
// colour; in a picture of 6.22 and a margin.
TEST(MeshPicture, ColoursMeetWhereTheProbeTouchesTheBalls) {
  const TemporaryFile pair("pair.xyz", "2\n\nN 0 0 0\nO 3 0 0\n");
  const std::vector<std::string> options = {"--radius",  "N=1.7", "--radius", "O=1.52", "--probe", "1.4",
                                            "--surface", "ses",   "--edge",   "0.4",    "--view",  "0,0,1"};
  const std::string svg = drawn_text(pair.path(), options);
  EXPECT_LT(svg.find(">N<"), svg.find(">O<"));
  EXPECT_LT(svg.find(">O<"), svg.find(">between atoms<"));
  EXPECT_EQ(svg.find(">C<"), std::string::npos);
  const double plane = (3.1 * 3.1 - 2.92 * 2.92 + 9) / 6, scale = 1000 / (6.22 * 1.06);
  const double touched[2] = {plane * 1.7 / 3.1, 3 - (3 - plane) * 1.52 / 2.92};
  double low[3] = {1e9, 1e9, 1e9}, high[3] = {0, 0, 0};
  for (const Part &part : parts_of(svg)) {
    const size_t kind = part.colour[2] > part.colour[0] + 40 ? 0 : part.colour[0] > part.colour[2] + 20 ? 2 : 1;
    for (const Point &point : part.points) {
      low[kind] = std::min(low[kind], point[0]);
      high[kind] = std::max(high[kind], point[0]);
    }
  }
  size_t borders[2] = {0, 0};
  const double touching[2] = {1.7 * std::sqrt(1 - std::pow(plane / 3.1, 2)),
                              1.52 * std::sqrt(1 - std::pow((3 - plane) / 2.92, 2))};
  for (size_t k = 0; k < 2; ++k) {
    const double px = (touched[k] + 1.7 + 0.03 * 6.22) * scale;
    EXPECT_NEAR(high[k], px, 1.5);
    EXPECT_NEAR(low[k + 1], px, 1.5);  // contours are smooth across such edges
    double least = 0, most = -1e9;
    for (const Line &line : lines_of(svg, true)) {
      if (std::abs(line.points[0][0] - px) >= 1) continue;
      ++borders[k];
      for (const Point &point : line.points) {
        least = std::min(least, point[1]);
        most = std::max(most, point[1]);
      }
    }
    // Circles seen edge-on, each as wide all along: to where they go over into the back.
    EXPECT_GT(borders[k], 0u);
    EXPECT_NEAR(most - least, 2 * touching[k] * scale, 3);
  }
  EXPECT_EQ(borders[0] + borders[1], lines_of(svg, true).size());
  // The same before a dark page.
  std::vector<std::string> dark = options;
  dark.emplace_back("--dark");
  const std::string night = drawn_text(pair.path(), dark);
  EXPECT_NE(night.find("<rect width=\"10000\" height=\""), std::string::npos);
  EXPECT_NE(night.find("fill=\"#14171e\"/>"), std::string::npos);
  EXPECT_EQ(night.find("#ffffff"), std::string::npos);
  EXPECT_EQ(parts_of(night).size(), parts_of(svg).size());
  EXPECT_EQ(run_program({"mesh", pair.path(), "-o", "none.ply", "--dark"}).status, 2);
}

// Three balls of radius 1.5 in distances of 5, probe 1.4: the spheres of both its places meet in a ring of radius
// (1.4^2 - 2.9^2 + 25 / 3)^(1/2), of which the far side is seen. Its line has the light of that of which more is seen.
TEST(MeshPicture, CreasesBelongToOneSphere) {
  const TemporaryFile three("three.xyzr", "0 0 0 1.5\n5 0 0 1.5\n2.5 4.330127018922193 0 1.5\n");
  const std::string svg = drawn_text(
      three.path(), {"--probe", "1.4", "--surface", "ses", "--edge", "0.2", "--view", "0,-1,1", "--up", "0,0,1"});
  std::string path;
  std::map<std::string, size_t> of_balls;  // s0, s3 and s6, where their colour ends
  for (size_t at = 0; (at = svg.find("<path fill=\"none\" stroke=\"url(#", at)) != std::string::npos; ++at) {
    const std::string one = svg.substr(at, svg.find('\n', at) - at), stroke = attribute(one, "stroke");
    if (stroke.size() == 8) {
      ++of_balls[stroke];
    } else {
      EXPECT_EQ(path, "");
      path = one;
    }
  }
  EXPECT_EQ(of_balls.size(), 3u);
  ASSERT_NE(path, "");
  const std::string stroke = attribute(path, "stroke");
  EXPECT_FALSE(element_of(svg, stroke.substr(5, stroke.size() - 6)).empty());
  std::map<std::string, double> seen;
  for (const Part &part : parts_of(svg)) seen[part.fill] += std::fabs(part.area());
  size_t concave = 0;
  for (const auto &[fill, area] : seen) {
    if (fill.size() < 9 || fill.substr(0, 5) != "url(#") continue;  // s0, s3 and s6 are the balls
    EXPECT_LE(area, seen[stroke]) << fill;
    ++concave;
  }
  EXPECT_EQ(concave, 2u);
  const double ring = std::sqrt(1.4 * 1.4 - 2.9 * 2.9 + 25.0 / 3), scale = 1000 / (8 * 1.06);
  double low = 1e9, high = 0;
  for (const Part &part : loops_of(attribute(path, "d"))) {
    for (const Point &point : part.points) {
      low = std::min(low, point[0]);
      high = std::max(high, point[0]);
    }
  }
  EXPECT_NEAR(low + high, 1000, 8);
  EXPECT_GT(high - low, ring * scale);
  EXPECT_LT(high - low, 2 * ring * scale + 2);
}

bool covers(const std::vector<Part> &parts, const Point &at) {
  for (const Part &part : parts) {
    bool within = false;
    for (size_t k = 0; part.closed && k < part.points.size(); ++k) {
      const Point &a = part.points[k], &b = part.points[(k + 1) % part.points.size()];
      if ((a[1] > at[1]) == (b[1] > at[1])) continue;
      within ^= a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > at[0];
    }
    if (within) return true;
  }
  return false;
}

// Balls of other colours cover the same, also where a small ball has nothing of a side between it and a large one.
TEST(MeshPicture, ColoursLeaveNoGaps) {
  for (const char *small : {"1.2 0.9 0.5", "0.3 2.1 0.8", "1.2 1.0 1.3", "-0.9 1.4 0.2"}) {
    std::vector<std::vector<Part>> found;
    for (const char *names : {"CCC", "NOH", "CCH", "HCC", "CHC"}) {
      std::string text = "3\n\n";
      const char *const places[] = {"0 0 0", "2.6 0 0", small};
      for (size_t k = 0; k < 3; ++k) text += std::string(1, names[k]) + ' ' + places[k] + '\n';
      const TemporaryFile file("three.xyz", text);
      found.push_back(
          drawn(file.path(), {"--radius", "C=1.6", "--radius", "N=1.6", "--radius", "O=1.6", "--radius", "H=1.6",
                              "--probe", "1.4", "--surface", "ses", "--edge", "0.3", "--view", "0.2,0.1,1"}));
    }
    size_t inside = 0;
    for (double x = 0; x < 1000; x += 23) {
      for (double y = 0; y > -1000; y -= 23) {
        if (!covers(found[0], {x, y})) continue;
        ++inside;
        for (size_t k = 1; k < found.size(); ++k) {
          bool any = false;
          for (const Point &step : {Point{0, 0}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}}) {
            any = any || covers(found[k], {x + step[0], y + step[1]});
          }
          EXPECT_TRUE(any) << small << ' ' << k << ": " << x << ' ' << y;
        }
      }
    }
    EXPECT_GT(inside, 500u);
  }
}

// Six balls around a void: as a body it has the shape that they leave, and is seen only if they are cut open.
TEST(MeshPicture, VoidsAreTeal) {
  const std::vector<std::string> options = {"--edge", "0.05", "--view", "0,0,1"};
  for (const Part &part : drawn("good/cage.xyzr", options)) EXPECT_FALSE(part.is_teal());
  std::vector<std::string> cut = options;
  cut.emplace_back("--cut");
  double area = 0;  // of the side towards the viewer, which comes last
  std::string fill;
  std::array<double, 2> low = {1e9, 1e9};
  std::array<double, 2> high = {-1e9, -1e9};
  const std::vector<Part> parts = drawn("good/cage.xyzr", cut);
  for (const Part &part : parts) fill = part.is_teal() ? part.fill : fill;
  for (const Part &part : parts) {
    if (!part.is_teal()) continue;
    area -= part.fill == fill ? part.area() : 0;
    for (const auto &point : part.points) {
      for (size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], point[k]);
        high[k] = std::max(high[k], point[k]);
      }
    }
  }
  // Its corners are where three spheres meet: (c, c, c) with (1 - c)^2 + 2 c^2 = .81, in a picture 3.8 wide.
  const double corner = (1 - std::sqrt(1 - 3 * 0.19)) / 3;
  const double scale = 1000 / (3.8 * 1.06);
  for (size_t k = 0; k < 2; ++k) EXPECT_NEAR(high[k] - low[k], 2 * corner * scale, 0.5);
  // Between the corners four arcs bend inward.
  EXPECT_LT(area, std::pow(2 * corner * scale, 2));
  EXPECT_GT(area, std::pow(0.2 * scale, 2));
}

// The cut goes through the middle of the void, not of all balls: nothing is before the front of the void.
TEST(MeshPicture, TheCutGoesThroughTheVoid) {
  const TemporaryFile more("more.xyzr", read_file(inputs_folder() + "/good/cage.xyzr") + "0 0 9 1.5\n3 0 2 1\n");
  const std::vector<Part> parts = drawn(more.path(), {"--edge", "0.05", "--view", "0,0,1", "--cut"});
  const auto last = std::find_if(parts.rbegin(), parts.rend(), [](const Part &part) { return part.closed; });
  ASSERT_NE(last, parts.rend());
  EXPECT_TRUE(last->is_teal());
}

// The nearer atom is painted last, in its own colour, from whichever side one looks.
TEST(MeshPicture, NearerOnesComeLast) {
  const TemporaryFile pair("pair.xyz", "2\n\nO 0 0 3\nN 0 0 -3\n");
  const auto front = drawn(pair.path(), {"--view", "0,0,1"}).back().colour;
  EXPECT_GT(front[0], front[2] + 20);  // oxygen
  const auto behind = drawn(pair.path(), {"--view", "0,0,-1"}).back().colour;
  EXPECT_GT(behind[2], behind[0] + 20);  // nitrogen
}

// A small ball behind a large one is not painted, nor named; seen from the side it is.
TEST(MeshPicture, HiddenOnesAreLeftOut) {
  const TemporaryFile hidden("hidden.xyz", "3\n\nC 0 0 0\nN 0 0 -4\nO 9 0 -2\n");
  const std::vector<std::string> options = {"--view", "0,0,1", "--edge", "0.2", "--radius", "C=3,N=0.8,O=1"};
  const std::string svg = drawn_text(hidden.path(), options);
  EXPECT_EQ(svg.find(">N<"), std::string::npos);
  EXPECT_NE(svg.find(">O<"), std::string::npos);
  EXPECT_NE(drawn_text(hidden.path(), {"--view", "1,0,0", "--edge", "0.2", "--radius", "C=3,N=0.8,O=1"}).find(">N<"),
            std::string::npos);
}

bool is_blue(const Part &part) {
  return part.closed && part.colour[2] > part.colour[0] + 60;
}

// Six balls of radius 0.7 at distance 1 around a room. Probes below sqrt(2/3) - 0.7 = 0.1165 pass its windows: it
// is a pocket between such ones and wider ones.
TEST(MeshPicture, PocketsHaveColours) {
  const TemporaryFile room("room.xyzr", "1 0 0 0.7\n-1 0 0 0.7\n0 1 0 0.7\n0 -1 0 0.7\n0 0 1 0.7\n0 0 -1 0.7\n");
  for (const char *surface : {"ses", "sas"}) {
    for (const auto &[wide, pockets] : {std::pair<const char *, bool>{"0.115", false}, {"0.118", true}}) {
      const std::vector<std::string> options = {"--probe",   "0.1", "--surface", surface, "--edge", "0.1",
                                                "--pockets", wide,  "--view",    "1,2,3", "--cut"};
      const std::string svg = drawn_text(room.path(), options);
      EXPECT_EQ(svg.find(">pocket 1<") != std::string::npos, pockets) << surface << wide;
      double blue = 0, other = 0;
      for (const Part &part : parts_of(svg)) (is_blue(part) ? blue : other) += std::abs(part.area());
      EXPECT_EQ(blue > 0, pockets);
      EXPECT_GT(other, 0);
      // The wall of the room behind the cut, which is 0.3 to 0.7 from its middle, in a picture of about 3.3.
      if (pockets) {
        EXPECT_GT(blue, 0.2 * std::pow(1000 / 3.3, 2)) << surface;
        EXPECT_LT(blue, 1.8 * std::pow(1000 / 3.3, 2)) << surface;
      }
    }
  }
  // A probe that passes no window rolls over concave patches, too: no part of the room's wall is without a colour.
  const std::string closed = drawn_text(room.path(), {"--probe", "0.13", "--surface", "ses", "--edge", "0.1",
                                                      "--pockets", "0.2", "--view", "1,2,3", "--cut"});
  double wall = 0;
  for (const Part &part : parts_of(closed)) wall += is_blue(part) ? std::abs(part.area()) : 0;
  EXPECT_GT(wall, 0.8 * std::pow(1000 / 3.3, 2));
  EXPECT_EQ(run_program({"mesh", room.path(), "-o", "x.svg", "--probe", "0.1", "--pockets", "0.05"}).err,
            "hardsphere: --pockets: W must not be less than --probe\n");
  EXPECT_EQ(run_program({"mesh", room.path(), "-o", "x.ply", "--probe", "0.1", "--pockets", "0.5"}).err,
            "hardsphere: --pockets is for a picture, -o OUT.svg\n");
  EXPECT_EQ(run_program({"mesh", room.path(), "-o", "x.svg", "--least", "0.5"}).err,
            "hardsphere: --least needs --pockets\n");
}

// A pocket that is no wider than its mouth by so much has no colour of its own, and is no part of the outside either.
TEST(MeshPicture, OtherPocketsAreGrey) {
  const TemporaryFile room("room.xyzr", "1 0 0 0.7\n-1 0 0 0.7\n0 1 0 0.7\n0 -1 0 0.7\n0 0 1 0.7\n0 0 -1 0.7\n");
  const auto grey_of = [&](const std::string &least, std::string &svg) {
    svg = drawn_text(room.path(), {"--probe", "0.1", "--surface", "ses", "--edge", "0.1", "--pockets", "0.118",
                                   "--least", least, "--view", "1,2,3", "--cut"});
    double grey = 0;
    for (const Part &part : parts_of(svg)) {
      const bool slate = part.closed && part.colour[2] > part.colour[0] && !is_blue(part);
      grey += slate ? std::abs(part.area()) : 0;
    }
    return grey;
  };
  std::string svg;
  EXPECT_EQ(grey_of("0", svg), 0);
  EXPECT_EQ(svg.find(">other pockets<"), std::string::npos);
  EXPECT_GT(grey_of("5", svg), 0.2 * std::pow(1000 / 3.3, 2));
  EXPECT_NE(svg.find(">pockets<"), std::string::npos);
  EXPECT_EQ(svg.find(">pocket 1<"), std::string::npos);
}

// By symmetry the border of the room is the octahedron of the centres, |x| + |y| + |z| = 1, but for two thirds of an
// edge by which smoothing may move it. Cut open along x = y it is seen edge-on, beside windows that are cut through
// their middles.
TEST(MeshPicture, PocketsEndWhereTheWayUpChanges) {
  const TemporaryFile room("room.xyzr", "1 0 0 0.7\n-1 0 0 0.7\n0 1 0 0.7\n0 -1 0 0.7\n0 0 1 0.7\n0 0 -1 0.7\n");
  for (const auto &[surface, radius] : {std::pair<const char *, double>{"ses", 0.7}, {"sas", 0.8}}) {
    const double high = 2 * (1 + radius), wide = 2 * (std::sqrt(0.5) + radius);
    const double scale = 1000 / (wide + 0.06 * high);
    for (const char *edge : {"0.12", "0.06"}) {
      double most = 0;
      for (const Part &part : drawn(room.path(), {"--probe", "0.1", "--surface", surface, "--edge", edge, "--pockets",
                                                  "0.118", "--view", "1,-1,0", "--up", "0,0,1", "--cut"})) {
        for (const auto &point : part.points) {
          const double across = (point[0] - 500) / scale, up = point[1] / scale + 0.53 * high;
          if (is_blue(part)) most = std::max(most, std::sqrt(2) * std::abs(across) + std::abs(up));
        }
      }
      EXPECT_NEAR(most, 1, std::stod(edge) * 2 / 3) << surface << edge;
    }
  }
}

// A pocket has a rim, where its colour ends and nowhere else; surfaces without pockets have none.
TEST(MeshPicture, PocketsHaveRims) {
  const TemporaryFile room("room.xyzr", "1 0 0 0.7\n-1 0 0 0.7\n0 1 0 0.7\n0 -1 0 0.7\n0 0 1 0.7\n0 0 -1 0.7\n");
  const double edge = 0.12 * 1000 / (2 * (std::sqrt(0.5) + 0.7) + 0.06 * 3.4);  // px
  std::vector<std::string> options = {"--probe", "0.1",    "--surface", "ses",   "--edge", "0.06",
                                      "--view",  "1,-1,0", "--up",      "0,0,1", "--cut"};
  EXPECT_EQ(rims_of(drawn_text(room.path(), options)).size(), 0u);
  options.insert(options.end(), {"--pockets", "0.118"});
  const std::string svg = drawn_text(room.path(), options);
  const std::vector<Line> rims = rims_of(svg);
  std::vector<Point> blue;
  for (const Part &part : parts_of(svg)) {
    if (is_blue(part)) blue.insert(blue.end(), part.points.begin(), part.points.end());
  }
  ASSERT_GT(rims.size(), 0u);
  for (const Line &line : rims) {
    for (const Point &point : line.points) {
      double nearest = 1000;
      for (const Point &at : blue) nearest = std::min(nearest, std::hypot(at[0] - point[0], at[1] - point[1]));
      EXPECT_LT(nearest, edge);
    }
  }
}

// Borders are smoothed no farther than pockets are wide.
TEST(MeshPicture, PocketsAreThereHoweverLongEdgesAre) {
  for (const char *edge : {"1", "5"}) {
    const TemporaryFile out("long.svg");
    run_json({"mesh", molecules_folder() + "/crambin.pdb", "--probe", "0.8", "--surface", "ses", "--edge", edge,
              "--pockets", "3", "--least", "0.1", "--cut", "-o", out.path()});
    const std::string svg = read_file(out.path());
    EXPECT_NE(svg.find(">pocket 1<"), std::string::npos) << edge;
    EXPECT_NE(svg.find(">other pockets<"), std::string::npos) << edge;
  }
}

// The room with a ball far before it: the cut opens the room, where the middle of everything is between the two.
TEST(MeshPicture, TheCutGoesThroughThePocket) {
  const TemporaryFile room("room.xyzr",
                           "1 0 0 0.7\n-1 0 0 0.7\n0 1 0 0.7\n0 -1 0 0.7\n0 0 1 0.7\n0 0 -1 0.7\n0 0 7 0.7\n");
  bool section = false, blue = false;
  for (const Part &part : drawn(room.path(), {"--probe", "0.1", "--surface", "ses", "--edge", "0.2", "--pockets",
                                              "0.13", "--view", "0,0,1", "--cut"})) {
    section = section || !part.closed;
    blue = blue || is_blue(part);
  }
  EXPECT_TRUE(section && blue);
}

// A cavity is a pocket without a mouth: its body has the colour, and no void is teal.
TEST(MeshPicture, PocketsWithoutMouths) {
  const std::string svg = drawn_text("good/cage.xyzr", {"--edge", "0.2", "--cut", "--pockets", "1"});
  size_t blue = 0;
  for (const Part &part : parts_of(svg)) {
    blue += is_blue(part) ? 1 : 0;
    EXPECT_FALSE(part.closed && part.is_teal());
  }
  EXPECT_GT(blue, 0u);
  EXPECT_NE(svg.find(">pocket 1<"), std::string::npos);
  EXPECT_EQ(svg.find(">voids<"), std::string::npos);
}

// The names are the numbers that pores prints, of those that last.
TEST(MeshPicture, PocketsHaveTheirNumbers) {
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const std::string svg = drawn_text(
      crambin, {"--edge", "0.8", "--probe", "0.8", "--surface", "ses", "--pockets", "3", "--least", "0.1", "--cut"});
  const Outcome listed = run_program({"pores", crambin, "--probe", "0.8", "--pockets", "3", "--least", "0.1", "--csv"});
  std::istringstream lines(listed.out);
  std::vector<std::string> numbers;
  for (std::string line; std::getline(lines, line);) numbers.push_back(line.substr(0, line.find(',')));
  for (size_t at = svg.find(">pocket "); at != std::string::npos; at = svg.find('>', at + 1)) {
    const std::string text = svg.substr(at + 1, svg.find('<', at) - at - 1);
    const std::string number = text.rfind("pocket ", 0) == 0 ? text.substr(7) : text;
    if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) continue;
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), number), 1) << number;
  }
  size_t named = 0;
  for (size_t k = 1; k < numbers.size(); ++k) {
    const bool shown = svg.find('>' + (named == 0 ? "pocket " : std::string()) + numbers[k] + '<') != std::string::npos;
    named += shown ? 1 : 0;
    EXPECT_FALSE(shown && k > 6);
    if (k == 1) {
      EXPECT_TRUE(shown);  // the cut goes through it
    }
  }
  EXPECT_GE(named, 3u);
}

TEST(MeshPicture, OptionsOfPicturesAreForPictures) {
  for (const std::vector<std::string> &options : std::vector<std::vector<std::string>>{
           {"--cut"}, {"--view", "1,0,0"}, {"--view", "auto"}, {"--up", "1,0,0"}, {"--rotate", "0,90,0"}}) {
    std::vector<std::string> arguments = {"mesh", "good/water.pdb", "-o", "mesh.ply"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "hardsphere: --view, --up, --rotate and --cut are for a picture, -o OUT.svg\n");
  }
}

// The name of a file may be anything; XML is not.
TEST(MeshPicture, TitlesAreXml) {
  const TemporaryFolder folder("mesh_title");
  const std::string ball = folder.write("a<&\x01\xC3.xyzr", "0 0 0 1\n");
  const std::string out = folder.path("out.svg");
  ASSERT_EQ(run_program({"mesh", ball, "-o", out}).status, 0);
  EXPECT_NE(read_file(out).find("<title>a&lt;&amp;??.xyzr</title>"), std::string::npos);
  const std::string nothing = folder.write("nothing.xyzr", "0 0 0 0\n");
  ASSERT_EQ(run_program({"mesh", nothing, "-o", out}).status, 0);
  EXPECT_TRUE(parts_of(read_file(out)).empty());
}

}  // namespace
