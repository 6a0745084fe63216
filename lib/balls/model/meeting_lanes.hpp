// Balls in floats, as many as there are lanes, against one: for the kernels that ask which of them meet it
// (meeting.hpp). Like everything in kernels it has internal linkage.
#pragma once

#include "lanes/words.hpp"
#include "model/meeting.hpp"

namespace hsp::HSP_TARGET {
namespace {

// One ball in all lanes.
struct FloatBall {
  Floats x, y, z, r;

  // d^2 - t^2 of each of the others.
  Floats excess(Floats other_x, Floats other_y, Floats other_z, Floats other_r) const {
    const Floats dx = distance(x, other_x), dy = distance(y, other_y), dz = distance(z, other_z), sum = r + other_r;
    return fused(dz, dz, fused(dy, dy, fused_minus(dx, dx, sum * sum)));
  }
};

// Some doubles from p on, less an origin.
inline Floats relative(const double *p, double origin) {
  const Doubles from = Doubles::all(origin);
  return to_floats(Doubles::load(p) - from, Doubles::load(p + Doubles::lanes) - from);
}

// Balls that meet nothing, as many as there are lanes, for the end of such arrays.
inline void store_far_balls(float *x, float *y, float *z, float *r) {
  const Floats zero = Floats::all(0.0F);
  Floats::all(0x1p60F).store(x);
  zero.store(y);
  zero.store(z);
  zero.store(r);
}

// The lanes of `meet`, but of the doubtful ones those for which meets(lane).
template <class Meets>
inline LaneBits decided(LaneBits doubtful, LaneBits meet, Meets meets) {
  for (; doubtful != 0; doubtful &= doubtful - 1) {
    const uint32_t lane = lowest(doubtful);
    meet = (meet & ~(1U << lane)) | static_cast<LaneBits>(meets(lane)) << lane;
  }
  return meet;
}

}  // namespace
}  // namespace hsp::HSP_TARGET
