// Areas and volumes as integers, so that their sums have the same bits in every grouping: an area is a multiple of a
// quantum, to which it is rounded once, in 128 bits; what volumes are made of is areas times lengths, in 192.
//
// The quantum is 2^(2 e - 80) square steps, with 2^e above the largest radius. A sphere then has fewer than 2^83.7
// quanta, and 2^43 spheres fit 127 bits; times a coordinate below 2^51 they fit 178. A radius of 5 steps has e = 3 and
// quanta of 2^-74 square steps.
#pragma once

#include "exact/wide_integer.hpp"

namespace hsp {

using AreaSum = exact::WideInteger<exact::FastLimb, 128>;
using VolumeSum = exact::WideInteger<exact::FastLimb, 192>;

inline void add_to(AreaSum &sum, const AreaSum &term) {
  sum = sum + term;
}
inline void add_to(VolumeSum &sum, const VolumeSum &term) {
  sum = sum + term;
}

// An area times a length in steps.
inline VolumeSum times(const AreaSum &area, int64_t length) {
  return exact::product<192>(area, exact::WideInteger<exact::FastLimb, 64>::from(length));
}

class AreaQuantum {
 public:
  // Of balls with radii up to this, below 2^31.
  explicit AreaQuantum(int64_t largest_radius);

  // The nearest multiple, of an area or a component of a vector area of one sphere.
  AreaSum round(double square_steps) const;
  // In square steps, and in cubic steps of three times a volume: the integer is rounded once.
  double area(const AreaSum &sum) const { return sum.to_double() * quantum_; }
  double volume(const VolumeSum &thrice) const { return thrice.to_double() * quantum_ / 3.0; }

 private:
  double quantum_, quanta_;  // and how many are in a square step
};

}  // namespace hsp
