// Contours, read from files again: their widths follow what a z-buffer says lies behind, are nothing at tangencies, go
// on from one to the next, end under nearer balls, and never lie on one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawn_ink.hpp"
#include "molecule_balls.hpp"
#include "picture_paths.hpp"

namespace {

constexpr double outer_share = 0.62;

struct Scene {
  std::string name;
  DrawnInk drawn;
};

const std::vector<Scene> &scenes() {
  static const std::vector<Scene> all = [] {
    const oracle::Balls caffeine = read_molecule(support::own_molecule("caffeine.pdb"));
    const oracle::Balls crambin = read_molecule(support::own_molecule("crambin.pdb"));
    std::vector<Scene> made;
    made.push_back({"crambin", DrawnInk(crambin)});
    made.push_back({"crambin from elsewhere", DrawnInk(crambin, {1, 2, 3})});
    made.push_back({"caffeine from the side", DrawnInk(caffeine, {0, 1, 0})});
    made.push_back({"caffeine", DrawnInk(caffeine, {1, 3, -2})});
    return made;
  }();
  return all;
}

// Thick contours, so that what is wrong with them is seen; without fog and without lines.
hsp_picture_options thick(uint32_t format) {
  hsp_picture_options options = picture_options(format, HSP_STYLE_FLAT);
  options.fog = 0;
  options.outline = 0;
  options.ink_width[HSP_INK_BORDER] = 6;
  options.ink_width[HSP_INK_GROUP] = 4;
  options.ink_width[HSP_INK_DEPTH] = 5;
  return options;
}

// The balls on the page.
struct PageBall {
  PagePoint centre;
  double radius;  // px
  double depth;
};

class Placed {
 public:
  Placed(const DrawnInk &drawn, const hsp_picture_options &options, const PictureFile &file) {
    const hsp_view_info &info = drawn.info();
    const double w = info.high[0] - info.low[0], h = info.high[1] - info.low[1];
    scale_ = file.width / (w + 2 * options.margin * std::max(w, h));
    for (size_t k = 0; k < 2; ++k) {
      shift_[k] = (k == 0 ? file.width : file.height) / 2 - scale_ * (info.low[k] + info.high[k]) / 2;
    }
    for (const oracle::PlainBall &ball : drawn.seen()) {
      balls_.push_back({place(ball.centre.data()), scale_ * ball.radius, ball.centre[2]});
    }
  }
  [[nodiscard]] PagePoint place(const double *point) const {
    return {scale_ * point[0] + shift_[0], scale_ * point[1] + shift_[1]};
  }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] const std::vector<PageBall> &balls() const { return balls_; }

  // The ball with the highest front at a point of the page, but one; none: the number of balls.
  [[nodiscard]] size_t top(const PagePoint &at, size_t but, double &depth) const {
    size_t found = balls_.size();
    depth = -1e300;
    for (size_t b = 0; b < balls_.size(); ++b) {
      const double d = distance(at, balls_[b].centre);
      if (b == but || d >= balls_[b].radius) continue;
      const double front = balls_[b].depth + std::sqrt(balls_[b].radius * balls_[b].radius - d * d) / scale_;
      if (front <= depth) continue;
      depth = front;
      found = b;
    }
    return found;
  }

 private:
  double scale_ = 0;
  PagePoint shift_{};
  std::vector<PageBall> balls_;
};

// A line that cuts a contour off: from its outer side to its inner side, or back.
struct Cap {
  PagePoint a, b;
};

// Lines across the ball's circle. A piece shorter than some roundings is not seen.
std::vector<Cap> caps_of(const PaintedPath &path, const PageBall &own) {
  std::vector<Cap> caps;
  const auto add = [&](const PagePoint &a, const PagePoint &b) {
    const double beyond[] = {distance(a, own.centre) - own.radius, distance(b, own.centre) - own.radius};
    if (std::fmax(beyond[0], beyond[1]) > 0.01 && std::fmin(beyond[0], beyond[1]) < -0.01) caps.push_back({a, b});
  };
  for (const Loop &loop : path.loops) {
    for (const Segment &s : loop.segments) {
      if (s.kind == Segment::Kind::line) add(s.start, s.end);
    }
    add(loop.start, loop.segments.back().end);
  }
  return caps;
}

// Issue's and header's: the width of a contour by the gap to what is behind, in mean radii.
double width_of(const hsp_picture_options &options, double gap, bool same_group) {
  const double depth = options.ink_width[HSP_INK_DEPTH] * std::pow(std::fmin(1, gap / 3), 0.625);
  return same_group ? depth : std::fmax(depth, options.ink_width[HSP_INK_GROUP] * std::fmin(1, 2 * gap));
}

TEST(Ink, IsNothingAtTangencies) {
  size_t looked_at = 0;
  for (const Scene &scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const hsp_picture_options options = thick(HSP_FORMAT_SVG);
    const PictureFile file = read_svg(scene.drawn.picture(options));
    const Placed placed(scene.drawn, options, file);
    const std::vector<hsp_map_vertex> vertices = scene.drawn.vertices();
    for (const hsp_map_vertex &vertex : vertices) {
      if (vertex.kind != HSP_MAP_TANGENCY) continue;
      const PagePoint at = placed.place(vertex.xyz);
      const auto is_near = [&](const hsp_map_vertex &other) { return distance(placed.place(other.xyz), at) < 1; };
      if (std::count_if(vertices.begin(), vertices.end(), is_near) > 1) continue;
      for (const PaintedPath &path : file.ink) {
        if (path.ball != vertex.ball[1]) continue;
        // Corners of a contour next to the tangency are one point, and no line cuts it off there.
        for (const Loop &loop : path.loops) {
          for (const Segment &s : loop.segments) {
            if (distance(s.end, at) > 0.5) continue;
            EXPECT_LE(distance(s.end, at), 0.02);
            ++looked_at;
          }
        }
        for (const Cap &cap : caps_of(path, placed.balls()[path.ball])) {
          const PagePoint middle = {(cap.a[0] + cap.b[0]) / 2, (cap.a[1] + cap.b[1]) / 2};
          EXPECT_GT(distance(middle, at), 0.02);
        }
      }
    }
  }
  EXPECT_GT(looked_at, 200U);
}

// Around a ball a border of one width goes on without a bend from one lune to the next: curves as long as 1.2 bent by
// five degrees there.
TEST(Ink, BordersAreRound) {
  const auto direction = [](const PagePoint &from, const PagePoint &to) {
    return std::atan2(to[1] - from[1], to[0] - from[0]);
  };
  size_t looked_at = 0;
  for (const Scene &scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const hsp_picture_options options = thick(HSP_FORMAT_SVG);
    const double outside = outer_share * options.ink_width[HSP_INK_BORDER];
    const PictureFile file = read_svg(scene.drawn.picture(options));
    const Placed placed(scene.drawn, options, file);
    for (const PaintedPath &path : file.ink) {
      const PageBall &own = placed.balls()[path.ball];
      const auto is_outside = [&](const PagePoint &point) {
        return std::fabs(distance(point, own.centre) - own.radius - outside) < 0.02;
      };
      for (const Loop &loop : path.loops) {
        for (size_t k = 0; k + 1 < loop.segments.size(); ++k) {
          const Segment &s = loop.segments[k], &t = loop.segments[k + 1];
          const bool curves = s.kind == Segment::Kind::cubic && t.kind == Segment::Kind::cubic;
          if (!curves || distance(s.start, s.end) < 10 || distance(t.start, t.end) < 10) continue;
          if (!is_outside(s.start) || !is_outside(s.end) || !is_outside(t.end)) continue;
          const double bend = direction(s.handle[1], s.end) - direction(t.start, t.handle[0]);
          EXPECT_LT(std::fabs(std::remainder(bend, 2 * std::numbers::pi)), 0.02) << "ball " << path.ball;
          ++looked_at;
        }
      }
    }
  }
  EXPECT_GT(looked_at, 50U);
}

// However steeply what is behind rises towards a tangency, widths fall off along twice the largest one at least, but
// where a border is so near.
TEST(Ink, EndsInPoints) {
  size_t looked_at = 0;
  for (const Scene &scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const hsp_picture_options options = thick(HSP_FORMAT_SVG);
    const double largest = options.ink_width[HSP_INK_BORDER], length = 2 * largest;
    const PictureFile file = read_svg(scene.drawn.picture(options));
    const Placed placed(scene.drawn, options, file);
    for (const hsp_map_vertex &vertex : scene.drawn.vertices()) {
      if (vertex.kind != HSP_MAP_TANGENCY) continue;
      const PageBall &own = placed.balls()[vertex.ball[1]];
      const PagePoint at = placed.place(vertex.xyz);
      bool border = false;
      std::vector<std::pair<double, double>> widths;  // how far from the tangency
      for (const PaintedPath &path : file.ink) {
        if (path.ball != vertex.ball[1]) continue;
        for (const Loop &loop : path.loops) {
          for (const Segment &s : loop.segments) {
            const double beyond = distance(s.end, own.centre) - own.radius;
            const PagePoint on = {own.centre[0] + (s.end[0] - own.centre[0]) * own.radius / (own.radius + beyond),
                                  own.centre[1] + (s.end[1] - own.centre[1]) * own.radius / (own.radius + beyond)};
            if (path.name == "border") border |= distance(on, at) < 5 * largest;
            if (path.name != "border" && beyond > 0) widths.push_back({distance(on, at), beyond / outer_share});
          }
        }
      }
      for (const auto &[far, width] : widths) {
        const double share = 1.03 * far / length;  // along the circle it is a little farther
        if (border || far > 0.95 * length) continue;
        EXPECT_LE(width, largest * share * (2 - share) + 0.05) << "ball " << vertex.ball[1];
        ++looked_at;
      }
    }
  }
  EXPECT_GT(looked_at, 100U);
}

// Every end of a contour is that of another one of the same ball, of the same width, or lies under a nearer ball.
TEST(Ink, GoesOnOrEndsUnderNearerBalls) {
  size_t meet = 0, under = 0;
  for (const Scene &scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const hsp_picture_options options = thick(HSP_FORMAT_SVG);
    const PictureFile file = read_svg(scene.drawn.picture(options));
    const Placed placed(scene.drawn, options, file);
    const std::vector<hsp_map_vertex> vertices = scene.drawn.vertices();
    for (size_t p = 0; p < file.ink.size(); ++p) {
      const PageBall &own = placed.balls()[file.ink[p].ball];
      for (const Cap &cap : caps_of(file.ink[p], own)) {
        const PagePoint middle = {outer_share * cap.b[0] + (1 - outer_share) * cap.a[0],
                                  outer_share * cap.b[1] + (1 - outer_share) * cap.a[1]};
        const PagePoint other_way = {outer_share * cap.a[0] + (1 - outer_share) * cap.b[0],
                                     outer_share * cap.a[1] + (1 - outer_share) * cap.b[1]};
        const bool a_is_outer = distance(cap.a, own.centre) > distance(cap.b, own.centre);
        const PagePoint on_circle = a_is_outer ? middle : other_way;
        ASSERT_NEAR(distance(on_circle, own.centre), own.radius, 1);
        bool found = false;
        for (const PageBall &nearer : placed.balls()) {
          if (&nearer != &own && nearer.depth >= own.depth && distance(on_circle, nearer.centre) < nearer.radius + 0.4)
            found = true;
        }
        if (found) {
          ++under;
          continue;
        }
        // Between a crossing and a tangency next to it there is no room for another contour.
        for (const hsp_map_vertex &vertex : vertices) {
          found |= vertex.kind == HSP_MAP_TANGENCY && distance(placed.place(vertex.xyz), on_circle) < 6;
        }
        for (size_t q = 0; q < file.ink.size() && !found; ++q) {
          if (file.ink[q].ball != file.ink[p].ball) continue;
          for (const Cap &to : caps_of(file.ink[q], own)) {
            const bool itself = q == p && to.a == cap.a && to.b == cap.b;
            const double off = std::fmin(std::fmax(distance(to.a, cap.a), distance(to.b, cap.b)),
                                         std::fmax(distance(to.a, cap.b), distance(to.b, cap.a)));
            const double widths = distance(to.a, to.b) - distance(cap.a, cap.b);
            if (!itself && off <= 0.35 && std::fabs(widths) <= 0.02) found = true;  // one begins under the other
          }
        }
        EXPECT_TRUE(found) << "ball " << file.ink[p].ball << " at " << cap.a[0] << " " << cap.a[1];
        ++meet;
      }
    }
  }
  EXPECT_GT(meet, 100U);
  EXPECT_GT(under, 100U);
}

// Where a lune begins or ends, away from the ends of contours and from jumps, its width is that of the gap there.
TEST(Ink, IsAsWideAsTheGapBehind) {
  size_t compared = 0, of_groups = 0;
  for (const Scene &scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const hsp_picture_options options = thick(HSP_FORMAT_SVG);
    std::vector<uint32_t> group;
    for (size_t i = 0; i < scene.drawn.seen().size(); ++i) group.push_back(static_cast<uint32_t>(i / 5 % 3));
    const PictureFile file = read_svg(scene.drawn.picture(options, group));
    const Placed placed(scene.drawn, options, file);
    std::vector<PagePoint> ends;
    for (const hsp_map_vertex &vertex : scene.drawn.vertices()) ends.push_back(placed.place(vertex.xyz));
    for (const PaintedPath &path : file.ink) {
      const PageBall &own = placed.balls()[path.ball];
      for (const Loop &loop : path.loops) {
        for (const Segment &s : loop.segments) {
          const double beyond = distance(s.end, own.centre) - own.radius;
          if (beyond < 0.05) continue;  // the outer side
          const PagePoint on = {own.centre[0] + (s.end[0] - own.centre[0]) * own.radius / (own.radius + beyond),
                                own.centre[1] + (s.end[1] - own.centre[1]) * own.radius / (own.radius + beyond)};
          double nearest = 1e300;
          for (const PagePoint &end : ends) nearest = std::fmin(nearest, distance(end, on));
          // Widths fall off along twice the largest, and are less in gaps that are shorter than eight times that.
          if (nearest < (path.name == "border" ? 13 : 25)) continue;
          double depth = 0;
          const size_t behind = placed.top(on, path.ball, depth);
          if (behind < placed.balls().size() && depth > own.depth) continue;  // it goes on unseen
          std::string expected_name = "border";
          double expected = options.ink_width[HSP_INK_BORDER];
          if (behind < placed.balls().size()) {
            const bool same = group[behind] == group[path.ball];
            expected = width_of(options, (own.depth - depth) / scene.drawn.mean_radius(), same);
            expected_name = same ? "depth" : "group";
            of_groups += same ? 0 : 1;
          }
          EXPECT_EQ(path.name, expected_name);
          EXPECT_NEAR(beyond / outer_share, expected, 0.04) << "ball " << path.ball;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 120U);
  EXPECT_GT(of_groups, 15U);
}

// Rows of pixels within the loops of a path, by either fill rule.
template <class Visit>
void scan(const PaintedPath &path, size_t columns, size_t rows, double side, Visit visit) {
  std::vector<std::vector<std::pair<double, int>>> crossings(rows);
  const auto edge = [&](const PagePoint &a, const PagePoint &b) {
    const int up = b[1] > a[1] ? 1 : -1;
    const double low = std::fmin(a[1], b[1]), high = std::fmax(a[1], b[1]);
    for (auto row = static_cast<int64_t>(std::ceil(low / side - 0.5)); row < static_cast<int64_t>(rows); ++row) {
      const double y = (static_cast<double>(row) + 0.5) * side;
      if (y < low || row < 0) continue;
      if (y >= high) break;
      crossings[static_cast<size_t>(row)].push_back({a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]), up});
    }
  };
  for (const Loop &loop : path.loops) {
    PagePoint here = loop.start;
    for (const Segment &s : loop.segments) {
      const int parts = s.kind == Segment::Kind::line ? 1 : s.kind == Segment::Kind::arc ? 96 : 12;
      for (int part = 1; part <= parts; ++part) {
        const PagePoint next = part == parts ? s.end : s.at(static_cast<double>(part) / parts);
        edge(here, next);
        here = next;
      }
    }
    edge(here, loop.start);
  }
  for (size_t row = 0; row < rows; ++row) {
    std::sort(crossings[row].begin(), crossings[row].end());
    int winding = 0;
    for (size_t k = 0; k + 1 < crossings[row].size(); ++k) {
      winding += crossings[row][k].second;
      if (winding == 0) continue;
      const auto from = static_cast<int64_t>(std::ceil(crossings[row][k].first / side - 0.5));
      const auto to = static_cast<int64_t>(std::ceil(crossings[row][k + 1].first / side - 0.5));
      for (int64_t x = std::max<int64_t>(from, 0); x < std::min(to, static_cast<int64_t>(columns)); ++x) {
        visit(row * columns + static_cast<size_t>(x));
      }
    }
  }
}

// The ball with the highest front at the middle of each pixel; none: the number of balls.
std::vector<size_t> tops(const Placed &placed, size_t columns, size_t rows, double side) {
  std::vector<size_t> found(columns * rows, placed.balls().size());
  std::vector<double> depth(columns * rows, -1e300);
  for (size_t b = 0; b < placed.balls().size(); ++b) {
    const PageBall &ball = placed.balls()[b];
    const auto column = [&](double x) { return static_cast<size_t>(std::clamp(x / side, 0.0, double(columns))); };
    const auto row = [&](double y) { return static_cast<size_t>(std::clamp(y / side, 0.0, double(rows))); };
    for (size_t y = row(ball.centre[1] - ball.radius); y < row(ball.centre[1] + ball.radius); ++y) {
      for (size_t x = column(ball.centre[0] - ball.radius); x < column(ball.centre[0] + ball.radius); ++x) {
        const double dx = (static_cast<double>(x) + 0.5) * side - ball.centre[0];
        const double dy = (static_cast<double>(y) + 0.5) * side - ball.centre[1];
        const double squared = ball.radius * ball.radius - dx * dx - dy * dy;
        if (squared <= 0) continue;
        const double front = ball.depth + std::sqrt(squared) / placed.scale();
        const size_t pixel = y * columns + x;
        if (front <= depth[pixel]) continue;
        depth[pixel] = front;
        found[pixel] = b;
      }
    }
  }
  return found;
}

struct InkPixels {
  size_t count = 0;
  size_t wrong = 0;
};

// Paints the file as it is, and asks a z-buffer what is seen at each pixel that ends up with ink.
InkPixels paint(const DrawnInk &drawn, double side) {
  const hsp_picture_options options = thick(HSP_FORMAT_SVG);
  const PictureFile file = read_svg(drawn.picture(options));
  const Placed placed(drawn, options, file);
  const auto columns = static_cast<size_t>(file.width / side), rows = static_cast<size_t>(file.height / side);
  constexpr uint32_t none = 0xFFFFFFFFU;
  std::vector<uint32_t> inked(columns * rows, none);
  size_t next = 0;
  for (size_t p = 0; p < file.paths.size(); ++p) {
    scan(file.paths[p], columns, rows, side, [&](size_t pixel) { inked[pixel] = none; });
    for (; next < file.ink.size() && file.ink[next].behind == p + 1; ++next) {
      scan(file.ink[next], columns, rows, side, [&](size_t pixel) { inked[pixel] = file.ink[next].ball; });
    }
  }
  InkPixels result;
  const std::vector<size_t> seen = tops(placed, columns, rows, side);
  for (size_t pixel = 0; pixel < inked.size(); ++pixel) {
    if (inked[pixel] == none) continue;
    ++result.count;
    const double own = placed.balls()[inked[pixel]].depth;
    const auto is_nearer = [&](size_t top) { return top < placed.balls().size() && placed.balls()[top].depth > own; };
    bool wrong = is_nearer(seen[pixel]);
    // Everything seen within a hair: numbers in files are rounded.
    for (int k = 0; k < 8 && wrong; ++k) {
      const double away = 0.06;
      const PagePoint at = {
          (static_cast<double>(pixel % columns) + 0.5) * side + away * std::cos(k * std::numbers::pi / 4),
          (static_cast<double>(pixel / columns) + 0.5) * side + away * std::sin(k * std::numbers::pi / 4)};
      double depth = 0;
      wrong = is_nearer(placed.top(at, placed.balls().size(), depth));
    }
    if (wrong) ++result.wrong;
  }
  return result;
}

TEST(Ink, LiesOnNoNearerBall) {
  size_t pixels = 0;
  for (const Scene &scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const InkPixels found = paint(scene.drawn, 0.36);
    EXPECT_EQ(found.wrong, 0U);
    pixels += found.count;
  }
  EXPECT_GT(pixels, 1000000U);
}

// A ring of six and its six neighbours in one plane, up to noise.
oracle::Balls planar(uint32_t seed, int64_t noise) {
  oracle::Balls balls;
  for (int k = 0; k < 6; ++k) {
    const double c = std::cos(k * std::numbers::pi / 3), s = std::sin(k * std::numbers::pi / 3);
    for (const int64_t away : {1400, 2480}) {
      seed = seed * 1664525 + 1013904223;
      balls.push_back({std::lround(static_cast<double>(away) * c), std::lround(static_cast<double>(away) * s),
                       static_cast<int64_t>(seed >> 16) % (2 * noise + 1) - noise, away == 1400 ? 1700 : 1100});
    }
  }
  return balls;
}

// How dark each pixel is, from 0 to 255.
std::vector<double> darkness(const DrawnInk &drawn, const hsp_picture_options &options) {
  const PictureFile file = read_svg(drawn.picture(options));
  constexpr size_t fine = 8, size = 240;
  std::vector<char> inked(size * size * fine * fine, 0);
  size_t next = 0;
  for (size_t p = 0; p < file.paths.size(); ++p) {
    scan(file.paths[p], size * fine, size * fine, 1.0 / fine, [&](size_t pixel) { inked[pixel] = 0; });
    for (; next < file.ink.size() && file.ink[next].behind == p + 1; ++next) {
      scan(file.ink[next], size * fine, size * fine, 1.0 / fine, [&](size_t pixel) { inked[pixel] = 1; });
    }
  }
  std::vector<double> dark(size * size, 0);
  for (size_t pixel = 0; pixel < inked.size(); ++pixel) {
    const size_t x = pixel % (size * fine) / fine, y = pixel / (size * fine) / fine;
    dark[y * size + x] += inked[pixel] * 255.0 / (fine * fine);
  }
  return dark;
}

// Atoms that lie in a plane but for noise of a thousandth of an angstrom look the same with any noise. At the corners,
// where contours are cut, parts of some pixels differ. Samples are 64 for a pixel: one of them is four levels.
TEST(Ink, OfPlanarMoleculesDoesNotDependOnNoise) {
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
  options.width = options.height = 240;
  options.scale = 28;
  options.fog = 0;
  options.outline = 0;
  const std::vector<double> first = darkness(DrawnInk(planar(1, 1)), options);
  size_t inked = 0;
  for (const double dark : first) inked += dark > 100 ? 1 : 0;
  EXPECT_GT(inked, 1000U);
  for (uint32_t seed = 2; seed < 10; ++seed) {
    const std::vector<double> other = darkness(DrawnInk(planar(seed, 1)), options);
    double sum = 0;
    size_t different = 0;
    for (size_t pixel = 0; pixel < first.size(); ++pixel) {
      const double difference = std::fabs(first[pixel] - other[pixel]);
      sum += difference;
      different += difference > 2 + 4 ? 1 : 0;
    }
    EXPECT_LT(sum / static_cast<double>(first.size()), 0.05) << seed;
    EXPECT_LE(different, 60U) << seed;
  }
}

// The same contours in each format.
// Without curves no longer than a digit of a file, which some files have and others do not.
Loop seen_of(const Loop &loop) {
  Loop seen = loop;
  seen.segments.clear();
  PagePoint here = loop.start;
  for (const Segment &segment : loop.segments) {
    if (distance(segment.end, here) > 0.015) seen.segments.push_back(segment);
    here = segment.end;
  }
  return seen;
}

TEST(Ink, IsTheSameInAllFormats) {
  const DrawnInk &drawn = scenes()[0].drawn;
  hsp_picture_options options = thick(HSP_FORMAT_SVG);
  options.outline = 0.5;  // PDF: balls have lines, contours have none
  const PictureFile svg = read_svg(drawn.picture(options));
  options.format = HSP_FORMAT_EPS;
  const PictureFile eps = read_eps(drawn.picture(options));
  options.format = HSP_FORMAT_PDF;
  std::vector<PaintedPath> pdf;
  for (const PaintedPath &path : read_pdf(drawn.picture(options)).paths) {
    if (path.paint == "f") pdf.push_back(path);
  }
  ASSERT_GT(svg.ink.size(), 100U);
  ASSERT_EQ(eps.ink.size(), svg.ink.size());
  ASSERT_EQ(pdf.size(), svg.ink.size());
  for (size_t p = 0; p < svg.ink.size(); ++p) {
    EXPECT_EQ(eps.ink[p].behind, svg.ink[p].behind);
    for (const PaintedPath *other : std::initializer_list<const PaintedPath *>{&eps.ink[p], &pdf[p]}) {
      ASSERT_EQ(other->loops.size(), svg.ink[p].loops.size());
      for (size_t l = 0; l < other->loops.size(); ++l) {
        const Loop a = seen_of(svg.ink[p].loops[l]), b = seen_of(other->loops[l]);
        EXPECT_TRUE(a.closed && b.closed);
        EXPECT_LE(distance(a.start, b.start), 0.015);
        ASSERT_EQ(a.segments.size(), b.segments.size());
        for (size_t s = 0; s < a.segments.size(); ++s) {
          for (const double share : {0.25, 0.5, 1.0}) {
            EXPECT_LE(distance(a.segments[s].at(share), b.segments[s].at(share)), 0.03);
          }
        }
      }
    }
  }
}

}  // namespace
