// The inside of the handle hsp_view.
#pragma once

#include "hsp_model.hpp"
#include "view/view_builder.hpp"

struct hsp_view : hsp::capi::FromModel<hsp::ViewBuilder> {
  static constexpr auto kind = hsp::capi::HandleKind::view;
  using Given = hsp_view_limits;
  using Limits = hsp::capi::LimitFields<hsp::ViewLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                                        offsetof(Given, arcs)>;
};
