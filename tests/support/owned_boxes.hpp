// Handles of the component boxes that own their memory.
#pragma once

#include "owned_handle.hpp"

namespace support {

struct PeriodicKind : KindOf<hsp_periodic, hsp_periodic_limits, 5, hsp_periodic_bytes, hsp_periodic_init> {
  static constexpr const char *name = "hsp_periodic";
  static constexpr std::array limits = {&Limits::balls,    &Limits::images,  &Limits::neighbours,
                                        &Limits::vertices, &Limits::circles, &Limits::contacts};
  static size_t most_bytes(const Limits &most) {
    return HSP_PERIODIC_BYTES(most.balls, most.images, most.neighbours, most.vertices, most.circles, most.contacts);
  }
};

using OwnedPeriodic = OwnedHandle<PeriodicKind>;

}  // namespace support
