// Pictures of the balls of small_view(), in memory of fixed size.
#pragma once

#include "kept_text.hpp"
#include "picture/picture.hpp"
#include "picture/writers.hpp"
#include "small_view.hpp"

namespace cases {

// What a picture of small_view() is made of.
inline hsp::PictureInput picture_input(const uint32_t *colour = nullptr, const char *title = nullptr,
                                       const char *description = nullptr) {
  return {small_view().balls(), small_view().view(), colour, title, description};
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

}  // namespace cases
