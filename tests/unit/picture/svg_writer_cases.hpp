// SVG files read back: sizes, texts, paths around circles known by hand, the order of paint, and gradients.
#pragma once

#include <cstring>
#include <initializer_list>

#include "small_picture.hpp"
#include "small_scenes.hpp"
#include "svg_path_cases.hpp"

namespace cases {

inline const PictureText &svg(const hsp::PictureOptions &options, const hsp::PictureInput &input) {
  return written(hsp::write_svg, input, options);
}

// The course of a path's loops, in px, y down. turn: +1 clockwise as it is seen.
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
inline bool reads_loop(TextReader &reader, const Loop &loop, double rounding = .006) {
  double at[2], arc[7];
  const double angle = loop.rotation * hsp::pi / 180;
  // From the centre, where the ellipse is the unit circle.
  const auto on_circle = [&](const double point[2], double(&result)[2]) {
    const double x = point[0] - loop.centre[0], y = point[1] - loop.centre[1];
    result[0] = (std::cos(angle) * x + std::sin(angle) * y) / loop.semi_axis[0];
    result[1] = (std::cos(angle) * y - std::sin(angle) * x) / loop.semi_axis[1];
    return near(std::sqrt(result[0] * result[0] + result[1] * result[1]), 1, 2 * rounding / loop.semi_axis[1]);
  };
  if (!reader.take("M") || !reader.numbers(at)) return false;
  const double from[2] = {at[0], at[1]};
  double a[2], b[2], total = 0;
  if (!on_circle(from, a)) return false;
  while (next_arc(reader, at, arc)) {
    if (!near(arc[0], loop.semi_axis[0], rounding) || !near(arc[1], loop.semi_axis[1], rounding)) return false;
    const bool round = loop.semi_axis[0] == loop.semi_axis[1];
    if (!round && !near(arc[2], loop.rotation, .01) && !near(arc[2], loop.rotation - 180, .01)) return false;
    // The sweep as it is with y down.
    if (arc[4] != (loop.turn > 0 ? 1 : 0) || !on_circle(at, b)) return false;
    double turn = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    if (arc[3] != 0) turn += turn < 0 ? 2 * hsp::pi : -2 * hsp::pi;
    if (turn * loop.turn <= 0) return false;
    total += turn;
    a[0] = b[0];
    a[1] = b[1];
  }
  return near(total, 2 * hsp::pi * loop.turn, 1e-3) && near(at[0], from[0], 1e-9) && near(at[1], from[1], 1e-9) &&
         reader.take("Z");
}
// Reads the loops of a path in any order.
inline bool reads_loops(TextReader &reader, const Loop *loop, uint32_t loops, double rounding = .006) {
  uint32_t found = 0;
  for (uint32_t l = 0; l < loops; ++l) {
    for (uint32_t k = 0; k < loops; ++k) {
      TextReader trial = reader;
      if (!reads_loop(trial, loop[k], rounding)) continue;
      reader = trial;
      found |= UINT32_C(1) << k;
      break;
    }
  }
  return found + 1 == UINT32_C(1) << loops;
}

inline uint32_t paths_run_along_circles() {
  return first_failing(paths, [](const Path &c) {
    if (!small_view().succeeds(c.ball, c.n, {{}, hsp::PieceKind::outside_all, true})) return false;
    TextReader reader(svg(two_px_per_step(c.width), picture_input()).text);
    if (!reader.find("<path data-ball=\"0\" fill=\"#d2cdc3\" d=\"")) return false;
    return reads_loops(reader, c.loop, c.loops) && reader.take("\"/>");
  });
}

// A ball that nothing cuts is a circle; numbers that are 0 are left out.
struct WholeBall {
  double width;
  const char *expected;
};
constexpr WholeBall whole_balls[] = {
    {100, "<circle data-ball=\"0\" fill=\"#d2cdc3\" cx=\"100\" cy=\"100\" r=\"100\"/>"},
    {10, "<circle data-ball=\"0\" fill=\"#d2cdc3\" cx=\"10\" cy=\"10\" r=\"10\"/>"}};

inline uint32_t whole_balls_are_circles() {
  return first_failing(whole_balls, [](const WholeBall &c) {
    constexpr SmallBall ball{3, 4, 5, 50};
    if (!small_view().succeeds(&ball, 1)) return false;
    const PictureText &text = svg(two_px_per_step(c.width), picture_input());
    return text.count(c.expected) == 1 && text.count("<path") == 0;
  });
}

// Every loop of every path ends where it starts, and all numbers can be read.
inline uint32_t loops_are_closed() {
  return first_failing(scenes, [](const Scene &c) {
    if (!small_view().succeeds(c.ball, c.n, seen_from(3, 1, 2))) return false;
    const PictureText &text = svg({}, picture_input());
    TextReader reader(text.text);
    uint32_t loops = text.count("<circle");
    while (reader.find(" d=\"")) {
      do {
        double start[2], step[2], arc[7];
        if (!reader.take("M") || !reader.numbers(start)) return false;
        double at[2] = {start[0], start[1]};
        for (bool line = false; !reader.take("Z");) {
          if (reader.take("l")) line = true;
          if (reader.take("a")) line = false;
          if (!line) {
            if (!next_arc(reader, at, arc) || arc[3] > 1 || arc[4] > 1) return false;
            continue;
          }
          if (!reader.numbers(step)) return false;
          for (int k = 0; k < 2; ++k) at[k] += step[k];
        }
        if (!near(at[0], start[0], 1e-9) || !near(at[1], start[1], 1e-9)) return false;
        ++loops;
      } while (!reader.take("\"/>"));
    }
    return loops == small_view().view().loops.size();
  });
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
      for (double start[2] = {at[0], at[1]}; next_arc(reader, at, arc); start[0] = at[0], start[1] = at[1]) {
        if (near(arc[0], 400 * scale, .01) && arc[1] < .9 * arc[0]) {
          if (!centre_of_arc(start, arc, centre)) return false;
          if (!near(centre[0], 500, .1) || !near(centre[1], 500 - 50 * scale, .1)) return false;
          ++flat;
        }
      }
    }
    return flat == 2;
  });
}

constexpr FileParts svg_parts[] = {
    {{300, false, true, true, 1.5, nullptr, nullptr},
     {" width=\"300px\" height=\"300px\" viewBox=\"0 0 300 300\" role=\"img\">",
      "<rect width=\"300\" height=\"300\" fill=\"#fedcba\"/>", "<circle data-ball=\"0\" fill=\"#00ff7f\"",
      "<g stroke=\"#010203\" stroke-width=\"1.5\""},
     {"<title", "<desc", "Gradient"}},
    // An inch.
    {{25.4, true, true, false, 25.4, "", ""},
     {" width=\"25.4mm\" height=\"25.4mm\" viewBox=\"0 0 96 96\" role=\"img\">", "stroke-width=\"96\"", "data-ball",
      "<g stroke"},
     {"<title", "<desc", "<rect"}},
    {{40, false, false, false, 0, "a<b & \"c\"", "1 > 0\x01"},
     {"<title>a&lt;b &amp; &quot;c&quot;</title>", "<desc>1 &gt; 0?</desc>", "<circle fill=\"#00ff7f\"", "<g>"},
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
    return text.count("<g ") == groups && text.count("</g>") == groups && text.count("<circle") == 4;
  });
}

// The letters and digits between the kind of a name and its number: the same for all of a picture.
constexpr uint32_t name_length = 5;  // four of them and a hyphen
struct Names {
  char text[name_length + 1] = "";
  bool read(TextReader &reader) {
    if (text[0] == '\0') std::strncpy(text, reader.rest(), name_length);
    return text[name_length - 1] == '-' && reader.take(text);
  }
  bool is(const Names &other) const { return std::strcmp(text, other.text) == 0; }
};

// A gradient for each level of fog, whatever the sizes.
struct Gradients {
  hsp::PictureStyle style;
  double fog;
  uint32_t levels;
};
constexpr Gradients gradients[] = {{hsp::PictureStyle::headlight, 0, 1},
                                   {hsp::PictureStyle::soft, 0, 1},
                                   {hsp::PictureStyle::headlight, 1, 3},
                                   {hsp::PictureStyle::soft, .1, 3}};
// staggered, with balls of two sizes, both of which are at one of three depths.
constexpr SmallBall of_two_sizes[] = {{0, 0, 40, 10}, {15, 5, 80, 12}, {30, 0, 0, 10}, {45, 0, 80, 10}};

inline uint32_t svg_gradients() {
  return first_failing(gradients, [](const Gradients &c) {
    if (!small_view().succeeds(of_two_sizes, 4)) return false;
    hsp::PictureOptions options = two_px_per_step(65);
    options.style = c.style;
    options.fog = c.fog;
    const PictureText &text = svg(options, picture_input());
    const bool soft = c.style == hsp::PictureStyle::soft;
    if (text.count("<radialGradient ") != c.levels) return false;
    if (text.count("<stop offset=\"") != c.levels * (soft ? 13 : 17)) return false;
    if (text.count("<stop offset=\"0\"") != c.levels || text.count("<stop offset=\"1\"") != c.levels) return false;
    if (text.count(" stop-opacity=\"") != text.count("<stop ")) return false;
    TextReader reader(text.text);
    Names names;
    double level, known = -1;
    for (uint32_t k = 0; k < c.levels; ++k) {
      if (!reader.find("<radialGradient id=\"g") || !names.read(reader) || !reader.number(level)) return false;
      if (level <= known) return false;
      known = level;
      if (!reader.take("\" gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" r=\"1\"")) return false;
      // Soft light comes from the left and from above, where y is less.
      if (soft && !reader.take(" fx=\"-.34\" fy=\"-.4\"")) return false;
      if (!reader.take("><stop offset=\"0\"")) return false;
    }
    return text.count("xmlns:xlink=\"http://www.w3.org/1999/xlink\"") == 1;
  });
}

// Each ball with light is a group with its colour, in which its disc is the unit circle: its outline, and the same with
// light. Lines are as wide as they are on the page.
inline uint32_t svg_light_lies_over_colour() {
  constexpr uint32_t colour[] = {7, 8, 9, 8};
  constexpr double outlines[] = {0, 1.2};
  return first_failing(outlines, [&](double outline) {
    for (const auto style : {hsp::PictureStyle::headlight, hsp::PictureStyle::soft}) {
      if (!small_view().succeeds(of_two_sizes, 4)) return false;
      hsp::PictureOptions options = two_px_per_step(65);
      options.style = style;
      options.outline = outline;
      options.scale = 2;
      options.height = 130;
      TextReader reader(svg(options, picture_input(colour)).text);
      Names names;
      for (uint32_t p = 0; p < 4; ++p) {
        const uint32_t ball = farthest_first[p];
        double number, place[2];
        if (!reader.find("<g data-ball=\"") || !reader.number(number) || number != ball) return false;
        if (!reader.take("\" fill=\"#00000") || !reader.number(number) || number != colour[ball]) return false;
        if (!reader.take("\" transform=\"translate(") || !reader.numbers(place)) return false;
        const SmallBall &at = of_two_sizes[ball];
        if (place[0] != 65 + 2 * at.x || place[1] != 65 - 2 * at.y) return false;
        if (!reader.take(")scale(") || !reader.number(number) || number != 2 * at.r) return false;
        if (!reader.take(")\"><circle id=\"p") || !names.read(reader) || !reader.number(number) || number != p)
          return false;
        if (!reader.take("\" r=\"1\"/><use xlink:href=\"#p") || !names.read(reader)) return false;
        if (!reader.number(number) || number != p) return false;
        if (!reader.take("\" fill=\"url(#g") || !names.read(reader) || !reader.number(number)) return false;
        if (number != 0 || !reader.take(")\"")) return false;
        if (outline > 0) {
          if (!reader.take(" stroke=\"#23202b\" stroke-width=\"") || !reader.number(number)) return false;
          if (!near(number, outline / (2 * at.r), 1e-5) || !reader.take("\"")) return false;
        }
        if (!reader.take("/></g>")) return false;
      }
    }
    return true;
  });
}

// A ball that another one cuts, in its own coordinates: ball 0 of the third of `paths`.
inline uint32_t svg_lit_paths_run_along_circles() {
  constexpr SmallBall lens[] = {{0, 0, 0, 50}, {48, 0, 64, 50}};
  constexpr Loop loops[] = {{{0, 0}, {1, 1}, 0, -1}, {{.48, 0}, {.6, .48}, 90, 1}};
  if (!small_view().succeeds(lens, 2, {{}, hsp::PieceKind::outside_all, true})) return 0;
  hsp::PictureOptions options = two_px_per_step(148);
  options.style = hsp::PictureStyle::soft;
  TextReader reader(svg(options, picture_input()).text);
  if (!reader.find("<g data-ball=\"0\" ") || !reader.find(" transform=\"translate(100 100)scale(100)\"><path id=\"p"))
    return 1;
  if (!reader.find(" d=\"") || !reads_loops(reader, loops, 2, 6e-5)) return 2;
  return reader.take("\"/><use ") ? all_hold : 3;
}

// The names in a file: numbers of balls, or ids instead where there are classes, and tooltips.
inline uint32_t svg_names_balls() {
  constexpr const char *classes[] = {"el-C res-A&B", nullptr, "", "chain-1"};
  constexpr const char *titles[] = {nullptr, "a<b", "", "CYS 16 SG"};
  constexpr hsp::PictureStyle drawn_styles[] = {hsp::PictureStyle::flat, hsp::PictureStyle::soft};
  return first_failing(drawn_styles, [&](hsp::PictureStyle style) {
    if (!small_view().succeeds(staggered, 4)) return false;
    hsp::PictureOptions options = two_px_per_step(65);
    options.style = style;
    hsp::PictureInput input = picture_input();
    input.atom_class = classes;
    input.atom_title = titles;
    for (const bool ids : {true, false}) {
      options.ids = ids;
      const PictureText &text = svg(options, input);
      if (text.count(" class=\"el-C res-A&amp;B\" fill=\"") != 1 || text.count(" class=\"chain-1\" fill=\"") != 1)
        return false;
      if (text.count(" class=") != 2 || text.count(" id=\"a") != (ids ? 2 : 0)) return false;
      if (text.count("-0\" class=\"el-C") != (ids ? 1 : 0) || text.count("-3\" class=\"ch") != (ids ? 1 : 0))
        return false;
      if (text.count("data-ball=") != (ids ? 2 : 0) || text.count("data-ball=\"1\"") != (ids ? 1 : 0)) return false;
      if (text.count("<title>a&lt;b</title>") != 1 || text.count("<title>CYS 16 SG</title>") != 1) return false;
      if (text.count("<title>") != 2) return false;
      const bool flat = style == hsp::PictureStyle::flat;
      if (text.count("</title></circle>") != (flat ? 2 : 0) || text.count("</title><circle id=") != (flat ? 0 : 2))
        return false;
    }
    return true;
  });
}

// Pictures inline in one page: names differ where colours, sizes, paths or light do, and else are the same.
struct Named {
  uint32_t colour[2];
  double width;
  hsp::PieceKind kind;
  hsp::PictureStyle style;
};
constexpr Named named[] = {
    {{7, 8}, 65, hsp::PieceKind::outside_farther, hsp::PictureStyle::soft},
    {{7, 8}, 65, hsp::PieceKind::outside_farther, hsp::PictureStyle::soft},  // the same again
    {{7, 9}, 65, hsp::PieceKind::outside_farther, hsp::PictureStyle::soft},
    {{7, 8}, 66, hsp::PieceKind::outside_farther, hsp::PictureStyle::soft},
    {{7, 8}, 65, hsp::PieceKind::outside_all, hsp::PictureStyle::soft},
    {{7, 8}, 65, hsp::PieceKind::outside_farther, hsp::PictureStyle::headlight},
};

inline uint32_t names_differ_between_pictures() {
  constexpr SmallBall lens[] = {{0, 0, 0, 50}, {48, 0, 64, 50}};
  constexpr uint32_t count = sizeof named / sizeof named[0];
  Names names[count];
  for (uint32_t k = 0; k < count; ++k) {
    const Named &c = named[k];
    if (!small_view().succeeds(lens, 2, {{}, c.kind, true})) return k;
    hsp::PictureOptions options = two_px_per_step(c.width);
    options.style = c.style;
    TextReader reader(svg(options, picture_input(c.colour)).text);
    if (!reader.find("<radialGradient id=\"g") || !names[k].read(reader)) return k;
    for (uint32_t other = 0; other < k; ++other) {
      if (names[k].is(names[other]) != (k == 1)) return k;
    }
  }
  return all_hold;
}

// Renderers fail on a scale of 0, which the radius of a small ball would be rounded to.
inline uint32_t no_svg_radius_is_0() {
  hsp::PictureOptions options;
  options.style = hsp::PictureStyle::soft;
  if (!small_view().succeeds(small_beside_large, 2)) return 0;
  const PictureText &text = svg(options, picture_input());
  return text.count("scale(.01)") == 1 && text.count("scale(0)") == 0 ? all_hold : 1;
}

inline constexpr Check picture_svg_writer[] = {
    {"paths_run_along_circles", paths_run_along_circles},
    {"whole_balls_are_circles", whole_balls_are_circles},
    {"loops_are_closed", loops_are_closed},
    {"flat_ellipses_are_where_they_belong", flat_ellipses_are_where_they_belong},
    {"parts_of_svg_files", parts_of_svg_files},
    {"svg_paints_the_farthest_first", svg_paints_the_farthest_first},
    {"svg_gradients", svg_gradients},
    {"svg_light_lies_over_colour", svg_light_lies_over_colour},
    {"svg_lit_paths_run_along_circles", svg_lit_paths_run_along_circles},
    {"svg_names_balls", svg_names_balls},
    {"names_differ_between_pictures", names_differ_between_pictures},
    {"no_svg_radius_is_0", no_svg_radius_is_0}};

}  // namespace cases
