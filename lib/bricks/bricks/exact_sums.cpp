#include "bricks/exact_sums.hpp"

#include <bit>

#include "core/decimal.hpp"

namespace hsp {
namespace {

constexpr uint32_t mantissa_bits = 52, exponent_bias = 1023;

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<uint64_t>(exponent + static_cast<int>(exponent_bias)) << mantissa_bits);
}

}  // namespace

AreaQuantum::AreaQuantum(int64_t largest_radius) {
  const int shift = 80 - 2 * static_cast<int>(std::bit_width(static_cast<uint64_t>(largest_radius)));
  quanta_ = power_of_two(shift);
  quantum_ = power_of_two(-shift);
}

AreaSum AreaQuantum::round(double square_steps) const {
  const double quanta = square_steps * quanta_;
  if (std::fabs(quanta) < 0x1p62) return AreaSum::from(nearest(quanta));
  // The double is an integer already, below 2^85: 53 bits, and zeros behind.
  const uint64_t bits = std::bit_cast<uint64_t>(quanta);
  const auto size = static_cast<int64_t>((bits & ((uint64_t{1} << mantissa_bits) - 1)) | uint64_t{1} << mantissa_bits);
  const uint32_t zeros = static_cast<uint32_t>(bits >> mantissa_bits & 0x7FF) - exponent_bias - mantissa_bits;
  using Factor = exact::WideInteger<exact::FastLimb, 64>;
  return exact::product<128>(Factor::from(quanta < 0.0 ? -size : size), Factor::from(int64_t{1} << (zeros & 63)));
}

}  // namespace hsp
