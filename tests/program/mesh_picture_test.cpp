// hardsphere mesh -o OUT.svg: what the triangles of a picture cover, in which order and colours, and what a cut shows.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

struct Part {
  std::array<int, 3> colour;
  std::vector<std::array<double, 2>> points;  // px, y up
  bool closed;

  [[nodiscard]] double area() const {
    double sum = 0;
    for (size_t k = 0; closed && k < points.size(); ++k) {
      const auto &a = points[k];
      const auto &b = points[(k + 1) % points.size()];
      sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sum;
  }
  [[nodiscard]] bool is_red() const { return colour[0] > colour[1] + 60; }
};

// Units of the file are tenths of a px.
std::vector<Part> parts_of(const std::string &svg) {
  std::vector<Part> parts;
  const std::string head = "<path color=\"#";
  for (size_t at = svg.find(head); at != std::string::npos; at = svg.find(head, at + 1)) {
    Part part{{}, {}, false};
    const unsigned long colour = std::stoul(svg.substr(at + head.size(), 6), nullptr, 16);
    for (size_t k = 0; k < 3; ++k) part.colour[k] = static_cast<int>(colour >> (16 - 8 * k) & 0xFF);
    const size_t begin = svg.find(" d=\"M", at) + 5;
    std::string path = svg.substr(begin, svg.find('"', begin) - begin);
    part.closed = path.back() == 'z';
    std::string spaced;
    for (const char c : path) {
      if (c == '-') spaced += ' ';
      spaced += c == 'l' || c == 'z' ? ' ' : c;
    }
    std::istringstream numbers(spaced);
    double x = 0;
    double y = 0;
    for (double dx = 0, dy = 0; numbers >> dx >> dy;) {
      x += dx / 10;
      y -= dy / 10;
      part.points.push_back({x, y});
    }
    parts.push_back(part);
  }
  return parts;
}

std::vector<Part> drawn(const std::string &file, std::vector<std::string> options) {
  const TemporaryFile out("mesh.svg");
  options.insert(options.begin(), {"mesh", file, "-o", out.path()});
  const Outcome outcome = run_program(options);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string svg = read_file(out.path());
  EXPECT_EQ(svg.substr(0, 38), "<svg xmlns=\"http://www.w3.org/2000/svg");
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  return parts_of(svg);
}

double area_of(const std::vector<Part> &parts) {
  double sum = 0;
  for (const Part &part : parts) sum += part.area();
  return sum;
}

// The front of a ball covers its disc, once: 1000 px are its diameter and a margin of .03 of it on either side.
TEST(MeshPicture, TheFrontOfABallIsADisc) {
  const TemporaryFile ball("ball.xyzr", "5 6 7 2\n");
  const double disc = std::numbers::pi * 0.25 * std::pow(1000 / 1.06, 2);
  for (const char *view : {"0,0,1", "1,2,3"}) {
    const std::vector<Part> parts = drawn(ball.path(), {"--edge", "0.2", "--view", view});
    EXPECT_GT(parts.size(), 1000u);
    for (const Part &part : parts) {
      EXPECT_GE(part.area(), -1);  // but for rounding they all face the viewer
    }
    EXPECT_NEAR(area_of(parts), disc, 0.01 * disc) << view;
  }
}

// Cut in the middle, the back of the ball shows its inside, on the same disc, within a rim all around.
TEST(MeshPicture, ACutShowsTheInside) {
  const TemporaryFile ball("ball.xyzr", "5 6 7 2\n");
  const double radius = 500 / 1.06;
  const std::vector<Part> parts = drawn(ball.path(), {"--edge", "0.2", "--view", "0,0,1", "--cut"});
  double rim = 0;
  double area = 0;
  for (const Part &part : parts) {
    area += part.area();
    if (part.closed) continue;
    ASSERT_EQ(part.points.size(), 2u);
    rim += std::hypot(part.points[1][0] - part.points[0][0], part.points[1][1] - part.points[0][1]);
    EXPECT_NEAR(std::hypot(part.points[0][0] - 500, part.points[0][1] + 500), radius, 0.02 * radius);
  }
  EXPECT_NEAR(area, -std::numbers::pi * radius * radius, 0.01 * std::numbers::pi * radius * radius);
  EXPECT_NEAR(rim, 2 * std::numbers::pi * radius, 0.02 * rim);
}

// Six balls around a void: as a body it has the shape that they leave, and is seen only if they are cut open.
TEST(MeshPicture, VoidsAreRed) {
  const std::vector<std::string> options = {"--edge", "0.05", "--view", "0,0,1"};
  for (const Part &part : drawn("good/cage.xyzr", options)) EXPECT_FALSE(part.is_red());
  std::vector<std::string> cut = options;
  cut.emplace_back("--cut");
  double area = 0;
  std::array<double, 2> low = {1e9, 1e9};
  std::array<double, 2> high = {-1e9, -1e9};
  for (const Part &part : drawn("good/cage.xyzr", cut)) {
    if (!part.is_red()) continue;
    area -= part.area();
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
  ASSERT_FALSE(parts.empty());
  EXPECT_TRUE(parts.back().is_red());
}

// The nearer atom is painted last, in its own colour, from whichever side one looks.
TEST(MeshPicture, NearerOnesComeLast) {
  const TemporaryFile pair("pair.xyz", "2\n\nO 0 0 3\nN 0 0 -3\n");
  const auto front = drawn(pair.path(), {"--view", "0,0,1"}).back().colour;
  EXPECT_GT(front[0], front[2] + 20);  // oxygen
  const auto behind = drawn(pair.path(), {"--view", "0,0,-1"}).back().colour;
  EXPECT_GT(behind[2], behind[0] + 20);  // nitrogen
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
