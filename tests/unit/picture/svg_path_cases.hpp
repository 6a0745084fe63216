// Path data of SVG read back: how numbers are kept apart, in how many parts arcs are written, which curves are lines.
#pragma once

#include <cmath>
#include <initializer_list>

#include "cases.hpp"
#include "kept_text.hpp"
#include "picture/svg_path.hpp"

namespace cases {

using PathText = KeptText<400>;

template <class Put>
PathText path_text(const hsp::SvgFrame &frame, int decimals, Put put) {
  return text_of<400>([&](hsp::ByteSink &sink) {
    hsp::SvgPath path(sink, frame, decimals);
    put(path);
  });
}
constexpr hsp::SvgFrame page_of_height_10{{0, 10}, 1};

// The path after M1.5 2 by lines to some points, y up.
struct LineText {
  uint32_t points;
  hsp::PagePoint to[3];
  const char *expected;
};
constexpr LineText line_texts[] = {{1, {{2, 7.75}}, "M1.5 2l.5.25"},
                                   {2, {{2, 7.75}, {2.5, 7.5}}, "M1.5 2l.5.25.5.25"},
                                   {2, {{2, 7.75}, {5, 7.75}}, "M1.5 2l.5.25 3 0"},
                                   {2, {{4.5, 5}, {5, 4.5}}, "M1.5 2l3 3 .5.5"},
                                   {3, {{1, 8.5}, {1, 8}, {3.5, 8}}, "M1.5 2l-.5-.5 0 .5 2.5 0"}};

inline uint32_t svg_numbers_are_kept_apart() {
  return first_failing(line_texts, [](const LineText &c) {
    return path_text(page_of_height_10, 2,
                     [&c](hsp::SvgPath &path) {
                       path.begin({1.5, 8});
                       for (uint32_t k = 0; k < c.points; ++k) path.line_to(c.to[k]);
                     })
        .is(c.expected);
  });
}

// Each loop has its own beginning, which counts from the origin; steps do not add up what is rounded.
inline uint32_t svg_paths_count_from_their_frame() {
  const auto draw = [](hsp::SvgPath &path) {
    path.begin({110, 40});
    for (int k = 1; k <= 3; ++k) path.line_to({110 + k / 300.0, 40});
    path.close();
    path.begin({100, 50});
    path.line_to({100, 70});
  };
  const bool conditions[] = {
      path_text({{100, 50}, 1}, 2, draw).is("M10 10l0 0 .01 0 0 0ZM0 0l0-20"),
      path_text({{100, 50}, 20}, 4, draw).is("M.5.5l.0002 0 .0001 0 .0002 0ZM0 0l0-1"),
      path_text({{0, 100}, 1}, 0, draw).is("M110 60l0 0 0 0 0 0ZM100 50l0-20"),
  };
  return first_false(conditions);
}

// The centre of an arc from its ends, as renderers find it (SVG 1.1, F.6.5). arc: both axes, the angle, whether it is
// large, its sweep, and its end.
inline bool centre_of_arc(const double (&start)[2], const double (&arc)[7], double (&centre)[2]) {
  const double a = arc[0], b = arc[1], angle = arc[2] * hsp::pi / 180, c = std::cos(angle), s = std::sin(angle);
  const double dx = (start[0] - arc[5]) / 2, dy = (start[1] - arc[6]) / 2;
  const double x = (c * dx + s * dy) / a, y = (c * dy - s * dx) / b;
  const double squared = 1 / (x * x + y * y) - 1;
  if (squared < 0.0) return false;  // the radii are too small
  const double root = arc[3] == arc[4] ? std::sqrt(squared) : -std::sqrt(squared);
  const double u = -root * a * y, v = root * b * x;
  centre[0] = c * u - s * v + (start[0] + arc[5]) / 2;
  centre[1] = s * u + c * v + (start[1] + arc[6]) / 2;
  return true;
}

// The arc with which a path goes on from a point, which becomes its end: steps count from there, and a letter stands
// once for several arcs.
inline bool next_arc(TextReader &reader, double (&at)[2], double (&arc)[7]) {
  reader.take("a");
  if (!reader.numbers(arc)) return false;
  for (int k = 0; k < 2; ++k) arc[5 + k] = at[k] += arc[5 + k];
  return true;
}

// Arcs of an ellipse with semi-axes 10 and 10 or 6, a turn being 1: in how many parts, and which of these are large.
struct ArcParts {
  double turns;
  uint32_t parts;
  bool large[2];
};
constexpr ArcParts arc_parts[] = {{.01, 1, {false}},         {.25, 1, {false}},       {.449, 1, {false}},
                                  {.451, 2, {false, false}}, {.5, 2, {false, false}}, {.549, 2, {false, false}},
                                  {.551, 1, {true}},         {.75, 1, {true}},        {.874, 1, {true}},
                                  {.876, 2, {false, true}},  {.99, 2, {false, true}}, {1, 2, {false, true}}};

inline uint32_t svg_arcs_are_well_conditioned() {
  return first_failing(arc_parts, [](const ArcParts &c) {
    for (const double minor : {10.0, 6.0}) {
      for (const double turn : {1.0, -1.0}) {
        for (const double first : {0.0, 1.0, 2.5}) {
          hsp::PageArc arc{};
          arc.major = {10 * std::cos(.3), 10 * std::sin(.3)};
          arc.minor = {-minor * std::sin(.3), minor * std::cos(.3)};
          arc.semi_axis[0] = 10;
          arc.semi_axis[1] = minor;
          arc.from = first;
          arc.to = first + turn * c.turns * 2 * hsp::pi;
          arc.start = arc.at(arc.from);
          arc.end = arc.at(arc.to);
          arc.circle = minor == 10.0;
          const auto text = path_text({{0, 0}, 1}, 2, [&arc](hsp::SvgPath &path) {
            path.begin(arc.start);
            path.follow(arc, 2);
          });
          TextReader reader(text.text);
          double at[2], read[7], centre[2];
          if (!reader.take("M") || !reader.numbers(at)) return false;
          for (uint32_t k = 0; k < c.parts; ++k) {
            const double start[2] = {at[0], at[1]};
            if (!next_arc(reader, at, read) || read[0] != 10 || read[1] != minor) return false;
            if ((read[3] != 0) != c.large[k] || read[4] != (turn > 0 ? 0 : 1)) return false;
            if (!near(read[2], arc.circle ? 0 : -.3 * 180 / hsp::pi, .05)) return false;
            // A short arc says little of its centre, and needs not to.
            if (c.turns < .1) continue;
            if (!centre_of_arc(start, read, centre) || !near(std::hypot(centre[0], centre[1]), 0, .08)) return false;
          }
          if (*reader.rest() != '\0') return false;
          if (!near(at[0], arc.end.x, .0051) || !near(at[1], -arc.end.y, .0051)) return false;
        }
      }
    }
    return true;
  });
}

// Radii of circles have their own decimals, axes of ellipses those of the points; both count in units of the frame.
struct ArcText {
  bool circle;
  double unit;
  const char *expected;
};
constexpr ArcText arc_texts[] = {{true, 1, "M1.2346 0a1.23 1.23 0 0 0-1.2346-1.2346"},
                                 {false, 1, "M1.2346 0a1.2346 1.2346 0 0 0-1.2346-1.2346"},
                                 {true, 1.23456, "M1 0a1 1 0 0 0-1-1"},
                                 {false, 10, "M.1235 0a.1235.1235 0 0 0-.1235-.1235"}};

inline uint32_t svg_arcs_have_decimals() {
  return first_failing(arc_texts, [](const ArcText &c) {
    hsp::PageArc arc{};
    arc.major = {1.23456, 0};
    arc.minor = {0, 1.23456};
    arc.semi_axis[0] = arc.semi_axis[1] = 1.23456;
    arc.to = hsp::pi / 2;
    arc.start = {1.23456, 0};
    arc.end = {0, 1.23456};
    arc.circle = c.circle;
    return path_text({{0, 0}, c.unit}, 4,
                     [&arc](hsp::SvgPath &path) {
                       path.begin(arc.start);
                       path.follow(arc, 2);
                     })
        .is(c.expected);
  });
}

// Curves from the origin.
struct CurveText {
  hsp::PagePoint control, end;
  const char *expected;
};
constexpr CurveText curve_texts[] = {{{.5, 0}, {1, 0}, "M0 0l1 0"},          {{.5, -.02}, {1, 0}, "M0 0l1 0"},
                                     {{.5, -.03}, {1, 0}, "M0 0q.5.03 1 0"}, {{.53, 0}, {1, 0}, "M0 0q.53 0 1 0"},
                                     {{.01, .01}, {.004, -.004}, "M0 0"},    {{-1, 1}, {0, 0}, "M0 0q-1-1 0 0"}};

inline uint32_t svg_curves_that_are_lines() {
  return first_failing(curve_texts, [](const CurveText &c) {
    return path_text({{0, 0}, 1}, 2,
                     [&c](hsp::SvgPath &path) {
                       path.begin({0, 0});
                       path.follow({{0, 0}, c.control, c.end, false});
                     })
        .is(c.expected);
  });
}

inline constexpr Check picture_svg_path[] = {{"svg_numbers_are_kept_apart", svg_numbers_are_kept_apart},
                                             {"svg_paths_count_from_their_frame", svg_paths_count_from_their_frame},
                                             {"svg_arcs_are_well_conditioned", svg_arcs_are_well_conditioned},
                                             {"svg_arcs_have_decimals", svg_arcs_have_decimals},
                                             {"svg_curves_that_are_lines", svg_curves_that_are_lines}};

}  // namespace cases
