// Cases of unit tests as plain tables. A header <file>_cases.hpp holds tables and checks that need neither heap nor
// streams nor GoogleTest, so that the same cases run on a microcontroller as well.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cases {

// The answer of a check whose cases all hold.
inline constexpr uint32_t all_hold = UINT32_C(0xFFFFFFFF);

// The index of the first case for which holds(case) is false.
template <class Case, size_t n, class Holds>
constexpr uint32_t first_failing(const Case (&table)[n], Holds holds) {
  for (uint32_t k = 0; k < n; ++k) {
    if (!holds(table[k])) return k;
  }
  return all_hold;
}

// The index of the first false one of several conditions.
template <size_t n>
constexpr uint32_t first_false(const bool (&conditions)[n]) {
  return first_failing(conditions, [](bool condition) { return condition; });
}

// A check by name; run() returns the index of its first failing case, or all_hold.
struct Check {
  const char *name;
  uint32_t (*run)();
};

// Numbers without a pattern, the same everywhere (SplitMix64: Steele, Lea and Flood, OOPSLA 2014).
class Random {
 public:
  explicit constexpr Random(uint64_t seed) : state_(seed) {}
  constexpr uint64_t next() {
    uint64_t z = state_ += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
  }
  constexpr uint32_t below(uint32_t n) { return static_cast<uint32_t>(next() % n); }
  constexpr int64_t in(int64_t low, int64_t high) {
    return low + static_cast<int64_t>(next() % static_cast<uint64_t>(high - low + 1));
  }

 private:
  uint64_t state_;
};

// Whether two numbers differ by at most `tolerance`.
constexpr bool near(double a, double b, double tolerance) {
  return a - b <= tolerance && b - a <= tolerance;
}

}  // namespace cases
