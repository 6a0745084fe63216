// A visibility map with its inner records open, and pictures painted from it to be held against the z-buffer.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "built_grid.hpp"
#include "lattice_ball.hpp"
#include "maps/map_builder.hpp"
#include "z_buffer.hpp"

class BuiltMap {
 public:
  // Lattice step 1. Limits grow until they suffice, three times at most.
  explicit BuiltMap(const oracle::Balls &balls, const std::array<double, 3> &towards = {0, 0, 1});

  // The same balls from elsewhere.
  void look(const std::array<double, 3> &towards);
  void take(const hsp::MapLimits &limits);

  hsp::Status status() const { return status_; }
  const hsp::VisibilityMap &map() const { return builder_.structure(); }
  hsp::MapBuilder &builder() { return builder_; }
  const hsp::CubeGrid &grid() const { return grid_.grid(); }
  const hsp::DiscGrid &discs() const { return builder_.discs(); }
  // The balls in view coordinates, in the caller's order.
  std::vector<oracle::PlainBall> seen() const;
  // The number that the caller gave to a ball of the map; oracle::no_ball for no_id.
  uint32_t caller(uint32_t ball) const;

 private:
  BuiltGrid grid_;
  CarvedMemory map_memory_;
  hsp::MapBuilder builder_;
  hsp::Status status_ = hsp::Status::ok;
};

// The owner of every pixel centre by the edges of a map, row by row. Which edges there are, and the faces beside them,
// is the library's; the curves of the edges are computed from their balls anew.
struct MapImage {
  std::vector<uint32_t> ball;    // the caller's number
  std::vector<uint8_t> on_edge;  // whether an edge passes within 1e-6 pixels in the row
  size_t breaks = 0;             // where one edge of a row ends with another owner than the next one begins with
};
MapImage painted(const BuiltMap &built, const oracle::PixelGrid &grid);

// Empty, or how the map differs from the z-buffer: in pixels, and in the area seen of each ball.
std::string map_disagrees(const BuiltMap &built, size_t pixels);
