// EPS files read back: boxes and texts, arcs that join as they are written, the order of paint, and shades.
#pragma once

#include "small_picture.hpp"
#include "small_scenes.hpp"

namespace cases {

// px are 3/4 of a point; the box is rounded up to points.
constexpr FileParts eps_parts[] = {
    {broken_points,
     {"%%BoundingBox: 0 0 226 226\n%%HiResBoundingBox: 0 0 225.3 225.3\n", "16#fedcba C 0 0 300.4 300.4 rectfill\n",
      "16#010203 C\n", " 1.5 setlinewidth\n"},
     {"%%Title", "rawshade", "\n% "}},
    {an_inch,
     {"%%BoundingBox: 0 0 72 72\n%%HiResBoundingBox: 0 0 72 72\n", " C 0 0 96 96 rectfill\n", " 96 setlinewidth\n",
      "16#00ff7f F\n"},
     {"%%Title", "shfill", "\n% "}},
    {escaped_texts,
     {"%%Title: (a\\(b\\)\\\\c?)\n", "\n% 1 (2)?3\n", "/I{newpath}bind def\n", "%%HiResBoundingBox: 0 0 30 30\n"},
     {"rectfill", "16#010203", "{stroke}"}}};

inline uint32_t parts_of_eps_files() {
  return first_failing(eps_parts, [](const FileParts &c) {
    const PictureText &text = text_of_one_ball(hsp::write_eps, c.options);
    return has_parts(text, c) && TextReader(text.text).take("%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: ") &&
           text.count("%%EndComments\n") == 1 && text.count("\nshowpage\n") == 1 && ends_with(text, "\n%%EOF\n");
  });
}

// Titles and descriptions of any length are whole, on lines of at most 255 characters.
inline uint32_t long_texts() {
  constexpr uint32_t lengths[] = {1, 119, 120, 121, 240, 241, 399};
  return first_failing(lengths, [](uint32_t length) {
    char title[400] = {};
    for (uint32_t k = 0; k < length; ++k) title[k] = "()\\"[k % 3];
    const PictureText &text = text_of_one_ball(hsp::write_eps, {40, false, true, true, 1, title, title});
    TextReader reader(text.text);
    uint32_t read = 0;
    if (!reader.find("%%Title: (")) return false;
    const char *next = reader.rest();
    while (read < length) {
      if (*next == ')') {
        TextReader continued(next);
        if (!continued.take(")\n%%+ (")) return false;
        next = continued.rest();
      }
      if (*next == '\\') ++next;
      if (*next++ != title[read++]) return false;
    }
    if (!TextReader(next).take(")\n%%Creator")) return false;
    TextReader comment(text.text);
    if (!comment.find("%%EndComments\n% ")) return false;
    next = comment.rest();
    for (read = 0; read < length; ++read) {
      if (*next == '\n') next += 3;
      if (*next++ != title[read]) return false;
    }
    size_t column = 0;
    for (const char *at = text.text; *at != '\0'; ++at) {
      column = *at == '\n' ? 0 : column + 1;
      if (column > 255) return false;
    }
    return *next == '\n';
  });
}

// An arc as it is written, in px, y up.
struct WrittenArc {
  double centre[2] = {}, major[2] = {}, minor[2] = {}, from = 0, to = 0;  // degrees
  bool read(TextReader &reader) {
    double numbers[5];
    TextReader trial = reader;
    if (trial.numbers(numbers) && (trial.take(" A\n") || trial.take(" B\n"))) {
      if ((trial.rest()[-2] == 'A') != (numbers[4] > numbers[3])) return false;
      centre[0] = numbers[0];
      centre[1] = numbers[1];
      major[0] = minor[1] = numbers[2];
      from = numbers[3];
      to = numbers[4];
      reader = trial;
      return true;
    }
    if (!reader.number(from) || !reader.number(to) || !reader.take("[") || !reader.numbers(major)) return false;
    if (!reader.numbers(minor) || !reader.numbers(centre)) return false;
    return reader.take(from < to ? " ]E\n" : " ]D\n");
  }
  double at(double degrees, int axis) const {
    const double t = degrees * hsp::pi / 180;
    return centre[axis] + std::cos(t) * major[axis] + std::sin(t) * minor[axis];
  }
};

// The end of each arc, as written, is within 1e-6 px of the start of the next; and lies where the view says.
inline uint32_t arcs_join() {
  return first_failing(scenes, [](const Scene &c) {
    if (!small_view().succeeds(c.ball, c.n, seen_from(3, 1, 2))) return false;
    const hsp::PictureInput input = picture_input();
    const hsp::PictureOptions options;
    TextReader reader(written(hsp::write_eps, input, options).text);
    if (!reader.find("rectfill\n")) return false;
    const hsp::Page page = hsp::lay_out(input, options);
    const auto close = [](const double(&a)[2], double x, double y) {
      return near(a[0], x, 1e-6) && near(a[1], y, 1e-6);
    };
    bool holds = true;
    for (uint32_t p = 0; p < input.paths.size(); ++p) {
      double at[2] = {}, start[2] = {};
      input.paths.visit(input.balls, p, hsp::PathPart::outline,
                        [&](const hsp::ProjectedArc &seen, bool first, bool last) {
                          if (first) {
                            while (reader.take("16#")) reader.find("\n");  // colours
                            holds = holds && reader.numbers(start) && reader.take(" M\n");
                            at[0] = start[0];
                            at[1] = start[1];
                          }
                          WrittenArc arc;
                          holds = holds && arc.read(reader) && close(at, arc.at(arc.from, 0), arc.at(arc.from, 1));
                          at[0] = arc.at(arc.to, 0);
                          at[1] = arc.at(arc.to, 1);
                          const hsp::PagePoint end = page.to_page(seen.end);
                          holds = holds && close(at, end.x, end.y) &&
                                  near((arc.to - arc.from) * hsp::pi / 180, seen.to - seen.from, 1e-6);
                          if (last) holds = holds && close(at, start[0], start[1]) && reader.take("Z\n");
                        });
    }
    return holds;
  });
}

inline uint32_t eps_paints_the_farthest_first() {
  constexpr uint32_t colour[] = {0, 1, 2, 3};
  if (!small_view().succeeds(staggered, 4)) return 0;
  hsp::PictureOptions options;
  options.fog = 0;
  TextReader reader(written(hsp::write_eps, picture_input(colour), options).text);
  for (uint32_t p = 0; p < 4; ++p) {
    double ball;
    if (!reader.find("Z\n16#00000") || !reader.number(ball) || ball != farthest_first[p]) return p;
  }
  return all_hold;
}

// The table of shades, one colour for each stop, and the shade, centre and radius of each ball.
inline uint32_t eps_shades() {
  constexpr hsp::PictureStyle shaded[] = {hsp::PictureStyle::headlight, hsp::PictureStyle::soft};
  return first_failing(shaded, [](hsp::PictureStyle style) {
    constexpr uint32_t colour[] = {7, 8, 9, 8};
    const bool soft = style == hsp::PictureStyle::soft;
    if (!small_view().succeeds(staggered, 4)) return false;
    hsp::PictureOptions options = two_px_per_step(65);
    options.format = hsp::PictureFormat::eps;
    options.style = style;
    TextReader reader(written(hsp::write_eps, picture_input(colour), options).text);
    double intervals, focus[2], count, number, first_stop[3], at[4];
    if (!reader.find("/n ") || !reader.number(intervals) || intervals != (soft ? 12 : 16)) return false;
    // Soft light comes from the left and from above.
    if (!reader.find("/f{") || !reader.numbers(focus) || (soft ? focus[0] >= 0 || focus[1] <= 0 : focus[0] != 0))
      return false;
    if (!reader.find("/T ") || !reader.number(count) || count != 3 || !reader.take(" array def\n")) return false;
    for (uint32_t s = 0; s < 3; ++s) {
      if (!reader.number(number) || number != s || !reader.take("<")) return false;
      const size_t digits = std::strspn(reader.rest(), "0123456789abcdef");
      if (digits != 6 * (static_cast<size_t>(intervals) + 1)) return false;
      const char six[] = {reader.rest()[0],
                          reader.rest()[1],
                          reader.rest()[2],
                          reader.rest()[3],
                          reader.rest()[4],
                          reader.rest()[5],
                          '\0'};
      // Seen from the front a ball in headlight has its own colour.
      if (!soft && (!TextReader(six).number(first_stop[s]) || first_stop[s] != 7 + s)) return false;
      if (!reader.find(">S\n")) return false;
    }
    for (const uint32_t ball : farthest_first) {
      if (!reader.find("Z\n") || !reader.numbers(at) || !reader.take(" G\n") || at[2] != 20) return false;
      if (at[0] != 2 * (staggered[ball].x + 10) || at[1] != 2 * (staggered[ball].y + 10)) return false;
      if (at[3] != colour[ball] - 7) return false;
    }
    return true;
  });
}

// A scale of 0 would be an error.
inline uint32_t no_eps_radius_is_0() {
  hsp::PictureOptions options;
  options.format = hsp::PictureFormat::eps;
  options.style = hsp::PictureStyle::soft;
  options.width = .1;
  if (!small_view().succeeds(small_beside_large, 2)) return 0;
  const PictureText &text = written(hsp::write_eps, picture_input(), options);
  return text.count(" .0000001 0 G\n") == 1 && text.count(" 0 0 G\n") == 0 ? all_hold : 1;
}

inline constexpr Check picture_eps_writer[] = {{"parts_of_eps_files", parts_of_eps_files},
                                               {"long_texts", long_texts},
                                               {"arcs_join", arcs_join},
                                               {"eps_paints_the_farthest_first", eps_paints_the_farthest_first},
                                               {"eps_shades", eps_shades},
                                               {"no_eps_radius_is_0", no_eps_radius_is_0}};

}  // namespace cases
