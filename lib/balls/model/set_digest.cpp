#include "model/set_digest.hpp"

#include <bit>

namespace hsp {

// The constants are odd digits of pi. A factor of 0 would hide the other factor. The factors of the first product are
// not 0, as a and b are no such numbers.
uint64_t mixed(uint64_t a, uint64_t b, uint64_t c, uint64_t d) {
  const uint64_t first = folded_product(a ^ UINT64_C(0x243F6A8885A308D3), b ^ UINT64_C(0x452821E638D01377));
  return folded_product(first ^ c, d ^ UINT64_C(0xC0AC29B7C97C50DD));
}

uint64_t digest_of(const CubeGrid &grid) {
  const BallSet &balls = grid.balls();
  const auto bits = [](double number) { return std::bit_cast<uint64_t>(number); };
  uint64_t sum = mixed(static_cast<uint64_t>(grid.side()), static_cast<uint64_t>(balls.probe_steps),
                       bits(balls.lattice.step()), ~uint64_t{balls.n});
  for (uint32_t i = 0; i < balls.n; ++i) {
    sum += mixed(bits(balls.x[i]), bits(balls.y[i]), bits(balls.z[i]),
                 bits(balls.r[i]) + balls.caller[i] * UINT64_C(0x9E3779B97F4A7C15));
  }
  return sum;
}

}  // namespace hsp
