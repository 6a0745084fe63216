// For kernels: one ball in floats against as many others as there are lanes, for whether they meet (meeting.hpp). Like
// everything in kernels it has internal linkage.
#pragma once

#include "lanes/words.hpp"
#include "model/meeting.hpp"

namespace hsp::HSP_TARGET {
namespace {

// One ball in all lanes.
struct FloatBall {
  Floats x, y, z, r;

  // d^2 - t^2 for each of the others.
  Floats excess(Floats other_x, Floats other_y, Floats other_z, Floats other_r) const {
    const Floats dx = distance(x, other_x), dy = distance(y, other_y), dz = distance(z, other_z), sum = r + other_r;
    return fused(dz, dz, fused(dy, dy, fused_minus(dx, dx, sum * sum)));
  }
};

// The doubles from p on, as many as there are lanes of floats, less an origin, as floats.
inline Floats relative(const double *p, double origin) {
  const Doubles from = Doubles::all(origin);
  return to_floats(Doubles::load(p) - from, Doubles::load(p + Doubles::lanes) - from);
}

// Writes balls that meet nothing, as many as there are lanes, behind the last ball of arrays.
inline void store_far_balls(float *x, float *y, float *z, float *r) {
  const Floats zero = Floats::all(0.0F);
  Floats::all(0x1p60F).store(x);
  zero.store(y);
  zero.store(z);
  zero.store(r);
}

// The lanes of `meet`, where meets(lane) decides about doubtful lanes.
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
