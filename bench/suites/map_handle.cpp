#include "map_handle.hpp"

#include <algorithm>

namespace bench {

VisibleMap::VisibleMap(const Model &model, const std::vector<Direction> &directions) : model_(&model) {
  expect_ok(hsp_view_options_init(&options_, sizeof options_), "hsp_view_options_init");
  hsp_map_limits limits{};
  limits.struct_size = sizeof limits;
  limits.balls = model.size();
  limits.neighbours = std::min<uint32_t>(model.size(), 64);
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
  hsp_map_info info{};
  expect_ok(hsp_map_get_info(map_.get(), &info), "hsp_map_get_info");
  return info;
}

}  // namespace bench
