// What is behind the handle hsp_sticks.
#pragma once

#include "hsp_model.hpp"
#include "sticks/stick_view_builder.hpp"

struct hsp_sticks {
  using Builder = hsp::StickViewBuilder;
  static constexpr uint64_t kind = 0x737469636b73;  // "sticks" in ASCII

  uintptr_t tag;
  Builder builder;
  const hsp_model *model = nullptr;  // what was computed last
  uint64_t revision = 0;
  bool complete = false;

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && hsp::capi::is_live(model) && revision == model->revision; }
  const hsp::StickView &structure() const { return builder.structure(); }
  const hsp::BallSet &balls() const { return model->balls(); }
};
