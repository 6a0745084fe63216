#include "sphere/float_caps.hpp"
#include "lanes/words.hpp"

namespace hsp::HSP_TARGET {

bool make_float_caps(const BallArrays &balls, uint32_t i, uint32_t *near, uint32_t count, const FloatCaps &caps) {
  Integers::all(i).store(near + count);
  // The differences of words must be below 2^31. As floats are in doubt, the centres may be 2^12 farther apart than
  // those of balls that meet.
  if (balls.r[i] >= 0x1p30 - 0x1p14) return false;
  const auto own = [&balls, i](uint32_t c) {
    return Integers::all(static_cast<uint32_t>(balls.words[4 * uint64_t{i} + c]));
  };
  const Integers own_x = own(0), own_y = own(1), own_z = own(2), own_r = own(3);
  const float radius = static_cast<float>(balls.r[i]);
  const Floats half_inverse = Floats::all(0.5F / radius);
  const Floats far = Floats::all(16.0F * radius * radius);
  const Floats below = Floats::all(1.0F - 0x1p-19F);
  const Floats above = Floats::all(1.0F + 0x1p-19F);
  const Floats one = Floats::all(1.0F), nothing = Floats::all(4.0F);
  LaneBits unsure = 0;
  for (uint32_t k = 0; k < count; k += Floats::lanes) {
    // The differences are exact, and rounded as they become floats.
    const FourIntegersOfEach other = FourIntegersOfEach::at(balls.words, near + k);
    const Floats dx = to_floats(other.a - own_x), dy = to_floats(other.b - own_y), dz = to_floats(other.c - own_z);
    const Floats difference = to_floats(other.d - own_r), sum = to_floats(other.d + own_r);
    const Floats squared = fused(dx, dx, fused(dy, dy, dz * dz));
    const LaneBits circles =
        greater(sum * sum * below, squared) & greater(squared, difference * difference * above) & greater(far, squared);
    unsure |= first_lanes(count - k) & ~circles;
    // The ball itself fills the lanes behind the last one. For it, and for balls with its centre, which are not sure,
    // nothing is divided by 0.
    const Floats inverse = one / square_root(larger(squared, one));
    const Floats h = minus_fused(difference, sum, squared);
    (dx * inverse).store(caps.x + k);
    (dy * inverse).store(caps.y + k);
    (dz * inverse).store(caps.z + k);
    // Nothing lies in the caps behind the last one. They are written together with it: if one vector is read that was
    // written as two, the processor waits for both stores.
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
