#include "drawn_ink.hpp"

#include <stdexcept>

DrawnInk::DrawnInk(const oracle::Balls &balls, Direction towards)
    : scene_(balls, drawn_step),
      view_(scene_, ViewChoice{HSP_PIECES_OUTSIDE_FARTHER, 0, false, towards, {}}),
      info_(view_.records().info),
      colours_(colours_of(balls)) {
  const hsp_view_options options = ViewChoice{HSP_PIECES_OUTSIDE_FARTHER, 0, false, towards, {}}.options();
  map_.take(support::default_map_limits(static_cast<uint32_t>(balls.size())));
  map_.compute(
      [&](hsp_map *map, hsp_map_limits *limits) { return hsp_map_compute(map, scene_.model(), &options, limits); });
  expect_ok(hsp_map_get_info(map_.get(), &map_info_), "hsp_map_get_info");
}

std::string DrawnInk::picture(hsp_picture_options options, const std::vector<uint32_t> &group) const {
  std::string text;
  options.ink = map_.get();
  options.group = group.empty() ? nullptr : group.data();
  expect_ok(
      hsp_picture_write(view_.handle(), colours_.data(), &options, nullptr, nullptr, append_bytes, &text, nullptr),
      "hsp_picture_write");
  return text;
}

std::vector<hsp_map_vertex> DrawnInk::vertices() const {
  std::vector<hsp_map_vertex> vertices(map_info_.vertices);
  expect_ok(hsp_map_get_vertices(map_.get(), 0, map_info_.vertices, vertices.data()), "hsp_map_get_vertices");
  return vertices;
}

std::vector<oracle::PlainBall> DrawnInk::seen() const {
  const oracle::ViewAxes axes{std::to_array(map_info_.origin), std::to_array(map_info_.right),
                              std::to_array(map_info_.up), std::to_array(map_info_.towards)};
  return oracle::seen_along(scene_.balls(), axes);
}

double DrawnInk::mean_radius() const {
  double sum = 0;
  for (const oracle::PlainBall &ball : scene_.balls()) sum += ball.radius;
  return sum / static_cast<double>(scene_.balls().size());
}
