#include "z_buffer.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

double product(const std::array<double, 3> &a, const std::array<double, 3> &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The first and the last pixel, one more than needed on either side, that a disc can meet along one axis.
std::array<size_t, 2> pixel_range(double centre, double radius, double first, double side, size_t count) {
  const auto clamped = [&](double position) {
    return static_cast<size_t>(std::clamp(position, 0.0, static_cast<double>(count)));
  };
  return {clamped(std::floor((centre - radius - first) / side) - 1),
          clamped(std::ceil((centre + radius - first) / side) + 2)};
}

}  // namespace

std::vector<PlainBall> plain_balls(const Balls &balls, double step) {
  std::vector<PlainBall> result;
  for (const LatticeBall &ball : balls)
    result.push_back(
        {{static_cast<double>(ball.x) * step, static_cast<double>(ball.y) * step, static_cast<double>(ball.z) * step},
         static_cast<double>(ball.radius) * step});
  return result;
}

std::array<double, 3> ViewAxes::coordinates(const std::array<double, 3> &point) const {
  const std::array<double, 3> v = {point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]};
  return {product(v, right), product(v, up), product(v, towards)};
}

std::vector<PlainBall> seen_along(const std::vector<PlainBall> &balls, const ViewAxes &axes) {
  std::vector<PlainBall> result;
  for (const PlainBall &ball : balls) result.push_back({axes.coordinates(ball.centre), ball.radius});
  return result;
}

PixelGrid grid_around(const std::vector<PlainBall> &seen, size_t pixels) {
  PixelGrid grid{0, 0, 1, pixels, pixels};
  if (seen.empty()) return grid;
  std::array<double, 2> low = {seen[0].centre[0], seen[0].centre[1]};
  std::array<double, 2> high = low;
  for (const PlainBall &ball : seen)
    for (size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], ball.centre[k] - ball.radius);
      high[k] = std::max(high[k], ball.centre[k] + ball.radius);
    }
  const double side = std::max(high[0] - low[0], high[1] - low[1]);
  if (side > 0) grid.side = 1.06 * side / static_cast<double>(pixels);
  const double half = grid.side * static_cast<double>(pixels) / 2;
  grid.left = (low[0] + high[0]) / 2 - half + 0.3819660113 * grid.side;
  grid.bottom = (low[1] + high[1]) / 2 - half + 0.5698402910 * grid.side;
  return grid;
}

double front_of(const PlainBall &ball, double x, double y) {
  const double dx = x - ball.centre[0];
  const double dy = y - ball.centre[1];
  const double square = ball.radius * ball.radius - dx * dx - dy * dy;
  if (ball.radius <= 0 || square < 0) return -std::numeric_limits<double>::infinity();
  return ball.centre[2] + std::sqrt(square);
}

std::vector<SeenPixel> z_buffer(const std::vector<PlainBall> &seen, const PixelGrid &grid) {
  std::vector<SeenPixel> image(grid.pixels());
  for (size_t i = 0; i < seen.size(); ++i) {
    const PlainBall &ball = seen[i];
    const auto columns = pixel_range(ball.centre[0], ball.radius, grid.left, grid.side, grid.columns);
    const auto rows = pixel_range(ball.centre[1], ball.radius, grid.bottom, grid.side, grid.rows);
    for (size_t row = rows[0]; row < rows[1]; ++row)
      for (size_t column = columns[0]; column < columns[1]; ++column) {
        const double depth = front_of(ball, grid.x(column), grid.y(row));
        SeenPixel &pixel = image[row * grid.columns + column];
        if (depth > pixel.depth)
          pixel = {static_cast<uint32_t>(i), depth, pixel.depth};
        else
          pixel.runner_up = std::max(pixel.runner_up, depth);
      }
  }
  return image;
}

}  // namespace oracle
