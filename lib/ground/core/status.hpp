// The outcome of an operation. The numbers are those of hardsphere.h (checked in capi/shims/core/conversion.hpp).
#pragma once

#include <cstdint>

namespace hsp {

enum class Status : int32_t {
  ok = 0,
  argument = -1,
  capacity = -2,
  memory = -3,
  state = -4,
  id = -5,
  check = -6,
  sink = -7,
  not_finite = -10,
  negative = -11,
  range = -12,
  conflict = -13,
  executor = -15,
  degenerate = -16,
  stopped = -17,
};

// The id that no ball, vertex, loop or face has.
inline constexpr uint32_t no_id = UINT32_C(0xFFFFFFFF);

// The largest number of balls of a model, and the largest limit of any kind.
inline constexpr uint32_t max_count = UINT32_C(0x0FFFFFFF);

constexpr uint32_t larger_count(uint32_t a, uint32_t b) {
  return a < b ? b : a;
}

}  // namespace hsp
