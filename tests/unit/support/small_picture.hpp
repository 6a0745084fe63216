// Pictures of the balls of small_view(), in memory of fixed size.
#pragma once

#include "kept_text.hpp"
#include "picture/picture.hpp"
#include "picture/writers.hpp"
#include "small_view.hpp"

namespace cases {

// The inputs of a picture of small_view().
inline hsp::PictureInput picture_input(const uint32_t *colour = nullptr, const char *title = nullptr,
                                       const char *description = nullptr) {
  return {small_view().balls(), hsp::paths_of(small_view().view()), colour, title, description};
}

using PictureText = KeptText<64 * 1024>;

// The text of a picture of small_view() by one of the writers; empty if there is no room for it.
template <class Writer>
const PictureText &written(Writer write, const hsp::PictureInput &input, const hsp::PictureOptions &options) {
  static PictureText kept;
  kept.clear();
  const hsp::Page page = hsp::lay_out(input, options);
  const hsp::Paint paint(input, options, page, small_view().scratch());
  hsp::ByteSink sink(PictureText::keep, &kept);
  write(sink, input, options, page, paint);
  sink.flush();
  if (sink.refused()) kept.clear();
  return kept;
}

// A page on which a step is two px if all that is seen is `width` steps wide.
inline hsp::PictureOptions two_px_per_step(double width) {
  hsp::PictureOptions options;
  options.width = 2 * width;
  options.margin = 0;
  options.outline = 0;  // the width of lines would make the page larger
  options.fog = 0;
  return options;
}

// The request for a picture of one ball.
struct FileOptions {
  double width;
  bool millimetres, ids, backdrop;
  double outline;
  const char *title, *description;
};
// For formats that measure in points: a page that is no whole number of points, an inch, and texts with characters to
// be escaped.
constexpr FileOptions broken_points{300.4, false, true, true, 1.5, nullptr, nullptr};
constexpr FileOptions an_inch{25.4, true, false, true, 25.4, "", ""};
constexpr FileOptions escaped_texts{40, false, false, false, 0, "a(b)\\c\xC3\xA9", "1 (2)\n3"};

// The texts that stand in such a file exactly once, and those that stand nowhere in it.
struct FileParts {
  FileOptions options;
  const char *present[4];
  const char *absent[3];
};

// The picture of a ball of radius 10 and colour 0x00FF7F, with lines 0x010203, before 0xFEDCBA.
template <class Writer>
const PictureText &text_of_one_ball(Writer write, const FileOptions &asked) {
  static constexpr SmallBall ball{0, 0, 0, 10};
  static constexpr uint32_t colour[] = {0x00FF7F};
  hsp::PictureOptions options;
  options.width = asked.width;
  options.millimetres = asked.millimetres;
  options.ids = asked.ids;
  options.backdrop = asked.backdrop;
  options.background = 0xFEDCBA;
  options.outline = asked.outline;
  options.outline_colour = 0x010203;
  small_view().succeeds(&ball, 1);
  return written(write, picture_input(colour, asked.title, asked.description), options);
}

inline bool has_parts(const PictureText &text, const FileParts &parts) {
  for (const char *part : parts.present) {
    if (part != nullptr && text.count(part) != 1) return false;
  }
  for (const char *part : parts.absent) {
    if (part != nullptr && text.count(part) != 0) return false;
  }
  return text.size > 0;
}

inline bool ends_with(const PictureText &text, const char *end) {
  const size_t length = std::strlen(end);
  return text.size >= length && std::strcmp(text.text + text.size - length, end) == 0;
}

// Balls behind each other, seen along the z axis, and the order in which they are painted.
constexpr SmallBall staggered[] = {{0, 0, 40, 10}, {15, 5, 80, 10}, {30, 0, 0, 10}, {45, 0, 80, 10}};
constexpr uint32_t farthest_first[] = {2, 0, 1, 3};

// A small ball beside a large one: rounded to digits its radius is 0.
constexpr SmallBall small_beside_large[] = {{0, 0, 0, 1000000}, {3000000, 0, 0, 1}};

}  // namespace cases
