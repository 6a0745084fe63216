// The inside of the handle hsp_map.
#pragma once

#include "hsp_model.hpp"
#include "maps/map_builder.hpp"

struct hsp_map {
  using Builder = hsp::MapBuilder;
  static constexpr auto kind = hsp::capi::HandleKind::map;
  using Given = hsp_map_limits;
  using Limits = hsp::capi::LimitFields<hsp::MapLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                                        offsetof(Given, edges)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};
  bool complete = false;

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && model.is_unchanged(); }
  const hsp::VisibilityMap &structure() const { return builder.structure(); }
  const hsp::BallSet &balls() const { return model->balls(); }
  // The caller's number of a ball of the map.
  uint32_t caller(uint32_t ball) const {
    return ball == hsp::no_id ? HSP_NONE : balls().caller[structure().scene.balls[ball].ball];
  }
};
