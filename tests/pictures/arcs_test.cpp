// Every file, read again: loops are closed as the formats promise, and every arc is the one that the interface tells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "drawn_view.hpp"
#include "molecule_balls.hpp"
#include "picture_paths.hpp"

namespace {

struct Scene {
  std::string name;
  DrawnView view;
};

// Two balls whose circle is seen edge on, or nearly: their centres differ by dz in depth.
oracle::Balls edge_on(int64_t size, int64_t dz) {
  return {{0, 0, 0, size}, {size, size / 3, dz, size}};
}

oracle::Balls lattice() {
  oracle::Balls balls;
  for (int64_t k = 0; k < 27; ++k) balls.push_back({k % 3 * 1500, k / 3 % 3 * 1500, k / 9 * 1500, 1000});
  return balls;
}

const std::vector<Scene> &scenes() {
  static const std::vector<Scene> all = [] {
    const oracle::Balls caffeine = read_molecule(support::own_molecule("caffeine.pdb"));
    std::vector<Scene> made;
    made.push_back({"caffeine, plane seen edge on", DrawnView(caffeine)});
    made.push_back({"caffeine from the side", DrawnView(caffeine, {0, 1, 0})});
    made.push_back({"crambin", DrawnView(read_molecule(support::own_molecule("crambin.pdb")))});
    made.push_back({"caffeine, H-pieces", DrawnView(caffeine, {0, 1, 0}, HSP_PIECES_OUTSIDE_ALL)});
    made.push_back({"caffeine, H-pieces, edge on", DrawnView(caffeine, {0, 0, 1}, HSP_PIECES_OUTSIDE_ALL)});
    made.push_back({"a lattice", DrawnView(lattice(), {0, 0, 1}, HSP_PIECES_OUTSIDE_ALL)});
    made.push_back({"one ball", DrawnView({{5, 7, 9, 1000}})});
    made.push_back({"no ball", DrawnView({})});
    made.push_back({"a hole", DrawnView({{0, 0, 0, 1000}, {0, 0, 800, 700}})});
    for (const int64_t dz : {0, 1, 10, 100, 10000}) {
      for (const uint32_t pieces : {HSP_PIECES_OUTSIDE_FARTHER, HSP_PIECES_OUTSIDE_ALL}) {
        made.push_back({"edge on but for " + std::to_string(dz), DrawnView(edge_on(1000000, dz), {0, 0, 1}, pieces)});
      }
    }
    return made;
  }();
  return all;
}

// From the view plane to the page, as the header describes width and margin.
class Mapping {
 public:
  Mapping(const hsp_view_info &info, const hsp_picture_options &options, const PictureFile &file)
      : line_(options.outline * (options.unit == HSP_UNIT_MM ? 96 / 25.4 : 1)),
        flattest_(std::clamp(line_ / 8, 1e-4, 0.2)) {
    const double w = info.high[0] - info.low[0];
    const double h = info.high[1] - info.low[1];
    const double margin = options.margin * std::max(w, h);
    scale_ = std::min(file.width / (w + 2 * margin), file.height / (h + 2 * margin));
    const double room = std::min({line_ / 2, file.width / 4, file.height / 4});
    if (margin * scale_ < room) scale_ = std::min((file.width - 2 * room) / w, (file.height - 2 * room) / h);
    for (size_t k = 0; k < 2; ++k) {
      shift_[k] = (k == 0 ? file.width : file.height) / 2 - scale_ * (info.low[k] + info.high[k]) / 2;
    }
  }
  [[nodiscard]] PagePoint place(const double point[2]) const {
    return {scale_ * point[0] + shift_[0], scale_ * point[1] + shift_[1]};
  }
  [[nodiscard]] PagePoint place(const hsp_view_arc &arc, double t) const {
    const double c = std::cos(arc.rotation);
    const double s = std::sin(arc.rotation);
    const double u = arc.semi_axis[0] * std::cos(t);
    const double v = arc.semi_axis[1] * std::sin(t);
    const double point[2] = {arc.centre[0] + u * c - v * s, arc.centre[1] + u * s + v * c};
    return place(point);
  }
  [[nodiscard]] double scale() const { return scale_; }
  // Ellipses with a lesser semi-axis are lines, px.
  [[nodiscard]] double flattest() const { return flattest_; }

 private:
  double line_, flattest_;
  double scale_ = 0;
  PagePoint shift_{};
};

struct Worst {
  double gap = 0;   // between the end of a segment and the start of the next
  double away = 0;  // from where the interface puts a point of an arc
};

// How a format cuts arcs, and at which shares of a segment its point is known.
struct Format {
  uint32_t id;
  const char *name;
  PictureFile (*read)(const std::string &);
  double longest;  // parameter span of a segment; 0: see cuts_in_svg and compare_curves
  std::vector<double> shares;
  double gap;
  double away;
};

// SVG: two decimals, and what a renderer makes of them on narrow ellipses. EPS: 1e-6 px as
// lib/sight/picture/writers.hpp says. PDF: a unit of .01 px for what a cubic leaves the arc, and rounding to that unit.
const std::vector<Format> &formats() {
  static const std::vector<Format> all = {
      {HSP_FORMAT_SVG, "SVG", read_svg, 0, {0, 0.25, 0.5, 0.75, 1}, 1e-9, 0.06},
      {HSP_FORMAT_EPS, "EPS", read_eps, 7, {0, 0.125, 0.3, 0.5, 0.8, 1}, 1e-6, 1e-6},
      {HSP_FORMAT_PDF, "PDF", read_pdf, 0, {0.2, 0.5, 0.8, 1}, 1e-9, 0.02}};
  return all;
}

// The least of distance(share) for shares from 0 to 1: what is best around the best of a few, or before 1, where a
// closed curve is as near as at 0.
template <class Distance>
double least(Distance of) {
  static constexpr int parts = 16;
  int best = 0;
  for (int k = 1; k <= parts; ++k) {
    if (of(1.0 * k / parts) < of(1.0 * best / parts)) best = k;
  }
  const auto around = [&of](int k) {
    double low = std::max(k - 1, 0) / static_cast<double>(parts);
    double high = std::min(k + 1, parts) / static_cast<double>(parts);
    for (int step = 0; step < 32; ++step) {
      const double a = low + (high - low) / 3;
      const double b = high - (high - low) / 3;
      if (of(a) < of(b)) {
        high = b;
      } else {
        low = a;
      }
    }
    return of((low + high) / 2);
  };
  return best > 0 ? around(best) : std::min(around(0), around(parts));
}

// The corners of an ellipse that is drawn as a line.
std::vector<PagePoint> corners(const Mapping &map, const hsp_view_arc &arc) {
  std::vector<PagePoint> points;
  for (int k = -2; k <= 2; ++k) {
    const double t = k * std::numbers::pi;
    if (std::min(arc.from, arc.to) < t && t < std::max(arc.from, arc.to)) points.push_back(map.place(arc, t));
  }
  if (arc.to < arc.from) std::reverse(points.begin(), points.end());
  points.push_back(map.place(arc.end));
  return points;
}

// Segments up to the one that ends where the arc does: all of them along the arc, and all of the arc along them.
void compare_curves(const Format &format, const Mapping &map, const hsp_view_arc &arc, const Loop &loop, size_t &next,
                    Worst &worst) {
  const size_t first = next;
  const auto on_arc = [&](double share) { return map.place(arc, arc.from + (arc.to - arc.from) * share); };
  const auto note = [&worst](double away) { worst.away = std::max(worst.away, away); };
  note(distance(loop.segments.at(next).start, map.place(arc.start)));
  do {
    const Segment &segment = loop.segments.at(next++);
    ASSERT_EQ(segment.kind, Segment::Kind::cubic);
    for (const double share : format.shares) {
      note(least([&](double t) { return distance(segment.at(share), on_arc(t)); }));
    }
  } while (distance(loop.segments[next - 1].end, map.place(arc.end)) > format.away);
  for (int k = 0; k <= 3; ++k) {
    double away = 1e300;
    for (size_t s = first; s < next; ++s) {
      away = std::min(away, least([&](double t) { return distance(loop.segments[s].at(t), on_arc(k / 3.0)); }));
    }
    note(away);
  }
}

// Where an arc is cut, as shares of it: whole, in halves, or after a third. No part is nearly half a turn or nearly a
// whole one, but for the halves of circles.
std::vector<double> cuts_in_svg(const Loop &loop, size_t next, double span) {
  std::vector<double> cuts{0};
  double read = 0;
  while (read < 0.8 * span) {
    const Segment &segment = loop.segments.at(next + cuts.size() - 1);
    const double part = std::fabs(segment.to - segment.from);
    EXPECT_TRUE(std::fabs(part - std::numbers::pi) > 0.09 * std::numbers::pi || span > 6.2) << part;
    EXPECT_LT(part, 1.76 * std::numbers::pi);
    read += part;
    cuts.push_back(read);
  }
  for (double &cut : cuts) cut = std::round(6 * cut / read) / 6;
  return cuts;
}
// One more where rounding makes an arc a little longer than so many parts.
std::vector<double> equal_cuts(const Format &format, const Mapping &map, const hsp_view_arc &arc, const Loop &loop,
                               size_t next) {
  int parts = static_cast<int>(std::ceil(std::fabs(arc.to - arc.from) / format.longest));
  const Segment &last = loop.segments.at(next + static_cast<size_t>(parts) - 1);
  if (distance(last.end, map.place(arc.end)) > format.away) ++parts;
  std::vector<double> cuts;
  for (int k = 0; k <= parts; ++k) cuts.push_back(static_cast<double>(k) / parts);
  return cuts;
}

void compare_arc(const Format &format, const Mapping &map, const hsp_view_arc &arc, const Loop &loop, size_t &next,
                 Worst &worst) {
  const double narrow = map.scale() * arc.semi_axis[1];
  if (narrow < map.flattest()) {
    for (const PagePoint &corner : corners(map, arc)) {
      const Segment &segment = loop.segments.at(next++);
      ASSERT_EQ(segment.kind, Segment::Kind::line);
      worst.away = std::max(worst.away, distance(segment.end, corner));
    }
    return;
  }
  if (format.id == HSP_FORMAT_PDF) {
    compare_curves(format, map, arc, loop, next, worst);
    return;
  }
  const std::vector<double> cuts = format.id == HSP_FORMAT_SVG ? cuts_in_svg(loop, next, std::fabs(arc.to - arc.from))
                                                               : equal_cuts(format, map, arc, loop, next);
  for (size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Segment &segment = loop.segments.at(next++);
    ASSERT_NE(segment.kind, Segment::Kind::line);
    for (const double share : format.shares) {
      const double t = arc.from + (arc.to - arc.from) * (cuts[k] + share * (cuts[k + 1] - cuts[k]));
      worst.away = std::max(worst.away, distance(segment.at(share), map.place(arc, t)));
    }
  }
}

Worst compare(const Format &format, const Scene &scene, hsp_picture_options options) {
  Worst worst;
  options.outline = 0.9;  // what is drawn as a line depends on it
  const PictureFile file = format.read(scene.view.picture(options, "title", "description"));
  EXPECT_EQ(file.paths.size(), scene.view.pieces().size());
  if (file.paths.size() != scene.view.pieces().size()) return worst;
  const Mapping map(scene.view.info(), options, file);
  for (size_t p = 0; p < file.paths.size(); ++p) {
    const hsp_view_piece &piece = scene.view.pieces()[p];
    const PaintedPath &path = file.paths[p];
    if (format.id == HSP_FORMAT_SVG) {
      EXPECT_EQ(path.ball, piece.ball);
    }
    EXPECT_EQ(path.loops.size(), piece.loops);
    for (size_t l = 0; l < path.loops.size(); ++l) {
      const Loop &loop = path.loops[l];
      const hsp_view_loop &told = scene.view.loops()[piece.first_loop + l];
      EXPECT_TRUE(loop.closed);
      size_t next = 0;
      for (uint32_t a = 0; a < told.arcs; ++a) {
        compare_arc(format, map, scene.view.arcs()[told.first_arc + a], loop, next, worst);
      }
      EXPECT_EQ(next, loop.segments.size());
      PagePoint here = loop.start;
      for (const Segment &segment : loop.segments) {
        worst.gap = std::max(worst.gap, distance(here, segment.start));
        here = segment.end;
      }
      worst.gap = std::max(worst.gap, distance(here, loop.start));
    }
  }
  return worst;
}

class PictureArcs : public testing::TestWithParam<size_t> {};

TEST_P(PictureArcs, AreThoseOfTheView) {
  const Format &format = formats()[GetParam()];
  for (const Scene &scene : scenes()) {
    for (const uint32_t style : {HSP_STYLE_FLAT, HSP_STYLE_HEADLIGHT, HSP_STYLE_SOFT}) {
      SCOPED_TRACE(scene.name + ", style " + std::to_string(style));
      const Worst worst = compare(format, scene, picture_options(format.id, style));
      EXPECT_LE(worst.gap, format.gap);
      EXPECT_LE(worst.away, format.away);
      if (std::getenv("HSP_VERBOSE") != nullptr) {
        std::printf("%s %s: gap %.3g, away %.3g\n", format.name, scene.name.c_str(), worst.gap, worst.away);
      }
    }
  }
}

// The promises are in px whatever the size of the page.
TEST_P(PictureArcs, FitPagesOfAllShapes) {
  const Format &format = formats()[GetParam()];
  const Scene &scene = scenes()[1];
  for (const double size : {20.0, 300.0, 4000.0}) {
    for (const double ratio : {0.0, 0.5, 1.0, 3.0}) {
      for (const uint32_t unit : {HSP_UNIT_PX, HSP_UNIT_MM}) {
        SCOPED_TRACE(std::to_string(size) + " by " + std::to_string(size * ratio));
        hsp_picture_options options = picture_options(format.id, HSP_STYLE_FLAT);
        options.width = size;
        options.height = size * ratio;
        options.unit = unit;
        const Worst worst = compare(format, scene, options);
        EXPECT_LE(worst.gap, format.gap);
        EXPECT_LE(worst.away, format.away);
      }
    }
  }
}

// Numbers have as many decimals as a small page needs, and none that a large one does not.
TEST(PictureArcsInSvg, AreRoundedToTheSizeOfThePage) {
  const Scene &hole = scenes()[8];
  for (const double size : {1.234567, 9.123457, 11.765432, 93.0, 997.0}) {
    hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
    options.width = size;
    const Worst worst = compare(formats()[0], hole, options);
    const double step = std::fmin(0.01, std::pow(10.0, std::floor(std::log10(size / 1e4) + 1e-9)));
    EXPECT_LE(worst.away, 2 * step) << size;
    EXPECT_GE(worst.away, 0.02 * step) << size;
  }
}

// A small picture of circles that are seen nearly edge on: lines that turn at the ends of the major axis, which those
// of H-pieces pass by a hair.
TEST_P(PictureArcs, OfFlatEllipsesAreLines) {
  const Format &format = formats()[GetParam()];
  int looked_at = 0;
  for (const Scene &scene : scenes()) {
    if (!scene.name.starts_with("edge on but for 1")) continue;
    SCOPED_TRACE(scene.name);
    ++looked_at;
    hsp_picture_options options = picture_options(format.id, HSP_STYLE_FLAT);
    options.width = 40;
    const Worst worst = compare(format, scene, options);
    EXPECT_LE(worst.gap, format.gap);
    EXPECT_LE(worst.away, format.away);
  }
  EXPECT_EQ(looked_at, 8);
}

// The header: a unit away at most, besides rounding to it, and no longer than a quarter of a turn. On circles that can
// be seen from outside; their number of cubics is the least with 2/27 sin^6(d / 4) / cos^2(d / 4) below a unit.
TEST(PictureArcsInPdf, AreWithinTheirBound) {
  const DrawnView one({{0, 0, 0, 1000}});
  for (const double radius : {0.3, 5.0, 36.0, 38.0, 500.0, 20000.0, 5e5}) {
    hsp_picture_options options = picture_options(HSP_FORMAT_PDF, HSP_STYLE_FLAT);
    options.margin = 0;
    options.outline = 0;
    options.width = 2 * radius;
    const PictureFile file = read_pdf(one.picture(options));
    ASSERT_EQ(file.paths.size(), 1U);
    const std::vector<Segment> &cubics = file.paths[0].loops.at(0).segments;
    double unit = 0.01;
    while (unit > 2 * radius / 1e4 * (1 + 1e-9)) unit /= 10;
    const auto deviation = [](size_t parts) {
      const double quarter = std::numbers::pi / 2 / static_cast<double>(parts);
      return 2.0 / 27 * std::pow(std::sin(quarter), 6) / std::pow(std::cos(quarter), 2);
    };
    size_t parts = 4;
    while (deviation(parts) * radius > unit) ++parts;
    EXPECT_EQ(cubics.size(), parts + parts % 2) << radius;  // they meet at 0 degrees, and the circle begins at 180
    double worst = 0;
    for (const Segment &cubic : cubics) {
      for (int k = 0; k <= 50; ++k) {
        worst = std::max(worst, std::fabs(distance(cubic.at(k / 50.0), {radius, radius}) - radius));
      }
    }
    EXPECT_LE(worst, 2 * unit) << radius;
    EXPECT_GE(worst, 0.05 * unit) << radius;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, PictureArcs, testing::Range<size_t>(0, 3));

// An arc that ends elsewhere is noticed: the readers do not repair files.
TEST(PictureReaders, NoticeABrokenFile) {
  const Scene &scene = scenes()[1];
  std::string text = scene.view.picture(picture_options(HSP_FORMAT_EPS, HSP_STYLE_FLAT));
  const size_t arc = text.find(" A\n");
  ASSERT_NE(arc, std::string::npos);
  text[arc - 3] = text[arc - 3] == '5' ? '6' : '5';
  double gap = 0;
  for (const PaintedPath &path : read_eps(text).paths) {
    for (const Loop &loop : path.loops) {
      for (size_t k = 0; k < loop.segments.size(); ++k) {
        gap = std::max(gap, distance(loop.segments[k].end, loop.segments[(k + 1) % loop.segments.size()].start));
      }
    }
  }
  EXPECT_GT(gap, 1e-6);
  std::string pdf = scene.view.picture(picture_options(HSP_FORMAT_PDF, HSP_STYLE_FLAT));
  pdf.insert(pdf.find("/Contents"), " ");
  EXPECT_THROW(read_pdf(pdf), std::exception);
}

}  // namespace
