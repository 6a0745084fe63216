// For kernels: finds the balls near one ball, and makes their caps, four at a time. lanes/target.hpp says why all
// arguments are raw pointers.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

// The arrays of a BallSet.
struct BallArrays {
  const double *x, *y, *z, *r;
  const int32_t *words = nullptr;
};
// The arrays of Caps; the pointers may point to any cap.
struct CapArrays {
  double *ux, *uy, *uz, *b;
  uint32_t *ball;
};

// Up to so many entries behind the last id of an array may be written.
inline constexpr uint32_t spare_ids = 8;

// Writes to `near` those of balls first .. last - 1 that are not certainly disjoint from ball i, which i itself is not.
// Stops when further ids might not fit into `room`; `first` becomes the ball to go on with, or `last`. Returns how many
// ids are written. `near` has room for room + spare_ids.
HSP_KERNEL(uint32_t, near_balls,
           (const BallArrays &balls, uint32_t i, uint32_t &first, uint32_t last, uint32_t *near, uint32_t room),
           (balls, i, first, last, near, room))

// Makes the caps of ball i by the `count` balls in `near`, with the same bits as in caps.cpp. Stops before the first
// group of four in which a ball is not certain to meet ball i in a proper circle. Returns how many caps are made, and
// raises length_squared to the largest |v|^2. Reads and writes up to three entries behind the last of `count`.
HSP_KERNEL(uint32_t, caps_of_circles,
           (const BallArrays &balls, uint32_t i, const uint32_t *near, uint32_t count, const CapArrays &caps,
            double &length_squared),
           (balls, i, near, count, caps, length_squared))

}  // namespace hsp
