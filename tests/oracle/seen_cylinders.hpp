// Solid cylinders among the balls that a z-buffer shows, by intersecting each line of sight with each cylinder.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "z_buffer.hpp"

namespace oracle {

// The side of a cylinder around the line between two points, given in view coordinates. Its flat ends are not seen:
// they lie within balls. It changes its name at the part `change` of its length.
struct PlainCylinder {
  std::array<double, 3> from{};
  std::array<double, 3> to{};
  double radius = 0;
  double change = 0.5;
  // Without strands all of the cylinder is seen. With strands only these are: thinner cylinders beside each other in
  // the view plane, each over one part of the length.
  struct Strand {
    double left = 0;  // how far its axis is to the left of the cylinder's, looking from `from` to `to`
    double radius = 0;
    double begin = 0, end = 1;
    std::array<double, 3> under{};  // x, y and radius of a ball's disc that hides the strand wherever it covers it
  };
  std::vector<Strand> strands{};
};

// Where a line of sight first meets the side: z, minus infinity if it does not, and the part of the length.
struct CylinderFront {
  double depth = 0;
  double part = 0;
};
CylinderFront front_of(const PlainCylinder &cylinder, double x, double y);

// Adds cylinders to an image of balls. Cylinder k is named first + 2 k up to its change, and first + 2 k + 1 beyond.
void add_cylinders(const std::vector<PlainCylinder> &cylinders, uint32_t first, const PixelGrid &grid,
                   std::vector<SeenPixel> &image);

}  // namespace oracle
