#include "view_handle.hpp"

#include <algorithm>

namespace bench {
namespace {

int32_t count_bytes(void *context, const char *bytes, std::size_t count) {
  static_cast<void>(bytes);
  *static_cast<std::uint64_t *>(context) += count;
  return 0;
}

}  // namespace

View::View(const Model &model, const Boundary *boundary, std::uint32_t pieces, const std::vector<Direction> &directions)
    : model_(&model), boundary_(boundary) {
  require_ok(hsp_view_options_init(&options_, sizeof options_), "hsp_view_options_init");
  options_.pieces = pieces;
  require_ok(hsp_picture_options_init(&picture_, sizeof picture_), "hsp_picture_options_init");
  picture_.format = HSP_FORMAT_SVG;
  picture_.style = HSP_STYLE_FLAT;
  for (std::uint32_t ball = 0; ball < model.size(); ++ball) {
    colour_.push_back(hsp_palette_colour(HSP_PALETTE_SOFT, 6 + ball % 3, 0));
  }
  hsp_view_limits limits{};
  limits.struct_size = sizeof limits;
  limits.balls = model.size();
  limits.neighbours = std::min<std::uint32_t>(model.size(), 64);
  limits.arcs = model.size() + 64;
  take(limits);
  for (const Direction &towards : directions) {
    int32_t status = try_compute(towards);
    // Three enlargements at most lead to success (hsp_view_get_needed).
    for (int enlargements = 0; status == HSP_E_CAPACITY && enlargements < 3; ++enlargements) {
      hsp_view_limits needed{};
      require_ok(hsp_view_get_needed(view_, &needed), "hsp_view_get_needed");
      limits.neighbours = std::max(limits.neighbours, needed.neighbours);
      limits.arcs = std::max(limits.arcs, needed.arcs + needed.arcs / 8);
      take(limits);
      status = try_compute(towards);
    }
    require_ok(status, "hsp_view_compute");
  }
}

void View::take(const hsp_view_limits &limits) {
  std::size_t bytes = 0;
  require_ok(hsp_view_bytes(&limits, &bytes), "hsp_view_bytes");
  std::vector<std::byte>().swap(memory_);
  memory_.resize(bytes);
  require_ok(hsp_view_init(memory_.data(), memory_.size(), &limits, &view_), "hsp_view_init");
}

int32_t View::try_compute(const Direction &towards) {
  std::copy(towards.begin(), towards.end(), options_.towards);
  return hsp_view_compute(view_, model_->get(), boundary_ != nullptr ? boundary_->get() : nullptr, &options_);
}

void View::compute(const Direction &towards) {
  require_ok(try_compute(towards), "hsp_view_compute");
}

std::uint64_t View::write_picture() {
  std::uint64_t counted = 0;
  std::uint64_t written = 0;
  require_ok(hsp_picture_write(view_, colour_.data(), &picture_, nullptr, nullptr, count_bytes, &counted, &written),
             "hsp_picture_write");
  if (counted != written) require_ok(HSP_E_SINK, "bytes of the picture");
  return written;
}

hsp_view_info View::info() const {
  hsp_view_info info{};
  require_ok(hsp_view_get_info(view_, &info), "hsp_view_get_info");
  return info;
}

}  // namespace bench
