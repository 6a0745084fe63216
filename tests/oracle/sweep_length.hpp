// How long the sweeps of tests over sets are.
#pragma once

#include <cstdlib>

namespace oracle {

// Whether the environment variable HSP_LONG_TESTS asks for the long form of the slow tests.
inline bool long_tests() {
  const char *asked = std::getenv("HSP_LONG_TESTS");
  return asked != nullptr && *asked != '\0';
}

// Of so many sets one is tried. Builds that repeat the tests of another one, with sanitizers, with 32-bit limbs or for
// an emulated processor, look for what depends on the code that runs rather than on the numbers, and take many times as
// long for a set.
inline constexpr int sets_for_one = HSP_REPEATED_TESTS ? 4 : 1;

// The number of sets that a sweep tries.
inline int sets(int number) {
  return (number + sets_for_one - 1) / sets_for_one;
}

// The same for slow tests. The usual form tries the first sets of the long one.
inline int rounds(int usual, int many) {
  return long_tests() ? many : sets(usual);
}

}  // namespace oracle
