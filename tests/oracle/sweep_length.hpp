// How long the sweeps of tests over sets are.
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

// Of so many sets one is tried. Builds that repeat the tests of another one, with sanitizers, with 32-bit limbs or for
// an emulated processor, look for what depends on the code that runs rather than on the numbers, and take many times as
// long for a set.
inline constexpr int sets_for_one = HSP_SETS_FOR_ONE;
// Whether that is for an emulated processor, where the long doubles of oracles, which are functions, take most of the
// time.
inline constexpr bool emulated = sets_for_one > 8;

// The number of sets that a sweep tries.
inline int sets(int number) {
  return (number + sets_for_one - 1) / sets_for_one;
}

// Of a list of sets those that are tried: one of every sets_for_one, but at least three.
template <class Set>
std::vector<Set> some_of(const std::vector<Set> &all) {
  const size_t every = std::clamp(all.size() / 3, size_t{1}, size_t{sets_for_one});
  std::vector<Set> some;
  for (size_t k = 0; k < all.size(); k += every) some.push_back(all[k]);
  return some;
}

// The same for tests that have a long form, whose first sets the usual form tries.
inline int rounds(int usual, int many) {
  return long_tests() ? many : sets(usual);
}

// The length of a sweep over numbers alone, the same in every build, and in the long form four times that.
inline int numbers(int usual) {
  return long_tests() ? 4 * usual : usual;
}

}  // namespace oracle
