// The inside of the handle hsp_boundary.
#pragma once

#include "boundary/boundary_builder.hpp"
#include "hsp_model.hpp"

struct hsp_boundary {
  using Builder = hsp::BoundaryBuilder;
  static constexpr auto kind = hsp::capi::HandleKind::boundary;
  using Given = hsp_boundary_limits;
  struct Limits
      : hsp::capi::LimitFields<hsp::BoundaryLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                               offsetof(Given, vertices), offsetof(Given, circles), offsetof(Given, workers)> {
    static int32_t read(const Given *given, hsp::BoundaryLimits &limits) {
      const int32_t status = LimitFields::read(given, limits);
      return status == HSP_OK && limits.workers > HSP_MAX_WORKERS ? HSP_E_RANGE : status;
    }
  };

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};  // the source of the last computation
  bool complete = false;                 // whether there is a boundary
  bool of_some = false;                  // whether it is that on some balls alone, with areas and gradients only

  // Whether the model is unchanged.
  bool has_model() const { return model.is_unchanged(); }
  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return has_areas() && !of_some; }
  // Whether areas of the selected balls may be read.
  bool has_areas() const { return complete && has_model(); }
  uint64_t version() const { return model.version(); }
  const hsp::Boundary &structure() const { return builder.boundary(); }
  const hsp::BallSet &balls() const { return model->balls(); }
  // Flags that were set of pairs; null, or one for each ball of the caller.
  void clear_flags_of_left_out(uint32_t *flags) const {
    if (!of_some || flags == nullptr) return;
    for (uint32_t i = 0; i < balls().n; ++i) {
      if (structure().is_left_out(i)) flags[balls().caller[i]] = 0;
    }
  }
};

namespace hsp::capi {

// The common part of handles that are computed from a boundary.
template <class Build>
struct FromBoundary {
  using Builder = Build;

  uintptr_t tag;
  Builder builder;
  Source<hsp_boundary> boundary{};
  bool complete = false;

  // Whether results may be read: computed, and neither the boundary nor the model has changed since.
  bool has_results() const { return complete && boundary.is_unchanged(); }
  const auto &structure() const { return builder.structure(); }
  const BallSet &balls() const { return boundary->balls(); }
};

}  // namespace hsp::capi
