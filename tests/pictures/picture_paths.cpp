#include "picture_paths.hpp"

#include <cmath>

double distance(const PagePoint &a, const PagePoint &b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

Segment quadratic(const PagePoint &start, const PagePoint &control, const PagePoint &end) {
  Segment curve;
  curve.kind = Segment::Kind::cubic;
  curve.start = start;
  curve.end = end;
  for (size_t k = 0; k < 2; ++k) {
    curve.handle[0][k] = (start[k] + 2 * control[k]) / 3;
    curve.handle[1][k] = (end[k] + 2 * control[k]) / 3;
  }
  return curve;
}

PagePoint Segment::at(double share) const {
  PagePoint point{};
  const double rest = 1 - share;
  const double t = from + (to - from) * share;
  for (size_t k = 0; k < 2; ++k) {
    switch (kind) {
      case Kind::line:
        point[k] = rest * start[k] + share * end[k];
        break;
      case Kind::arc:
        point[k] = centre[k] + std::cos(t) * axis[0][k] + std::sin(t) * axis[1][k];
        break;
      case Kind::cubic:
        point[k] = rest * rest * rest * start[k] + 3 * rest * rest * share * handle[0][k] +
                   3 * rest * share * share * handle[1][k] + share * share * share * end[k];
        break;
    }
  }
  return point;
}
