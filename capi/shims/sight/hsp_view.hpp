// The inside of the handle hsp_view.
#pragma once

#include "hsp_model.hpp"
#include "view/view_builder.hpp"

struct hsp_view {
  using Builder = hsp::ViewBuilder;
  static constexpr auto kind = hsp::capi::HandleKind::view;
  using Given = hsp_view_limits;
  using Limits = hsp::capi::LimitFields<hsp::ViewLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                                        offsetof(Given, arcs)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};
  bool complete = false;

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && model.is_unchanged(); }
  const hsp::View &structure() const { return builder.structure(); }
  const hsp::BallSet &balls() const { return model->balls(); }
};
