// The inside of the handle hsp_model.
#pragma once

#include "handle_memory.hpp"
#include "model/set_digest.hpp"
#include "source.hpp"

struct hsp_model {
  using Builder = hsp::CubeGrid;
  static constexpr auto kind = hsp::capi::HandleKind::model;

  uintptr_t tag;
  Builder grid;
  uint64_t digest = 0;   // of the grid
  bool complete = true;  // whether the grid holds the balls that were set; if not it has none

  // To be called whenever the grid has changed.
  void take_digest() {
    digest = hsp::digest_of(grid);
    complete = true;
  }
  uint64_t version() const { return digest; }
  bool has_results() const { return complete; }
  const hsp::BallSet &balls() const { return grid.balls(); }
};

namespace hsp::capi {

// The common part of handles that are computed from a model.
template <class Build>
struct FromModel {
  using Builder = Build;

  uintptr_t tag;
  Builder builder;
  Source<hsp_model> model{};
  bool complete = false;

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && model.is_unchanged(); }
  const auto &structure() const { return builder.structure(); }
  const BallSet &balls() const { return model->balls(); }
};

}  // namespace hsp::capi
