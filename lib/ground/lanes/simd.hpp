// Two doubles at once, with the vector types of GCC and clang. Targets with a 128-bit vector unit keep them in
// registers. Each lane is computed by the same IEEE operations as a scalar, so that results do not depend on the
// target.
#pragma once

#include <cstdint>
#include <cstring>

#include "lanes/floating_point.hpp"

namespace hsp {

inline constexpr uint32_t lane_count = 2;

typedef double Lanes __attribute__((vector_size(16)));
typedef int64_t LaneMask __attribute__((vector_size(16)));  // -1 where true

inline Lanes load_lanes(const double *p) {
  Lanes lanes;
  std::memcpy(&lanes, p, sizeof lanes);
  return lanes;
}
inline Lanes all_lanes(double x) {
  return Lanes{x, x};
}

inline bool any(const LaneMask &mask) {
  return (mask[0] | mask[1]) != 0;
}
inline uint32_t count(const LaneMask &mask) {
  return static_cast<uint32_t>(-(mask[0] + mask[1]));
}

}  // namespace hsp
