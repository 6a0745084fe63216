// A computed visibility map that pictures are written of.
#pragma once

#include <string>
#include <vector>

#include "drawn_view.hpp"
#include "owned_views.hpp"
#include "z_buffer.hpp"

class DrawnMap {
 public:
  explicit DrawnMap(const oracle::Balls &balls, Direction towards = {0, 0, 1});

  [[nodiscard]] std::string picture(const hsp_picture_options &options, const char *title = nullptr,
                                    const char *description = nullptr) const;

  [[nodiscard]] const hsp_map_info &info() const { return info_; }
  [[nodiscard]] std::vector<hsp_map_edge> edges() const;
  // In view coordinates.
  [[nodiscard]] std::vector<oracle::PlainBall> seen() const;

 private:
  LibraryScene scene_;
  support::OwnedMap map_;
  hsp_map_info info_{};
  std::vector<uint32_t> colours_;
};
