// What is behind the handle hsp_sticks.
#pragma once

#include "hsp_model.hpp"
#include "sticks/stick_view_builder.hpp"

struct hsp_sticks {
  using Builder = hsp::StickViewBuilder;
  static constexpr uint64_t kind = 0x737469636b73;  // "sticks" in ASCII

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};
  bool complete = false;

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && model.is_unchanged(); }
  const hsp::StickView &structure() const { return builder.structure(); }
  const hsp::BallSet &balls() const { return model->balls(); }
};
