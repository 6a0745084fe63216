// How many sets of balls a test's sweep tries: fewer in builds that repeat the tests, more in the long form.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace oracle {

// Whether the environment variable HSP_LONG_TESTS asks for the long form of tests that have one.
inline bool long_tests() {
  const char *asked = std::getenv("HSP_LONG_TESTS");
  return asked != nullptr && *asked != '\0';
}

// One set of every sets_for_one is tried. This is 1 in the main build. Builds that repeat its tests with sanitizers,
// with 32-bit limbs or for an emulated processor look for faults that depend on the code and not on the numbers, and
// take many times as long for a set.
inline constexpr int sets_for_one = HSP_SETS_FOR_ONE;
// Whether this build is for an emulated processor: there the oracles' long doubles are computed by functions, which
// takes most of the time.
inline constexpr bool emulated = sets_for_one > 8;

// The number of sets that a sweep tries.
inline int sets(int number) {
  return (number + sets_for_one - 1) / sets_for_one;
}

// The sets of a list that are tried: one of every sets_for_one, but at least three if there are as many.
template <class Set>
std::vector<Set> some_of(const std::vector<Set> &all) {
  const size_t every = std::clamp(all.size() / 3, size_t{1}, size_t{sets_for_one});
  std::vector<Set> some;
  for (size_t k = 0; k < all.size(); k += every) some.push_back(all[k]);
  return some;
}

// The number of sets for a test that has a long form. The usual form tries the first sets of the long one.
inline int rounds(int usual, int many) {
  return long_tests() ? many : sets(usual);
}

// The length of a sweep over numbers alone: the same in every build, four times as long in the long form.
inline int numbers(int usual) {
  return long_tests() ? 4 * usual : usual;
}

}  // namespace oracle
