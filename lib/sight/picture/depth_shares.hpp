// The effects of depth in a picture: how wide a contour is before a gap, and how much of the fog lies over a body.
#pragma once

#include <cmath>

#include "core/extremes.hpp"

namespace hsp {

// A contour has its full width before a gap of so many mean radii.
constexpr double full_gap = 3.0;

// Fog covers at least so many mean radii of depth: planar molecules have next to none of it.
constexpr double least_fog = 5.0;

// The width of a contour before a gap, which is in mean radii and not below 0: full_width times the power 5/8 of the
// gap's share of full_gap.
inline double width_before_gap(double full_width, double gap) {
  const double root = std::sqrt(smaller_of(gap / full_gap, 1.0));
  return full_width * root * std::sqrt(std::sqrt(root));
}

// The depth at which the fog is full, for balls whose centres are between the depths `nearest` and `farthest`.
inline double end_of_fog(double nearest, double farthest, double mean_radius) {
  const double least = nearest - least_fog * mean_radius;
  return farthest < least ? farthest : least;
}

// The share of fog at a depth: f^(5/4), where f is 0 at the nearest centre and 1 at the end of the fog.
inline double share_of_fog(double nearest, double end, double depth) {
  if (!(nearest > end)) return 0.0;
  const double f = (nearest - depth) / (nearest - end);
  if (!(f > 0.0)) return 0.0;
  return f < 1.0 ? f * std::sqrt(std::sqrt(f)) : 1.0;
}

}  // namespace hsp
