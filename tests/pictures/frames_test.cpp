// Fixed frames: 36 pictures of a turn have one scale and one centre; a frame that says what the fit chooses gives the
// fit's bytes; what lies beyond the edges is cut off.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drawn_view.hpp"
#include "molecule_balls.hpp"
#include "picture_paths.hpp"

namespace {

struct Reader {
  uint32_t format;
  PictureFile (*read)(const std::string &);
  double away;  // what rounding may move a point by, px
};
const Reader readers[] = {
    {HSP_FORMAT_SVG, read_svg, 0.011}, {HSP_FORMAT_EPS, read_eps, 1e-6}, {HSP_FORMAT_PDF, read_pdf, 0.011}};

double number_after(const std::string &text, const std::string &key) {
  const size_t at = text.find(key);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + key.size()));
}

// The width of the lines: the last number before setlinewidth or w.
double line_width(const std::string &text, uint32_t format) {
  if (format == HSP_FORMAT_SVG) return number_after(text, "stroke-width=\"");
  if (format == HSP_FORMAT_EPS) return number_after(text, "1 setlinejoin ");
  return number_after(text, " cm 1 j ");
}

// Where the silhouette of a ball in front of all others lies: the box of its one path.
struct Disc {
  PagePoint centre;
  double radius;
};
Disc last_disc(const PictureFile &file) {
  PagePoint low = {1e300, 1e300};
  PagePoint high = {-1e300, -1e300};
  for (const Segment &segment : file.paths.back().loops.at(0).segments) {
    for (int k = 0; k <= 512; ++k) {
      const PagePoint at = segment.at(k / 512.0);
      for (size_t axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
    }
  }
  return {{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2}, (high[0] - low[0]) / 2};
}

Direction direction(int frame, double tilt) {
  const double angle = 2 * std::numbers::pi * frame / 36;
  return {std::sin(angle), tilt, std::cos(angle)};
}

// A marker, a ball that stands apart from crambin towards the viewer, is where the frame says, with its radius times
// the scale, whatever the direction. Crambin is off the frame's centre, so that its own box wanders.
TEST(PictureFrames, StayWhereTheyAreWhenAMoleculeTurns) {
  constexpr double step = 0x1p-10;  // of DrawnView
  const oracle::Balls molecule = read_molecule(support::own_molecule("crambin.pdb"));
  const double centre[3] = {double(molecule[7].x) * step, double(molecule[7].y) * step, double(molecule[7].z) * step};
  std::vector<double> lines(3, 0);
  double narrowest = 1e300;
  double widest = 0;
  for (int frame = 0; frame < 36; ++frame) {
    const Direction towards = direction(frame, 0.3);
    const double length = std::sqrt(1 + 0.3 * 0.3);
    // On the line through the centre that is seen as a point.
    oracle::Balls balls = molecule;
    const auto along = [&](size_t axis, int64_t value) {
      return value + static_cast<int64_t>(std::lround(60 * towards[axis] / length / step));
    };
    balls.push_back({along(0, molecule[7].x), along(1, molecule[7].y), along(2, molecule[7].z), 1700});
    const DrawnView view(balls, towards);
    const double box = view.info().high[0] - view.info().low[0];
    narrowest = std::min(narrowest, box);
    widest = std::max(widest, box);
    for (const Reader &reader : readers) {
      SCOPED_TRACE("frame " + std::to_string(frame) + ", format " + std::to_string(reader.format));
      hsp_picture_options options = picture_options(reader.format, HSP_STYLE_FLAT);
      options.width = 640;
      options.height = 480;
      options.scale = 12.5;
      std::copy(centre, centre + 3, options.centre);
      const std::string text = view.picture(options);
      const PictureFile file = reader.read(text);
      EXPECT_NEAR(file.width, 640, 1e-5);
      EXPECT_NEAR(file.height, 480, 1e-5);
      const Disc marker = last_disc(file);
      // The marker's own centre is rounded to half a step, and extremes are looked for at 512 points of an arc.
      const double away = reader.away + 12.5 * step + 1e-3;
      EXPECT_NEAR(marker.centre[0], 320, away);
      EXPECT_NEAR(marker.centre[1], 240, away);
      EXPECT_NEAR(marker.radius, 12.5 * 1700 * step, away);
      double &line = lines[reader.format];
      if (frame == 0) line = line_width(text, reader.format);
      EXPECT_GT(line, 0.1);
      EXPECT_EQ(line_width(text, reader.format), line);
    }
  }
  EXPECT_GT(widest, 1.15 * narrowest);
}

// The frame that the header says is the one of a fit without margin and lines.
hsp_picture_options as_frame(const DrawnView &view, hsp_picture_options options) {
  const hsp_view_info &info = view.info();
  options.scale = options.width / (info.high[0] - info.low[0]);
  options.height = options.scale * (info.high[1] - info.low[1]);
  for (int axis = 0; axis < 3; ++axis) {
    options.centre[axis] = info.origin[axis] + info.right[axis] * (info.low[0] + info.high[0]) / 2 +
                           info.up[axis] * (info.low[1] + info.high[1]) / 2;
  }
  return options;
}

TEST(PictureFrames, ThatSayWhatTheFitChoosesGiveItsBytes) {
  const DrawnView square({{0, 0, 0, 1024}, {1024, 1024, 0, 1024}, {512, 0, 512, 512}});
  const DrawnView turned(read_molecule(support::own_molecule("caffeine.pdb")), {1, 2, 3});
  for (const Reader &reader : readers) {
    for (const uint32_t style : {HSP_STYLE_FLAT, HSP_STYLE_HEADLIGHT, HSP_STYLE_SOFT}) {
      for (const DrawnView *view : {&square, &turned}) {
        hsp_picture_options options = picture_options(reader.format, style);
        options.margin = 0;
        options.width = 384;
        options.outline = 0;
        EXPECT_TRUE(view->picture(options) == view->picture(as_frame(*view, options)))
            << "format " << reader.format << ", style " << style << (view == &turned ? ", turned" : "");
      }
    }
  }
}

// EPS has no edge of its own.
TEST(PictureFrames, CutWhatLiesBeyondTheEdges) {
  const DrawnView two({{0, 0, 0, 1024}, {4096, 0, 0, 1024}});
  hsp_picture_options options = picture_options(HSP_FORMAT_EPS, HSP_STYLE_FLAT);
  options.width = 300;
  options.height = 200;
  options.scale = 40;
  EXPECT_NE(two.picture(options).find("0 0 300 200 rectclip\n"), std::string::npos);
  options.centre[0] = 2;
  EXPECT_EQ(two.picture(options).find("rectclip"), std::string::npos);
  EXPECT_EQ(read_eps(two.picture(options)).paths.size(), 2U);
}

}  // namespace
