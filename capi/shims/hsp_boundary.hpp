// What is behind the handle hsp_boundary.
#pragma once

#include "boundary/boundary_builder.hpp"
#include "hsp_model.hpp"

struct hsp_boundary {
  using Builder = hsp::BoundaryBuilder;
  static constexpr auto kind = hsp::capi::HandleKind::boundary;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};  // of what was computed last, or has begun
  bool complete = false;                 // the boundary is there

  // Whether the model is as it was.
  bool has_model() const { return model.is_unchanged(); }
  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && has_model(); }
  uint64_t version() const { return model.version(); }
  const hsp::Boundary &structure() const { return builder.boundary(); }
  const hsp::BallSet &balls() const { return model->balls(); }
};
