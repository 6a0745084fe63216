// Prints the library's arc tangent at 100000 points as bit patterns, one line each, to be compared between processors
// and compilers. The points are made from integers alone, so that they are the same everywhere.
#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>

#include "../support/random_numbers.hpp"
#include "core/elementary.hpp"

namespace {

// A double of either sign whose binary exponent differs from 0 by at most `widest`; from 1023 on with subnormals.
double number(support::Random &random, int widest) {
  const uint64_t sign_and_fraction = random.next() & UINT64_C(0x800FFFFFFFFFFFFF);
  const int64_t biased = std::min<int64_t>(random.in(-widest, widest) + 1023, 2046);
  return std::bit_cast<double>(sign_and_fraction | static_cast<uint64_t>(biased) << 52);
}

void print(double y, double x) {
  std::printf("%016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", std::bit_cast<uint64_t>(y), std::bit_cast<uint64_t>(x),
              std::bit_cast<uint64_t>(hsp::arc_tangent(y, x)));
}

}  // namespace

int main() {
  constexpr double corners[] = {
      0.0,       -0.0,       1.0,       -1.0,    0x1p-4,   3 * 0x1p-4, 0x1.fffffffffffffp+1023,
      0x1p-1074, -0x1p-1074, 0x1p-1022, 0x1p900, -0x1p901, 0x1.8p0};
  for (const double y : corners) {
    for (const double x : corners) print(y, x);
  }
  constexpr int widths[] = {0, 1, 6, 60, 1023};
  support::Random random(20);
  for (int k = 0; k < 100000; ++k) {
    const int widest = widths[k % 5];
    const double y = number(random, widest);
    print(y, number(random, widest));
  }
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? 0 : 1;
}
