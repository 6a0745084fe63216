// The fastest simple z-buffer for balls: the height of every ball over every pixel of its disc, without triangles and
// without shading. The reference that the library's frames are measured against.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "z_buffer/placement.hpp"

namespace bench {

// Pixels that no ball covers have this owner.
constexpr uint32_t no_owner = 0xFFFFFFFF;

class AnalyticZBuffer {
 public:
  AnalyticZBuffer();

  // A new frame: clears the image and draws all balls.
  void draw(const PlacedBalls &balls);

  // The ball seen in pixel (x, y), row 0 at the bottom; no_owner for none.
  uint32_t owner(int x, int y) const { return owner_[index(x, y)]; }
  float depth(int x, int y) const { return depth_[index(x, y)]; }

 private:
  static size_t index(int x, int y) { return static_cast<size_t>(y) * row_length + static_cast<size_t>(x); }

  std::vector<float> depth_;
  std::vector<uint32_t> owner_;
};

}  // namespace bench
