#include "picture/page.hpp"

#include "core/elementary.hpp"
#include "core/extremes.hpp"
#include "picture/depth_shares.hpp"

namespace hsp {
namespace {

// The least and the most that a side can become, in units. No format has pages without a width or a height.
constexpr double shortest_side = 0.01;
constexpr double longest_side = 1e6;

// px: thinner lines are left out. They would be written with the width 0, which in EPS and PDF is the thinnest line
// that there is, not none.
constexpr double thinnest_line = 5e-5;

double clamped(double value, double low, double high) {
  return value < low ? low : value > high ? high : value;
}

// A side as the options give it; 0 stays 0.
double given_side(double side) {
  return side == 0.0 ? 0.0 : clamped(side, shortest_side, longest_side);
}

// px from the middle: coordinates so far away, with ten decimals, are integers below 2^62.
constexpr double farthest_from_middle = 1e7;

// px, semi-axes: a flatter ellipse is drawn as a line. If lines are drawn along it, one flatter than an eighth of their
// width is, too, up to a fifth of a px: that is not seen, and strokes along it break.
constexpr double flattest_ellipse = 1e-4;
constexpr double flattest_with_lines = 0.2;

double mean_radius(const BallSet &balls) {
  double sum = 0.0;
  for (uint32_t b = 0; b < balls.n; ++b) sum += balls.r[b];
  return balls.n > 0 ? sum / balls.n : 0.0;
}

// The width of lines that suits the balls: 1 for a mean radius of 34 px. In a fixed frame it must not depend on which
// balls are seen, so that all balls count.
double suitable_width(const PictureInput &input, bool fixed, double scale) {
  const uint32_t paths = input.paths.size();
  if (fixed ? input.balls.n == 0 : paths == 0) return 1.0;
  double sum = 0.0;
  for (uint32_t p = 0; p < paths && !fixed; ++p) sum += input.balls.r[input.paths.ball_of(p)];
  const double mean = fixed ? mean_radius(input.balls) : sum / paths;
  return clamped(std::sqrt(mean * scale / 34.0), 0.45, 1.9);
}

// px, for a suitable width of 1. Beside contours lines are thin; between many balls there are too many of them.
constexpr double chosen_line = 0.9;
constexpr double chosen_line_beside_ink = 0.5;
constexpr uint32_t most_balls_with_lines_and_ink = 1000;
constexpr double chosen_ink[3] = {3.1, 2.2, 2.9};

// Chooses the widths of lines and contours for the page's scale.
void choose_widths(const PictureInput &input, const PictureOptions &options, Page &page) {
  const double suitable = suitable_width(input, options.scale > 0.0, page.scale);
  double chosen = chosen_line;
  if (input.silhouettes.exist()) chosen = input.balls.n > most_balls_with_lines_and_ink ? 0.0 : chosen_line_beside_ink;
  page.line = options.outline < 0.0 ? chosen * suitable : options.outline * page.unit;
  if (page.line < thinnest_line) page.line = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double width = options.ink_width[k];
    page.ink[k] = !input.silhouettes.exist() ? 0.0 : width < 0.0 ? chosen_ink[k] * suitable : width * page.unit;
  }
}

}  // namespace

PagePoint PageArc::at(double t) const {
  const SinCos d = sin_cos(t);
  return {centre.x + d.cosine * major.x + d.sine * minor.x, centre.y + d.cosine * major.y + d.sine * minor.y};
}

PageArc Page::to_page(const ProjectedArc &arc) const {
  const ProjectedEllipse &e = arc.ellipse;
  const PagePoint major{e.major[0] * scale, e.major[1] * scale};
  const PagePoint minor{e.minor[0] * scale, e.minor[1] * scale};
  return {to_page(e.centre),
          major,
          minor,
          {std::sqrt(major.x * major.x + major.y * major.y), std::sqrt(minor.x * minor.x + minor.y * minor.y)},
          arc.from,
          arc.to,
          to_page(arc.start),
          to_page(arc.end),
          arc.other_ball == no_id};
}

Page lay_out(const PictureInput &input, const PictureOptions &options) {
  const ViewBox box = box_of(input.balls, input.paths);
  const bool empty = input.paths.size() == 0;
  const bool fixed = options.scale > 0.0;
  const double size[2] = {box.high[0] - box.low[0], box.high[1] - box.low[1]};
  const double margin = options.margin * larger_of(size[0], size[1]);
  const double framed[2] = {size[0] + 2 * margin, size[1] + 2 * margin};
  // A side of 0 follows from the other one.
  const bool square = empty || fixed;
  double width = given_side(options.width), height = given_side(options.height);
  if (height == 0.0) height = clamped(square ? width : width * (framed[1] / framed[0]), shortest_side, longest_side);
  if (width == 0.0) width = clamped(square ? height : height * (framed[0] / framed[1]), shortest_side, longest_side);

  Page page;
  page.unit = options.millimetres ? px_per_millimetre : 1.0;
  page.width = width * page.unit;
  page.height = height * page.unit;
  page.scale = 0.0;
  if (fixed) {
    const exact::Lattice &lattice = input.balls.lattice;
    const Vec3 &origin = input.paths.frame().origin;
    const Vec3 centre = input.paths.frame().to_view({lattice.steps(options.centre[0]) - origin.x,
                                                     lattice.steps(options.centre[1]) - origin.y,
                                                     lattice.steps(options.centre[2]) - origin.z});
    page.scale = options.scale * page.unit * lattice.step();
    choose_widths(input, options, page);
    page.middle[0] = centre.x;
    page.middle[1] = centre.y;
  } else {
    if (!empty) page.scale = smaller_of(page.width / framed[0], page.height / framed[1]);
    choose_widths(input, options, page);
    if (!empty) {
      // However narrow the margin is, there is room for the outer half of lines along the outermost silhouettes, and
      // for the outer share of contours.
      const double half = page.line / 2, outside = outer_share_of_ink * page.ink[0];
      const double room = smaller_of(larger_of(half, outside), smaller_of(page.width, page.height) / 4);
      if (margin * page.scale < room) {
        page.scale = smaller_of((page.width - 2 * room) / size[0], (page.height - 2 * room) / size[1]);
      }
    }
    for (int k = 0; k < 2; ++k) page.middle[k] = box.low[k] + size[k] / 2;
  }
  page.possible = true;
  page.cut = false;
  for (int k = 0; k < 2 && fixed && !empty; ++k) {
    const double below = (page.middle[k] - box.low[k]) * page.scale;
    const double above = (box.high[k] - page.middle[k]) * page.scale;
    const double edge = (k == 0 ? page.width : page.height) / 2;
    // Written so that also a NaN, from an overflow, counts as too far.
    if (!(std::fabs(below) <= farthest_from_middle && std::fabs(above) <= farthest_from_middle)) page.possible = false;
    if (below > edge || above > edge) page.cut = true;
  }
  page.mean_radius = mean_radius(input.balls);
  page.narrowest_ellipse = clamped(page.line / 8, flattest_ellipse, flattest_with_lines);
  page.nearest = box.depth_high;
  page.farthest = end_of_fog(page.nearest, box.depth_low, page.mean_radius);
  page.decimals = decimals_for(larger_of(page.width, page.height) / 1e4, 2, 6);
  return page;
}

}  // namespace hsp
