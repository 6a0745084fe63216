// Balls as seen from infinitely far away: for every pixel centre the ball whose front is nearest there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// A ball in lengths.
struct PlainBall {
  std::array<double, 3> centre{};
  double radius = 0;
};

std::vector<PlainBall> plain_balls(const Balls &balls, double step);

// View coordinates: three orthonormal axes and the point with coordinates 0 0 0; larger along towards is nearer.
struct ViewAxes {
  std::array<double, 3> origin{};
  std::array<double, 3> right{1, 0, 0};
  std::array<double, 3> up{0, 1, 0};
  std::array<double, 3> towards{0, 0, 1};

  [[nodiscard]] std::array<double, 3> coordinates(const std::array<double, 3> &point) const;
};

// The same balls in view coordinates.
std::vector<PlainBall> seen_along(const std::vector<PlainBall> &balls, const ViewAxes &axes);

// Square pixels in the view plane, given by their centres; row 0 is the lowest.
struct PixelGrid {
  double left = 0;    // of column 0
  double bottom = 0;  // of row 0
  double side = 1;    // of a pixel
  size_t columns = 0;
  size_t rows = 0;

  [[nodiscard]] double x(size_t column) const { return left + side * static_cast<double>(column); }
  [[nodiscard]] double y(size_t row) const { return bottom + side * static_cast<double>(row); }
  [[nodiscard]] size_t pixels() const { return columns * rows; }
};

// The grid with so many pixels on a side that shows all the balls, given in view coordinates, and a margin of about
// 3 %. It is shifted by a part of a pixel that no lattice knows, so that aligned balls have no edges on centres.
PixelGrid grid_around(const std::vector<PlainBall> &seen, size_t pixels);

// The owner seen at a pixel centre.
struct SeenPixel {
  uint32_t ball = no_ball;                                      // the first of those that are equally near
  double depth = -std::numeric_limits<double>::infinity();      // z of its front there
  double runner_up = -std::numeric_limits<double>::infinity();  // the same for the next ball behind it
};

// z of a ball's front at (x, y), minus infinity beside it. The ball is given in view coordinates.
double front_of(const PlainBall &ball, double x, double y);

// Pixels row by row. Balls of radius 0 are not seen.
std::vector<SeenPixel> z_buffer(const std::vector<PlainBall> &seen, const PixelGrid &grid);

}  // namespace oracle
