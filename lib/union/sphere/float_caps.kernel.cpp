#include "sphere/float_caps.hpp"
#include "lanes/words.hpp"

namespace hsp::HSP_TARGET {
namespace {

// As many numbers as there are lanes, less one of them, exact before they are rounded.
Floats differences(const double *p, const uint32_t *id, Doubles from) {
  return to_floats(Doubles::at(p, id) - from, Doubles::at(p, id + Doubles::lanes) - from);
}

}  // namespace

bool make_float_caps(const BallArrays &balls, uint32_t i, uint32_t *near, uint32_t count, const FloatCaps &caps) {
  Integers::all(i).store(near + count);
  const Doubles own[4] = {Doubles::all_of(balls.x + i), Doubles::all_of(balls.y + i), Doubles::all_of(balls.z + i),
                          Doubles::all_of(balls.r + i)};
  const float radius = static_cast<float>(balls.r[i]);
  const Floats half_inverse = Floats::all(0.5F / radius);
  const Floats far = Floats::all(16.0F * radius * radius);
  const Floats below = Floats::all(1.0F - 0x1p-19F);
  const Floats above = Floats::all(1.0F + 0x1p-19F);
  const Floats one = Floats::all(1.0F), nothing = Floats::all(4.0F);
  LaneBits unsure = 0;
  for (uint32_t k = 0; k < count; k += Floats::lanes) {
    const uint32_t *const ids = near + k;
    const Floats dx = differences(balls.x, ids, own[0]), dy = differences(balls.y, ids, own[1]),
                 dz = differences(balls.z, ids, own[2]);
    const Doubles r_low = Doubles::at(balls.r, ids), r_high = Doubles::at(balls.r, ids + Doubles::lanes);
    const Floats difference = to_floats(r_low - own[3], r_high - own[3]);
    const Floats sum = to_floats(r_low + own[3], r_high + own[3]);
    const Floats squared = fused(dx, dx, fused(dy, dy, dz * dz));
    const LaneBits circles =
        greater(sum * sum * below, squared) & greater(squared, difference * difference * above) & greater(far, squared);
    unsure |= first_lanes(count - k) & ~circles;
    // Of the ball itself, which fills the end, and of others with its centre no quotient is taken; those are not sure.
    const Floats inverse = one / square_root(larger(squared, one));
    const Floats h = minus_fused(difference, sum, squared);
    (dx * inverse).store(caps.x + k);
    (dy * inverse).store(caps.y + k);
    (dz * inverse).store(caps.z + k);
    // Nothing lies in caps behind the last one. They are written with it: where one vector is read that was written as
    // two, the processor waits for both stores.
    where_greater(one, squared, nothing, h * inverse * half_inverse).store(caps.b + k);
  }
  if constexpr (Floats::lanes < FloatCaps::spare) {
    const Floats zero = Floats::all(0.0F);
    const uint32_t end = (count + Floats::lanes - 1) / Floats::lanes * Floats::lanes;
    zero.store(caps.x + end);
    zero.store(caps.y + end);
    zero.store(caps.z + end);
    nothing.store(caps.b + end);
  }
  return unsure == 0;
}

}  // namespace hsp::HSP_TARGET
