// PDF files read back: offsets that lead to their objects, boxes and texts, curves along circles, the order of paint.
#pragma once

#include "small_picture.hpp"

namespace cases {

// px are 3/4 of a point. The unit of the contents is a hundredth of a px, on small pages a thousandth.
constexpr FileParts pdf_parts[] = {
    {broken_points,
     {"/MediaBox[0 0 225.3 225.3]", ".996 .863 .729 rg 0 0 30041 30041 re f\n", ".004 .008 .012 RG\n",
      "\n.0075 0 0 .0075 0 0 cm 1 j 150 w\n"},
     {"/Title", "/Subject", "/Shading"}},
    {an_inch,
     {"/Font<</F1<</Type/Font/Subtype/Type1/BaseFont/Helvetica/Encoding/WinAnsiEncoding>>>>",
      "rg 0 0 96001 96001 re f\n", "\n.00075 0 0 .00075 0 0 cm 1 j 96000 w\n", "h\nB\n"},
     {"/Title", "/Subject", "h\nf\n"}},
    {escaped_texts,
     {"/Title<FEFF0061002800620029005C006300E9>", "/Subject<FEFF00310020002800320029000A0033>", "0 1 .498 rg\n",
      "h\nf\n"},
     {" re f", "RG", "h\nB\n"}}};

// The number of the object at `offset`, or 0; goes behind its first line.
inline uint32_t object_at(const PictureText &text, double offset, TextReader &reader) {
  if (offset >= static_cast<double>(text.size)) return 0;
  reader = TextReader(text.text + static_cast<size_t>(offset));
  double number;
  return reader.number(number) && reader.take(" 0 obj\n") ? static_cast<uint32_t>(number) : 0;
}

// Every entry of the table of offsets, of 20 bytes, leads to its object; the stream is as long as it says.
inline bool offsets_lead_to_objects(const PictureText &text) {
  TextReader reader(text.text), object(text.text);
  double start, offset, length, size;
  if (!reader.take("%PDF-1.4\n") || !reader.find("\nstartxref\n") || !reader.number(start)) return false;
  if (!reader.take("\n%%EOF\n") || *reader.rest() != '\0' || start >= static_cast<double>(text.size)) return false;
  TextReader table(text.text + static_cast<size_t>(start));
  if (!table.take("xref\n0 ") || !table.number(size) || size != text.count(" 0 obj\n") + 1) return false;
  if (!table.take("\n0000000000 65535 f \n")) return false;
  for (uint32_t k = 1; k < size; ++k) {
    const char *entry = table.rest();
    if (!table.number(offset) || !table.take(" 00000 n \n") || table.rest() - entry != 20) return false;
    if (object_at(text, offset, object) != k) return false;
    if (object.take("<</Length ")) {
      TextReader stream = object;
      if (!stream.find(">>\nstream\n")) return false;
      const char *first = stream.rest();
      if (!stream.find("endstream\nendobj\n")) return false;
      const size_t between = static_cast<size_t>(stream.rest() - first) - std::strlen("endstream\nendobj\n");
      // Its length is an object of its own, which the stream refers to.
      double number;
      if (!object.number(number) || !object.take(" 0 R>>")) return false;
      char heading[] = "\n0 0 obj\n";
      heading[1] = static_cast<char>('0' + static_cast<int>(number));
      TextReader lengths(text.text);
      if (!lengths.find(heading) || !lengths.number(length) || length != static_cast<double>(between)) return false;
    }
  }
  double root, info;
  if (!table.take("trailer\n<</Size ") || !table.number(offset) || offset != size) return false;
  return table.take("/Root ") && table.number(root) && table.take(" 0 R/Info ") && table.number(info) && root != info;
}

inline uint32_t parts_of_pdf_files() {
  return first_failing(pdf_parts, [](const FileParts &c) {
    const PictureText &text = text_of_one_ball(hsp::write_pdf, c.options);
    return has_parts(text, c) && offsets_lead_to_objects(text);
  });
}

// A ball on pages of several sizes: integers, from its centre on, of cubics that stay within two units of the circle.
inline uint32_t curves_along_circles() {
  constexpr double widths[] = {.05, 1, 40, 300, 12345, 1e6};
  return first_failing(widths, [](double width) {
    const PictureText &text = text_of_one_ball(hsp::write_pdf, {width, false, true, false, 0, nullptr, nullptr});
    TextReader reader(text.text);
    double unit, matrix[6], first[2], from[2], c[6], total = 0;
    if (!reader.find("endobj\n5 0 obj") || !reader.find("stream\nq\n") || !reader.number(unit)) return false;
    unit /= 0.75;
    if (!(unit <= width / 1e4 * (1 + 1e-9)) || unit > 0.0100001) return false;
    const double r = width / 2 / 1.06 / unit;  // the margin is .03 of the width
    if (!reader.find("q") || !reader.numbers(matrix) || !reader.take(" cm\n")) return false;
    if (matrix[0] != 1 || matrix[1] != 0 || matrix[2] != 0 || matrix[3] != 1) return false;
    if (!near(matrix[4], width / 2 / unit, 0.51) || matrix[5] != matrix[4]) return false;
    if (!reader.find("rg\n") || !reader.numbers(first) || !reader.take(" m\n")) return false;
    from[0] = first[0];
    from[1] = first[1];
    while (!reader.take("h\n")) {
      if (!reader.numbers(c) || !reader.take(" c\n")) return false;
      const double to[2] = {c[4], c[5]};
      for (const double number : c) {
        if (number != static_cast<double>(static_cast<int64_t>(number))) return false;
      }
      for (int k = 0; k <= 8; ++k) {
        const double t = k / 8.0, u = 1 - t;
        const auto at = [&](int axis) {
          return u * u * u * from[axis] + 3 * u * u * t * c[axis] + 3 * u * t * t * c[axis + 2] + t * t * t * to[axis];
        };
        if (!near(std::sqrt(at(0) * at(0) + at(1) * at(1)), r, 2)) return false;
      }
      total += std::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
      from[0] = to[0];
      from[1] = to[1];
    }
    // Counter-clockwise, once around.
    return near(total, 2 * hsp::pi, 1e-3) && from[0] == first[0] && from[1] == first[1];
  });
}

// Where balls are alike, so are parts of them, wherever they are: what is between 0 and 90 degrees.
inline uint32_t pdf_repeats_itself() {
  hsp::PictureOptions options = two_px_per_step(65);
  options.width = 130.37;
  if (!small_view().succeeds(staggered, 4)) return 0;
  const PictureText &text = written(hsp::write_pdf, picture_input(), options);
  TextReader reader(text.text);
  char line[64];
  for (uint32_t lines = 0; lines < 3; ++lines) {
    if (!reader.find(lines == 0 ? " m\n" : "c\n")) return 1;
  }
  const char *const end = std::strchr(reader.rest(), '\n');
  const size_t length = static_cast<size_t>(end - reader.rest());
  if (length + 1 > sizeof line) return 2;
  std::memcpy(line, reader.rest(), length);
  line[length] = '\0';
  return text.count(line) == 4 ? all_hold : 3;
}

// Integers that not every reader knows are written as reals: of a ball of 4e6 px on a page of .05 px.
inline uint32_t pdf_has_no_large_integers() {
  static constexpr SmallBall ball{0, 0, 0, 10};
  hsp::PictureOptions options;
  options.width = 0.05;
  options.scale = 4e5;
  if (!small_view().succeeds(&ball, 1)) return 0;
  const PictureText &text = written(hsp::write_pdf, picture_input(), options);
  return text.count("\n-4000000000000. 0 m\n") == 1 && text.count("4000000000000 ") == 0 ? all_hold : 1;
}

inline uint32_t pdf_paints_the_farthest_first() {
  constexpr uint32_t colour[] = {0x000000, 0xFF0000, 0x00FF00, 0x0000FF};
  constexpr double channels[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (!small_view().succeeds(staggered, 4)) return 0;
  hsp::PictureOptions options;
  options.fog = 0;
  options.backdrop = false;
  TextReader reader(written(hsp::write_pdf, picture_input(colour), options).text);
  if (!reader.find("RG\n")) return 1;
  for (const uint32_t ball : farthest_first) {
    double rgb[3];
    if (!reader.find(" cm\n") || !reader.numbers(rgb) || !reader.take(" rg\n") || !reader.find("h\nB\n"))
      return 2 + ball;
    for (int k = 0; k < 3; ++k) {
      if (rgb[k] != channels[ball][k]) return 2 + ball;
    }
  }
  return reader.take("Q\nQ\nendstream") ? all_hold : 6;
}

// A shading for each colour, and for each ball its path, the shading on its disc, and its line.
inline uint32_t pdf_shades() {
  constexpr hsp::PictureStyle shaded[] = {hsp::PictureStyle::headlight, hsp::PictureStyle::soft};
  return first_failing(shaded, [](hsp::PictureStyle style) {
    constexpr uint32_t colour[] = {7, 8, 9, 8};
    const uint32_t intervals = style == hsp::PictureStyle::soft ? 12 : 16;
    if (!small_view().succeeds(staggered, 4)) return false;
    hsp::PictureOptions options = two_px_per_step(65);
    options.format = hsp::PictureFormat::pdf;
    options.style = style;
    options.outline = 1e-4;  // lines that want next to no room
    const PictureText &text = written(hsp::write_pdf, picture_input(colour), options);
    if (!offsets_lead_to_objects(text)) return false;
    if (text.count("<</ShadingType 3") != 3 || text.count("<</FunctionType 2") != 3 * intervals) return false;
    TextReader reader(text.text);
    // Where an interval ends the next one starts.
    double end[3], start[3];
    for (uint32_t k = 0; k < 3 * intervals; ++k) {
      if (!reader.find("/C0[") || !reader.numbers(start)) return false;
      if (k % intervals != 0 && (start[0] != end[0] || start[1] != end[1] || start[2] != end[2])) return false;
      if (!reader.find("/C1[") || !reader.numbers(end)) return false;
    }
    for (const uint32_t ball : farthest_first) {
      double place[2], matrix[6], shade;
      if (!reader.find("q 1 0 0 1") || !reader.numbers(place) || !reader.take(" cm\n")) return false;
      if (!near(place[0], 200 * (staggered[ball].x + 10), 1)) return false;
      if (!near(place[1], 200 * (staggered[ball].y + 10), 1)) return false;
      if (!reader.find("q\n") || !reader.find("h\nW n") || !reader.numbers(matrix) || !reader.take(" cm /S"))
        return false;
      if (!reader.number(shade) || shade != colour[ball] - 7 || !reader.take(" sh Q\n")) return false;
      if (matrix[0] != 2000 || matrix[1] != 0 || matrix[2] != 0 || matrix[3] != 2000) return false;
      if (matrix[4] != 0 || matrix[5] != 0) return false;
      if (!reader.find("h\nS\n")) return false;
    }
    // And one around all of it.
    return text.count("\nq\n") == 5 && text.count(" Q\n") == 4 && text.count("\nQ\n") == 5;
  });
}

// A scale of 0 would be an error.
inline uint32_t no_pdf_radius_is_0() {
  hsp::PictureOptions options;
  options.format = hsp::PictureFormat::pdf;
  options.style = hsp::PictureStyle::soft;
  options.width = 1;
  if (!small_view().succeeds(small_beside_large, 2)) return 0;
  const PictureText &text = written(hsp::write_pdf, picture_input(), options);
  return text.count("n 1 0 0 1 ") == 1 && text.count("n 0 0 0 0 ") == 0 ? all_hold : 1;
}

inline constexpr Check picture_pdf_writer[] = {{"parts_of_pdf_files", parts_of_pdf_files},
                                               {"curves_along_circles", curves_along_circles},
                                               {"pdf_repeats_itself", pdf_repeats_itself},
                                               {"pdf_has_no_large_integers", pdf_has_no_large_integers},
                                               {"pdf_paints_the_farthest_first", pdf_paints_the_farthest_first},
                                               {"pdf_shades", pdf_shades},
                                               {"no_pdf_radius_is_0", no_pdf_radius_is_0}};

}  // namespace cases
