// Whether long doubles have more digits than doubles. They have not on 32-bit Arm, where oracles that compute in them
// are no more precise than the library: tests that need more are skipped there.
#pragma once

#include <limits>

namespace oracle {

inline constexpr bool has_long_reals = std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits;

}  // namespace oracle
