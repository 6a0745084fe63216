// SVG files read back: sizes, texts, paths around circles known by hand, the order of paint, and gradients.
#pragma once

#include <cstring>
#include <initializer_list>

#include "small_picture.hpp"
#include "small_scenes.hpp"

namespace cases {

inline const PictureText &svg(const hsp::PictureOptions &options, const hsp::PictureInput &input) {
  return written(hsp::write_svg, input, options);
}

// What the loops of a path run along, in px, y down. turn: +1 clockwise as it is seen.
struct Loop {
  double centre[2], semi_axis[2], rotation;
  int turn;
};
// Ball 0 of two, outside the other one.
struct Path {
  uint32_t n;
  SmallBall ball[2];
  double width;  // steps
  uint32_t loops;
  Loop loop[2];  // in any order
};
constexpr Path paths[] = {
    {1, {{3, 4, 5, 50}}, 100, 1, {{{100, 100}, {100, 100}, 0, -1}}},
    {2, {{0, 0, 0, 50}, {0, 0, 60, 50}}, 100, 2, {{{100, 100}, {100, 100}, 0, -1}, {{100, 100}, {80, 80}, 0, 1}}},
    {2, {{0, 0, 0, 50}, {48, 0, 64, 50}}, 148, 2, {{{100, 100}, {100, 100}, 0, -1}, {{148, 100}, {60, 48}, 90, 1}}},
    {2, {{0, 0, 0, 50}, {0, 48, 64, 50}}, 100, 2, {{{100, 196}, {100, 100}, 0, -1}, {{100, 148}, {60, 48}, 0, 1}}},
    // The circle's axis is (.36, .48, .8).
    {2,
     {{0, 0, 0, 250}, {144, 192, 320, 250}},
     644,
     2,
     {{{500, 884}, {500, 500}, 0, -1}, {{644, 692}, {300, 240}, 36.8699, 1}}}};

// Reads one loop, from M to Z, and holds it against the ellipse that it should run along.
inline bool reads_loop(TextReader &reader, const Loop &loop) {
  constexpr double rounding = .006;
  double from[2], arc[7];
  const double angle = loop.rotation * hsp::pi / 180;
  // From the centre, where the ellipse is the unit circle.
  const auto on_circle = [&](const double point[2], double(&result)[2]) {
    const double x = point[0] - loop.centre[0], y = point[1] - loop.centre[1];
    result[0] = (std::cos(angle) * x + std::sin(angle) * y) / loop.semi_axis[0];
    result[1] = (std::cos(angle) * y - std::sin(angle) * x) / loop.semi_axis[1];
    return near(std::sqrt(result[0] * result[0] + result[1] * result[1]), 1, 2 * rounding / loop.semi_axis[1]);
  };
  if (!reader.take("M") || !reader.numbers(from)) return false;
  double a[2], b[2], total = 0;
  if (!on_circle(from, a)) return false;
  while (reader.take("A")) {
    if (!reader.numbers(arc) || !near(arc[0], loop.semi_axis[0], rounding) ||
        !near(arc[1], loop.semi_axis[1], rounding))
      return false;
    const bool round = loop.semi_axis[0] == loop.semi_axis[1];
    if (!round && !near(arc[2], loop.rotation, .01) && !near(arc[2], loop.rotation - 180, .01)) return false;
    // No large arc, and the sweep as it is with y down.
    if (arc[3] != 0 || arc[4] != (loop.turn > 0 ? 1 : 0) || !on_circle(arc + 5, b)) return false;
    const double turn = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    if (turn * loop.turn <= 0) return false;
    total += turn;
    a[0] = b[0];
    a[1] = b[1];
  }
  return near(total, 2 * hsp::pi * loop.turn, 1e-3) && arc[5] == from[0] && arc[6] == from[1] && reader.take("Z");
}

inline uint32_t paths_run_along_circles() {
  return first_failing(paths, [](const Path &c) {
    if (!small_view().succeeds(c.ball, c.n, {{}, hsp::PieceKind::outside_all, true})) return false;
    TextReader reader(svg(two_px_per_step(c.width), picture_input()).text);
    if (!reader.find("<path data-ball=\"0\" fill=\"#d2cdc3\" d=\"")) return false;
    uint32_t found = 0;
    for (uint32_t l = 0; l < c.loops; ++l) {
      for (uint32_t k = 0; k < c.loops; ++k) {
        TextReader trial = reader;
        if (!reads_loop(trial, c.loop[k])) continue;
        reader = trial;
        found |= UINT32_C(1) << k;
        break;
      }
    }
    return found + 1 == UINT32_C(1) << c.loops && reader.take("\"/>");
  });
}

// Every loop of every path ends where it starts, digit by digit, and all numbers can be read.
inline uint32_t loops_are_closed() {
  return first_failing(scenes, [](const Scene &c) {
    if (!small_view().succeeds(c.ball, c.n, seen_from(3, 1, 2))) return false;
    TextReader reader(svg({}, picture_input()).text);
    uint32_t loops = 0;
    while (reader.find(" d=\"")) {
      do {
        double start[2], at[2], arc[5];
        if (!reader.take("M") || !reader.numbers(start)) return false;
        while (!reader.take("Z")) {
          const bool line = reader.take("L");
          if (!line && (!reader.take("A") || !reader.numbers(arc) || arc[3] != 0)) return false;
          if (!reader.numbers(at)) return false;
        }
        if (at[0] != start[0] || at[1] != start[1]) return false;
        ++loops;
      } while (!reader.take("\"/>"));
    }
    return loops == small_view().view().loops.size();
  });
}

// The centre of an arc from its ends, as renderers find it (SVG 1.1, F.6.5), for an arc that is not large.
inline bool centre_of_arc(const double (&start)[2], const double (&arc)[7], double (&centre)[2]) {
  const double a = arc[0], b = arc[1], angle = arc[2] * hsp::pi / 180, c = std::cos(angle), s = std::sin(angle);
  const double dx = (start[0] - arc[5]) / 2, dy = (start[1] - arc[6]) / 2;
  const double x = (c * dx + s * dy) / a, y = (c * dy - s * dx) / b;
  const double squared = 1 / (x * x + y * y) - 1;
  if (squared < 0.0) return false;  // the radii are too small
  const double root = arc[4] != 0 ? -std::sqrt(squared) : std::sqrt(squared);
  const double u = -root * a * y, v = root * b * x;
  centre[0] = c * u - s * v + (start[0] + arc[5]) / 2;
  centre[1] = s * u + c * v + (start[1] + arc[6]) / 2;
  return true;
}

// A circle of radius 400, without its ends, seen nearly edge on from directions (k, 0, 1000): renderers find it where
// it is, 50 above the middle of the picture.
constexpr double nearly_edge_on[] = {2, 5, 10, 20, 50, 100, 200, 500};

inline uint32_t flat_ellipses_are_where_they_belong() {
  return first_failing(nearly_edge_on, [](double k) {
    constexpr SmallBall lens[] = {{0, 0, 0, 500}, {600, 0, 0, 500}, {300, 400, 0, 200}, {300, -400, 0, 300}};
    if (!small_view().succeeds(lens, 4, {{{k, 0, 1000}, {0, 1, 0}}, hsp::PieceKind::outside_all, true})) return false;
    hsp::PictureOptions options;
    options.height = 1000;
    options.margin = 0;
    options.outline = 0;  // with lines the flattest would be lines themselves
    const double scale = hsp::lay_out(picture_input(), options).scale;
    TextReader reader(svg(options, picture_input()).text);
    uint32_t flat = 0;
    while (reader.find(" d=\"M")) {
      double at[2], arc[7], centre[2];
      if (!reader.numbers(at)) return false;
      while (reader.take("A")) {
        if (!reader.numbers(arc)) return false;
        if (near(arc[0], 400 * scale, .01) && arc[1] < .9 * arc[0]) {
          if (!centre_of_arc(at, arc, centre)) return false;
          if (!near(centre[0], 500, .1) || !near(centre[1], 500 - 50 * scale, .1)) return false;
          ++flat;
        }
        at[0] = arc[5];
        at[1] = arc[6];
      }
    }
    return flat == 2;
  });
}

constexpr FileParts svg_parts[] = {
    {{300, false, true, true, 1.5, nullptr, nullptr},
     {" width=\"300px\" height=\"300px\" viewBox=\"0 0 300 300\">",
      "<rect width=\"300\" height=\"300\" fill=\"#fedcba\"/>", "<path data-ball=\"0\" fill=\"#00ff7f\"",
      "<g stroke=\"#010203\" stroke-width=\"1.5\""},
     {"<title", "<desc", "Gradient"}},
    // An inch.
    {{25.4, true, true, false, 25.4, "", ""},
     {" width=\"25.4mm\" height=\"25.4mm\" viewBox=\"0 0 96 96\">", "stroke-width=\"96\"", "data-ball", "<g stroke"},
     {"<title", "<desc", "<rect"}},
    {{40, false, false, false, 0, "a<b & \"c\"", "1 > 0\x01"},
     {"<title>a&lt;b &amp; &quot;c&quot;</title>", "<desc>1 &gt; 0?</desc>", "<path fill=\"#00ff7f\"", "<g>"},
     {"data-ball", "<rect", "stroke"}}};

inline uint32_t parts_of_svg_files() {
  return first_failing(svg_parts, [](const FileParts &c) {
    const PictureText &text = text_of_one_ball(hsp::write_svg, c.options);
    return has_parts(text, c) && text.count("<svg ") == 1 && ends_with(text, "</svg>\n") &&
           text.count("<g") == text.count("</g>");
  });
}

// A group for each colour of lines.
inline uint32_t svg_paints_the_farthest_first() {
  constexpr double fogs[] = {0, .5};
  return first_failing(fogs, [](double fog) {
    if (!small_view().succeeds(staggered, 4)) return false;
    hsp::PictureOptions options;
    options.fog = fog;
    const PictureText &text = svg(options, picture_input());
    TextReader reader(text.text);
    for (const uint32_t ball : farthest_first) {
      double number;
      if (!reader.find("data-ball=\"") || !reader.number(number) || number != ball) return false;
    }
    const uint32_t groups = fog > 0 ? 3 : 1;
    return text.count("<g ") == groups && text.count("</g>") == groups && text.count("<path") == 4;
  });
}

// The letters and digits between the kind of a gradient and its number: the same for all of a picture.
constexpr uint32_t name_length = 7;  // six hexadecimal digits and a hyphen
struct GradientNames {
  char text[name_length + 1] = "";
  bool read(TextReader &reader) {
    if (text[0] == '\0') std::strncpy(text, reader.rest(), name_length);
    return text[name_length - 1] == '-' && reader.take(text);
  }
  bool is(const GradientNames &other) const { return std::strcmp(text, other.text) == 0; }
};

// Each ball has a gradient of its own, whole but for the stops, which are the shade's.
inline uint32_t svg_gradients() {
  constexpr hsp::PictureStyle shaded[] = {hsp::PictureStyle::headlight, hsp::PictureStyle::soft};
  return first_failing(shaded, [](hsp::PictureStyle style) {
    constexpr uint32_t colour[] = {7, 8, 9, 8};
    if (!small_view().succeeds(staggered, 4)) return false;
    hsp::PictureOptions options = two_px_per_step(65);
    options.style = style;
    const PictureText &text = svg(options, picture_input(colour));
    if (text.count("<radialGradient id=\"g") != 3 || text.count("<radialGradient id=\"b") != 4) return false;
    uint32_t colour_of[3] = {};
    const bool soft = style == hsp::PictureStyle::soft;
    if (text.count("<stop offset=\"") != 3 * (soft ? 13 : 17)) return false;
    if (text.count("<stop offset=\"0\"") != 3 || text.count("<stop offset=\"1\"") != 3) return false;
    TextReader reader(text.text);
    GradientNames names;
    for (uint32_t p = 0; p < 4; ++p) {
      const uint32_t ball = farthest_first[p];
      double id, shade, x, y, radius, focus[2];
      if (!reader.find("<radialGradient id=\"b") || !names.read(reader) || !reader.number(id) || id != p) return false;
      if (!reader.take("\" xlink:href=\"#g") || !names.read(reader) || !reader.number(shade)) return false;
      if (!reader.take("\" gradientUnits=\"userSpaceOnUse\" cx=\"") || !reader.number(x)) return false;
      if (!reader.take("\" cy=\"") || !reader.number(y)) return false;
      if (!reader.take("\" r=\"") || !reader.number(radius) || radius != 20) return false;
      if (shade >= 3 || x != 2 * (staggered[ball].x + 10) || y != 2 * (15 - staggered[ball].y)) return false;
      // Soft light comes from the left and from above, where y is less.
      if (soft) {
        if (!reader.take("\" fx=\"") || !reader.number(focus[0])) return false;
        if (!reader.take("\" fy=\"") || !reader.number(focus[1])) return false;
        if (!near(focus[0], x - .34 * radius, .01) || !near(focus[1], y - .4 * radius, .01)) return false;
      }
      if (!reader.take("\"/>")) return false;
      // The same shade for the same colour.
      uint32_t &known = colour_of[static_cast<uint32_t>(shade)];
      if (known != 0 && known != colour[ball]) return false;
      known = colour[ball];
    }
    for (uint32_t p = 0; p < 4; ++p) {
      double id;
      if (!reader.find(" fill=\"url(#b") || !names.read(reader) || !reader.number(id) || id != p) return false;
    }
    return text.count("xmlns:xlink=\"http://www.w3.org/1999/xlink\"") == 1;
  });
}

// Pictures inline in one page: names differ where colours, places or sizes do, and else are the same.
inline uint32_t names_differ_between_pictures() {
  constexpr uint32_t colours[][4] = {{7, 8, 9, 8}, {7, 8, 9, 8}, {7, 8, 9, 7}, {7, 8, 9, 8}};  // 0 and 1 are the same
  constexpr double widths[] = {65, 65, 65, 66};
  GradientNames names[4];
  if (!small_view().succeeds(staggered, 4)) return 0;
  for (uint32_t k = 0; k < 4; ++k) {
    hsp::PictureOptions options = two_px_per_step(widths[k]);
    options.style = hsp::PictureStyle::soft;
    TextReader reader(svg(options, picture_input(colours[k])).text);
    if (!reader.find("<radialGradient id=\"g") || !names[k].read(reader)) return k;
    for (uint32_t other = 0; other < k; ++other) {
      if (names[k].is(names[other]) != (k == 1)) return k;
    }
  }
  return all_hold;
}

// Renderers fail on a radius of 0, which that of a small ball would be rounded to.
inline uint32_t no_svg_radius_is_0() {
  hsp::PictureOptions options;
  options.style = hsp::PictureStyle::soft;
  if (!small_view().succeeds(small_beside_large, 2)) return 0;
  const PictureText &text = svg(options, picture_input());
  return text.count(" r=\".01\"") == 1 && text.count(" r=\"0\"") == 0 ? all_hold : 1;
}

inline constexpr Check picture_svg_writer[] = {
    {"paths_run_along_circles", paths_run_along_circles},
    {"loops_are_closed", loops_are_closed},
    {"flat_ellipses_are_where_they_belong", flat_ellipses_are_where_they_belong},
    {"parts_of_svg_files", parts_of_svg_files},
    {"svg_paints_the_farthest_first", svg_paints_the_farthest_first},
    {"svg_gradients", svg_gradients},
    {"names_differ_between_pictures", names_differ_between_pictures},
    {"no_svg_radius_is_0", no_svg_radius_is_0}};

}  // namespace cases
