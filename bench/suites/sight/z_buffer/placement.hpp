// Balls turned into view and scaled to a square image of pixels: what a z-buffer does first in every frame.
//
// These programs stand for the other way to hidden surface removal, against which the library is timed. They share
// nothing with it, and work in float as such programs do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

// Pixels of an image: image_side x image_side, of which a margin stays empty on all sides.
constexpr int image_side = 1000;
constexpr float image_margin = 0.03F;  // of the larger side of the box around all balls in view

// Rows are longer than the image so that a vector may stick out at the right end of the last one.
constexpr int row_length = image_side + 8;

// Unit vectors, right-handed: right and up in the image, towards the viewer.
struct Axes {
  std::array<float, 3> right, up, towards;
};

// The axes for a viewer in this direction, of any length but 0.
Axes axes_towards(const std::array<double, 3> &direction);

// `count` directions spread evenly over the sphere, none of them along an axis.
std::vector<std::array<double, 3>> spread_directions(size_t count);

// Balls in pixels: x to the right, y up, z towards the viewer, pixel (i, j) having its centre at (i + 1/2, j + 1/2).
struct PlacedBalls {
  std::vector<float> x, y, z, radius;
};

class Placement {
 public:
  // xyz is [n][3].
  Placement(const std::vector<double> &xyz, const std::vector<double> &radius);

  // Turns all centres and scales them so that the larger side of their box fills the image but for the margin: no
  // ball reaches out of the image, hence nobody has to clip.
  const PlacedBalls &place(const Axes &axes);

  size_t size() const { return radius_.size(); }

 private:
  std::vector<float> x_, y_, z_, radius_;
  PlacedBalls placed_;
};

}  // namespace bench
