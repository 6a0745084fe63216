// How long the sweeps of the slow tests are.
#pragma once

#include <cstdlib>

namespace oracle {

// Whether the environment variable HSP_LONG_TESTS asks for the long form of the slow tests.
inline bool long_tests() {
  const char *asked = std::getenv("HSP_LONG_TESTS");
  return asked != nullptr && *asked != '\0';
}

// The number of sets a sweep tries. The usual form tries the first sets of the long one.
inline int rounds(int usual, int many) {
  return long_tests() ? many : usual;
}

}  // namespace oracle
