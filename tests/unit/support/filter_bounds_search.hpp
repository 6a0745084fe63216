// A search for the input on which a computed number is worst: random starts, then small changes that are kept as long
// as they make it worse.
#pragma once

#include "exact/lattice_ball.hpp"
#include "perturbation_determinants.hpp"
#include "random_balls.hpp"

namespace filter_bounds {

// Ball 0 and three others that meet it, each in a circle.
struct Scene {
  hsp::exact::LatticeBall ball[4];

  bool valid() const;
  hsp::exact::Sphere sphere() const { return hsp::exact::sphere_of(ball[0]); }
  hsp::exact::Plane plane(int k) const { return hsp::exact::plane_of(ball[0], ball[k]); }
  // The same balls for the naive determinants.
  perturbation::Balls as_given() const;
};

// Balls near the limits of the contract without any rule; with caps from tiny to nearly whole; radii as different as 1
// and 2^29; axes that are nearly parallel; circles that nearly touch.
enum class Kind { any, unlike_radii, parallel_axes, touching_circles };
constexpr int kinds = 4;

Scene random_scene(oracle::RandomSource &random, Kind kind);

// A change of one to three numbers, each by anything from one step to its own size.
Scene changed(oracle::RandomSource &random, const Scene &scene);

// The largest badness(scene) found; badness is negative where it has no meaning.
template <class Badness>
double worst(oracle::RandomSource &random, int starts, int changes, const Badness &badness) {
  double largest = 0.0;
  for (int start = 0; start < starts; ++start) {
    Scene scene = random_scene(random, static_cast<Kind>(start % kinds));
    double current = badness(scene);
    for (int k = 0; k < changes; ++k) {
      const Scene next = changed(random, scene);
      if (!next.valid()) continue;
      const double value = badness(next);
      if (value >= current) {
        scene = next;
        current = value;
      }
    }
    if (current > largest) largest = current;
  }
  return largest;
}

}  // namespace filter_bounds
