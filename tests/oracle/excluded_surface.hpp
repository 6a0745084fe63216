// The solvent-excluded surface from its definition alone: the points whose distance from the closed outside of the
// balls with the probe is the probe's radius. The nearest point of the outside is the foot on a sphere, on the circle
// of two spheres, or a vertex of three; all those that are in no open ball are tried. Volume and area come from lines
// along the three axes; a given volume can also be tested by random points. The library's closed forms of patches are
// not used.
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

// Whether a point that is in no open ball counts as outside. Space that does not count, such as a void, is filled.
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
  // The point of the outside that is nearest to x, and its distance: x itself and 0 if x is outside.
  [[nodiscard]] Nearest operator()(const Point &x) const;

 private:
  struct Circle {
    Point centre{}, axis{};
    double radius = 0;
    size_t i = 0, j = 0;
  };
  static constexpr size_t none = static_cast<size_t>(-1);

  // Whether y is in no open ball and counts as outside. Balls i, j and k, on whose spheres y lies, are not tested.
  [[nodiscard]] bool is_outside(const Point &y, size_t i = none, size_t j = none, size_t k = none) const;

  std::vector<ProbedBall> balls_;
  Room room_;
  std::vector<Circle> circles_;
  std::vector<Point> vertices_;
};

struct AreaAndVolume {
  double area = 0, volume = 0;
};

// Along each axis run `lines` x `lines` lines. A surface element dA with the unit normal n has the area |n_x| dA as
// seen along x. So crossings of lines along x with the weight |n_x| sum to the integral of n_x^2, and the three
// directions together make the area, as n_x^2 + n_y^2 + n_z^2 = 1.
AreaAndVolume excluded_surface_by_lines(const std::vector<ProbedBall> &balls, double probe, int lines,
                                        const Room &room = everywhere);

// Draws random points in a box around the solid and counts those inside. Returns the square of the difference between
// this number and the number that `volume` predicts, divided by its variance: 1 in the mean if `volume` is right.
// Returns -1 if fewer than 10 points are expected inside or outside.
double deviation_by_points(const std::vector<ProbedBall> &balls, double probe, double volume, int points,
                           uint64_t seed);

}  // namespace oracle
