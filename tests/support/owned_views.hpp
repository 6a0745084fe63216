// Handles of the component sight that own their memory.
#pragma once

#include "owned_handle.hpp"

namespace support {

struct ViewKind : KindOf<hsp_view, hsp_view_limits, 3, hsp_view_bytes, hsp_view_init> {
  static constexpr const char *name = "hsp_view";
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::arcs};
  static size_t most_bytes(const Limits &most) { return HSP_VIEW_BYTES(most.balls, most.neighbours, most.arcs); }
};
struct MapKind : KindOf<hsp_map, hsp_map_limits, 12, hsp_map_bytes, hsp_map_init> {
  static constexpr const char *name = "hsp_map";
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::edges};
  static size_t most_bytes(const Limits &most) { return HSP_MAP_BYTES(most.balls, most.neighbours, most.edges); }
};
struct SticksKind : KindOf<hsp_sticks, hsp_sticks_limits, 12, hsp_sticks_bytes, hsp_sticks_init> {
  static constexpr const char *name = "hsp_sticks";
  static constexpr std::array limits = {&Limits::balls, &Limits::sticks, &Limits::pairs, &Limits::edges};
  static size_t most_bytes(const Limits &most) {
    return HSP_STICKS_BYTES(most.balls, most.sticks, most.pairs, most.edges);
  }
};
using OwnedView = OwnedHandle<ViewKind>;
using OwnedMap = OwnedHandle<MapKind>;

inline hsp_view_limits default_view_limits(uint32_t balls) {
  hsp_view_limits limits;
  expect_ok(hsp_view_limits_init(&limits, sizeof limits, balls), "hsp_view_limits_init");
  return limits;
}

inline hsp_map_limits default_map_limits(uint32_t balls) {
  hsp_map_limits limits;
  expect_ok(hsp_map_limits_init(&limits, sizeof limits, balls), "hsp_map_limits_init");
  return limits;
}

}  // namespace support
