// The balls near one ball, and their caps, four at a time. Raw pointers, as lanes/target.hpp says.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

// The arrays of a BallSet.
struct BallArrays {
  const double *x, *y, *z, *r;
  const int32_t *words = nullptr;
};
// The arrays of Caps, from some cap on.
struct CapArrays {
  double *ux, *uy, *uz, *b;
  uint32_t *ball;
};

// More ids than asked for may be written behind an array, but no more than this.
inline constexpr uint32_t spare_ids = 8;

// Those of balls first .. last - 1 that are not certainly disjoint from ball i, i itself among them. Stops when no more
// than `room` ids are sure to fit; `first` then is where to go on. Returns their number. Room for room + spare_ids.
HSP_KERNEL(uint32_t, near_balls,
           (const BallArrays &balls, uint32_t i, uint32_t &first, uint32_t last, uint32_t *near, uint32_t room),
           (balls, i, first, last, near, room))

// The caps of `count` balls near ball i, with the bits that caps.cpp gives them, up to a group of four of which one is
// not certain to meet the ball in a proper circle. Returns how many there are, and raises length_squared to the largest
// |v|^2. Writes, and reads of `near`, up to three more than `count`.
HSP_KERNEL(uint32_t, caps_of_circles,
           (const BallArrays &balls, uint32_t i, const uint32_t *near, uint32_t count, const CapArrays &caps,
            double &length_squared),
           (balls, i, near, count, caps, length_squared))

}  // namespace hsp
