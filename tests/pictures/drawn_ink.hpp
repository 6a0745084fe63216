// A view and a map of the same balls from the same direction, for pictures with contours.
#pragma once

#include <string>
#include <vector>

#include "drawn_view.hpp"
#include "owned_views.hpp"
#include "z_buffer.hpp"

class DrawnInk {
 public:
  explicit DrawnInk(const oracle::Balls &balls, Direction towards = {0, 0, 1});

  // With the ink of the map, whatever the options say, and with numbers of groups if there are any.
  [[nodiscard]] std::string picture(hsp_picture_options options, const std::vector<uint32_t> &group = {}) const;

  [[nodiscard]] const hsp_view_info &info() const { return info_; }
  [[nodiscard]] std::vector<hsp_map_vertex> vertices() const;
  // In view coordinates.
  [[nodiscard]] std::vector<oracle::PlainBall> seen() const;
  [[nodiscard]] double mean_radius() const;

 private:
  LibraryScene scene_;
  LibraryView view_;
  support::OwnedMap map_;
  hsp_view_info info_;
  hsp_map_info map_info_{};
  std::vector<uint32_t> colours_;
};
