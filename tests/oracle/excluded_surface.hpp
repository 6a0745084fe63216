// The solvent-excluded surface from its definition alone: the points whose distance from the closed outside of the
// balls with the probe is the probe's radius. That distance is the least of those to feet on spheres, circles and
// vertices that are in no open ball. Volume and area by lines along the three axes, or the volume from random points.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace oracle {

using Point = std::array<double, 3>;

struct ProbedBall {
  Point centre{};
  double radius = 0;  // with the probe
};

// Whether a point that is in no open ball counts as outside: what is left out, as voids, is filled.
using Room = std::function<bool(const Point &)>;
inline bool everywhere(const Point &) {
  return true;
}

class DistanceFromOutside {
 public:
  explicit DistanceFromOutside(std::vector<ProbedBall> balls, Room room = everywhere);

  struct Nearest {
    double distance = 0;
    Point point{};
  };
  // Of a point in some open ball; distance 0 for all others.
  [[nodiscard]] Nearest operator()(const Point &x) const;

 private:
  struct Circle {
    Point centre{}, axis{};
    double radius = 0;
    size_t i = 0, j = 0;
  };
  static constexpr size_t none = static_cast<size_t>(-1);

  // But for the balls whose spheres y is on.
  [[nodiscard]] bool is_outside(const Point &y, size_t i = none, size_t j = none, size_t k = none) const;

  std::vector<ProbedBall> balls_;
  Room room_;
  std::vector<Circle> circles_;
  std::vector<Point> vertices_;
};

struct AreaAndVolume {
  double area = 0, volume = 0;
};

// `lines` along each axis and either other one. A surface element dA is crossed by |n_x| dA of the lines along x per
// area, and n_x^2 + n_y^2 + n_z^2 = 1: weights |n| make the three directions' crossings an area.
AreaAndVolume excluded_surface_by_lines(const std::vector<ProbedBall> &balls, double probe, int lines,
                                        const Room &room = everywhere);

// How many of so many random points in a box are in the solid, and how far that is from the number which a volume
// expects: the square of the difference in units of its mean square. Exactly 1 in the mean if the volume is right,
// whatever it is. Negative where fewer points are expected on one side than that takes.
double deviation_by_points(const std::vector<ProbedBall> &balls, double probe, double volume, int points,
                           uint64_t seed);

}  // namespace oracle
