// Pictures of maps, read again and scan-converted: every pixel lies in the path of the ball that the z-buffer sees
// there and in no other one, in each format; and every line is drawn once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawn_map.hpp"
#include "molecule_balls.hpp"
#include "path_painter.hpp"
#include "picture_paths.hpp"
#include "random_balls.hpp"

namespace {

struct Scene {
  std::string name;
  DrawnMap map;
  double scale;  // px for a unit of length
};

oracle::Balls lattice() {
  oracle::Balls balls;
  for (int64_t k = 0; k < 27; ++k) balls.push_back({k % 3 * 1500, k / 3 % 3 * 1500, k / 9 * 1500, 1000});
  return balls;
}

// A ring of balls before a larger one, which is seen within the ring and around it.
oracle::Balls ring() {
  oracle::Balls balls = {{0, 0, 0, 3000}};
  for (int k = 0; k < 6; ++k) {
    balls.push_back({std::lround(1000 * std::cos(k * 3.14159265358979 / 3)),
                     std::lround(1000 * std::sin(k * 3.14159265358979 / 3)), 9000 + 7 * k, 550});
  }
  return balls;
}

// Rows of balls one before the other, turned by a quarter: many small faces.
oracle::Balls crossing_rows() {
  oracle::Balls balls;
  for (int64_t k = 0; k < 8; ++k) {
    for (int64_t i = 0; i < 26; ++i) {
      balls.push_back({300 * i, 1000 * k, 0, 260});
      balls.push_back({1000 * k + 37, 300 * i + 11, 2000, 260});
    }
  }
  return balls;
}

const std::vector<Scene> &scenes() {
  static const std::vector<Scene> all = [] {
    const oracle::Balls caffeine = read_molecule(support::own_molecule("caffeine.pdb"));
    const oracle::Balls crambin = read_molecule(support::own_molecule("crambin.pdb"));
    oracle::RandomSource random(77);
    std::vector<Scene> made;
    made.push_back({"caffeine, plane seen edge on", DrawnMap(caffeine), 30});
    made.push_back({"caffeine from the side", DrawnMap(caffeine, {0, 1, 0}), 30});
    made.push_back({"crambin", DrawnMap(crambin), 10});
    made.push_back({"crambin from elsewhere", DrawnMap(crambin, {1, 2, 3}), 10});
    made.push_back({"a lattice along its axis", DrawnMap(lattice()), 60});
    made.push_back({"a ring", DrawnMap(ring()), 50});
    made.push_back({"crossing rows", DrawnMap(crossing_rows()), 30});
    made.push_back({"random balls", DrawnMap(oracle::loose_balls(random, 200), {3, 1, 2}), 500});
    made.push_back({"one ball", DrawnMap({{5, 7, 9, 1000}}), 100});
    made.push_back({"no ball", DrawnMap({}), 100});
    return made;
  }();
  return all;
}

// band: px from edges within which a pixel counts for nothing. SVG: what renderers make of narrow ellipses, see
// arcs_test. PDF: chords of cubics.
struct Format {
  uint32_t id;
  PictureFile (*read)(const std::string &);
  double band;
};
constexpr Format formats[] = {
    {HSP_FORMAT_SVG, read_svg, 0.06}, {HSP_FORMAT_EPS, read_eps, 1e-4}, {HSP_FORMAT_PDF, read_pdf, 0.03}};

oracle::PathArc line(const PagePoint &start, const PagePoint &end) {
  const double half[2] = {(end[0] - start[0]) / 2, (end[1] - start[1]) / 2};
  return {{start[0] + half[0], start[1] + half[1]},
          {std::hypot(half[0], half[1]), 0},
          std::atan2(half[1], half[0]),
          -std::numbers::pi,
          0,
          start,
          end};
}

// As arcs that are closed bit for bit.
oracle::Path oracle_path(const PaintedPath &path) {
  oracle::Path result;
  for (const Loop &loop : path.loops) {
    EXPECT_TRUE(loop.closed);
    PagePoint here = loop.start;
    for (size_t k = 0; k < loop.segments.size(); ++k) {
      const Segment &s = loop.segments[k];
      const PagePoint end = k + 1 == loop.segments.size() ? loop.start : s.end;
      if (s.kind == Segment::Kind::arc) {
        const double a = std::hypot(s.axis[0][0], s.axis[0][1]);
        const double b = std::hypot(s.axis[1][0], s.axis[1][1]);
        const double rotation = std::atan2(s.axis[0][1], s.axis[0][0]);
        result.push_back({s.centre, {a, b}, rotation, s.from, s.to, here, end});
      } else {
        constexpr int chords = 48;
        const int parts = s.kind == Segment::Kind::line ? 1 : chords;
        for (int part = 1; part <= parts; ++part) {
          const PagePoint next = part == parts ? end : s.at(static_cast<double>(part) / parts);
          result.push_back(line(here, next));
          here = next;
        }
      }
      here = end;
    }
  }
  return result;
}

// How many paths cover each pixel, and which of them covers it last.
struct Coverage {
  std::vector<uint32_t> ball;
  std::vector<int> times;
};

Coverage covered(const PictureFile &file, const std::vector<uint32_t> &balls, const oracle::PixelGrid &grid) {
  Coverage coverage{std::vector<uint32_t>(grid.pixels(), oracle::no_ball), std::vector<int>(grid.pixels(), 0)};
  for (size_t p = 0; p < file.paths.size(); ++p) {
    const oracle::PaintedImage image = oracle::painted({oracle_path(file.paths[p])}, grid);
    EXPECT_TRUE(image.windings.empty()) << "path " << p;  // either fill rule
    for (size_t pixel = 0; pixel < grid.pixels(); ++pixel) {
      if (image.even_odd[pixel] == oracle::no_ball) continue;
      coverage.ball[pixel] = balls[p];
      ++coverage.times[pixel];
    }
  }
  return coverage;
}

// The ball that is seen at each pixel and everywhere within a band around it; else `undecided`.
constexpr uint32_t undecided = 0xFFFFFFF0U;
std::vector<uint32_t> certain_pixels(const std::vector<oracle::PlainBall> &seen, const oracle::PixelGrid &grid,
                                     double band) {
  std::vector<uint32_t> result;
  for (const oracle::SeenPixel &pixel : oracle::z_buffer(seen, grid)) result.push_back(pixel.ball);
  for (int k = 0; k < 8; ++k) {
    oracle::PixelGrid moved = grid;
    moved.left += band * std::cos(k * std::numbers::pi / 4);
    moved.bottom += band * std::sin(k * std::numbers::pi / 4);
    const std::vector<oracle::SeenPixel> pixels = oracle::z_buffer(seen, moved);
    for (size_t p = 0; p < pixels.size(); ++p) {
      if (pixels[p].ball != result[p]) result[p] = undecided;
    }
  }
  return result;
}

hsp_picture_options options_for(const Scene &scene, uint32_t format, double outline) {
  hsp_picture_options options = picture_options(format, HSP_STYLE_FLAT);
  options.width = 240;
  options.scale = scene.scale;
  options.outline = outline;
  std::copy(scene.map.info().origin, scene.map.info().origin + 3, options.centre);
  return options;
}

// The page's pixels, and the balls on it.
constexpr double side = 240;
const oracle::PixelGrid page{0.4871, 0.5113, 1, 240, 240};

std::vector<oracle::PlainBall> on_page(const Scene &scene) {
  std::vector<oracle::PlainBall> balls = scene.map.seen();
  for (oracle::PlainBall &ball : balls) {
    for (size_t k = 0; k < 3; ++k) ball.centre[k] = ball.centre[k] * scene.scale + (k < 2 ? side / 2 : 0);
    ball.radius *= scene.scale;
  }
  return balls;
}

TEST(VisibleRegions, AreWhatTheZBufferSees) {
  for (const Scene &scene : scenes()) {
    const std::vector<oracle::PlainBall> balls = on_page(scene);
    std::vector<uint32_t> owners;
    for (const Format &format : formats) {
      SCOPED_TRACE(scene.name + ", format " + std::to_string(format.id));
      const PictureFile file = format.read(scene.map.picture(options_for(scene, format.id, 0)));
      ASSERT_EQ(file.paths.size(), scene.map.info().balls);
      EXPECT_TRUE(file.lines.empty());
      if (format.id == HSP_FORMAT_SVG) {  // the others tell no balls, but have the same order
        for (const PaintedPath &path : file.paths) owners.push_back(path.ball);
      }
      const Coverage coverage = covered(file, owners, page);
      const std::vector<uint32_t> expected = certain_pixels(balls, page, format.band);
      size_t wrong = 0, twice = 0, skipped = 0, shown = 0;
      for (size_t p = 0; p < expected.size(); ++p) {
        skipped += expected[p] == undecided;
        if (expected[p] == undecided) continue;
        wrong += coverage.ball[p] != expected[p];
        twice += coverage.times[p] > 1;
        shown += expected[p] != oracle::no_ball;
      }
      EXPECT_EQ(wrong, 0U);
      EXPECT_EQ(twice, 0U);
      EXPECT_LT(skipped, expected.size() / 10);
      if (!owners.empty()) {
        EXPECT_GT(shown, expected.size() / 10);
      }
    }
  }
}

// The arcs of lines are the edges of the map, by their lengths as polygons of many sides; paths do not change.
TEST(VisibleRegions, HaveEachEdgeAsALineOnce) {
  for (const Scene &scene : scenes()) {
    double expected = 0;
    for (const hsp_map_edge &edge : scene.map.edges()) {
      constexpr int parts = 400;
      const auto place = [&](int part, size_t k) {
        const double t = edge.from + (edge.to - edge.from) * part / parts;
        return edge.centre[k] + std::cos(t) * edge.first[k] + std::sin(t) * edge.second[k];
      };
      for (int part = 0; part < parts; ++part) {
        expected += scene.scale * std::hypot(place(part + 1, 0) - place(part, 0), place(part + 1, 1) - place(part, 1));
      }
    }
    for (const Format &format : formats) {
      SCOPED_TRACE(scene.name + ", format " + std::to_string(format.id));
      // So thin that ellipses stay ellipses.
      const PictureFile file = format.read(scene.map.picture(options_for(scene, format.id, 8e-4)));
      const PictureFile bare = format.read(scene.map.picture(options_for(scene, format.id, 0)));
      double length = 0;
      for (const PaintedPath &lines : file.lines) {
        for (const Loop &run : lines.loops) {
          for (const Segment &s : run.segments) {
            constexpr int parts = 200;
            for (int part = 0; part < parts; ++part) {
              length += distance(s.at(static_cast<double>(part) / parts), s.at((part + 1.0) / parts));
            }
          }
        }
      }
      EXPECT_NEAR(length, expected, 0.002 * expected);
      ASSERT_EQ(file.paths.size(), bare.paths.size());
      for (size_t p = 0; p < file.paths.size(); ++p) {
        ASSERT_EQ(file.paths[p].loops.size(), bare.paths[p].loops.size());
        for (size_t l = 0; l < file.paths[p].loops.size(); ++l) {
          EXPECT_EQ(file.paths[p].loops[l].segments.size(), bare.paths[p].loops[l].segments.size());
        }
      }
    }
  }
}

// Lines stand apart and take no clicks; without them there is nothing but paths, and with shades each has its light.
TEST(VisibleRegions, AreForClickMaps) {
  const Scene &crambin = scenes()[2];
  const auto count = [](const std::string &text, const std::string &part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_SOFT);
  const std::string lined = crambin.map.picture(options);
  EXPECT_EQ(count(lined, "data-ball="), crambin.map.info().balls);
  EXPECT_EQ(count(lined, "<use "), crambin.map.info().balls);
  EXPECT_EQ(count(lined, "<g fill=\"none\" pointer-events=\"none\" stroke="), count(lined, "stroke=\""));
  EXPECT_GT(count(lined, "stroke=\""), 3U);
  options.outline = 0;
  const std::string bare = crambin.map.picture(options);
  EXPECT_EQ(count(bare, "stroke"), 0U);
  EXPECT_EQ(count(bare, "<path") + count(bare, "<circle"), crambin.map.info().balls);
  options.flags = HSP_PICTURE_NO_IDS;
  EXPECT_EQ(count(crambin.map.picture(options), "data-ball="), 0U);
}

// Fitted into the page a map is where a view of the same balls is.
TEST(VisibleRegions, FillThePageAsViewsDo) {
  const oracle::Balls balls = read_molecule(support::own_molecule("crambin.pdb"));
  const DrawnView view(balls, {1, 2, 3});
  const DrawnMap map(balls, {1, 2, 3});
  const PictureFile painted = read_svg(view.picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT)));
  const PictureFile mapped = read_svg(map.picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT)));
  EXPECT_NEAR(painted.height, mapped.height, 1e-5);
  EXPECT_NEAR(painted.width, mapped.width, 1e-5);
  const auto highest = [](const PictureFile &file) {
    double most = 0;
    for (const PaintedPath &path : file.paths)
      for (const Loop &loop : path.loops)
        for (const Segment &s : loop.segments)
          for (int k = 0; k <= 20; ++k) most = std::max(most, s.at(k / 20.0)[1]);
    return most;
  };
  EXPECT_NEAR(highest(painted), highest(mapped), 1);
}

}  // namespace
