// Sizes of pages, what lies where on them, and the numbers that follow from their sizes.
#pragma once

#include "small_picture.hpp"

namespace cases {

constexpr double inch = 96;  // px

struct PageLayout {
  uint32_t n;
  SmallBall ball[2];
  bool millimetres;
  double width, height, margin;  // options
  double px_width, px_height, px_scale;
  double middle[2];  // of the box, from the middle of the centres
};
constexpr PageLayout page_layouts[] = {
    {1, {{7, 8, 9, 10}}, false, 120, 0, .1, 120, 120, 5, {0, 0}},
    {1, {{7, 8, 9, 10}}, false, 0, 48, .1, 48, 48, 2, {0, 0}},
    {1, {{7, 8, 9, 10}}, false, 240, 48, .1, 240, 48, 2, {0, 0}},
    {1, {{7, 8, 9, 10}}, false, 40, 48, 0, 40, 48, 2, {0, 0}},
    // The margin goes by the longer side: 6 around 60 x 20.
    {2, {{0, 0, 0, 10}, {40, 0, 0, 10}}, false, 144, 0, .1, 144, 64, 2, {0, 0}},
    {2, {{0, 0, 0, 10}, {40, 0, 0, 10}}, false, 0, 64, .1, 144, 64, 2, {0, 0}},
    {2, {{0, 0, 0, 10}, {0, 40, 0, 10}}, false, 64, 0, .1, 64, 144, 2, {0, 0}},
    {2, {{0, 0, 0, 10}, {0, 40, 0, 10}}, false, 640, 72, .1, 640, 72, 1, {0, 0}},
    // The middle of the box is that of the silhouettes, not that of the centres.
    {2, {{0, 0, 0, 10}, {40, 30, 70, 20}}, false, 140, 0, 0, 140, 120, 2, {5, 5}},
    // An inch has 25.4 mm.
    {1, {{0, 0, 0, 10}}, true, 127, 0, .1, 5 * inch, 5 * inch, 20, {0, 0}},
    {1, {{0, 0, 0, 10}}, true, 0, 25.4, .1, inch, inch, 4, {0, 0}},
    // Sides from .01 to 1e6, the one that follows included.
    {1, {{0, 0, 0, 10}}, false, 1e9, 0, 0, 1e6, 1e6, 5e4, {0, 0}},
    {1, {{0, 0, 0, 10}}, false, 1e-9, 0, 0, .01, .01, 5e-4, {0, 0}},
    {2, {{0, 0, 0, 1}, {19999998, 0, 0, 1}}, false, 1000, 0, 0, 1000, .01, 5e-5, {0, 0}},
    {2, {{0, 0, 0, 1}, {0, 19999998, 0, 1}}, false, 1000, 0, 0, 1000, 1e6, .05, {0, 0}},
    {2, {{0, 0, 0, 1}, {0, 19999998, 0, 1}}, false, 0, 1000, 0, .01, 1000, 5e-5, {0, 0}},
    // Nothing to be seen.
    {0, {}, false, 300, 0, .1, 300, 300, 0, {0, 0}},
    {0, {}, false, 0, 200, .1, 200, 200, 0, {0, 0}},
    {0, {}, false, 300, 200, .1, 300, 200, 0, {0, 0}}};

inline uint32_t sizes_of_pages() {
  return first_failing(page_layouts, [](const PageLayout &c) {
    if (!small_view().succeeds(c.ball, c.n)) return false;
    hsp::PictureOptions options;
    options.millimetres = c.millimetres;
    options.width = c.width;
    options.height = c.height;
    options.margin = c.margin;
    options.outline = 0;  // lines would want room
    const hsp::PictureInput input = picture_input();
    const hsp::Page page = hsp::lay_out(input, options);
    const hsp::PagePoint middle = page.to_page(c.middle);
    const auto equal = [](double a, double b) { return near(a, b, 1e-12 * (1 + b)); };
    double farthest = 1e9, nearest = -1e9;
    for (uint32_t p = 0; p < input.paths.size(); ++p) {
      const uint32_t ball = input.paths.ball_of(p);
      const hsp::Vec3 centre = input.paths.frame().centre_of(input.balls, ball);
      farthest = centre.z < farthest ? centre.z : farthest;
      nearest = centre.z > nearest ? centre.z : nearest;
      const double reach = input.balls.r[ball] * page.scale;
      const hsp::PagePoint at = page.centre_of(input, p);
      if (!equal(at.x, (centre.x - c.middle[0]) * c.px_scale + c.px_width / 2) ||
          !equal(at.y, (centre.y - c.middle[1]) * c.px_scale + c.px_height / 2)) {
        return false;
      }
      if (at.x - reach < -1e-9 || at.x + reach > page.width + 1e-9) return false;
      if (at.y - reach < -1e-9 || at.y + reach > page.height + 1e-9) return false;
    }
    // Fog grows through five mean radii at least.
    const double least = nearest - 5 * (c.n > 1 ? (c.ball[0].r + c.ball[1].r) / 2.0 : c.ball[0].r);
    farthest = least < farthest ? least : farthest;
    if (c.n > 0 && (!near(page.farthest, farthest, 1e-9) || page.nearest != nearest)) return false;
    return equal(page.width, c.px_width) && equal(page.height, c.px_height) &&
           near(page.scale, c.px_scale, 1e-6 * c.px_scale) && equal(middle.x, c.px_width / 2) &&
           equal(middle.y, c.px_height / 2) && equal(page.unit * 25.4, c.millimetres ? inch : 25.4);
  });
}

// Fixed frames: pages whose middle and scale are given. The lattice of these balls has the step 1.
struct FixedFrame {
  double towards[3];  // with z up
  double width, height;
  bool millimetres;
  double scale, centre[3];
  double px_width, px_height, px_scale;
  double ball[2];  // where the centre of the last ball appears, px from the middle
  bool cut, possible;
};
// Seen from y, x is to the left.
constexpr FixedFrame fixed_frames[] = {
    {{0, 1, 0}, 100, 0, false, 2, {0, 0, 0}, 100, 100, 2, {-80, 0}, true, true},
    {{0, 1, 0}, 0, 60, false, 2, {40, 30, 0}, 60, 60, 2, {0, 0}, true, true},
    {{0, 1, 0}, 300, 200, false, 2, {0, 99, 30}, 300, 200, 2, {-80, -60}, false, true},
    {{1, 0, 0}, 300, 200, false, 2, {99, 0, 30}, 300, 200, 2, {60, -60}, false, true},
    {{-1, 0, 0}, 300, 200, false, 2, {99, 0, 30}, 300, 200, 2, {-60, -60}, false, true},
    {{0, 1, 0}, 254, 127, true, 2, {40, 0, 0}, 10 * inch, 5 * inch, 2 * inch / 25.4, {0, 0}, false, true},
    // Just within the edges, and a little beyond the left, the right, the lower and the upper one.
    {{0, 1, 0}, 100, 40, false, 1, {0, 30, 0}, 100, 40, 1, {-40, 0}, false, true},
    {{0, 1, 0}, 100, 40, false, 1, {-.5, 30, 0}, 100, 40, 1, {-40.5, 0}, true, true},
    {{0, 1, 0}, 100, 40, false, 1, {40, 30, 0}, 100, 40, 1, {0, 0}, false, true},
    {{0, 1, 0}, 100, 40, false, 1, {40.5, 30, 0}, 100, 40, 1, {.5, 0}, true, true},
    {{0, 1, 0}, 100, 40, false, 1, {0, 30, 10.5}, 100, 40, 1, {-40, -10.5}, true, true},
    {{0, 1, 0}, 100, 40, false, 1, {0, 30, -10.5}, 100, 40, 1, {-40, 10.5}, true, true},
    // A ball reaches just as far as it may, or farther.
    {{0, 1, 0}, 100, 40, false, 1, {1e7 - 10, 30, 0}, 100, 40, 1, {1e7 - 50, 0}, true, true},
    {{0, 1, 0}, 100, 40, false, 1, {1e7 - 9, 30, 0}, 100, 40, 1, {1e7 - 49, 0}, true, false},
    {{0, 1, 0}, 100, 40, false, 1, {0, 0, 1e7 - 9}, 100, 40, 1, {-40, 9 - 1e7}, true, false},
    {{0, 1, 0}, 100, 40, false, 1, {0, 0, -1e300}, 100, 40, 1, {-40, 1e300}, true, false},
    {{0, 1, 0}, 100, 40, false, 2e5, {0, 0, 0}, 100, 40, 2e5, {-8e6, 0}, true, true},
    {{0, 1, 0}, 100, 40, false, 1e300, {0, 0, 0}, 100, 40, 1e300, {-4e301, 0}, true, false}};

inline uint32_t pages_of_fixed_frames() {
  return first_failing(fixed_frames, [](const FixedFrame &c) {
    constexpr SmallBall balls[] = {{0, 0, 0, 10}, {40, 30, 0, 10}};
    if (!small_view().succeeds(balls, 2, seen_from(c.towards[0], c.towards[1], c.towards[2]))) return false;
    hsp::PictureOptions options;
    options.width = c.width;
    options.height = c.height;
    options.millimetres = c.millimetres;
    options.scale = c.scale;
    for (int axis = 0; axis < 3; ++axis) options.centre[axis] = c.centre[axis];
    const hsp::PictureInput input = picture_input();
    const hsp::Page page = hsp::lay_out(input, options);
    const hsp::Vec3 centre = input.paths.frame().centre_of(input.balls, small_union().grid().grid_index(1));
    const double point[2] = {centre.x, centre.y};
    const hsp::PagePoint at = page.to_page(point);
    const auto equal = [](double a, double b) { return near(a, b, 1e-12 * (1 + (b < 0 ? -b : b))); };
    uint64_t bytes = 0;
    const auto take = [](void *, const char *, size_t) -> int32_t { return 0; };
    const hsp::Status status = hsp::write_picture(input, options, small_view().scratch(), take, nullptr, bytes);
    return equal(page.width, c.px_width) && equal(page.height, c.px_height) && equal(page.scale, c.px_scale) &&
           equal(at.x - page.width / 2, c.ball[0]) && equal(at.y - page.height / 2, c.ball[1]) &&
           page.possible == c.possible && (page.cut == c.cut || !c.possible) &&
           (status == hsp::Status::ok) == c.possible && (c.possible || status == hsp::Status::range);
  });
}

// Lines chosen for a fixed frame go by the radii of all balls; those of a fitted picture by what is seen, here one of
// 170 that hides one of 34.
inline uint32_t lines_of_fixed_frames() {
  constexpr SmallBall balls[] = {{0, 0, 0, 34}, {0, 0, 300, 170}};
  hsp::PictureOptions options;
  options.margin = 0;
  options.width = 340;
  if (!small_view().succeeds(balls, 2)) return 0;
  const double fitted = hsp::lay_out(picture_input(), options).line;
  options.scale = 1;
  return first_false({small_view().view().pieces.size() == 1, near(fitted, .9 * 1.9, 1e-12),
                      near(hsp::lay_out(picture_input(), options).line, .9 * std::sqrt(3.0), 1e-12)});
}

// A ball of radius 10 on a page as wide as it is: the options' outline and the width of the lines.
struct PageLine {
  double page_width;
  bool millimetres;
  double outline, line;
};
constexpr PageLine page_lines[] = {{100, false, 0, 0},
                                   {100, false, 2, 2},
                                   {100, true, 25.4, inch},
                                   {100, false, 6e-5, 6e-5},
                                   // Numbers that would be written as 0.
                                   {100, false, 4e-5, 0},
                                   // By the mean radius: .9 px where it is 34 px, with its square root, within bounds.
                                   {68, false, -1, .9},
                                   {68 * 2.25, false, -1, .9 * 1.5},
                                   {68 / 4, false, -1, .9 / 2},
                                   {2, false, -1, .9 * .45},
                                   {5000, false, -1, .9 * 1.9}};

inline uint32_t widths_of_lines() {
  return first_failing(page_lines, [](const PageLine &c) {
    constexpr SmallBall ball{0, 0, 0, 10};
    hsp::PictureOptions options;
    options.width = c.page_width;
    options.millimetres = c.millimetres;
    options.margin = 0;
    options.outline = c.outline;
    return small_view().succeeds(&ball, 1) && near(hsp::lay_out(picture_input(), options).line, c.line, 1e-12 * c.line);
  });
}

// The same ball on a page of 100 px: the outer half of a line has room, a quarter of the page at most, and ellipses are
// lines where they are narrower than an eighth of one, within bounds.
struct LineRoom {
  double outline, margin, scale, narrowest_ellipse;
};
constexpr LineRoom line_rooms[] = {
    {0, 0, 5, 1e-4}, {.8, .1, 100 / 24.0, .1}, {8, .1, 100 / 24.0, .2}, {8, 0, 4.6, .2}, {400, 0, 2.5, .2}};

inline uint32_t room_of_lines() {
  return first_failing(line_rooms, [](const LineRoom &c) {
    constexpr SmallBall ball{0, 0, 0, 10};
    hsp::PictureOptions options;
    options.width = 100;
    options.outline = c.outline;
    options.margin = c.margin;
    if (!small_view().succeeds(&ball, 1)) return false;
    const hsp::Page page = hsp::lay_out(picture_input(), options);
    return near(page.scale, c.scale, 1e-12 * c.scale) && near(page.narrowest_ellipse, c.narrowest_ellipse, 1e-15);
  });
}

// Decimals whose unit is at most a step, within bounds.
struct Decimals {
  double step;
  int least, most, expected;
};
constexpr Decimals step_decimals[] = {{1, 0, 10, 0},    {.99, 0, 10, 1}, {.125, 0, 10, 1},  {.0625, 0, 10, 2},
                                      {50, 0, 10, 0},   {50, 3, 10, 3},  {1e-9, 2, 6, 6},   {.01, 2, 6, 2},
                                      {.0099, 2, 6, 3}, {.5, 2, 6, 2},   {1.5e-4, 0, 6, 4}, {.9e-4, 0, 6, 5}};

inline uint32_t decimals_of_steps() {
  return first_failing(step_decimals,
                       [](const Decimals &c) { return hsp::decimals_for(c.step, c.least, c.most) == c.expected; });
}

// Those of a page are for steps of at most a ten-thousandth of its longer side.
struct PageDecimals {
  double width, height;
  int expected;
};
constexpr PageDecimals page_decimals[] = {{101, 5, 2}, {5, 101, 2}, {99, 5, 3},   {5, 99, 3},    {11, 11, 3},
                                          {9, 9, 4},   {1e5, 1, 2}, {.11, .1, 5}, {.09, .09, 6}, {.01, .01, 6}};

inline uint32_t decimals_of_pages() {
  return first_failing(page_decimals, [](const PageDecimals &c) {
    constexpr SmallBall ball{0, 0, 0, 10};
    hsp::PictureOptions options;
    options.width = c.width;
    options.height = c.height;
    return small_view().succeeds(&ball, 1) && hsp::lay_out(picture_input(), options).decimals == c.expected;
  });
}

struct SpanParts {
  double span, most;
  uint32_t expected;
};
constexpr SpanParts span_parts[] = {{0, 1, 1}, {.5, 1, 1},  {1, 1, 1},   {1.01, 1, 2},
                                    {2, 1, 2}, {2.5, 1, 3}, {6.28, 3, 3}};

inline uint32_t parts_of_spans() {
  return first_failing(span_parts, [](const SpanParts &c) { return hsp::parts_of(c.span, c.most) == c.expected; });
}

// Arcs of the view plane on a page of 100 x 60 px with two px for a step, whose middle is (5, 7).
struct OnPage {
  hsp::ProjectedArc arc;
  double centre[2], semi_axis[2], start[2], end[2], half_way[2];
};
constexpr double quarter_turn = hsp::pi / 2;
constexpr OnPage on_page[] = {{{{{5, 7}, {3, 0}, {0, 3}}, 0, 2 * quarter_turn, {8, 7}, {2, 7}, hsp::no_id},
                               {50, 30},
                               {6, 6},
                               {56, 30},
                               {44, 30},
                               {50, 36}},
                              {{{{0, 10}, {0, 5}, {-2, 0}}, quarter_turn, -quarter_turn, {-2, 10}, {2, 10}, 0},
                               {40, 36},
                               {10, 4},
                               {36, 36},
                               {44, 36},
                               {40, 46}},
                              {{{{5, 7}, {3, 4}, {-.8, .6}}, -quarter_turn, quarter_turn, {5.8, 6.4}, {4.2, 7.6}, 4},
                               {50, 30},
                               {10, 2},
                               {51.6, 28.8},
                               {48.4, 31.2},
                               {56, 38}}};

inline uint32_t arcs_on_pages() {
  return first_failing(on_page, [](const OnPage &c) {
    hsp::Page page{};
    page.width = 100;
    page.height = 60;
    page.scale = 2;
    page.middle[0] = 5;
    page.middle[1] = 7;
    const hsp::PageArc arc = page.to_page(c.arc);
    const auto lies_at = [](const hsp::PagePoint &point, const double(&expected)[2]) {
      return near(point.x, expected[0], 1e-13 * 100) && near(point.y, expected[1], 1e-13 * 100);
    };
    return lies_at(arc.centre, c.centre) && near(arc.semi_axis[0], c.semi_axis[0], 1e-14 * 10) &&
           near(arc.semi_axis[1], c.semi_axis[1], 1e-14 * 10) && lies_at(arc.start, c.start) &&
           lies_at(arc.end, c.end) && lies_at(arc.at(arc.from), c.start) && lies_at(arc.at(arc.to), c.end) &&
           lies_at(arc.at((arc.from + arc.to) / 2), c.half_way) && arc.circle == (c.arc.other_ball == hsp::no_id) &&
           near(arc.span(), 2 * quarter_turn, 1e-15);
  });
}

// The corners of a flat arc with its major axis from -1 to 1: the ends of the axis that it passes, then its own end.
struct FlatArc {
  double from, to;
  uint32_t passed;
  double end_of_axis[3];
};
constexpr FlatArc flat_arcs[] = {{-1, 1, 1, {1}},
                                 {1, -1, 1, {1}},
                                 {1, 2, 0, {}},
                                 {1, 6, 1, {-1}},
                                 {6, 1, 1, {-1}},
                                 {1, 7, 2, {-1, 1}},
                                 {7, 1, 2, {1, -1}},
                                 {0, 2 * quarter_turn, 0, {}},
                                 {-2 * quarter_turn, 2 * quarter_turn, 1, {1}},
                                 {2 * quarter_turn, -2 * quarter_turn, 1, {1}},
                                 {-4, 2, 2, {-1, 1}},
                                 {-7, -1, 2, {1, -1}},
                                 {-1, -7, 2, {-1, 1}},
                                 {-10, -8, 1, {-1}},
                                 {3, 9, 2, {-1, 1}}};

inline uint32_t corners_of_flat_arcs() {
  return first_failing(flat_arcs, [](const FlatArc &c) {
    hsp::PageArc arc{};
    arc.major = {3, 4};
    arc.from = c.from;
    arc.to = c.to;
    arc.end = {7, 7};
    uint32_t visited = 0;
    bool holds = true;
    hsp::visit_line(arc, [&](const hsp::PagePoint &corner) {
      if (visited < c.passed) {
        holds = holds && corner.x == 3 * c.end_of_axis[visited] && corner.y == 4 * c.end_of_axis[visited];
      } else {
        holds = holds && corner.x == 7 && corner.y == 7;
      }
      ++visited;
    });
    return holds && visited == c.passed + 1;
  });
}

inline constexpr Check picture_page[] = {{"sizes_of_pages", sizes_of_pages},
                                         {"pages_of_fixed_frames", pages_of_fixed_frames},
                                         {"lines_of_fixed_frames", lines_of_fixed_frames},
                                         {"widths_of_lines", widths_of_lines},
                                         {"room_of_lines", room_of_lines},
                                         {"decimals_of_steps", decimals_of_steps},
                                         {"decimals_of_pages", decimals_of_pages},
                                         {"parts_of_spans", parts_of_spans},
                                         {"arcs_on_pages", arcs_on_pages},
                                         {"corners_of_flat_arcs", corners_of_flat_arcs}};

}  // namespace cases
