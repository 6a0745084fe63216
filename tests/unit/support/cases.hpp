// Cases of unit tests as plain tables. A header <file>_cases.hpp holds tables and checks that need neither heap nor
// streams nor GoogleTest, so that the same cases run on a microcontroller as well.
#pragma once

#include <cstddef>
#include <cstdint>

#include "../../support/random_numbers.hpp"

namespace cases {

// The value that a check returns if all its cases hold.
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

using support::Random;

// Whether two numbers differ by at most `tolerance`.
constexpr bool near(double a, double b, double tolerance) {
  return a - b <= tolerance && b - a <= tolerance;
}

}  // namespace cases
