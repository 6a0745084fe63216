// Handles of the component motion that own their memory.
#pragma once

#include "owned_handle.hpp"

namespace support {

struct MovingKind : KindOf<hsp_moving, hsp_moving_limits, 2, hsp_moving_bytes, hsp_moving_init> {
  static constexpr const char *name = "hsp_moving";
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours};
  static size_t most_bytes(const Limits &most) { return HSP_MOVING_BYTES(most.balls, most.neighbours); }
};

}  // namespace support
