// The entrance to the writers: which of them writes, and sinks that refuse after any number of bytes.
#pragma once

#include "small_picture.hpp"

namespace cases {

constexpr SmallBall two_balls[] = {{0, 0, 0, 10}, {12, 3, 5, 8}};

using Writer = void (*)(hsp::ByteSink &, const hsp::PictureInput &, const hsp::PictureOptions &, const hsp::Page &,
                        const hsp::Paint &);
struct Format {
  hsp::PictureFormat format;
  Writer writer;
  const char *beginning;
};
constexpr Format formats[] = {{hsp::PictureFormat::svg, hsp::write_svg, "<svg xmlns=\"http://www.w3.org/2000/svg\""},
                              {hsp::PictureFormat::eps, hsp::write_eps, "%!PS-Adobe-3.0 EPSF-3.0\n"},
                              {hsp::PictureFormat::pdf, hsp::write_pdf, "%PDF-1.4\n"},
                              {static_cast<hsp::PictureFormat>(3), hsp::write_svg, "<svg "}};
constexpr hsp::PictureStyle styles[] = {hsp::PictureStyle::flat, hsp::PictureStyle::headlight, hsp::PictureStyle::soft};

inline hsp::Status write_to(PictureText &kept, const hsp::PictureOptions &options, uint64_t &bytes) {
  return hsp::write_picture(picture_input(nullptr, "two"), options, small_view().scratch(), PictureText::keep, &kept,
                            bytes);
}

inline uint32_t formats_have_their_writers() {
  return first_failing(formats, [](const Format &c) {
    if (!small_view().succeeds(two_balls, 2)) return false;
    for (const hsp::PictureStyle style : styles) {
      hsp::PictureOptions options;
      options.format = c.format;
      options.style = style;
      static PictureText kept;
      kept.clear();
      uint64_t bytes = 0;
      if (write_to(kept, options, bytes) != hsp::Status::ok || bytes != kept.size) return false;
      const PictureText &expected = written(c.writer, picture_input(nullptr, "two"), options);
      if (expected.size == 0 || !kept.is(expected.text) || !TextReader(kept.text).take(c.beginning)) return false;
    }
    return true;
  });
}

// The status tells it, and the number of bytes is that of those taken, which are the first ones.
inline uint32_t sinks_that_refuse() {
  return first_failing(formats, [](const Format &c) {
    if (!small_view().succeeds(two_balls, 2)) return false;
    hsp::PictureOptions options;
    options.format = c.format;
    options.style = hsp::PictureStyle::soft;  // several blocks of bytes
    options.fog = 0;
    static PictureText whole, kept;
    whole.clear();
    uint64_t bytes = 0;
    if (write_to(whole, options, bytes) != hsp::Status::ok || whole.calls < 2) return false;
    for (size_t room = 0; room <= whole.size; ++room) {
      kept.clear();
      kept.room = room;
      const bool fits = room == whole.size;
      if (write_to(kept, options, bytes) != (fits ? hsp::Status::ok : hsp::Status::sink)) return false;
      if (bytes != kept.size || bytes > room || std::memcmp(kept.text, whole.text, kept.size) != 0) return false;
      if (fits && bytes != whole.size) return false;
    }
    return true;
  });
}

inline constexpr Check picture_picture[] = {{"formats_have_their_writers", formats_have_their_writers},
                                            {"sinks_that_refuse", sinks_that_refuse}};

}  // namespace cases
