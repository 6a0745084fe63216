// Numbers as text, by integers alone: the same bytes on every machine and in every locale.
#pragma once

#include "picture/byte_sink.hpp"

namespace hsp {

// value times 10^decimals as the nearest integer, halves away from zero, after one rounding of the product. The product
// must stay below 2^62.
int64_t scaled(double value, int decimals);

// The number n / 10^decimals without trailing zeros and without a zero before the point: 1.5, -.25, 0.
void put_scaled(ByteSink &sink, int64_t n, int decimals);

inline void put_decimal(ByteSink &sink, double value, int decimals) {
  put_scaled(sink, scaled(value, decimals), decimals);
}

// At least `digits` digits.
void put_integer(ByteSink &sink, uint64_t n, int digits = 1);

// 0xRRGGBB as six hexadecimal digits.
void put_colour(ByteSink &sink, uint32_t colour);

}  // namespace hsp
