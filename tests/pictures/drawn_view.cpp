#include "drawn_view.hpp"

#include <stdexcept>

namespace {

uint32_t atomic_number(int64_t radius) {
  switch (radius) {
    case 1700:
      return 6;
    case 1550:
      return 7;
    case 1520:
      return 8;
    case 1800:
      return 16;
    default:
      return 1;
  }
}

}  // namespace

int32_t append_bytes(void *context, const char *bytes, size_t count) {
  static_cast<std::string *>(context)->append(bytes, count);
  return 0;
}

std::vector<uint32_t> colours_of(const oracle::Balls &balls) {
  std::vector<uint32_t> colours;
  for (const oracle::LatticeBall &ball : balls) {
    colours.push_back(hsp_palette_colour(HSP_PALETTE_SOFT, atomic_number(ball.radius), 0));
  }
  return colours;
}

DrawnView::DrawnView(const oracle::Balls &balls, Direction towards, uint32_t pieces)
    : scene_(balls, drawn_step),
      view_(scene_, ViewChoice{pieces, 0, pieces == HSP_PIECES_OUTSIDE_ALL, towards, {}}),
      records_(view_.records()),
      colours_(colours_of(balls)) {}

std::string DrawnView::picture(const hsp_picture_options &options, const char *title, const char *description) const {
  std::string text;
  uint64_t bytes = 0;
  expect_ok(
      hsp_picture_write(view_.handle(), colours_.data(), &options, title, description, append_bytes, &text, &bytes),
      "hsp_picture_write");
  if (bytes != text.size()) throw std::runtime_error("hsp_picture_write: another number of bytes");
  return text;
}

hsp_picture_options picture_options(uint32_t format, uint32_t style) {
  hsp_picture_options options;
  expect_ok(hsp_picture_options_init(&options, sizeof options), "hsp_picture_options_init");
  options.format = format;
  options.style = style;
  return options;
}
