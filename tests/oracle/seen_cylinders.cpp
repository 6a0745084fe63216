#include "seen_cylinders.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {

CylinderFront front_of(const PlainCylinder &cylinder, double x, double y) {
  const CylinderFront none{-std::numeric_limits<double>::infinity(), 0};
  std::array<double, 3> d{};
  double length = 0;
  for (size_t k = 0; k < 3; ++k) {
    d[k] = cylinder.to[k] - cylinder.from[k];
    length = std::hypot(length, d[k]);
  }
  for (double &component : d) component /= length;
  // The points (x, y, z) as m + z (0, 0, 1), without what they have along the axis: |m + z v|^2 = radius^2.
  const std::array<double, 3> line = {x - cylinder.from[0], y - cylinder.from[1], -cylinder.from[2]};
  const double along = line[0] * d[0] + line[1] * d[1] + line[2] * d[2];
  double a = 0, b = 0, c = -cylinder.radius * cylinder.radius;
  for (size_t k = 0; k < 3; ++k) {
    const double m = line[k] - along * d[k];
    const double v = (k == 2 ? 1 : 0) - d[2] * d[k];
    a += v * v;
    b += m * v;
    c += m * m;
  }
  if (a <= 0 || b * b < a * c) return none;
  const double z = (std::sqrt(b * b - a * c) - b) / a;
  const double part = (along + z * d[2]) / length;
  return part < 0 || part > 1 ? none : CylinderFront{z, part};
}

namespace {

// Of a cylinder with strands: if the line of sight meets a strand, the depth of the whole cylinder and the part of the
// length at which it meets the strand; else minus infinity.
CylinderFront front_of_strands(const PlainCylinder &cylinder, double x, double y) {
  CylinderFront whole = front_of(cylinder, x, y);
  if (cylinder.strands.empty() || !(whole.depth > -std::numeric_limits<double>::infinity())) return whole;
  const double dx = cylinder.to[0] - cylinder.from[0], dy = cylinder.to[1] - cylinder.from[1];
  const double seen = std::hypot(dx, dy);
  for (const PlainCylinder::Strand &strand : cylinder.strands) {
    const double aside[2] = {-dy / seen * strand.left, dx / seen * strand.left};
    PlainCylinder own{cylinder.from, cylinder.to, strand.radius};
    for (size_t k = 0; k < 2; ++k) {
      own.from[k] += aside[k];
      own.to[k] += aside[k];
    }
    const CylinderFront front = front_of(own, x, y);
    if (front.depth > -std::numeric_limits<double>::infinity() && front.part >= strand.begin &&
        front.part <= strand.end && std::hypot(x - strand.under[0], y - strand.under[1]) >= strand.under[2])
      return {whole.depth, front.part};
  }
  return {-std::numeric_limits<double>::infinity(), 0};
}

}  // namespace

void add_cylinders(const std::vector<PlainCylinder> &cylinders, uint32_t first, const PixelGrid &grid,
                   std::vector<SeenPixel> &image) {
  for (size_t k = 0; k < cylinders.size(); ++k) {
    const PlainCylinder &cylinder = cylinders[k];
    const auto range = [&](size_t axis, double low, size_t count) {
      const double least = std::min(cylinder.from[axis], cylinder.to[axis]) - cylinder.radius;
      const double most = std::max(cylinder.from[axis], cylinder.to[axis]) + cylinder.radius;
      const auto clamped = [&](double at) {
        return static_cast<size_t>(std::clamp((at - low) / grid.side, 0.0, static_cast<double>(count)));
      };
      return std::array<size_t, 2>{clamped(least), std::min(clamped(most) + 2, count)};
    };
    const auto columns = range(0, grid.left, grid.columns);
    const auto rows = range(1, grid.bottom, grid.rows);
    for (size_t row = rows[0]; row < rows[1]; ++row)
      for (size_t column = columns[0]; column < columns[1]; ++column) {
        const CylinderFront front = front_of_strands(cylinder, grid.x(column), grid.y(row));
        SeenPixel &pixel = image[row * grid.columns + column];
        const auto name = static_cast<uint32_t>(first + 2 * k + (front.part < cylinder.change ? 0 : 1));
        if (front.depth > pixel.depth)
          pixel = {name, front.depth, pixel.depth};
        else
          pixel.runner_up = std::max(pixel.runner_up, front.depth);
      }
  }
}

}  // namespace oracle
