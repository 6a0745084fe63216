#include "view_handle.hpp"

#include <algorithm>

namespace bench {
namespace {

int32_t count_bytes(void *context, const char *bytes, size_t count) {
  static_cast<void>(bytes);
  *static_cast<uint64_t *>(context) += count;
  return 0;
}

// The first limits, which suffice for most directions, without arcs and edges; if they are too small they are raised.
template <class Limits>
Limits small_limits(uint32_t balls) {
  Limits limits{};
  limits.struct_size = sizeof limits;
  limits.balls = balls;
  limits.neighbours = std::min<uint32_t>(balls, 64);
  return limits;
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
  hsp_view_limits limits = small_limits<hsp_view_limits>(model.size());
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
  return read(hsp_view_get_info, view_.get(), "hsp_view_get_info");
}

VisibleMap::VisibleMap(const Model &model, const std::vector<Direction> &directions) : model_(&model) {
  expect_ok(hsp_view_options_init(&options_, sizeof options_), "hsp_view_options_init");
  hsp_map_limits limits = small_limits<hsp_map_limits>(model.size());
  limits.edges = model.size() + 64;
  map_.take(limits);
  for (const Direction &towards : directions) compute(towards);
}

void VisibleMap::compute(const Direction &towards) {
  std::copy(towards.begin(), towards.end(), options_.towards);
  map_.compute(
      [&](hsp_map *map, hsp_map_limits *limits) { return hsp_map_compute(map, model_->get(), &options_, limits); });
}

hsp_map_info VisibleMap::info() const {
  return read(hsp_map_get_info, map_.get(), "hsp_map_get_info");
}

namespace {

Balls smaller_balls(Balls balls) {
  for (double &radius : balls.radius) radius *= 0.25;
  return balls;
}

}  // namespace

Sticks::Sticks(const Balls &balls) : model_(smaller_balls(balls), 0) {
  for (uint32_t i = 0; i < balls.size(); ++i) {
    for (uint32_t j = 0; j < i; ++j) {
      double squared = 0;
      for (size_t axis = 0; axis < 3; ++axis) {
        const double d = balls.xyz[3 * size_t{i} + axis] - balls.xyz[3 * size_t{j} + axis];
        squared += d * d;
      }
      const double reach = 0.6 * (balls.radius[i] + balls.radius[j]);
      if (squared < reach * reach) sticks_.push_back({{i, j}, 0, 0});
    }
  }
  hsp_sticks_limits limits{};
  expect_ok(hsp_sticks_limits_init(&limits, sizeof limits, balls.size()), "hsp_sticks_limits_init");
  handle_.take(limits);
}

void Sticks::compute(const Direction &towards, bool as_map) {
  hsp_view_options options{};
  expect_ok(hsp_view_options_init(&options, sizeof options), "hsp_view_options_init");
  std::copy(towards.begin(), towards.end(), options.towards);
  handle_.compute([&](hsp_sticks *sticks, hsp_sticks_limits *limits) {
    return (as_map ? hsp_sticks_compute_map : hsp_sticks_compute)(
        sticks, model_.get(), &options, sticks_.data(), static_cast<uint32_t>(sticks_.size()), 0.12, nullptr, limits);
  });
}

uint64_t Sticks::write_picture(const Sticks *ink) {
  hsp_picture_options options{};
  expect_ok(hsp_picture_options_init(&options, sizeof options), "hsp_picture_options_init");
  if (ink != nullptr) options.ink_of_sticks = ink->handle_.get();
  uint64_t counted = 0;
  expect_ok(
      hsp_picture_write_sticks(handle_.get(), nullptr, &options, nullptr, nullptr, count_bytes, &counted, nullptr),
      "hsp_picture_write_sticks");
  return counted;
}

}  // namespace bench
