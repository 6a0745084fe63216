#include "drawn_map.hpp"

#include <algorithm>
#include <stdexcept>

DrawnMap::DrawnMap(const oracle::Balls &balls, Direction towards)
    : scene_(balls, drawn_step), colours_(colours_of(balls)) {
  const hsp_view_options options = ViewChoice{HSP_PIECES_OUTSIDE_FARTHER, 0, false, towards, {}}.options();
  map_.take(support::default_map_limits(static_cast<uint32_t>(balls.size())));
  map_.compute(
      [&](hsp_map *map, hsp_map_limits *limits) { return hsp_map_compute(map, scene_.model(), &options, limits); });
  expect_ok(hsp_map_get_info(map_.get(), &info_), "hsp_map_get_info");
}

std::string DrawnMap::picture(const hsp_picture_options &options, const char *title, const char *description) const {
  std::string text;
  uint64_t bytes = 0;
  expect_ok(
      hsp_picture_write_map(map_.get(), colours_.data(), &options, title, description, append_bytes, &text, &bytes),
      "hsp_picture_write_map");
  if (bytes != text.size()) throw std::runtime_error("hsp_picture_write_map: another number of bytes");
  return text;
}

std::vector<hsp_map_edge> DrawnMap::edges() const {
  std::vector<hsp_map_edge> edges(info_.edges);
  expect_ok(hsp_map_get_edges(map_.get(), 0, info_.edges, edges.data()), "hsp_map_get_edges");
  return edges;
}

std::vector<oracle::PlainBall> DrawnMap::seen() const {
  const oracle::ViewAxes axes{std::to_array(info_.origin), std::to_array(info_.right), std::to_array(info_.up),
                              std::to_array(info_.towards)};
  return oracle::seen_along(scene_.balls(), axes);
}
