// Areas and volumes as integers, so that sums have the same bits in every grouping. An area is rounded once to a
// multiple of a quantum, in 128 bits. The terms of volumes are areas times lengths, in 192 bits.
//
// The quantum is 2^(2 e - 80) square steps, with 2^e above the largest radius. So a sphere has fewer than 2^83.7
// quanta, and 2^43 spheres fit into 127 bits; times a coordinate below 2^51 they fit into 178. For example a radius of
// 5 steps has e = 3 and quanta of 2^-74 square steps.
#pragma once

#include "exact/wide_integer.hpp"

namespace hsp {

using AreaSum = exact::WideInteger<exact::FastLimb, 128>;
using VolumeSum = exact::WideInteger<exact::FastLimb, 192>;

// An area times a length in steps.
inline VolumeSum times(const AreaSum &area, int64_t length) {
  return exact::product<192>(area, exact::WideInteger<exact::FastLimb, 64>::from(length));
}

class AreaQuantum {
 public:
  // The quantum for balls with radii up to this, below 2^31.
  explicit AreaQuantum(int64_t largest_radius);

  // The nearest multiple of the quantum, for an area or a component of a vector area of one sphere.
  AreaSum round(double square_steps) const;
  // An area in square steps; a volume in cubic steps, from three times the volume. The integer is rounded once.
  double area(const AreaSum &sum) const { return sum.to_double() * quantum_; }
  double volume(const VolumeSum &thrice) const { return thrice.to_double() * quantum_ / 3.0; }

 private:
  double quantum_, quanta_;  // the quantum, and how many are in a square step
};

}  // namespace hsp
