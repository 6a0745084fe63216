// Pictures painted by whole paths of elliptical arcs, row of pixels by row of pixels, from the arcs' own equations.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "z_buffer.hpp"

namespace oracle {

// The points centre + semi_axis[0] cos(t) (cos rotation, sin rotation) + semi_axis[1] sin(t) (-sin rotation,
// cos rotation) for t from `from` to `to`, which may be less. start and end are the same points as `from` and `to`:
// loops are closed if the end of each arc is bit for bit the start of the next.
struct PathArc {
  std::array<double, 2> centre{};
  std::array<double, 2> semi_axis{};
  double rotation = 0;
  double from = 0;
  double to = 0;
  std::array<double, 2> start{};
  std::array<double, 2> end{};

  [[nodiscard]] std::array<double, 2> at(double t) const;
  // Half the integral of x dy - y dx along the arc: summed over a loop, the area on its left.
  [[nodiscard]] double swept_area() const;
};

// Any number of closed loops.
using Path = std::vector<PathArc>;

// Where a path crosses a horizontal line, by increasing x; up is +1 where it goes up and -1 where it goes down. An arc
// counts between the heights of its ends as given, so that closed loops go up as often as down on every line.
struct PathCrossing {
  double x = 0;
  int up = 0;
};
std::vector<PathCrossing> crossings(const Path &path, double y);

// How often a path runs counter-clockwise around a point.
int winding_number(const Path &path, double x, double y);

// The index of the path that was painted last at each pixel centre, row by row; no_ball where none was.
struct PaintedImage {
  std::vector<uint32_t> even_odd;
  std::vector<uint32_t> non_zero;
  // Pixels around which some path does not run exactly 0 times or 1 time; each once for every such path.
  struct Winding {
    uint32_t path = 0;
    size_t pixel = 0;
    int times = 0;
  };
  std::vector<Winding> windings;
};
PaintedImage painted(const std::vector<Path> &paths, const PixelGrid &grid);

// Whether an arc of the path passes within a distance of the point (x, y).
bool passes_near(const Path &path, double x, double y, double distance);

}  // namespace oracle
