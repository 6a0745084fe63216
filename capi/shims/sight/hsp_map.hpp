// The inside of the handle hsp_map.
#pragma once

#include "hsp_model.hpp"
#include "maps/map_builder.hpp"

struct hsp_map : hsp::capi::FromModel<hsp::MapBuilder> {
  static constexpr auto kind = hsp::capi::HandleKind::map;
  using Given = hsp_map_limits;
  using Limits = hsp::capi::LimitFields<hsp::MapLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                                        offsetof(Given, edges)>;

  // The same names as in hsp_sticks, for map_records.hpp.
  bool has_map() const { return has_results(); }
  const hsp::VisibilityMap &map() const { return structure(); }
  const auto &sight() const { return builder.discs(); }
  uint32_t bodies() const { return balls().n; }
  uint32_t first_face_of(uint32_t ball) const { return map().first_face[model->grid.grid_index(ball)]; }
  // The caller's number of a ball of the map.
  uint32_t caller(uint32_t ball) const {
    return ball == hsp::no_id ? HSP_NONE : balls().caller[map().scene.balls[ball].ball];
  }
};
