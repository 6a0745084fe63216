// Prints the library's arc tangent at 100000 points as bit patterns, one line each, to be compared between processors
// and compilers. The points are made from integers alone, so that they are the same everywhere.
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>

#include "core/elementary.hpp"

namespace {

// Steele, Lea, Flood: "Fast splittable pseudorandom number generators" (2014): SplitMix64.
class Random {
 public:
  uint64_t bits() {
    state_ += UINT64_C(0x9E3779B97F4A7C15);
    uint64_t z = state_;
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
  }

  // A double of either sign whose binary exponent differs from 0 by at most `widest`; from 1023 on with subnormals.
  double number(int widest) {
    const uint64_t pattern = bits();
    const uint64_t sign_and_fraction = pattern & UINT64_C(0x800FFFFFFFFFFFFF);
    const int exponent = static_cast<int>(bits() % static_cast<uint64_t>(2 * widest + 1)) - widest;
    const int biased = exponent + 1023 < 2047 ? exponent + 1023 : 2046;
    return std::bit_cast<double>(sign_and_fraction | static_cast<uint64_t>(biased) << 52);
  }

 private:
  uint64_t state_ = 20;
};

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
  Random random;
  for (int k = 0; k < 100000; ++k) {
    const int widest = widths[k % 5];
    const double y = random.number(widest);
    print(y, random.number(widest));
  }
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? 0 : 1;
}
