#include "path_painter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace oracle {
namespace {

constexpr double pi = std::numbers::pi;

// An arc's height is centre + height cos(t - top), with its highest points at t = top + 2 k pi.
struct Heights {
  double height = 0;
  double top = 0;
};

Heights heights_of(const PathArc &arc) {
  const double along = arc.semi_axis[0] * std::sin(arc.rotation);
  const double across = arc.semi_axis[1] * std::cos(arc.rotation);
  return {std::hypot(along, across), std::atan2(across, along)};
}

// Adds where an arc crosses a line. The arc is cut at its highest and lowest points; each part goes one way only.
void add_crossings(const PathArc &arc, double y, std::vector<PathCrossing> &found) {
  if (y > arc.centre[1] + 1.01 * arc.semi_axis[0] || y < arc.centre[1] - 1.01 * arc.semi_axis[0])
    if ((arc.start[1] <= y) == (arc.end[1] <= y)) return;
  const Heights heights = heights_of(arc);
  const double low = std::min(arc.from, arc.to);
  const double high = std::max(arc.from, arc.to);
  const bool forwards = arc.to >= arc.from;
  const double low_y = forwards ? arc.start[1] : arc.end[1];
  const double high_y = forwards ? arc.end[1] : arc.start[1];
  // Part k runs from top + k pi to top + (k + 1) pi: downwards for even k, upwards for odd k.
  const auto first = static_cast<long>(std::floor((low - heights.top) / pi));
  const auto last = static_cast<long>(std::ceil((high - heights.top) / pi)) - 1;
  const auto extreme = [&](long k) { return arc.centre[1] + (k % 2 == 0 ? heights.height : -heights.height); };
  for (long k = first; k <= std::max(first, last); ++k) {
    const double from_y = k == first ? low_y : extreme(k);
    const double to_y = k >= last ? high_y : extreme(k + 1);
    if ((from_y <= y) == (to_y <= y)) continue;
    const double cosine = heights.height > 0 ? std::clamp((y - arc.centre[1]) / heights.height, -1.0, 1.0) : 1.0;
    const double angle = std::acos(k % 2 == 0 ? cosine : -cosine);
    const double t = std::clamp(heights.top + static_cast<double>(k) * pi + angle, low, high);
    const bool upwards = (from_y <= y) == forwards;
    found.push_back({arc.at(t)[0], upwards ? 1 : -1});
  }
}

double distance(const std::array<double, 2> &a, double x, double y) {
  return std::hypot(a[0] - x, a[1] - y);
}

// The distance of a point from an arc: the best of many points of the arc, and the best between its neighbours.
double distance_from(const PathArc &arc, double x, double y) {
  constexpr int parts = 256;
  const auto parameter = [&](double part) { return arc.from + (arc.to - arc.from) * part / parts; };
  double best = std::min(distance(arc.start, x, y), distance(arc.end, x, y));
  int nearest = 0;
  for (int k = 0; k <= parts; ++k)
    if (distance(arc.at(parameter(k)), x, y) < distance(arc.at(parameter(nearest)), x, y)) nearest = k;
  double low = std::max(0, nearest - 1);
  double high = std::min(parts, nearest + 1);
  for (int k = 0; k < 100; ++k) {  // by thirds
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    if (distance(arc.at(parameter(a)), x, y) < distance(arc.at(parameter(b)), x, y))
      high = b;
    else
      low = a;
  }
  best = std::min(best, distance(arc.at(parameter((low + high) / 2)), x, y));
  return best;
}

}  // namespace

std::array<double, 2> PathArc::at(double t) const {
  const double along = semi_axis[0] * std::cos(t);
  const double across = semi_axis[1] * std::sin(t);
  return {centre[0] + along * std::cos(rotation) - across * std::sin(rotation),
          centre[1] + along * std::sin(rotation) + across * std::cos(rotation)};
}

double PathArc::swept_area() const {
  return (centre[0] * (end[1] - start[1]) - centre[1] * (end[0] - start[0]) +
          semi_axis[0] * semi_axis[1] * (to - from)) /
         2;
}

std::vector<PathCrossing> crossings(const Path &path, double y) {
  std::vector<PathCrossing> found;
  for (const PathArc &arc : path) add_crossings(arc, y, found);
  std::sort(found.begin(), found.end(), [](const PathCrossing &a, const PathCrossing &b) { return a.x < b.x; });
  return found;
}

int winding_number(const Path &path, double x, double y) {
  int times = 0;
  for (const PathCrossing &crossing : crossings(path, y)) times -= crossing.x < x ? crossing.up : 0;
  return times;
}

PaintedImage painted(const std::vector<Path> &paths, const PixelGrid &grid) {
  PaintedImage image;
  image.even_odd.assign(grid.pixels(), no_ball);
  image.non_zero.assign(grid.pixels(), no_ball);
  for (size_t p = 0; p < paths.size(); ++p) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PathArc &arc : paths[p]) {
      low = std::min({low, arc.centre[1] - arc.semi_axis[0], arc.start[1], arc.end[1]});
      high = std::max({high, arc.centre[1] + arc.semi_axis[0], arc.start[1], arc.end[1]});
    }
    const auto pixel_at = [](double position, size_t count) {
      return static_cast<size_t>(std::clamp(std::ceil(position), 0.0, static_cast<double>(count)));
    };
    const size_t row_end = pixel_at((high - grid.bottom) / grid.side + 1, grid.rows);
    for (size_t row = pixel_at((low - grid.bottom) / grid.side - 1, grid.rows); row < row_end; ++row) {
      const std::vector<PathCrossing> found = crossings(paths[p], grid.y(row));
      int winding = 0;
      for (size_t k = 0; k + 1 < found.size(); ++k) {
        winding -= found[k].up;
        const size_t end = pixel_at((found[k + 1].x - grid.left) / grid.side, grid.columns);
        for (size_t column = pixel_at((found[k].x - grid.left) / grid.side, grid.columns); column < end; ++column) {
          const size_t pixel = row * grid.columns + column;
          if (k % 2 == 0) image.even_odd[pixel] = static_cast<uint32_t>(p);
          if (winding != 0) image.non_zero[pixel] = static_cast<uint32_t>(p);
          if (winding != static_cast<int>(k + 1) % 2)
            image.windings.push_back({static_cast<uint32_t>(p), pixel, winding});
        }
      }
    }
  }
  return image;
}

bool passes_near(const Path &path, double x, double y, double limit) {
  return std::any_of(path.begin(), path.end(), [&](const PathArc &arc) {
    const double size = 1.01 * arc.semi_axis[0] + limit;
    const bool far = std::abs(x - arc.centre[0]) > size || std::abs(y - arc.centre[1]) > size;
    return !far && distance_from(arc, x, y) <= limit;
  });
}

}  // namespace oracle
