// Pictures of a view or a map with any options: bytes counted and always the same, no effect of the order of the balls,
// and sinks that refuse.
#pragma once

#include <computed.h>
#include <hardsphere.h>
#include <picture_sink.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "fuzz_input.hpp"

namespace fuzz {

inline hsp_picture_options picture_options(Bytes &bytes) {
  hsp_picture_options options;
  FUZZ_REQUIRE(hsp_picture_options_init(&options, sizeof options) == HSP_OK, "hsp_picture_options_init");
  static constexpr double sizes[] = {1000, 0, 1, 37.5, 1e6, 1e-3, 5e-324};
  static constexpr double outlines[] = {-1, 0, 0.5, 3, 1e6, -1e300, 5e-324};
  options.format = bytes.below(3);
  options.style = bytes.below(3);
  options.unit = bytes.below(2);
  options.flags = bytes.below(4);
  options.width = sizes[bytes.below(7)];
  options.height = bytes.one_in(3) || options.width == 0 ? sizes[bytes.below(7)] : 0;
  if (options.width == 0 && options.height == 0) options.height = 200;
  options.outline = outlines[bytes.below(7)];
  options.margin = bytes.one_in(4) ? bytes.below(101) / 10.0 : 0.03;
  options.fog = bytes.below(5) / 4.0;
  options.outline_colour = bytes.below(256) << 16 | bytes.below(256);
  options.background = bytes.below(256) << 8;
  if (bytes.one_in(3)) {
    // Scales around the one at which the set fills the page, and far from it.
    static constexpr double scales[] = {1, 10, 100, 0.01, 1e4, 1e6, 1e-30, 5e-324, 1e300};
    options.scale = scales[bytes.below(9)];
    for (double &coordinate : options.centre) {
      coordinate = bytes.one_in(20) ? 1e9 : (bytes.below(41) - 20.0) * (bytes.one_in(5) ? 1000 : 1);
    }
  }
  if (bytes.one_in(2)) {
    static std::vector<unsigned char> memory(HSP_PICTURE_MEMORY);
    options.memory = memory.data();
    options.memory_bytes = memory.size();
  }
  return options;
}

// Colours from a ball's place and radius alone, so that equal balls have equal colours.
inline std::vector<uint32_t> colours_of(const computed &c) {
  std::vector<uint32_t> colour(c.n + 1);
  for (uint32_t i = 0; i < c.n; ++i) {
    const double place = c.xyz[3 * i] + 2 * c.xyz[3 * i + 1] + 3 * c.xyz[3 * i + 2] + 5 * c.radius[i];
    const auto number = static_cast<uint32_t>(std::fmod(std::fabs(place), 120.0));
    colour[i] = hsp_palette_colour(number % 4, number, number / 7);
    FUZZ_REQUIRE(colour[i] <= 0xFFFFFF, "hsp_palette_colour");
  }
  return colour;
}

class Picture {
 public:
  // write: a function of the interface with its handle bound.
  template <class Write>
  Picture(const computed &base, const Write &write, const hsp_picture_options &options, const std::string &title,
          size_t accepts) {
    const std::vector<uint32_t> colour = colours_of(base);
    uint64_t bytes = 12345;
    picture_sink_start(&sink_, accepts);
    status_ = write(colour.data(), &options, title.c_str(), title.c_str(), picture_sink_take, &sink_, &bytes);
    FUZZ_REQUIRE(status_ == HSP_OK || status_ == HSP_E_SINK || (status_ == HSP_E_RANGE && options.scale > 0),
                 hsp_status_text(status_));
    FUZZ_REQUIRE(bytes == sink_.count, "bytes is not the number of bytes taken");
    FUZZ_REQUIRE(sink_.odd == 0, "the sink was called with too much, nothing, or after it had refused");
    FUZZ_REQUIRE((status_ == HSP_E_SINK) == (sink_.refused == 1), "HSP_E_SINK exactly if the sink refuses");
  }
  ~Picture() { picture_sink_release(&sink_); }
  Picture(const Picture &) = delete;
  Picture &operator=(const Picture &) = delete;

  int32_t status() const { return status_; }
  std::string text() const { return {sink_.bytes, sink_.count}; }
  std::string text_without_ids() const {
    size_t length = 0;
    char *bare = picture_without_ids(sink_.bytes, sink_.count, &length);
    const std::string result(bare, length);
    std::free(bare);
    return result;
  }

 private:
  picture_sink sink_{};
  int32_t status_ = 0;
};

inline std::string some_title(Bytes &bytes) {
  std::string title;
  for (uint32_t more = bytes.one_in(3) ? bytes.below(12) : 0; more > 0; --more) {
    title.push_back(static_cast<char>(bytes.byte()));
  }
  return title;
}

// Pictures of the same balls in two orders must have the same bytes but for ids.
template <class Write, class WriteOther>
void require_pictures(const computed &base, const Write &write, const computed &other_base,
                      const WriteOther &write_other, Bytes &bytes) {
  const hsp_picture_options options = picture_options(bytes);
  const std::string title = some_title(bytes);
  const Picture one(base, write, options, title, SIZE_MAX), again(base, write, options, title, SIZE_MAX);
  FUZZ_REQUIRE(one.status() == again.status(), "a picture is refused now and then");
  if (one.status() == HSP_E_RANGE) {
    FUZZ_REQUIRE(one.text().empty(), "a part of a picture that is refused");
    return;
  }
  const std::string text = one.text();
  FUZZ_REQUIRE(one.status() == HSP_OK && !text.empty(), "a picture");
  FUZZ_REQUIRE(text == again.text(), "a picture differs the second time");
  if (options.format != HSP_FORMAT_PDF && title.empty()) {
    FUZZ_REQUIRE(text.find("nan") == std::string::npos && text.find("inf") == std::string::npos, "not a number");
    for (const char character : text) {
      FUZZ_REQUIRE(character == '\n' || (character >= ' ' && character <= '~'), "a character that is not ASCII");
    }
  }
  // hsp_picture_write and hsp_picture_write_map, property 1
  const Picture of_other(other_base, write_other, options, title, SIZE_MAX);
  FUZZ_REQUIRE(one.text_without_ids() == of_other.text_without_ids(), "a picture depends on the order of the balls");
  const size_t accepts = bytes.below(65536) % text.size();
  const Picture stopped(base, write, options, title, accepts);
  FUZZ_REQUIRE(stopped.status() == HSP_E_SINK, "a sink that refuses");
  FUZZ_REQUIRE(text.compare(0, stopped.text().size(), stopped.text()) == 0, "bytes before the sink refuses");
}

}  // namespace fuzz
