#include "view_handle.hpp"

#include <algorithm>

namespace bench {
namespace {

int32_t count_bytes(void *context, const char *bytes, size_t count) {
  static_cast<void>(bytes);
  *static_cast<uint64_t *>(context) += count;
  return 0;
}

}  // namespace

View::View(const Model &model, const Boundary *boundary, uint32_t pieces, const std::vector<Direction> &directions)
    : model_(&model), boundary_(boundary) {
  expect_ok(hsp_view_options_init(&options_, sizeof options_), "hsp_view_options_init");
  options_.pieces = pieces;
  expect_ok(hsp_picture_options_init(&picture_, sizeof picture_), "hsp_picture_options_init");
  picture_.format = HSP_FORMAT_SVG;
  picture_.style = HSP_STYLE_FLAT;
  for (uint32_t ball = 0; ball < model.size(); ++ball) {
    colour_.push_back(hsp_palette_colour(HSP_PALETTE_SOFT, 6 + ball % 3, 0));
  }
  hsp_view_limits limits{};
  limits.struct_size = sizeof limits;
  limits.balls = model.size();
  limits.neighbours = std::min<uint32_t>(model.size(), 64);
  limits.arcs = model.size() + 64;
  view_.take(limits);
  for (const Direction &towards : directions) compute(towards);
}

void View::compute(const Direction &towards) {
  std::copy(towards.begin(), towards.end(), options_.towards);
  const hsp_boundary *boundary = boundary_ != nullptr ? boundary_->get() : nullptr;
  view_.compute([&](hsp_view *view, hsp_view_limits *limits) {
    return hsp_view_compute(view, model_->get(), boundary, &options_, limits);
  });
}

uint64_t View::write_picture() {
  uint64_t counted = 0;
  uint64_t written = 0;
  expect_ok(
      hsp_picture_write(view_.get(), colour_.data(), &picture_, nullptr, nullptr, count_bytes, &counted, &written),
      "hsp_picture_write");
  if (counted != written) expect_ok(HSP_E_SINK, "bytes of the picture");
  return written;
}

hsp_view_info View::info() const {
  hsp_view_info info{};
  expect_ok(hsp_view_get_info(view_.get(), &info), "hsp_view_get_info");
  return info;
}

}  // namespace bench
